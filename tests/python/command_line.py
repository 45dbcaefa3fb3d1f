"""The programs as a user starts them: `stribeck` of the same build, and the examples."""

import os
import subprocess
import sys
from pathlib import Path

from examples.fmpy.coupling import PROJECT


def program(*arguments):
    """Runs it; an error if it fails."""
    binaries = Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target")) / "debug"
    return subprocess.run([binaries / "stribeck", *arguments], capture_output=True, text=True, check=True)


def run_example(module: str, *options: str, folder: Path) -> subprocess.CompletedProcess:
    """Runs a program of the examples in a folder; it finds the packages where this process does."""
    command = [sys.executable, "-m", f"examples.{module}", *options]
    found = {**os.environ, "PYTHONPATH": os.pathsep.join([str(PROJECT), str(PROJECT / "out" / "package")])}
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300, env=found)
