#!/usr/bin/env python3
"""Changes the friction laws in many small ways and counts how many of these mutants the tests catch.

    python3 tests/broken/mutants.py              every 13th mutant that cargo-mutants knows of src/friction
    python3 tests/broken/mutants.py --survivors  those that the last run missed

`python3 tasks.py mutants` installs cargo-mutants and runs this. cargo-mutants lists the changes, but it would build the
library once for each mutant, which takes hours. Here all mutants are in one build: each changed function contains its
changed bodies beside its own, and the environment variable MUTANT selects one. Nothing else of the library is changed.
A mutant that does not compile is not counted. One that makes a test fail, or that takes several times the processor
time of the whole library, is caught.
"""

import argparse
import collections
import json
import os
import random
import re
import signal
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

from project_copy import ProjectCopy, errors

SHARD = "0/13"
SMALLEST_SAMPLE = 200
SMALLEST_SHARE = 0.88
TESTS = ["models"]

SILENT = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}

SWITCH = """
/// Which mutant is active; 0 is none. A changed function asks at each call: if REACHED names a file, the numbers of all
/// functions that were called are written there.
pub(crate) fn mutant(function: usize) -> u32 {
    use std::io::Write;
    use std::sync::atomic::{AtomicBool, Ordering};
    static MUTANT: std::sync::LazyLock<u32> =
        std::sync::LazyLock::new(|| std::env::var("MUTANT").map_or(0, |number| number.parse().unwrap()));
    static REACHED: std::sync::LazyLock<Option<std::fs::File>> = std::sync::LazyLock::new(|| {
        let path = std::env::var_os("REACHED")?;
        Some(std::fs::OpenOptions::new().create(true).append(true).open(path).unwrap())
    });
    static KNOWN: [AtomicBool; 4096] = [const { AtomicBool::new(false) }; 4096];
    if let Some(mut file) = REACHED.as_ref() {
        if !KNOWN[function].swap(true, Ordering::Relaxed) {
            file.write_all(format!("{function}\\n").as_bytes()).unwrap();
        }
    }
    *MUTANT
}
"""


def declare_modules(copy):
    """cargo-mutants does not see modules declared by a macro. These lines are only for it."""
    folder = copy.root / "src" / "friction"
    declaration = folder / "mod.rs"
    text = declaration.read_text(encoding="utf-8")
    known = set(re.findall(r"^mod (\w+);", text, re.MULTILINE))
    laws = sorted({path.stem for path in folder.glob("*.rs")} - known - {"mod"})
    declaration.write_text(text + "".join(f"#[cfg(any())]\nmod {law};\n" for law in laws), encoding="utf-8")


def find_mutants(copy):
    """The sample, as cargo-mutants describes it: spread evenly over the files."""
    declare_modules(copy)
    options = ["--package", "stribeck", "--file", "src/friction/**", "--shard", SHARD, "--sharding", "round-robin"]
    command = ["cargo", "mutants", "--list", "--json", *options]
    found = json.loads(subprocess.run(command, cwd=copy.root, check=True, capture_output=True, text=True).stdout)
    # The value of a constant exists before a switch can select it.
    found = [mutant for mutant in found if mutant["function"]]
    for number, mutant in enumerate(found, start=1):
        mutant["number"] = number
    return found


def offset(lines, place):
    """Index in the text of a position given by line and column, both from 1."""
    return sum(len(line) for line in lines[: place["line"] - 1]) + place["column"] - 1


def as_one_type(text, return_type):
    """The signature and a wrapper for its bodies: two iterators of `impl Iterator` must get the same type."""
    kind = return_type.removeprefix("-> ")
    if not kind.startswith("impl "):
        return text, "{}"
    boxed = f"Box<dyn {kind.removeprefix('impl ')} + '_>"
    return text.replace(return_type, f"-> {boxed}"), "{{ let boxed: " + boxed + " = Box::new({}); boxed }}"


def with_mutants(text, mutants):
    """The text of a file in which each changed function selects its body."""
    lines = text.splitlines(keepends=True)
    functions = collections.defaultdict(list)
    for mutant in mutants:
        span = mutant["function"]["span"]
        functions[offset(lines, span["start"]), offset(lines, span["end"])].append(mutant)
    parts = []
    done = 0
    for (start, end), here in sorted(functions.items(), key=lambda item: item[0]):
        body = text.index("{", start)
        signature, wrapper = as_one_type(text[start:body], here[0]["function"]["return_type"])
        # A function has the number of its first mutant.
        number = here[0]["number"]
        parts += [text[done:start], signature, f"{{ match crate::mutant({number}) {{\n"]
        for mutant in here:
            mutant["function_number"] = number
            first, last = (offset(lines, mutant["span"][side]) for side in ("start", "end"))
            changed = text[body:first] + mutant["replacement"] + text[last:end]
            parts.append(f"/* mutant {mutant['number']} */ {mutant['number']} => {wrapper.format(changed)}\n")
        parts.append(f"/* mutant 0 */ _ => {wrapper.format(text[body:end])}\n}} }}")
        done = end
    return "".join([*parts, text[done:]])


