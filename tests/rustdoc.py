#!/usr/bin/env python3
"""In place of rustdoc in `cargo test`, as RUSTDOC: runs the examples of a crate, then writes its pages, from what was
compiled for the tests; `cargo doc` would check all dependencies again. A broken link is an error."""

import subprocess
import sys

# Options that only tests have, and how many words follow each.
OF_TESTS = {"--test": 0, "--test-run-directory": 1, "--test-args": 1}


def without(options: dict[str, int], words: list[str]) -> list[str]:
    """The words but for these options."""
    kept: list[str] = []
    following = iter(words)
    for word in following:
        if word in options:
            for _ in range(options[word]):
                next(following)
        else:
            kept.append(word)
    return kept


def main(*words: str) -> int:
    """Runs rustdoc once, and after tests that passed once more."""
    status = subprocess.run(["rustdoc", *words]).returncode
    if status != 0 or "--test" not in words:
        return status
    pages = [*without(OF_TESTS, list(words)), "--deny", "warnings", "--out-dir", "target/doc"]
    return subprocess.run(["rustdoc", *pages]).returncode


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
