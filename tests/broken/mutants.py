#!/usr/bin/env python3
"""Changes the friction laws in many small ways and counts how many of these mutants the tests notice.

    python3 tests/broken/mutants.py              every 13th mutant that cargo-mutants knows of src/friction
    python3 tests/broken/mutants.py --survivors  those that the last run has missed

`python3 tasks.py mutants` installs cargo-mutants and runs this. cargo-mutants says what to change; but it would build
the library once for each mutant, which takes hours. Here all mutants are in one build: each changed function holds its
changed bodies beside its own, and the environment variable MUTANT chooses one. Nothing else of the library is changed.
A mutant that does not compile counts for nothing. One that a test fails on, or that takes several times the processor
time of the whole library, is caught.
"""

import argparse
import collections
import json
import os
import re
import resource
import signal
import subprocess
import sys

from project_copy import ProjectCopy, errors

SHARD = "0/13"
SMALLEST_SAMPLE = 200
SMALLEST_SHARE = 0.8
TESTS = [
    "published",
    "published_memoryless",
    "published_lag",
    "published_hysteresis",
    "published_presliding",
    "contract",
]

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
    """cargo-mutants does not see modules that a macro declares. These lines are for it alone."""
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
    for number, mutant in enumerate(found, start=1):
        mutant["number"] = number
    return found


def offset(lines, place):
    """Index in the text of a place given by line and column, both from 1."""
    return sum(len(line) for line in lines[: place["line"] - 1]) + place["column"] - 1


def as_one_type(text, return_type):
    """The signature and a wrapper for its bodies: two iterators of `impl Iterator` must become of one type."""
    kind = return_type.removeprefix("-> ")
    if not kind.startswith("impl "):
        return text, "{}"
    boxed = f"Box<dyn {kind.removeprefix('impl ')} + '_>"
    return text.replace(return_type, f"-> {boxed}"), "{{ let boxed: " + boxed + " = Box::new({}); boxed }}"


def with_mutants(text, mutants):
    """The text of a file in which each changed function chooses its body."""
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
    """Puts those mutants into the copy that compile."""
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


def seconds_of_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def first_failure(command, folder, limit=resource.RLIM_INFINITY, **environment):
    """Runs a test program until a test fails. Says how it ended, None if well."""

    def bounded():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, resource.RLIM_INFINITY))

    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, "text": True}
    settings = {**os.environ, **environment}
    with subprocess.Popen(command, cwd=folder, env=settings, preexec_fn=bounded, **pipes) as test:
        for line in test.stdout:
            if line.rstrip().endswith("... FAILED"):
                test.kill()
                return line.split()[1]
        status = test.wait()
    if status == -signal.SIGXCPU:
        return "timeout"
    return None if status == 0 else f"exit code {status}"


class Test:
    """One test: which of the changed functions it calls, and the processor time it takes without a mutant."""

    def __init__(self, program, name, folder):
        self.program = program
        self.name = name
        reached = folder / "reached.txt"
        reached.write_text("", encoding="utf-8")
        before = seconds_of_children()
        failure = first_failure([program, "--exact", name], folder, REACHED=str(reached))
        if failure is not None:
            sys.exit(f"{name} fails without a mutant: {failure}")
        self.seconds = seconds_of_children() - before
        self.reached = {int(number) for number in reached.read_text(encoding="utf-8").split()}


class Suite:
    """All tests."""

    def __init__(self, copy):
        self.folder = copy.root
        programs = copy.build_tests(TESTS)
        if programs is None:
            sys.exit(f"the tests do not build in {copy.root}")
        self.tests = [test for program in programs.values() for test in self.tests_of(program)]
        self.tests.sort(key=lambda test: test.seconds)

    def tests_of(self, program):
        listed = subprocess.run([program, "--list"], cwd=self.folder, check=True, capture_output=True, text=True)
        names = re.findall(r"^(\S+): test$", listed.stdout, re.MULTILINE)
        return [Test(program, name, self.folder) for name in names]

    def verdict(self, mutant):
        """The test that notices the mutant, None if none does. Only a test that calls its function can."""
        for test in self.tests:
            if mutant["function_number"] in test.reached:
                limit = 10 + round(5 * test.seconds)
                command = [test.program, "--exact", test.name]
                failure = first_failure(command, self.folder, limit, MUTANT=str(mutant["number"]))
                if failure is not None:
                    return test.name if failure == test.name else f"{test.name}: {failure}"
        return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--survivors", action="store_true", help="only those that the last run has missed")
    only_survivors = parser.parse_args().survivors
    copy = ProjectCopy("mutants")
    record = copy.out / "outcomes.json"
    outcomes = json.loads(record.read_text(encoding="utf-8")) if only_survivors else {}
    # cargo-mutants names a mutant by its place, so the laws must not have changed since the last run.
    sample = [mutant for mutant in find_mutants(copy) if outcomes.get(mutant["name"]) is None]
    mutants = viable_mutants(copy, sample)
    print(f"{len(sample)} mutants, {len(sample) - len(mutants)} of them do not compile", flush=True)
    suite = Suite(copy)
    print(f"{len(suite.tests)} tests, {sum(test.seconds for test in suite.tests):.0f} s without a mutant", flush=True)
    for mutant in mutants:
        outcomes[mutant["name"]] = verdict = suite.verdict(mutant)
        print(f"{'MISSED' if verdict is None else 'caught'}  {mutant['name']}  [{verdict}]", flush=True)
        record.write_text(json.dumps(outcomes, indent=1), encoding="utf-8")
    caught = sum(verdict is not None for verdict in outcomes.values())
    slow = sum(verdict is not None and verdict.endswith("timeout") for verdict in outcomes.values())
    share = caught / len(outcomes)
    print(f"{len(outcomes)} mutants, {caught} caught ({slow} of them by their time): {100 * share:.1f} %")
    return 0 if len(outcomes) >= SMALLEST_SAMPLE and share >= SMALLEST_SHARE else 1


if __name__ == "__main__":
    sys.exit(main())
