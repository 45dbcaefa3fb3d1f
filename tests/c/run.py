#!/usr/bin/env python3
"""Compiles and runs the C and C++ programs against include/stribeck.h and the release library.

    .venv/bin/python tests/c/run.py                   in about two minutes
    .venv/bin/python tests/c/run.py --library FOLDER  with the libraries in this folder; otherwise they are built
    .venv/bin/python tests/c/run.py --thorough        with 10,000 loads, a million steps, under Valgrind and with
                                                      sanitizers in the library itself; needs nightly Rust

Every program is compiled with warnings as errors, linked to the shared and to the static library, and run as it is and
under the address and undefined-behaviour sanitizers. On Linux faults of hosts are then tried on every model. The
compilers are cc and c++, or what CC and CXX name; the headers of FMI 3.0 those of the Python package fmpy.
"""

import argparse
import ctypes
import importlib.util
import json
import os
import platform
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TESTS = ROOT / "tests" / "c"
EXAMPLES = ROOT / "examples"
WINDOWS = os.name == "nt"

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
STANDARD = {".c": "-std=c99", ".cpp": "-std=c++17"}
SANITIZERS = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-fno-omit-frame-pointer"]
# Programs that load the library, one for each version of FMI.
FMI_TESTS = ["fmi_test", "fmi3_test"]
VERSIONS = ["2", "3"]
ADDR_NO_RANDOMIZE = 0x0040000  # of <sys/personality.h>
TIMEOUT = 3600  # seconds; the longest program, of the thorough run, takes some minutes


def headers_of_fmi_3():
    """The folder with the headers of the standard."""
    fmpy = importlib.util.find_spec("fmpy")
    if fmpy is None:
        sys.exit("tests/c/run.py: no headers of FMI 3.0: start it with .venv/bin/python, which has fmpy")
    return Path(fmpy.origin).parent / "c-code"


class Failed(Exception):
    """A command that failed. The text is shown to the user, a long one only in part."""

    def __init__(self, text, longest=40):
        lines = text.splitlines()
        more = [f"... and {len(lines) - longest} more lines"] if len(lines) > longest else []
        super().__init__("\n".join(lines[:longest] + more))


def run(command, **options):
    """Runs a command and returns its result; raises Failed if it cannot be started or takes too long."""
    command = [str(word) for word in command]
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=TIMEOUT, **options)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise Failed(f"{shlex.join(command)}\n{error}") from error


