"""The wheel by itself: it needs numpy and nothing else, keeps to the stable interface of Python 3.10, and is small."""

import os
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


# Before the tour: from here on nobody is asked for anything, and no other program is started, a compiler for example.
ALONE = """
import sys
FOREIGN = {"socket.connect", "socket.getaddrinfo", "subprocess.Popen", "os.system", "os.exec", "os.posix_spawn"}
def refuse(event, arguments):
    if event in FOREIGN:
        raise RuntimeError(f"{event}: {arguments}")
sys.addaudithook(refuse)
"""


def environment_of(version, wheel, folder):
    """A virtual environment with the wheel, installed from files, and this numpy; its Python."""
    pip = [sys.executable, "-m", "pip", "--disable-pip-version-check", "--quiet"]
    numpy = ["--no-deps", "--only-binary=:all:", "--dest", folder / "files", f"numpy=={version}"]
    subprocess.run([*pip, "download", *numpy], check=True)
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", folder / "venv"], check=True)
    python = folder / "venv" / ("Scripts" if os.name == "nt" else "bin") / "python"
    offline = ["--isolated", "--python", python, "install", "--no-index", "--find-links", folder / "files"]
    subprocess.run([*pip, *offline, wheel], check=True)
    return python


@pytest.mark.parametrize("version", ["1.26.4", "2.4.6"])
def test_a_clean_environment_runs_the_tour_without_network_and_compiler(wheel, tmp_path, version):
    python = environment_of(version, wheel, tmp_path)
    code = f"{ALONE}\n{tour()}\nprint(numpy.__version__)"
    environment = {"PATH": "", "STRIBECK_CACHE": str(tmp_path / "cache")}
    done = subprocess.run([python, "-I", "-c", code], capture_output=True, text=True, env=environment, cwd=PROJECT)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[-1] == version
    assert (tmp_path / "cache" / "LuGre.fmu").is_file()


def test_the_wheel_is_small(wheel):
    assert wheel.stat().st_size <= LARGEST


def test_the_extension_keeps_to_the_stable_interface(wheel):
    done = subprocess.run([sys.executable, "-m", "abi3audit", "--strict", wheel], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "cp310-abi3" in wheel.name
