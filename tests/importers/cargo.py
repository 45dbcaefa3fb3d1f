#!/usr/bin/env python3
"""Runs cargo for tests/importers, with the libclang of requirements.txt, which the crate fmi needs to build.

.venv/bin/python tests/importers/cargo.py build
"""

import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

FOLDER = Path(__file__).resolve().parent


def libclang() -> Path:
    """The folder of the library."""
    package = find_spec("clang")
    if package is None or not package.submodule_search_locations:
        sys.exit("libclang not found: install requirements.txt (`python3 tasks.py setup`)")
    return Path(package.submodule_search_locations[0]) / "native"


def environment() -> dict[str, str]:
    """The variables that lint the crate while it is built, and give its build the path of libclang and the compiler's
    own headers, which it lacks."""
    linted = {**os.environ, "RUSTC_WORKSPACE_WRAPPER": "clippy-driver"}
    if "LIBCLANG_PATH" in os.environ:
        return linted
    command = [os.environ.get("CC", "cc"), "-print-file-name=include"]
    headers = subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
    return {**linted, "LIBCLANG_PATH": str(libclang()), "BINDGEN_EXTRA_CLANG_ARGS": f'-I"{headers}"'}


def main(task: str, *arguments: str) -> int:
    """Runs cargo; its output is with everything else in target."""
    target = os.environ.get("CARGO_TARGET_DIR", FOLDER.parents[1] / "target")
    command = ["cargo", task, "--locked", "--manifest-path", FOLDER / "Cargo.toml", "--target-dir", target]
    return subprocess.run([*command, *arguments], env=environment()).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