def write_mutants(copy, mutants):
    """Puts the mutants into the copy of the project."""
    copy.renew()
    library = copy.root / "src" / "lib.rs"
    library.write_text(library.read_text(encoding="utf-8") + SWITCH, encoding="utf-8")
    files = collections.defaultdict(list)
    for mutant in mutants:
        files[mutant["file"]].append(mutant)
    for name, here in files.items():
        path = copy.root / name
        path.write_text(with_mutants(path.read_text(encoding="utf-8"), here), encoding="utf-8")


def mutant_at(copy, place):
    """The number of the mutant in which the compiler found an error."""
    lines = (copy.root / place["file_name"]).read_text(encoding="utf-8").splitlines()
    marks = re.findall(r"/\* mutant (\d+) \*/", "\n".join(lines[: place["line_start"]]))
    return int(marks[-1]) if marks else 0


def viable_mutants(copy, mutants):
    """Puts the mutants that compile into the copy."""
    while True:
        write_mutants(copy, mutants)
        messages, succeeded = copy.cargo("check", "--package", "stribeck", "--lib")
        if succeeded:
            return mutants
        found = errors(messages)
        wrong = {mutant_at(copy, place) for error in found for place in error["spans"] if place["is_primary"]}
        if not wrong or 0 in wrong:
            sys.exit(f"the copy does not build\n{''.join(error['rendered'] for error in found)}")
        mutants = [mutant for mutant in mutants if mutant["number"] not in wrong]


def run_test(command, folder, limit=3600, **environment):
    """Runs a test with a limit on processor seconds. Returns how it failed, or None, and the seconds it took."""
    bounded = ["sh", "-c", 'ulimit -S -t "$0" && exec "$@"', str(limit), *command]
    settings = {**os.environ, **environment}
    with subprocess.Popen(bounded, cwd=folder, env=settings, **SILENT) as test:
        _, status, usage = os.wait4(test.pid, 0)
        test.returncode = os.waitstatus_to_exitcode(status)
    failure = {0: None, -signal.SIGXCPU: "timeout"}.get(test.returncode, f"exit code {test.returncode}")
    return failure, usage.ru_utime + usage.ru_stime


class Test:
    """One test: which of the changed functions it calls, and the processor time it takes without a mutant."""

    def __init__(self, command, folder):
        self.command = command
        self.folder = folder
        self.name = command[-1]
        with tempfile.NamedTemporaryFile("r", encoding="utf-8") as reached:
            failure, self.seconds = run_test(command, folder, REACHED=reached.name)
            self.reached = {int(number) for number in reached.read().split()}
        if failure is not None:
            raise RuntimeError(f"{self.name} fails without a mutant: {failure}")

    def failure(self, mutant):
        limit = 10 + round(5 * self.seconds)
        return run_test(self.command, self.folder, limit, MUTANT=str(mutant["number"]))[0]


def commands(program, folder):
    """One command for each test of a program."""
    listed = subprocess.run([program, "--list"], cwd=folder, check=True, capture_output=True, text=True)
    return [[program, "--exact", name] for name in re.findall(r"^(\S+): test$", listed.stdout, re.MULTILINE)]


def verdict(tests, mutant):
    """The test that catches the mutant, or None. Only a test that calls its function can."""
    for test in tests:
        if mutant["function_number"] in test.reached:
            failure = test.failure(mutant)
            if failure is not None:
                return f"{test.name}: {failure}"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--survivors", action="store_true", help="only those that the last run missed")
    only_survivors = parser.parse_args().survivors
    copy = ProjectCopy("mutants")
    record = copy.out / "outcomes.json"
    outcomes = json.loads(record.read_text(encoding="utf-8")) if only_survivors else {}
    # cargo-mutants names a mutant by its place, so the laws must not have changed since the last run.
    sample = [mutant for mutant in find_mutants(copy) if outcomes.get(mutant["name"]) is None]
    mutants = viable_mutants(copy, sample)
    print(f"{len(sample)} mutants, {len(sample) - len(mutants)} of them do not compile", flush=True)
    programs = copy.build_tests(TESTS)
    if programs is None:
        sys.exit(f"the tests do not build in {copy.root}")
    every = [command for program in programs.values() for command in commands(program, copy.root)]
    # In random order the first ones are also a fair sample.
    random.Random(1).shuffle(mutants)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        tests = sorted(pool.map(lambda command: Test(command, copy.root), every), key=lambda test: test.seconds)
        print(f"{len(tests)} tests, {sum(test.seconds for test in tests):.0f} s without a mutant", flush=True)
        for mutant, found in zip(mutants, pool.map(lambda mutant: verdict(tests, mutant), mutants), strict=True):
            outcomes[mutant["name"]] = found
            print(f"{'MISSED' if found is None else 'caught'}  {mutant['name']}  [{found}]", flush=True)
            record.write_text(json.dumps(outcomes, indent=1), encoding="utf-8")
    caught = sum(verdict is not None for verdict in outcomes.values())
    slow = sum(verdict is not None and verdict.endswith("timeout") for verdict in outcomes.values())
    share = caught / len(outcomes)
    print(f"figure: {len(outcomes)} mutants, {caught} caught ({slow} of them by their time): {100 * share:.1f} %")
    return 0 if len(outcomes) >= SMALLEST_SAMPLE and share >= SMALLEST_SHARE else 1


if __name__ == "__main__":
    sys.exit(main())