def succeed(command, **options):
    """Runs a command that must succeed and returns its output."""
    done = run(command, **options)
    if done.returncode != 0:
        shown = shlex.join(str(word) for word in command)
        raise Failed(f"{shown}\nexit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def build_library():
    """Builds the library as it is shipped and returns the folder it is in."""
    if subprocess.run(["cargo", "build", "--release", "--lib", "-p", "libstribeck"], cwd=ROOT).returncode != 0:
        sys.exit("tests/c/run.py: the library does not build")
    metadata = succeed(["cargo", "metadata", "--format-version", "1", "--no-deps"], cwd=ROOT)
    return Path(json.loads(metadata)["target_directory"]) / "release"


class Compiler:
    """The C and C++ compilers, and how a program is linked to the library."""

    def __init__(self, build_folder, output_folder):
        self.build_folder = build_folder
        self.output_folder = output_folder
        self.commands = {".c": find_compiler("CC", "cc"), ".cpp": find_compiler("CXX", "c++")}
        self.headers = headers_of_fmi_3()

    def shared_library(self):
        names = {"Windows": "stribeck.dll", "Darwin": "libstribeck.dylib"}
        return self.build_folder / names.get(platform.system(), "libstribeck.so")

    def link_flags(self, linkage):
        if linkage == "shared":
            # A function bound at its first call needs space on the small stack, as much as the processor's registers.
            bound = ["-Wl,-z,now"] if platform.system() == "Linux" else []
            run_path = [] if WINDOWS else [f"-Wl,-rpath,{self.build_folder}", *bound]
            return [self.shared_library(), *run_path, "-lm", *([] if WINDOWS else ["-lpthread", "-ldl"])]
        if linkage == "static":
            return [self.build_folder / "libstribeck.a", *native_static_libraries(self.output_folder), "-lm"]
        # Loaded by the program itself.
        return ["-lm"] if WINDOWS else ["-lm", "-ldl"]

    def compile(self, source, linkage, sanitized):
        """Compiles one source file to a program and returns the path of the program."""
        name = "-".join([source.stem, source.suffix[1:], linkage, *(["sanitized"] if sanitized else [])])
        program = self.output_folder / (name + (".exe" if WINDOWS else ""))
        flags = ["-g", "-O1", *SANITIZERS] if sanitized else ["-O2"]
        succeed(
            [
                *self.commands[source.suffix],
                STANDARD[source.suffix],
                *WARNINGS,
                *flags,
                f"-I{ROOT / 'include'}",
                *("-isystem", self.headers),
                source,
                "-o",
                program,
                *self.link_flags(linkage),
            ]
        )
        return program


def find_compiler(variable, usual):
    """The compiler command named by an environment variable, or the usual one."""
    command = shlex.split(os.environ.get(variable, usual))
    if not command or shutil.which(command[0]) is None:
        sys.exit(f"tests/c/run.py: no compiler {' '.join(command) or repr('')}: set {variable} to one that exists")
    return command


def native_static_libraries(folder):
    """Libraries to link beside the static library: the system libraries that Rust's standard library uses."""
    # A regular file: rustc replaces the file at its output path, even a device.
    words = ["rustc", "--crate-type", "staticlib", "--print", "native-static-libs", "-", "-o", folder / "empty.a"]
    done = run(words, input="")
    label = "native-static-libs:"
    for line in done.stderr.splitlines():
        if label in line:
            return line.split(label)[1].split()
    raise Failed(f"{shlex.join(done.args)}\nnames no libraries:\n{done.stderr}")


class Results:
    """Counts, and prints what failed at once."""

    def __init__(self):
        self.passed = 0
        self.failed = 0

    def check(self, name, test):
        try:
            test()
        except Failed as failure:
            self.failed += 1
            print(f"FAILED  {name}\n{failure}", flush=True)
        else:
            self.passed += 1
            print(f"ok      {name}", flush=True)


def expect(done, condition, wish):
    if not condition:
        shown = shlex.join(done.args)
        raise Failed(f"{shown}\n{wish}; exit code {done.returncode}\n{done.stdout}{done.stderr}")


def runs(program, *arguments, prints=()):
    """The program must succeed, print nothing on stderr, and print each of the given texts."""
    done = run([program, *arguments])
    expect(done, done.returncode == 0 and not done.stderr, "should succeed without a complaint")
    for text in prints:
        expect(done, text in done.stdout, f"should print {text!r}")
    return done


def report(program, *arguments, label=""):
    """Runs a program that prints its counts, and prints them as figures."""
    done = runs(program, *arguments, prints=[" 0 failed"])
    print("".join(f"figure: {label}{line}\n" for line in done.stdout.splitlines()), end="", flush=True)


def refuses(program, *arguments, complains):
    """The program must fail with exit code 1 and say why."""
    done = run([program, *arguments])
    expect(done, done.returncode == 1 and complains in done.stderr, f"should fail and say {complains!r}")


def is_caught(program, mistake, *arguments, by):
    """A sanitizer must stop the program."""
    done = run([program, mistake, *arguments])
    expect(done, done.returncode != 0 and by in done.stderr, f"should be caught: {by!r}")


def test_headers(compiler, results):
    for source in [TESTS / "header.c", TESTS / "header.cpp"]:
        results.check(source.name, lambda source=source: runs(compiler.compile(source, "none", False)))


def test_sanitizers(compiler, results):
    """A sanitizer that is not on would let everything pass."""

    def caught(mistake, by):
        is_caught(compiler.compile(TESTS / "caught.c", "none", True), mistake, by=by)

    results.check("sanitizer: address", lambda: caught("address", "heap-buffer-overflow"))
    results.check("sanitizer: overflow", lambda: caught("overflow", "signed integer overflow"))
    if platform.system() == "Linux":
        results.check("sanitizer: leak", lambda: caught("leak", "LeakSanitizer"))
    else:
        print(f"note: no leak detection on {platform.system()}")


def test_programs(compiler, results, linkage, sanitized):
    label = f"{linkage}, sanitized" if sanitized else linkage

    def program(folder, name):
        return compiler.compile(folder / name, linkage, sanitized)

    def belt():
        built = program(EXAMPLES / "c", "belt.c")
        runs(built, prints=["LuGre on the belt", "identical to the last bit", "refused, as it should be: mu_k = -0.1"])
        runs(built, "CoulombStiction", prints=["identical to the last bit"])
        # f_s / k / v_b = 14.715 s with 2 kg, and a slip of the closed form with w = 1 / s.
        runs(built, "CoulombStiction", "step=1e-3", "rig.mass=2", prints=["maximum at t =  14.916"])
        # A law in space, with the closed form of a band that captures; one that asks for the acceleration.
        runs(built, "Liang", "step=1e-3", prints=["maximum at t =   7.64"])
        runs(built, "NonReversible", "step=1e-3", prints=["maximum at t =   6.0"])
        refuses(built, "NoSuchLaw", complains="NoSuchLaw")
        refuses(built, "LuGre", "rig.mas=2", complains="mas")
        refuses(built, "LuGre", "mu_s=-1", complains="mu_s = -1")
        refuses(built, "LuGre", "mu_s", complains="'mu_s' is not of the form name=value")
        refuses(built, "LuGre", "step=0", complains="step = 0: must be > 0")

    def fmu_master():
        runs(program(EXAMPLES / "c", "fmu_master.c"), prints=["slips 5 times, first at 7.35"])

    def hysteresis():
        built = program(EXAMPLES / "cpp", "hysteresis.cpp")
        csv = built.with_suffix(".csv")
        csv.unlink(missing_ok=True)
        runs(built, csv, prints=["closed form", "refused, as it should be:  sigma_0 = -1"])
        rows = csv.read_text().splitlines()
        if rows[0] != "position_m,friction_force_N" or len(rows) != 1 + 200 * 21:
            raise Failed(f"{csv}: {len(rows)} lines, the first one is {rows[0]!r}")
        refuses(built, built.parent / "no" / "such" / "folder.csv", complains="cannot write")

    results.check(f"api_test ({label})", lambda: runs(program(TESTS, "api_test.c"), prints=[" 0 failed"]))
    results.check(f"throws ({label})", lambda: runs(program(TESTS, "throws.cpp"), prints=[" 0 failed"]))
    results.check(f"belt ({label})", belt)
    results.check(f"fmu_master ({label})", fmu_master)
    results.check(f"hysteresis ({label})", hysteresis)


def test_loaded(compiler, results, sanitized):
    label = "loaded, sanitized" if sanitized else "loaded"
    for test in FMI_TESTS:
        results.check(
            f"{test} ({label})",
            lambda test=test: runs(
                compiler.compile(TESTS / f"{test}.c", "loaded", sanitized),
                compiler.shared_library(),
                prints=[" 0 failed"],
            ),
        )


def test_functions_of_fmi_3(compiler, results):
    """The program for FMI 3.0 calls each function of the header."""

    def compare():
        header = (compiler.headers / "fmi3Functions.h").read_text(encoding="utf-8")
        program = (TESTS / "fmi3_test.c").read_text(encoding="utf-8")
        declared = set(re.findall(r"^FMI3_Export\s+fmi3(\w+)TYPE\s+fmi3\1;", header, re.MULTILINE))
        listed = set(re.findall(r"^    DO\((\w+)\)", program, re.MULTILINE))
        called = set(re.findall(r"\bfmi(?:->|\.)(\w+)\(", program))
        called |= {verb + kind for kind in re.findall(r"HAS_NO\((\w+), ", program) for verb in ("Get", "Set")}
        if not declared or listed != declared or not declared <= called:
            raise Failed(f"not listed: {declared ^ listed}; not called: {declared - called}")

    results.check("functions of fmi3Functions.h", compare)


def test_valgrind(compiler, results):
    """Every access to memory in the library itself as well, which the sanitizers of the C compiler do not see."""

    def watched(program, *arguments):
        options = ["--quiet", "--error-exitcode=9", "--leak-check=full", "--errors-for-leak-kinds=definite"]
        return run(["valgrind", *options, program, *arguments])

    def caught(mistake, by):
        done = watched(compiler.compile(TESTS / "caught.c", "none", False), mistake)
        expect(done, done.returncode == 9 and by in done.stderr, f"should be caught: {by!r}")

    def clean(program, *arguments):
        done = watched(program, *arguments)
        expect(done, done.returncode == 0 and not done.stderr, "should be clean")

    if shutil.which("valgrind") is None:
        raise Failed("valgrind not found: apt install valgrind (Debian, Ubuntu)")
    results.check("valgrind: address", lambda: caught("address", "Invalid read"))
    results.check("valgrind: leak", lambda: caught("leak", "definitely lost"))
    api_test = compiler.compile(TESTS / "api_test.c", "shared", False)
    results.check("valgrind: api_test", lambda: clean(api_test))
    for test in FMI_TESTS:
        program = compiler.compile(TESTS / f"{test}.c", "loaded", False)
        results.check(f"valgrind: {test}", lambda program=program: clean(program, compiler.shared_library()))
    faults = compiler.compile(TESTS / "faults.c", "shared", False)
    for version in VERSIONS:
        results.check(
            f"valgrind: faults ({version})", lambda version=version: clean(faults, version, "threads", *models())
        )


class Instrumented:
    """Library and programs with a sanitizer in both; Rust's standard library has none."""

    TARGET = "x86_64-unknown-linux-gnu"

    def __init__(self, sanitizer, output_folder):
        self.flag = f"-fsanitize={sanitizer}"
        self.folder = output_folder / f"{sanitizer}-sanitizer"
        self.library = self.folder / self.TARGET / "debug" / "libstribeck.so"
        cargo = ["cargo", "+nightly", "build", "--lib", "-p", "libstribeck", "--target", self.TARGET]
        flags = f"-Zsanitizer={sanitizer} -Cunsafe-allow-abi-mismatch=sanitizer"
        settings = {**os.environ, "RUSTFLAGS": flags, "CARGO_TARGET_DIR": str(self.folder)}
        if subprocess.run(cargo, cwd=ROOT, env=settings).returncode != 0:
            cure = "if there is no nightly: rustup toolchain install nightly"
            raise Failed(f"no library with {sanitizer} sanitizer; {cure}")

    def compile(self, *sources):
        """The sources of a program, linked to the library."""
        program = self.folder / sources[0].stem
        compiler = [*find_compiler("CC", "gcc"), STANDARD[".c"], self.flag, "-g", "-O1", f"-I{ROOT / 'include'}"]
        compiler += ["-isystem", headers_of_fmi_3()]
        linked = [self.library, f"-Wl,-rpath,{self.library.parent}", "-lm", "-lpthread", "-ldl"]
        succeed([*compiler, *sources, "-o", program, *linked])
        return program


def test_threads(output_folder, results):
    """The thread sanitizer sees two threads in one instance, and none in a thousand that are passed between threads."""
    faults = Instrumented("thread", output_folder).compile(TESTS / "faults.c", TESTS / "tsan.c")

    def check(version):
        label, place = f"thread sanitizer, FMI {version}: ", f"ffi/src/fmi{version}/"
        results.check(f"{label}race", lambda: is_caught(faults, version, "race", *models(), by=place))
        results.check(f"{label}threads", lambda: report(faults, version, "threads", *models(), label=label))

    for version in VERSIONS:
        check(version)


def test_addresses(output_folder, results):
    """The address sanitizer sees an array that is too short, and nothing in the fault programs; no leak either."""
    instrumented = Instrumented("address", output_folder)
    faults, loads = instrumented.compile(TESTS / "faults.c"), instrumented.compile(TESTS / "loads.c")

    def check(version):
        label, place = f"address sanitizer, FMI {version}: ", f"ffi/src/fmi{version}/values.rs"
        results.check(f"{label}short array", lambda: is_caught(faults, version, "short", *models(), by=place))
        test_conditions(results, (faults, loads), version, ["threads", "0.5"], (instrumented.library, 200), label)

    for version in VERSIONS:
        check(version)


def models():
    """Every model of the library, as name={guid}, from the descriptions that the FMUs carry."""
    found = []
    for path in sorted((ROOT / "modelDescription").glob("*.xml")):
        guid = re.search(r'\sguid="(\{[^"]+\})"', path.read_text(encoding="utf-8"))
        if guid is None:
            raise Failed(f"{path} has no guid")
        found.append(f"{path.stem}={guid[1]}")
    if not found:
        raise Failed("no description in modelDescription")
    return found


def guids():
    """The guid of every model."""
    return [model.partition("=")[2] for model in models()]


def report_environments(faults, version, label):
    """Odd floating-point modes, and the German locale, whether or not it is installed."""
    if shutil.which("localedef") is None or not Path("/usr/share/i18n/locales/de_DE").is_file():
        raise Failed("no definition of the German locale: apt install locales (Debian, Ubuntu)")
    with tempfile.TemporaryDirectory() as folder:
        # With warnings, as some definitions have, the exit code is 1; the program checks the locale.
        run(["localedef", "-i", "de_DE", "-f", "UTF-8", Path(folder) / "de_DE.UTF-8"])
        os.environ["LOCPATH"] = folder
        report(faults, version, "environment", *models(), label=label)


def report_loads(loads, version, library, cycles, label):
    """Loads and unloads of the library."""
    with tempfile.TemporaryDirectory() as folder:
        report(loads, version, library, folder, cycles, *guids(), label=label)


def test_conditions(results, programs, version, conditions, library_and_cycles, label):
    """Conditions that a host may impose on the library, in one version of FMI. Each program prints its counts, with the
    figures."""
    faults, loads = programs
    for fault in conditions:
        results.check(f"{label}{fault}", lambda fault=fault: report(faults, version, fault, *models(), label=label))
    results.check(f"{label}environment", lambda: report_environments(faults, version, label))
    results.check(f"{label}loads", lambda: report_loads(loads, version, *library_and_cycles, label))


def test_faults(compiler, results, thorough):
    """The same, in both versions."""
    if platform.system() != "Linux":
        print(f"note: no fault tests on {platform.system()}")
        return
    faults = compiler.compile(TESTS / "faults.c", "shared", False)
    loads = compiler.compile(TESTS / "loads.c", "loaded", False)
    seconds, cycles = ("5", 10_000) if thorough else ("0.25", 250)
    conditions = ["stack", "threads", seconds, *(["long"] if thorough else [])]
    for version in VERSIONS:
        library = (compiler.shared_library(), cycles)
        test_conditions(results, (faults, loads), version, conditions, library, f"FMI {version}: ")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--library", type=Path, metavar="FOLDER")
    parser.add_argument("--thorough", action="store_true")
    asked = parser.parse_args()
    build_folder = asked.library.resolve() if asked.library else build_library()
    if WINDOWS:
        # Windows looks for shared libraries along the path.
        os.environ["PATH"] = f"{build_folder}{os.pathsep}{os.environ['PATH']}"
    if platform.system() == "Linux":
        # Sanitizers of older compilers crash occasionally where the system randomises addresses widely. Processes that
        # may not request fixed ones run without them.
        ctypes.CDLL(None).personality(ADDR_NO_RANDOMIZE)
    output_folder = build_folder.parent / "c-tests"
    output_folder.mkdir(parents=True, exist_ok=True)
    compiler = Compiler(build_folder, output_folder)
    results = Results()

    linkages = ["shared", "static"]
    if not (build_folder / "libstribeck.a").exists():
        linkages.remove("static")
        print("note: the static library is in the format of another compiler; only the shared one is tested")
    sanitizing = [False, True]
    if WINDOWS:
        sanitizing.remove(True)
        print("note: no sanitizers on Windows")

    test_headers(compiler, results)
    test_functions_of_fmi_3(compiler, results)
    if True in sanitizing:
        test_sanitizers(compiler, results)
    for sanitized in sanitizing:
        test_loaded(compiler, results, sanitized)
        for linkage in linkages:
            test_programs(compiler, results, linkage, sanitized)

    test_faults(compiler, results, asked.thorough)
    if asked.thorough:
        test_valgrind(compiler, results)
        test_threads(output_folder, results)
        test_addresses(output_folder, results)

    print(f"figure: C programs: {results.passed} passed, {results.failed} failed")
    return 1 if results.failed else 0


if __name__ == "__main__":
    sys.exit(main())
