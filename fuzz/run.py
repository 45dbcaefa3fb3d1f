#!/usr/bin/env python3
"""Builds the fuzz targets with coverage instrumentation and runs them. Needs Rust, a C++ compiler and Linux.

    python3 fuzz/run.py                   replay the corpus, then a fixed number of new inputs: the same ones each time
    python3 fuzz/run.py --long 300        new inputs for 300 seconds per target, under the address sanitizer too
    python3 fuzz/run.py --keep            take into the corpus what long runs have found, as few inputs as cover it all
    python3 fuzz/run.py --long 60 fmi     one target
    python3 fuzz/run.py --lint            clippy, and nothing else

An input that fails is in target/fuzz/found; `cargo fuzz fmt`, or RUST_LIBFUZZER_DEBUG_PATH=FILE and the program with
that input, says what calls it stands for. The layout is that of cargo-fuzz, which runs the targets too:
`cargo +nightly fuzz run fmi`.
"""

import argparse
import ctypes
import os
import platform
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
CORPUS = FOLDER / "corpus"
OUT = Path(os.environ.get("CARGO_TARGET_DIR", FOLDER.parent / "target")) / "fuzz"

# What cargo-fuzz gives to rustc: counters of branches, their places, and the operands of comparisons.
COVERAGE = [
    "--cfg=fuzzing",
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
]
# The stable compiler brings the runtime of the sanitizer, but calls the flag unstable.
SANITIZER = {"RUSTC_BOOTSTRAP": "1", "RUSTFLAGS": " ".join([*COVERAGE, "-Zsanitizer=address"])}

# New inputs of a short run, and the longest input in bytes.
TARGETS = {
    "fmi": (3_000, 512),
    "c_api": (3_000, 512),
    "saved_state": (3_000, 512),
    "tyre_file": (10_000, 16384),
    "damper_test": (3_000, 4096),
    "parameter_set": (20_000, 2048),
    "shared_library": (20_000, 3072),
}
# Targets that read text, and the words that texts are made of.
TEXTS = ["tyre_file", "damper_test", "parameter_set"]
WORDS = FOLDER / "words.txt"
# An input that takes longer, in seconds, or more memory, in MB, fails. The clock is that on the wall: on a machine with
# other work a second of computation takes a minute.
LIMITS = ["-timeout=300", "-rss_limit_mb=2048", "-report_slow_units=300"]

ADDR_NO_RANDOMIZE = 0x0040000  # of <sys/personality.h>


def host():
    """Rust's name of this machine. With it as target, programs that only run while building are not instrumented."""
    return subprocess.run(["rustc", "--print", "host-tuple"], capture_output=True, text=True, check=True).stdout.strip()


def cargo(task, *arguments, sanitized=False):
    """Runs cargo on all targets and returns the folder they are in. What is linted need not be built again."""
    settings = SANITIZER if sanitized else {"RUSTFLAGS": " ".join(COVERAGE)}
    folder = OUT / ("sanitized" if sanitized else "plain")
    command = ["cargo", task, "--locked", "--release", "--manifest-path", FOLDER / "Cargo.toml"]
    command += ["--target", host(), "--target-dir", folder, *arguments]
    if subprocess.run(command, env={**os.environ, **settings}).returncode != 0:
        sys.exit(f"fuzz/run.py: cargo {task} failed")
    return folder / host() / "release"


def fuzz(programs, target, *options):
    """Runs a target; returns whether all went well, and prints its last counters."""
    found = OUT / "found"
    found.mkdir(parents=True, exist_ok=True)
    longest = TARGETS[target][1]
    command = [programs / target, f"-max_len={longest}", f"-artifact_prefix={found / target}-", *LIMITS]
    # Calls are made from the beginning of an input: a short one is a short sequence, so long ones are tried at once.
    command += [f"-dict={WORDS}"] if target in TEXTS else ["-len_control=0"]
    command += options
    log = OUT / f"{target}.log"
    with log.open("w") as file:
        status = subprocess.run(command, stdout=file, stderr=subprocess.STDOUT, cwd=OUT).returncode
    text = log.read_text(encoding="utf-8", errors="replace")
    counters = re.findall(r"^#(\d+)\s+\w+\s+cov: (\d+)", text, re.MULTILINE)
    inputs, coverage = map(int, counters[-1]) if counters else (0, 0)
    said = "ok" if status == 0 else "FAILED"
    print(f"figure: {said:<7} {target:<15} {inputs:>9} inputs reach {coverage:>5} branches", flush=True)
    if status == 0 and coverage == 0:
        print(f"{target}: no coverage: the instrumentation is not at work")
        return False
    if status != 0:
        shown = [line for line in text.splitlines() if not line.startswith(("#", "   "))]
        print("\n".join(shown[-40:]), f"\nall of it: {log}")
    return status == 0


def short(programs, target):
    """The corpus, then new inputs, their number fixed."""
    work = OUT / "short" / target
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    # In the order of names: that of a folder differs from disk to disk, and the new inputs with it.
    corpus = sorted((CORPUS / target).iterdir())
    seeds = work.with_suffix(".txt")
    seeds.write_text(",".join(map(str, corpus)), encoding="utf-8")
    count = TARGETS[target][0] + len(corpus)
    return fuzz(programs, target, "-seed=1", "-reload=0", f"-runs={count}", f"-seed_inputs=@{seeds}", work)


def long(programs, target, seconds):
    """New inputs for some time. What is found goes to the folder of long runs, from which the next one goes on."""
    work = OUT / "long" / target
    work.mkdir(parents=True, exist_ok=True)
    return fuzz(programs, target, f"-max_total_time={seconds}", work, CORPUS / target)


def keep(programs, target):
    """Makes the corpus the fewest inputs that reach what corpus and long runs reach, without counting how often."""
    fresh = OUT / "kept" / target
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    sources = [folder for folder in (OUT / "long" / target, CORPUS / target) if folder.is_dir()]
    options = ["-set_cover_merge=1", "-use_counters=0", fresh, *sources]
    if not fuzz(programs, target, *options):
        return False
    shutil.rmtree(CORPUS / target, ignore_errors=True)
    shutil.copytree(fresh, CORPUS / target)
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", help="; ".join(TARGETS))
    parser.add_argument("--long", type=int, metavar="SECONDS")
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--lint", action="store_true")
    arguments = parser.parse_args()
    if platform.system() != "Linux":
        print(f"note: no fuzzing on {platform.system()}")
        return 0
    unknown = set(arguments.targets) - set(TARGETS)
    if unknown:
        parser.error(f"no target {', '.join(sorted(unknown))}: there are {', '.join(TARGETS)}")
    if arguments.lint:
        cargo("clippy", "--all-targets", "--", "--deny", "warnings")
        return 0
    # New inputs depend on what a program compares, addresses too. Where fixed ones are forbidden, inputs vary a little.
    ctypes.CDLL(None).personality(ADDR_NO_RANDOMIZE)
    programs = cargo("build", "--bins", sanitized=arguments.long is not None)
    run = keep if arguments.keep else short

    def work(target):
        return long(programs, target, arguments.long) if arguments.long else run(programs, target)

    with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        results = list(pool.map(work, arguments.targets or TARGETS))
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
