#!/usr/bin/env python3
"""The project's tasks. Needs Python 3.11 and Rust; the first task that needs more installs it into .venv.

    python3 tasks.py demo     pack the FMUs, run each of them from Python, draw the results
    python3 tasks.py test     every check and test of the project
    python3 tasks.py bench    the benchmarks
    python3 tasks.py pack     the FMUs into dist/
    python3 tasks.py setup    .venv with the Python packages
    python3 tasks.py clean    remove what the other tasks have made

On Windows: py tasks.py demo
"""

from __future__ import annotations

import argparse
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent
VENV = ROOT / ".venv"
REQUIREMENTS = ROOT / "requirements.txt"
WINDOWS = os.name == "nt"
PROGRAMS = VENV / ("Scripts" if WINDOWS else "bin")
PYTHON = PROGRAMS / ("python.exe" if WINDOWS else "python")

RUST_FOLDERS = ["src", "tests", "benches", "fmu-build", "lab", "examples"]
PYTHON_FOLDERS = ["tasks.py", "examples", "tests"]
C_FOLDERS = ["examples/c", "examples/cpp", "examples/mujoco", "tests/c", "benches"]


class TaskError(Exception):
    """A step did not succeed; the text says which one, and what to do."""


def run(*command: str | Path, **environment: str) -> None:
    """Runs a command in the project's folder; a failure ends the task."""
    words = [str(word) for word in command]
    settings = [f"{name}={value}" for name, value in environment.items()]
    shown = shlex.join(settings + words)
    print(f"\n> {shown if len(shown) < 300 else shown[:300] + ' ...'}", flush=True)
    try:
        status = subprocess.run(words, cwd=ROOT, env={**os.environ, **environment}).returncode
    except OSError as error:
        raise TaskError(f"cannot run {words[0]}: {error}") from error
    if status != 0:
        raise TaskError(f"exit code {status}: {shown}")


def need(program: str, cure: str) -> None:
    """Ends the task if a program is missing."""
    if shutil.which(program) is None:
        raise TaskError(f"{program} not found: {cure}")


def need_rust() -> None:
    """Ends the task if Rust, or the linker it needs, is missing."""
    need("cargo", "install Rust from https://rustup.rs")
    # On Windows cargo finds Microsoft's linker by itself, outside the search path.
    if not WINDOWS:
        need_c_compiler()


def need_c_compiler() -> None:
    """Ends the task if there is no C compiler."""
    if not any(shutil.which(name) for name in ("cc", "gcc", "clang", "cl")):
        raise TaskError(
            "no C compiler found: install one (Debian, Ubuntu: apt install build-essential; macOS: xcode-select "
            "--install; Windows: Visual Studio Build Tools, and start from their developer prompt)"
        )


def files(folders: list[str], *endings: str) -> list[Path]:
    """All files with these endings below the folders, generated ones left out."""
    found = [
        path.relative_to(ROOT)
        for folder in folders
        for ending in endings
        for path in sorted((ROOT / folder).rglob(f"*{ending}"))
        if "target" not in path.parts
    ]
    if not found:
        raise TaskError(f"no {', '.join(endings)} file in {', '.join(folders)}")
    return found


def setup() -> None:
    """Makes .venv; again only if requirements.txt or the Python version has changed."""
    if sys.version_info < (3, 11):  # noqa: UP036 - whoever starts it may have an older one
        raise TaskError(f"Python 3.11 or newer is needed, this is {sys.version.split()[0]}: install it from python.org")
    stamp = VENV / "installed.txt"
    wanted = f"# Python {sys.version_info.major}.{sys.version_info.minor}\n{REQUIREMENTS.read_text(encoding='utf-8')}"
    if stamp.is_file() and stamp.read_text(encoding="utf-8") == wanted:
        return
    try:
        import ensurepip  # noqa: F401
    except ImportError as error:
        raise TaskError("this Python has no venv module: apt install python3-venv (Debian, Ubuntu)") from error
    run(sys.executable, "-m", "venv", "--clear", VENV)
    run(PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement", REQUIREMENTS)
    stamp.write_text(wanted, encoding="utf-8")


def pack() -> None:
    """Builds the library and packs every model as an FMU into dist/, and the four-post rig as SSP package."""
    need_rust()
    run("cargo", "run", "--package", "fmu-build", "--", "pack", "--out", "dist")
    run("cargo", "run", "--package", "fmu-build", "--", "ssp", "--out", "dist")


def demo() -> None:
    """Packs the FMUs and runs each of them from Python."""
    setup()
    pack()
    run(PYTHON, "examples/fmpy/demo.py")


def check_style() -> None:
    """Formatting and lints of all languages. `cargo fmt` does not see modules declared in a macro, rustfmt does."""
    run("rustfmt", "--check", "--edition", "2024", *files(RUST_FOLDERS, ".rs"))
    run(PYTHON, "-m", "ruff", "format", "--check", *PYTHON_FOLDERS)
    run(PYTHON, "-m", "ruff", "check", *PYTHON_FOLDERS)
    run(PROGRAMS / "clang-format", "--dry-run", "-Werror", *files(C_FOLDERS, ".c", ".cpp", ".h"))
    run("cargo", "clippy", "--workspace", "--all-targets", "--", "--deny", "warnings")


def test() -> None:
    """Every check and test, the fast ones first."""
    need_rust()
    need_c_compiler()
    for program in ("rustfmt", "cargo-clippy"):
        need(program, "rustup component add rustfmt clippy")
    setup()
    check_style()
    run("cargo", "test", "--workspace")
    run("cargo", "doc", "--no-deps", "--workspace", RUSTDOCFLAGS="-Dwarnings")
    run("cargo", "run", "--package", "fmu-build", "--", "check")
    pack()
    run(PYTHON, "tests/c/run.py")
    run(PYTHON, "-m", "pytest", "tests/python")


def bench() -> None:
    """The benchmarks."""
    need_rust()
    run("cargo", "bench")


def clean() -> None:
    """Removes everything that the tasks have made."""
    for folder in (VENV, ROOT / "dist", ROOT / "out", ROOT / "target"):
        print(f"removing {folder}")
        shutil.rmtree(folder, ignore_errors=True)


# What each task does, as it says when it starts. The times are those of a first run on two cores.
TASKS = {
    demo: "install the Python packages, build and pack the FMUs, run each of them, draw the results: 2 to 4 minutes, "
    "then under one",
    test: "check formatting and lints, run the Rust, C and Python tests: 5 to 10 minutes, then about 3",
    bench: "build and run the benchmarks: 2 to 5 minutes",
    pack: "build the library and pack every model as an FMU into dist/: 1 to 2 minutes",
    setup: "install the Python packages of requirements.txt into .venv: about a minute",
    clean: "remove .venv, dist, out and target",
}


def main() -> int:
    tasks = {task.__name__: task for task in TASKS}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=tasks)
    task = tasks[parser.parse_args().task]
    print(f"{task.__name__}: {TASKS[task]}.", flush=True)
    try:
        task()
    except TaskError as error:
        print(f"\n{task.__name__} failed: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"\n{task.__name__} interrupted", file=sys.stderr)
        return 130
    print(f"\n{task.__name__}: done.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
