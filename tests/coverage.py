#!/usr/bin/env python3
"""Prints the share of the library's code and branches that the tests cover. Fails below the limits.

    .venv/bin/python tests/coverage.py    after `cargo llvm-cov --no-report`; `python3 tasks.py coverage` does both

Also runs the C tests, with the instrumented library. A generic function exists once for each number type and model, and
all code twice, with and without the unit tests; a place in the source is covered if any of its instances is. Each
condition has two branches, true and false. The compiler does not count the arms of a `match` as branches, so the share
of the code, in pieces without a fork, is printed too. Test code is excluded, and so is a `const fn` that only the
compiler runs, where nothing can be counted. Lists the branches that no test takes.
"""

import collections
import itertools
import json
import os
import re
import subprocess
import sys
from pathlib import Path

from c.run import headers_of_fmi_3

ROOT = Path(__file__).resolve().parents[1]
SOURCES = [ROOT / "src", ROOT / "ffi" / "src"]
TARGET = ROOT / "target" / "llvm-cov-target"
PROGRAMS = TARGET / "debug" / "deps"
LIBRARY = TARGET / "debug" / "libstribeck.so"
# The foreign-function interfaces, and code that only they need.
FOREIGN = {"ffi", "memory.rs"}
TEST_CODE = {"ffi/src/fmi2/tests.rs", "ffi/src/fmi3/tests.rs", "ffi/src/probe.rs"}
LIMITS = {"core": 95.0, "FFI": 90.0}
CODE = 0  # kind of a region that is code; others are gaps, skipped text and expansions


def succeed(*command, **environment):
    """Runs a command that must succeed and returns its output."""
    words = [str(word) for word in command]
    return subprocess.run(
        words, check=True, stdout=subprocess.PIPE, env={**os.environ, **environment}, text=True
    ).stdout


def run_c_tests():
    """The C interface and the FMI functions, as C programs use them. Failed checks end these programs with an error."""
    # Beside the objects of the tests, which use no shared library.
    counted = {"RUSTFLAGS": "-Cinstrument-coverage -Zcoverage-options=branch", "LLVM_PROFILE_FILE": os.devnull}
    succeed("cargo", "build", "--package", "libstribeck", "--target-dir", TARGET, RUSTC_BOOTSTRAP="1", **counted)
    compiler = [os.environ.get("CC", "cc"), "-std=gnu99", "-O1", f"-I{ROOT / 'include'}"]
    compiler += ["-isystem", headers_of_fmi_3()]
    counters = str(TARGET / "c-tests-%p.profraw")
    for name, linked, arguments in [
        ("api_test", [LIBRARY, f"-Wl,-rpath,{LIBRARY.parent}"], []),
        ("fmi_test", [], [LIBRARY]),
        ("fmi3_test", [], [LIBRARY]),
    ]:
        program = TARGET / name
        succeed(*compiler, ROOT / "tests" / "c" / f"{name}.c", *linked, "-lm", "-ldl", "-o", program)
        succeed(program, *arguments, LLVM_PROFILE_FILE=counters)


def functions():
    """The covered code of each program, one after another, because functions of the same name in two of them differ."""
    compiler = succeed("rustc", "--version", "--verbose")
    host = re.search(r"^host: (\S+)$", compiler, re.MULTILINE)[1]
    tools = Path(succeed("rustc", "--print", "sysroot").strip()) / "lib" / "rustlib" / host / "bin"
    counted = TARGET / "all.profdata"
    succeed(tools / "llvm-profdata", "merge", *TARGET.glob("*.profraw"), "-o", counted)
    programs = [path for path in PROGRAMS.iterdir() if not path.suffix and os.access(path, os.X_OK) and path.is_file()]
    for program in [LIBRARY, *programs]:
        export = succeed(tools / "llvm-cov", "export", "-format=text", f"-instr-profile={counted}", program)
        for part in json.loads(export)["data"]:
            yield from part["functions"]


