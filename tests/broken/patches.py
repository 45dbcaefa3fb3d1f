#!/usr/bin/env python3
"""Deliberately breaks copies of the library, one mistake each, and shows which tests fail.

    python3 tests/broken/patches.py    or: python3 tasks.py broken

The mistakes are the patches beside this file: a wrong sign in one law, a missing NULL check in the FMI layer, a saved
state that lacks a column. Fails if a patch no longer applies, or if no test detects it.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

from project_copy import ProjectCopy

HERE = Path(__file__).resolve().parent
TESTS = ["fmi", "models"]
SLOWEST = 600  # seconds of one test program
SHOWN = 12


def break_copy(copy, patch):
    """Applies a patch to a new copy."""
    copy.renew()
    # Hidden from git, which would otherwise look for the files in the project that contains the copy.
    hidden = {**os.environ, "GIT_CEILING_DIRECTORIES": str(copy.out)}
    done = subprocess.run(["git", "apply", patch], cwd=copy.root, env=hidden, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{patch.name} does not apply: {done.stderr}")


def failures(program, folder):
    """The tests of a program that fail; the last one may have ended the process."""
    # One after another, so that a crash can be attributed to a test.
    command = [program, "--test-threads=1"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=SLOWEST)
    ended = dict(re.findall(r"^test (\S+) \.\.\. ?(.*)$", done.stdout, re.MULTILINE))
    failed = [f"{name} ({end or f'exit code {done.returncode}'})" for name, end in ended.items() if end != "ok"]
    if done.returncode != 0 and not failed:
        return [f"exit code {done.returncode}"]
    return failed


def noticed(copy):
    """The tests that fail in the copy, of all programs."""
    programs = copy.build_tests(TESTS)
    if programs is None:
        sys.exit(f"the tests do not build in {copy.root}")
    return [f"{name}: {test}" for name, program in programs.items() for test in failures(program, copy.root)]


def main():
    copy = ProjectCopy("broken")
    sound = noticed(copy)
    if sound:
        sys.exit(f"tests fail in a copy that is not broken: {sound}")
    missed = []
    for patch in sorted(HERE.glob("*.patch")):
        break_copy(copy, patch)
        found = noticed(copy)
        print(f"figure: {patch.stem}: {len(found)} tests fail", flush=True)
        for line in found[:SHOWN]:
            print(f"    {line}")
        if len(found) > SHOWN:
            print(f"    and {len(found) - SHOWN} more")
        if not found:
            missed.append(patch.stem)
    if missed:
        sys.exit(f"not detected: {', '.join(missed)}")


if __name__ == "__main__":
    main()
