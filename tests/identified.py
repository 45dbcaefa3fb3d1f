#!/usr/bin/env python3
"""Counts how often the intervals of an identification hold the truth; `python3 tasks.py identified` runs it.

The intervals that were counted are kept for as long as the sources are the same, so that a run that was ended goes on
where it was.
"""

import hashlib
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
FOLDERS = ["src", "lab/fit/src/identify", "lab/measured/src", "lab/fit/benches"]


def kept() -> Path:
    """The file of the intervals that were counted with these sources."""
    sources = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.rs"))]
    sources.append(ROOT / "lab/fit/src/rig.rs")
    state = hashlib.sha256(b"".join(path.read_bytes() for path in sources)).hexdigest()[:16]
    return ROOT / "target" / "identified" / f"{state}.csv"


def main() -> int:
    file = kept()
    file.parent.mkdir(parents=True, exist_ok=True)
    bench = ["cargo", "bench", "--package", "stribeck-fit", "--bench", "identify", *sys.argv[1:]]
    return subprocess.run(bench, cwd=ROOT, env={**os.environ, "IDENTIFIED": str(file)}).returncode


if __name__ == "__main__":
    sys.exit(main())
