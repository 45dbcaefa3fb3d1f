"""The wheel by itself: it needs numpy and nothing else, keeps to the stable interface of Python 3.10, and is small."""

import subprocess
import sys
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
LARGEST = 6_000_000


@pytest.fixture(scope="module")
def wheel():
    (one,) = (PROJECT / "dist").glob("stribeck-*.whl")
    return one


def tour():
    """The code of docs/python.md, without what needs other packages."""
    page = (PROJECT / "docs" / "python.md").read_text(encoding="utf-8")
    blocks = [block.split("```")[0] for block in page.split("```python\n")[1:]]
    alone = [block for block in blocks if not any(other in block for other in ("fmpy", "joblib", "SALib"))]
    lines = [line for block in alone for line in block.splitlines()]
    return "\n".join(line for line in lines if ".plot(" not in line)


@pytest.mark.parametrize("version", ["1.26.4", "2.4.6"])
def test_the_wheel_runs_the_tour_without_anything_but_numpy(wheel, tmp_path, version):
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--target", tmp_path]
    subprocess.run([*pip, "--only-binary=:all:", f"numpy=={version}"], check=True)
    subprocess.run([*pip, "--no-deps", "--no-index", wheel], check=True)
    # Neither the packages of this environment nor a compiler is found.
    code = f"import sys; sys.path.append({str(tmp_path)!r})\n{tour()}\nprint(numpy.__version__)"
    environment = {"PATH": "", "STRIBECK_CACHE": str(tmp_path / "cache")}
    done = subprocess.run([sys.executable, "-I", "-S", "-c", code], capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == version
    assert (tmp_path / "cache" / "LuGre.fmu").is_file()


def test_the_wheel_is_small(wheel):
    assert wheel.stat().st_size <= LARGEST


def test_the_extension_keeps_to_the_stable_interface(wheel):
    done = subprocess.run([sys.executable, "-m", "abi3audit", "--strict", wheel], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "cp310-abi3" in wheel.name
