"""The program `stribeck` of the same build, for comparison."""

import os
import subprocess
from pathlib import Path

from coupling import PROJECT


def program(*arguments):
    """Runs it; an error if it fails."""
    binaries = Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target")) / "debug"
    return subprocess.run([binaries / "stribeck", *arguments], capture_output=True, text=True, check=True)
