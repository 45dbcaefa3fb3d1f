#!/usr/bin/env python3
"""Runs tests of the Python package with the address sanitizer in the extension module.

    python3 tests/sanitized.py    needs nightly Rust and gcc; `python3 tasks.py faults` runs it

First a deliberately short array, which the sanitizer must see: otherwise everything would pass. Leaks are not looked
for here, as Python keeps memory until its end; a test of the package measures them.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
TARGET = "x86_64-unknown-linux-gnu"
BUILD = ROOT / "target" / "sanitized"
PACKAGE = ROOT / "out" / "sanitized"
TESTS = [f"tests/python/test_{name}.py" for name in ("package", "identification", "batch", "stepped")]
# Those run the command line, which has no sanitizer, or ask processes of their own for FMUs.
LEFT_OUT = "not command_line and not many_processes"

# A block of eight numbers that is said to hold a thousand.
SHORT = """
import ctypes, numpy, stribeck
block = (ctypes.c_double * 8)()
short = numpy.ctypeslib.as_array(ctypes.cast(block, ctypes.POINTER(ctypes.c_double)), shape=(1000,))
stribeck.simulate("LuGre", velocity=short, normal_force=1.0, dt=1e-3)
"""


def build() -> None:
    """Puts the package together from the packed FMUs, with an instrumented extension module."""
    settings = {
        **os.environ,
        "RUSTFLAGS": "-Zsanitizer=address -Cunsafe-allow-abi-mismatch=sanitizer",
        "CARGO_TARGET_DIR": str(BUILD),
        "CARGO_INCREMENTAL": "0",
    }
    cargo = ["cargo", "+nightly", "build", "--package", "stribeck-python", "--target", TARGET]
    subprocess.run(cargo, cwd=ROOT, env=settings, check=True)
    folder = PACKAGE / "stribeck"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "python" / "stribeck", folder, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copyfile(BUILD / TARGET / "debug" / "lib_stribeck.so", folder / "_stribeck.abi3.so")
    subprocess.run([sys.executable, "python/fmus.py", "dist", folder / "fmus"], cwd=ROOT, check=True)


def main() -> int:
    """Runs all of it; the exit code of the tests."""
    build()
    # The runtime looks for C++'s exceptions when it starts, before a module of Python brings them.
    libraries = [
        subprocess.run(["gcc", f"-print-file-name={name}"], capture_output=True, text=True, check=True).stdout.strip()
        for name in ("libasan.so", "libstdc++.so.6")
    ]
    settings = {
        **os.environ,
        "LD_PRELOAD": " ".join(libraries),
        "ASAN_OPTIONS": "detect_leaks=0:detect_stack_use_after_return=1:allocator_may_return_null=1",
        # Otherwise Python takes memory in large blocks, within which nothing is seen.
        "PYTHONMALLOC": "malloc",
        "PYTHONPATH": str(PACKAGE),
    }
    done = subprocess.run([sys.executable, "-c", SHORT], env=settings, capture_output=True, text=True)
    if done.returncode == 0 or "heap-buffer-overflow" not in done.stderr:
        print(f"the address sanitizer does not see a short array\n{done.stderr}")
        return 1
    print("figure: address sanitizer in the extension module: a deliberately short array is seen", flush=True)
    folders = f"pythonpath={PACKAGE} ."
    tests = [sys.executable, "-m", "pytest", "-q", "-o", folders, "-k", LEFT_OUT, *TESTS]
    return subprocess.run(tests, cwd=ROOT, env=settings).returncode


if __name__ == "__main__":
    sys.exit(main())
