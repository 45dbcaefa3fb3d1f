"""Python for Linux on ARM, from Debian's packages, run by qemu."""

import subprocess
import sys
from pathlib import Path

# Those that Python of Debian 12 needs, of the same system on ARM.
PYTHON = "python3.11"
PACKAGES = [f"{PYTHON}-minimal", f"lib{PYTHON}-minimal", f"lib{PYTHON}-stdlib"]
PACKAGES += ["libc6", "libgcc-s1", "libstdc++6", "zlib1g", "libexpat1", "libffi8", "libssl3", "libbz2-1.0", "liblzma5"]


def run(*command: str | Path, folder: Path | None = None) -> None:
    """Runs a command that must succeed."""
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, f"{command}\n{done.stdout}{done.stderr}"


def python(folder: Path) -> Path:
    """The root folder of a system with this Python; unpacked there the first time. This machine's own list of packages
    stays as it is."""
    root = folder / "root"
    if (root / "usr" / "bin" / PYTHON).exists():
        return root
    for part in ("lists/partial", "cache/archives/partial", "packages"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    apt = ["apt-get", "-o", "APT::Architecture=arm64", "-o", "APT::Architectures::=arm64"]
    apt += ["-o", f"Dir::State::lists={folder / 'lists'}", "-o", f"Dir::Cache={folder / 'cache'}"]
    apt += ["-o", "Dir::State::status=/dev/null"]
    run(*apt, "update")
    run(*apt, "download", *PACKAGES, folder=folder / "packages")
    for package in (folder / "packages").glob("*.deb"):
        run("dpkg", "-x", package, root)
    return root


def install(folder: Path, *packages: str | Path) -> None:
    """Installs wheels for it, without asking what else they need."""
    systems = ["--platform", "manylinux2014_aarch64", "--platform", "manylinux_2_28_aarch64"]
    kind = ["--implementation", "cp", "--python-version", PYTHON.removeprefix("python"), "--only-binary=:all:"]
    run(sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--target", folder, *systems, *kind, *packages)


def output(root: Path, packages: Path, code: str) -> str:
    """What a program prints, with these packages and no others."""
    program = ["qemu-aarch64-static", "-L", root, root / "usr" / "bin" / PYTHON, "-I", "-S", "-c"]
    code = f"import sys; sys.path.append({str(packages)!r})\n{code}"
    done = subprocess.run([*map(str, program), code], capture_output=True, text=True)
    # A signal leaves no message.
    assert done.returncode == 0, f"exit code {done.returncode}\n{done.stderr}"
    return done.stdout