class Covered:
    """Pieces of code and branches: number of executions by place."""

    def __init__(self):
        self.code = collections.Counter()
        self.branches = collections.Counter()

    def line(self, name):
        shares = [f"{100 * share(counts):6.1f} % of {len(counts):5}" for counts in (self.code, self.branches)]
        return f"{name:20} {shares[0]}   {shares[1]}"


def share(counts):
    return sum(count > 0 for count in counts.values()) / len(counts) if counts else 1.0


def code_lines(path):
    """The lines before the tests at the end of a file."""
    lines = path.read_text(encoding="utf-8").splitlines()
    for number, (line, following) in enumerate(itertools.pairwise(lines)):
        if line == "#[cfg(test)]" and following.startswith("mod tests"):
            return lines[:number]
    return lines


class Measured:
    """The files of the library, and their covered code."""

    def __init__(self, functions):
        self.files = collections.defaultdict(Covered)
        self.lines = {}
        instances = collections.defaultdict(list)
        for function in functions:
            instances[self.name(function["filenames"][0]), *function["regions"][0][:2]].append(function)
        self.compiled = [place for place, same in instances.items() if self.is_only_compiled(place, same)]
        for place in instances.keys() - self.compiled:
            for function in instances[place]:
                self.add(function)

    def is_only_compiled(self, place, functions):
        """Whether only the compiler runs this function."""
        name, line, _ = place
        is_const = self.is_code(name, line) and "const fn " in self.lines[name][line - 1]
        return is_const and not any(function["count"] for function in functions)

    def add(self, function):
        names = [self.name(file) for file in function["filenames"]]
        for first, column, last, end, count, file, _, kind in function["regions"]:
            if kind == CODE and self.is_code(names[file], first):
                self.files[names[file]].code[first, column, last, end] += count
        for first, column, last, end, true, false, file, *_ in function["branches"]:
            if self.is_code(names[file], first):
                branches = self.files[names[file]].branches
                branches[first, column, last, end, True] += true
                branches[first, column, last, end, False] += false

    @staticmethod
    def name(file):
        """The path in the project of a file of the library; None for another file."""
        path = Path(file)
        return path.relative_to(ROOT).as_posix() if any(map(path.is_relative_to, SOURCES)) else None

    def is_code(self, name, line):
        if name is None or name in TEST_CODE:
            return False
        if name not in self.lines:
            self.lines[name] = code_lines(ROOT / name)
        return line <= len(self.lines[name])

    def total(self, choice):
        """Sum over the files selected by `choice`."""
        sum_of_files = Covered()
        for name, covered in self.files.items():
            if choice(name):
                sum_of_files.code.update({(name, *place): count for place, count in covered.code.items()})
                sum_of_files.branches.update({(name, *place): count for place, count in covered.branches.items()})
        return sum_of_files

    def missed(self):
        for name, covered in sorted(self.files.items()):
            for (first, column, _, _, side), count in sorted(covered.branches.items()):
                if count == 0:
                    yield f"{name}:{first}:{column} is never {str(side).lower()}"


def folder(name):
    """The folder of a file below src, or the file itself; ffi for the crate of that name."""
    top, below, *_ = name.split("/")
    return below if top == "src" else top


def main():
    run_c_tests()
    measured = Measured(functions())
    print("\n".join(measured.missed()))
    print(f"\n{len(measured.compiled)} functions are run only by the compiler.\n")
    print(f"{'':20} {'pieces of code':18}   branches")
    for name in sorted({folder(name) for name in measured.files}):
        print(measured.total(lambda file, name=name: folder(file) == name).line(name))
    failed = []
    for part, limit in LIMITS.items():
        total = measured.total(lambda file, part=part: (folder(file) in FOREIGN) == (part == "FFI"))
        print(f"figure: {total.line(part)}")
        if not total.branches or 100 * share(total.branches) < limit:
            failed.append(f"{part}: fewer than {limit:.0f} % of the branches")
    return "\n".join(failed) or 0


if __name__ == "__main__":
    sys.exit(main())
