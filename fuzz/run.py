#!/usr/bin/env python3
"""Builds the fuzz targets with coverage instrumentation and runs them. Needs Rust, a C++ compiler and Linux.

    python3 fuzz/run.py                   replay the corpus, then a fixed number of new inputs: the same ones each time;
                                          without the readers of files, which take longer to build than to run
    python3 fuzz/run.py --long 300        new inputs for 300 seconds per target, also under the address sanitizer
    python3 fuzz/run.py --keep            add the findings of long runs to the corpus, with as few inputs as possible
    python3 fuzz/run.py --long 60 fmi     one target
    python3 fuzz/run.py record            one target that reads files

An input that fails is in target/fuzz/found; `cargo fuzz fmt`, or RUST_LIBFUZZER_DEBUG_PATH=FILE and the program with
that input, prints the calls that it encodes. The layout is that of cargo-fuzz, which can also run the targets:
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
import zipfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
CORPUS = FOLDER / "corpus"
OUT = Path(os.environ.get("CARGO_TARGET_DIR", FOLDER.parent / "target")) / "fuzz"

# The flags that cargo-fuzz passes to rustc: counters of branches, their places, and the operands of comparisons.
COVERAGE = [
    "--cfg=fuzzing",
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
]
# The stable compiler includes the runtime of the sanitizer, but treats the flag as unstable.
SANITIZER = {"RUSTC_BOOTSTRAP": "1", "RUSTFLAGS": " ".join([*COVERAGE, "-Zsanitizer=address"])}

# New inputs of a short run, and the longest input in bytes.
TARGETS = {
    "fmi": (3_000, 512),
    "fmi3": (3_000, 512),
    "c_api": (3_000, 512),
    "saved_state": (3_000, 512),
    "tyre_file": (10_000, 16384),
    "damper_test": (3_000, 4096),
    "parameter_set": (20_000, 2048),
    "shared_library": (20_000, 3072),
    "system": (3_000, 2048),
    "record": (3_000, 4096),
    "description": (20_000, 2048),
}
# Readers of files: targets for which the workbench is built.
READERS = ["tyre_file", "damper_test", "system", "record", "description"]
# Targets that read text, and the words of these texts.
TEXTS = ["parameter_set", *READERS]
WORDS = FOLDER / "words.txt"
# An input that takes longer, in seconds, or more memory, in MB, fails. This is wall-clock time: on a busy machine a
# second of computation can take a minute.
LIMITS = ["-timeout=300", "-rss_limit_mb=2048", "-report_slow_units=300"]

ADDR_NO_RANDOMIZE = 0x0040000  # of <sys/personality.h>


def host():
    """Rust's name of this machine. With it as target, programs that only run while building are not instrumented."""
    return subprocess.run(["rustc", "--print", "host-tuple"], capture_output=True, text=True, check=True).stdout.strip()


def build(targets, sanitized):
    """Builds and lints targets and returns the folder they are in."""
    flags = SANITIZER if sanitized else {"RUSTFLAGS": " ".join(COVERAGE)}
    settings = {**flags, "RUSTC_WORKSPACE_WRAPPER": "clippy-driver"}
    folder = OUT / ("sanitized" if sanitized else "plain")
    command = ["cargo", "build", "--bins", "--locked", "--release", "--manifest-path", FOLDER / "Cargo.toml"]
    command += ["--target", host(), "--target-dir", folder]
    command += ["--features", "readers"] if set(targets) & set(READERS) else []
    if subprocess.run(command, env={**os.environ, **settings}).returncode != 0:
        sys.exit("fuzz/run.py: cargo build failed")
    return folder / host() / "release"


def fuzz(programs, target, *options):
    """Runs a target; returns whether it succeeded, and prints its last counters."""
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
        print(f"{target}: no coverage: the instrumentation does not work")
        return False
    if status != 0:
        shown = [line for line in text.splitlines() if not line.startswith(("#", "   "))]
        print("\n".join(shown[-40:]), f"\nfull log: {log}")
    return status == 0


def unpack(target):
    """The folder with the committed inputs of a target, one file each."""
    folder = OUT / "corpus" / target
    shutil.rmtree(folder, ignore_errors=True)
    with zipfile.ZipFile(CORPUS / f"{target}.zip") as archive:
        archive.extractall(folder)
    return folder


def pack(target, folder):
    """Replaces the committed inputs. The same inputs give the same bytes: they are sorted, and have no date."""
    with zipfile.ZipFile(CORPUS / f"{target}.zip", "w") as archive:
        for file in sorted(folder.iterdir()):
            archive.writestr(zipfile.ZipInfo(file.name), file.read_bytes(), zipfile.ZIP_DEFLATED)


def short(programs, target):
    """The corpus, then new inputs, their number fixed."""
    work = OUT / "short" / target
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    # Sorted by name: the order of a folder differs from disk to disk, and with it the new inputs.
    corpus = sorted(unpack(target).iterdir())
    seeds = work.with_suffix(".txt")
    seeds.write_text(",".join(map(str, corpus)), encoding="utf-8")
    count = TARGETS[target][0] + len(corpus)
    return fuzz(programs, target, "-seed=1", "-reload=0", f"-runs={count}", f"-seed_inputs=@{seeds}", work)


def long(programs, target, seconds):
    """New inputs for some time. Findings go to the folder of long runs, from which the next one continues."""
    work = OUT / "long" / target
    work.mkdir(parents=True, exist_ok=True)
    return fuzz(programs, target, f"-max_total_time={seconds}", work, unpack(target))


def keep(programs, target):
    """Reduces the corpus to the fewest inputs with the coverage of corpus and long runs, without counting how often."""
    fresh = OUT / "kept" / target
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir(parents=True)
    sources = [folder for folder in (OUT / "long" / target, unpack(target)) if folder.is_dir()]
    options = ["-set_cover_merge=1", "-use_counters=0", fresh, *sources]
    if not fuzz(programs, target, *options):
        return False
    pack(target, fresh)
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("targets", nargs="*", help="; ".join(TARGETS))
    parser.add_argument("--long", type=int, metavar="SECONDS")
    parser.add_argument("--keep", action="store_true")
    arguments = parser.parse_args()
    if platform.system() != "Linux":
        print(f"note: no fuzzing on {platform.system()}")
        return 0
    unknown = set(arguments.targets) - set(TARGETS)
    if unknown:
        parser.error(f"no target {', '.join(sorted(unknown))}: there are {', '.join(TARGETS)}")
    # New inputs depend on the values that a program compares, including addresses. Where fixed addresses are forbidden,
    # inputs vary a little.
    ctypes.CDLL(None).personality(ADDR_NO_RANDOMIZE)
    is_short = arguments.long is None and not arguments.keep
    usual = [target for target in TARGETS if target not in READERS] if is_short else list(TARGETS)
    targets = arguments.targets or usual
    programs = build(targets, sanitized=arguments.long is not None)
    run = keep if arguments.keep else short

    def work(target):
        return long(programs, target, arguments.long) if arguments.long else run(programs, target)

    with ThreadPoolExecutor(max_workers=os.cpu_count()) as pool:
        results = list(pool.map(work, targets))
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
