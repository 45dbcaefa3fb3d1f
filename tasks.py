#!/usr/bin/env python3
"""The project's tasks. Needs Python 3.11 and Rust; the first task that needs more installs it into .venv.

    python3 tasks.py demo

On Windows: py tasks.py demo
"""

from __future__ import annotations

import argparse
import ctypes
import os
import platform
import re
import shlex
import shutil
import subprocess
import sys
import textwrap
import tomllib
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent
VENV = ROOT / ".venv"
REQUIREMENTS = ROOT / "requirements.txt"
REQUIREMENTS_OF_DEMO = ROOT / "requirements-demo.txt"
CONSTRAINTS = ROOT / "constraints.txt"
# Cargo tools that only some tasks need are built here, in these versions.
TOOLS = ROOT / "target" / "tools"
COVERAGE_TOOL = "cargo-llvm-cov@0.9.1"
MUTATION_TOOL = "cargo-mutants@27.1.0"
SUPPLY_TOOL = "cargo-deny@0.20.2"
REQUIREMENTS_OF_PLATFORMS = ROOT / "requirements-platforms.txt"
WINDOWS = os.name == "nt"
PROGRAMS = VENV / ("Scripts" if WINDOWS else "bin")
PYTHON = PROGRAMS / ("python.exe" if WINDOWS else "python")

# With the benchmark, cargo chooses the features of all crates as for the tests: what it has built for them is not built
# again with fewer.
AS_TESTED = ["--workspace", "--bench", "stribeck"]

# Clippy in place of the compiler, so that nothing is compiled only to be linted, and its arguments in its own form.
LINTED = {"RUSTC_WORKSPACE_WRAPPER": "clippy-driver", "CLIPPY_ARGS": "--deny__CLIPPY_HACKERY__warnings"}

# The parts of the library that contain code.
CRATES = ["--package", "stribeck", "--package", "stribeck-ffi"]
RUST_FOLDERS = ["src", "ffi", "tests", "benches", "fmu-build", "fuzz", "lab", "python", "ssp", "web", "examples"]
PYTHON_FOLDERS = ["tasks.py", "benches", "docs", "examples", "fuzz", "python", "release", "tests", "web"]
C_FOLDERS = ["examples/c", "examples/cpp", "examples/multibody", "tests/c", "tests/platforms", "benches"]
# Rust's names of the platforms of `fmu-build pack --platform all`, and of the static programs of a release.
TARGETS = ["x86_64-unknown-linux-gnu", "aarch64-unknown-linux-gnu", "x86_64-pc-windows-gnu"]
TARGETS += ["x86_64-apple-darwin", "aarch64-apple-darwin"]
TARGETS += ["x86_64-unknown-linux-musl", "aarch64-unknown-linux-musl"]
# Tests for Miri: memory, states as bytes, instances of the test model, and a complete run of every model.
UNDER_MIRI = ["guid::", "memory::", "number::", "serial::", "probe::", "fmi2::tests::child", "fmi3::tests::"]
# What tasks need, and the packages of Debian and Ubuntu that contain it. For the tests: the German locale is made from
# a file, Ecos calls unzip, exudyn is linked to libraries for its window.
TEST_PROGRAMS = {
    "localedef": "libc-bin",
    "/usr/share/i18n/locales/de_DE": "locales",
    "unzip": "unzip",
    "libGL.so.1": "libgl1",
    "libX11.so.6": "libx11-6",
}
# Those for the task faults.
FAULT_PROGRAMS = {"valgrind": "valgrind", "gcc": "gcc", **TEST_PROGRAMS}
# Where the page runs, and that in which it is tested.
WASM = "wasm32-unknown-unknown"
PAGE_PROGRAMS = {"chromium": "chromium"}
# Those that build for other platforms and run the results.
PLATFORM_PROGRAMS = {
    "x86_64-w64-mingw32-gcc": "gcc-mingw-w64-x86-64-win32",
    "/usr/lib/wine/wine64": "wine64",
    "aarch64-linux-gnu-gcc": "gcc-aarch64-linux-gnu libc6-dev-arm64-cross",
    "powerpc-linux-gnu-gcc": "gcc-powerpc-linux-gnu libc6-dev-powerpc-cross",
    "qemu-aarch64-static": "qemu-user-static",
    "arm-none-eabi-gcc": "gcc-arm-none-eabi libnewlib-arm-none-eabi",
    "qemu-system-arm": "qemu-system-arm",
}


# Tasks by name, with how long each takes.
TASKS: dict[str, tuple[Callable[[], None], str]] = {}


def task(duration: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Declares a task of the command line; its docstring says what it does."""

    def declare(work: Callable[..., None]) -> Callable[..., None]:
        TASKS[work.__name__] = (work, duration)
        return work

    return declare


def described(name: str) -> str:
    """A task, what it does and how long it takes, on a line."""
    work, duration = TASKS[name]
    text = " ".join((work.__doc__ or "").split())
    return f"{name}: {text.rstrip('.')} ({duration})"


class TaskError(Exception):
    """A step failed; the text says which one, and what to do."""


def processor_time() -> float:
    """Processor time of all commands so far, in s."""
    times = os.times()
    return times.children_user + times.children_system


def run(*command: str | Path, **environment: str) -> None:
    """Runs a command in the project's folder; a failure ends the task."""
    words = [str(word) for word in command]
    # The search path is long and of little interest.
    settings = [f"{name}={value}" for name, value in environment.items() if name != "PATH"]
    shown = shlex.join(settings + words)
    print(f"\n> {shown if len(shown) < 300 else shown[:300] + ' ...'}", flush=True)
    before = processor_time()
    try:
        status = subprocess.run(words, cwd=ROOT, env={**os.environ, **environment}).returncode
    except OSError as error:
        raise TaskError(f"cannot run {words[0]}: {error}") from error
    print(f"processor time: {processor_time() - before:.0f} s", flush=True)
    if status != 0:
        raise TaskError(f"exit code {status}: {shown}")


def figures(*command: str | Path, **environment: str) -> tuple[list[str], int]:
    """Returns what a command prints after `figure:` or cargo's `test result:`, and its exit code."""
    words = [str(word) for word in command]
    print(f"\n> {shlex.join(words)}", flush=True)
    found = []
    settings = {**os.environ, **environment}
    with subprocess.Popen(words, cwd=ROOT, env=settings, stdout=subprocess.PIPE, encoding="utf-8") as process:
        for line in process.stdout:
            print(line, end="", flush=True)
            found += re.findall(r"(?:figure|test result): (.*\S)", line)
    return found, process.returncode


def need(program: str, cure: str) -> None:
    """Ends the task if a program is missing."""
    if shutil.which(program) is None:
        raise TaskError(f"{program} not found: {cure}")


def need_rust() -> None:
    """Ends the task if Rust, or the linker it needs, is missing."""
    need("cargo", "install Rust from https://rustup.rs")
    # On Windows cargo finds Microsoft's linker itself, outside the search path.
    if not WINDOWS:
        need_c_compiler()


def need_c_compiler() -> None:
    """Ends the task if there is no C compiler."""
    if not any(shutil.which(name) for name in ("cc", "gcc", "clang", "cl")):
        raise TaskError(
            "no C compiler found: install one (Debian, Ubuntu: apt install build-essential; macOS: xcode-select "
            "--install; Windows: Visual Studio Build Tools, and start from their developer prompt)"
        )


def files(folders: list[str], *endings: str) -> list[Path]:
    """All files with these extensions below the folders, except generated ones."""
    found = [
        path.relative_to(ROOT)
        for folder in folders
        for ending in endings
        for path in sorted((ROOT / folder).rglob(f"*{ending}"))
        if not {"target", "node_modules"} & set(path.parts)
    ]
    if not found:
        raise TaskError(f"no {', '.join(endings)} file in {', '.join(folders)}")
    return found


@task("about a minute")
def setup(requirements: Path = REQUIREMENTS) -> None:
    """Creates .venv, again only if the packages to install or the Python version have changed."""
    if sys.version_info < (3, 11):  # noqa: UP036 - the user may have an older one
        raise TaskError(f"Python 3.11 or newer is needed, this is {sys.version.split()[0]}: install it from python.org")
    stamp = VENV / "installed.txt"
    header = f"# Python {sys.version_info.major}.{sys.version_info.minor}"
    both = [path.read_text(encoding="utf-8") for path in (CONSTRAINTS, REQUIREMENTS_OF_DEMO)]
    enough = {one: "\n".join([header, *both, one.read_text(encoding="utf-8")]) for one in (requirements, REQUIREMENTS)}
    if stamp.is_file() and stamp.read_text(encoding="utf-8") in enough.values():
        return
    try:
        import ensurepip  # noqa: F401
    except ImportError as error:
        raise TaskError("this Python has no venv module: apt install python3-venv (Debian, Ubuntu)") from error
    run(sys.executable, "-m", "venv", "--clear", VENV)
    # Python compiles the few files that are imported when they are: all of them take as long as to install them.
    run(PYTHON, "-m", "pip", "install", "--quiet", "--no-compile", "--disable-pip-version-check", "-r", requirements)
    stamp.write_text(enough[requirements], encoding="utf-8")


def setup_platforms() -> None:
    """Installs the tools that build and run the libraries of all platforms."""
    if platform.system() != "Linux" or platform.machine() != "x86_64":
        raise TaskError("this task needs Linux on x86-64; elsewhere `fmu-build pack --platform all` packs what it can")
    need("rustup", "this task needs the Rust of https://rustup.rs, which has standard libraries for other platforms")
    setup()
    run(PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r", REQUIREMENTS_OF_PLATFORMS)
    run("rustup", "target", "add", *TARGETS, WASM)
    install_missing(PLATFORM_PROGRAMS)


def is_here(name: str) -> bool:
    """Whether this program, file or library is here."""
    if ".so" in name:
        try:
            ctypes.CDLL(name)
        except OSError:
            return False
        return True
    return shutil.which(name) is not None or (name[0] == "/" and Path(name).exists())


def missing_files(packages: dict[str, str]) -> list[str]:
    """Those of these programs, files and libraries that are not here."""
    return [name for name in packages if not is_here(name)]


def install_missing(packages: dict[str, str]) -> None:
    """Installs missing packages. Only root can do it."""
    missing = missing_files(packages)
    if not missing:
        return
    wanted = " ".join(packages[name] for name in missing).split()
    # A new machine may still be installing updates.
    patience = ["-o", "DPkg::Lock::Timeout=300", "-o", "Acquire::Retries=3"]
    install = ["apt-get", *patience, "install", "--yes", "--no-install-recommends", *wanted]
    cure = f"{', '.join(missing)} not found: on Debian or Ubuntu, as root, run {shlex.join(install)}"
    if os.geteuid() != 0 or shutil.which("apt-get") is None:
        raise TaskError(cure)
    print(f"\n{cure}; trying that now", flush=True)
    run("apt-get", *patience, "update")
    run(*install, DEBIAN_FRONTEND="noninteractive")
    # A container image may omit files of its packages in /usr/share.
    if missing_files(packages):
        raise TaskError(f"{', '.join(missing_files(packages))} not found after {shlex.join(install)}")


def pack_for_all(project: Path, fmus: Path) -> None:
    """Packs the FMUs of a copy of this project for all platforms. The libraries are built from and in that copy."""
    run(
        *("cargo", "run", "--target-dir", ROOT / "target", "--package", "fmu-build", "--", "--project", project),
        *("pack", "--platform", "all", "--strict", "--out", fmus),
        PATH=f"{PROGRAMS}{os.pathsep}{os.environ['PATH']}",
        CARGO_TARGET_DIR=str(project / "target"),
    )


@task("15 to 30 minutes")
def platforms() -> None:
    """Packs the FMUs for all platforms, twice in different folders, and runs those that this machine can run."""
    need_rust()
    setup_platforms()
    out = ROOT / "out" / "platforms"
    copy = out / "copy"
    for folder in (copy, out / "fmus", out / "fmus-of-copy"):
        shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".git", ".venv", "dist", "out", "target"))
    # Most of the time a single processor optimises a whole library.
    with ThreadPoolExecutor() as both:
        list(both.map(pack_for_all, [ROOT, copy], [out / "fmus", out / "fmus-of-copy"]))
    run(PYTHON, "-m", "pytest", "-rP", "tests/platforms")


@task("1 to 2 minutes")
def pack(*fmu_build: str | Path) -> None:
    """Builds the library and packs every model as FMUs into dist/, and the four-post rig as an SSP package."""
    need_rust()
    fmu_build = fmu_build or ("cargo", "run", "--package", "fmu-build", "--")
    run(*fmu_build, "pack", "--plain", "--out", "dist")
    run(*fmu_build, "ssp", "--out", "dist")


def debug_folder() -> Path:
    """Where cargo puts what it builds for the tests."""
    return Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "debug"


def package(fmus: bool = True) -> None:
    """Puts the Python package together from what cargo has built for the tests, where pytest finds it."""
    names = {"win32": ("_stribeck.dll", "_stribeck.pyd"), "darwin": ("lib_stribeck.dylib", "_stribeck.abi3.so")}
    built, module = names.get(sys.platform, ("lib_stribeck.so", "_stribeck.abi3.so"))
    folder = ROOT / "out" / "package" / "stribeck"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "python" / "stribeck", folder, ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copyfile(debug_folder() / built, folder / module)
    if fmus:
        run(PYTHON, "python/fmus.py", "dist", folder / "fmus")


@task("4 to 8 minutes")
def wheel() -> None:
    """Builds the Python package from the packed FMUs into dist/, as one file, and tests it by itself."""
    need_rust()
    setup()
    pack()
    for old in (ROOT / "dist").glob("stribeck-*.whl"):
        old.unlink()
    run(PYTHON, "python/fmus.py", "dist", "python/stribeck/fmus")
    run(PYTHON, "-m", "maturin", "build", "--release", "--manifest-path", "python/Cargo.toml", "--out", "dist")
    run(PYTHON, "-m", "pytest", "tests/wheel")


@task("20 to 40 minutes")
def wheels() -> None:
    """Builds the Python package for all platforms into dist/wheels/, and examines and runs what can be run here."""
    need_rust()
    setup_platforms()
    shutil.rmtree(ROOT / "dist" / "wheels", ignore_errors=True)
    run(PYTHON, "-m", "release.wheels", "dist/wheels")
    run(PYTHON, "-m", "pytest", "-rP", "tests/wheels")


@task("20 to 60 minutes")
def release() -> None:
    """Writes all that a user takes away to dist/release/, for the platforms whose tools are here, and tests it."""
    need_rust()
    setup()
    run(PYTHON, "-m", "release")


def setup_wasm() -> None:
    """Rust's standard library for WebAssembly, from which C sources are made."""
    command = ["rustc", "--print", "target-libdir", "--target", WASM]
    found = subprocess.run(command, capture_output=True, encoding="utf-8")
    if not any(Path(found.stdout.strip()).glob("libstd-*.rlib")):
        need("rustup", f"this task needs Rust's standard library for {WASM}, which the Rust of https://rustup.rs has")
        run("rustup", "target", "add", WASM)


def setup_page() -> None:
    """What the page needs besides Rust: Node with its packages, and Rust's standard library for WebAssembly."""
    for program in ("node", "npm"):
        need(program, "install Node 20 or newer from https://nodejs.org")
    setup_wasm()
    run(shutil.which("npm"), "ci", "--prefix", "web", "--ignore-scripts", "--no-audit", "--no-fund")


@task("about a minute")
def types() -> None:
    """Writes the types of the page's questions and answers, as the library declares them, into web/page/types.ts."""
    setup()
    run("cargo", "build", "--package", "stribeck-page")
    run(PYTHON, "web/write_types.py")


def write_page() -> Path:
    """Writes the page as one file into dist/; returns the library in it."""
    run(shutil.which("npm"), "exec", "--prefix", "web", "--", "tsc", "--project", "web")
    run("cargo", "build", "--profile", "page", "--package", "stribeck-page", "--target", WASM)
    texts = ROOT / "out" / "texts.json"
    run("cargo", "run", "--package", "fmu-build", "--", "texts", "--out", texts)
    built = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    library = built / WASM / "page" / "stribeck_page.wasm"
    version = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    run("node", "web/build.mjs", library, texts, version, ROOT / "dist" / "page.html")
    return library


@task("3 to 6 minutes")
def page() -> None:
    """Builds the page into dist/, as one file, and tests it in Chromium, and against the library for this machine, the
    command line, Python and C."""
    need_rust()
    need_c_compiler()
    setup()
    setup_page()
    library = write_page()
    packages = ["stribeck-page", "stribeck-python", "libstribeck", "stribeck-cli"]
    run("cargo", "build", *[word for name in packages for word in ("--package", name)])
    package(fmus=False)
    names = {"win32": "stribeck_page.dll", "darwin": "libstribeck_page.dylib"}
    if platform.system() == "Linux":
        install_missing(PAGE_PROGRAMS)
    run(
        *("node", "--test", "--test-concurrency=1", "web/tests"),
        CHROMIUM=shutil.which("chromium") or "",
        LIBRARY=str(library),
        PAGE=str(ROOT / "dist" / "page.html"),
        NATIVE=str(debug_folder() / names.get(sys.platform, "libstribeck_page.so")),
        PYTHON=str(PYTHON),
        PACKAGE=str(ROOT / "out" / "package"),
        STRIBECK=str(debug_folder() / f"stribeck{'.exe' if WINDOWS else ''}"),
        C_COMPILER=next(name for name in ("cc", "gcc", "clang") if shutil.which(name)),
        C_LIBRARY=str(debug_folder()),
    )


@task("3 to 6 minutes, then about 1")
def site() -> None:
    """Writes the documentation site into dist/site/, with the page if it is built, and tests it."""
    need_rust()
    setup()
    run(PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r", "requirements-site.txt")
    run("cargo", "build", "--package", "fmu-build", "--package", "stribeck-python")
    package(fmus=False)
    run(PYTHON, "docs/site/build.py", debug_folder() / "fmu-build", PYTHONPATH=str(ROOT / "out" / "package"))
    run(PYTHON, "-m", "pytest", "-rP", "tests/site")


@task("6 to 9 minutes, then about 2")
def demo() -> None:
    """Shows a law, packs the FMUs and runs each in Python, draws laws on the thesis' belt, and identifies a law."""
    run(sys.executable, "-m", "examples.demo")


def check_style() -> None:
    """Formatting of all languages, lints but Rust's. rustfmt sees modules that macros declare, `cargo fmt` does not."""
    run("rustfmt", "--check", "--edition", "2024", *files(RUST_FOLDERS, ".rs"))
    run(PYTHON, "-m", "ruff", "format", "--check", *PYTHON_FOLDERS)
    run(PYTHON, "-m", "ruff", "check", *PYTHON_FOLDERS)
    run(PROGRAMS / "clang-format", "--dry-run", "-Werror", *files(C_FOLDERS, ".c", ".cpp", ".h"))


def documenter() -> str:
    """The program that writes the pages of a crate where cargo runs its examples."""
    script = ROOT / "tests" / "rustdoc.py"
    if not WINDOWS:
        return str(script)
    batch = ROOT / "out" / "rustdoc.bat"
    batch.parent.mkdir(exist_ok=True)
    batch.write_text(f'@"{sys.executable}" "{script}" %*\n', encoding="utf-8")
    return str(batch)


@task("15 to 25 minutes, then about 12")
def test() -> None:
    """Every check and test, the fast ones first."""
    need_rust()
    need_c_compiler()
    # On a new machine everything is built once: without the files of incremental builds that takes a third less time.
    os.environ.setdefault("CARGO_INCREMENTAL", "0")
    for program in ("rustfmt", "clippy-driver"):
        need(program, "rustup component add rustfmt clippy")
    setup()
    subprocess.run(f"rustup target add {WASM}", shell=True)  # Without it tests of C sources are skipped, and say so.
    if platform.system() == "Linux":
        install_missing(TEST_PROGRAMS)
    check_style()
    run("cargo", "test", "--workspace", RUSTDOC=documenter(), **LINTED)
    run("cargo", "test", "--workspace", "--benches", "--no-run", **LINTED)
    # Here each benchmark runs once, to check that it runs.
    run("cargo", "test", *AS_TESTED, **LINTED)
    run("cargo", "build", "--lib", "--bin", "fmu-build", *AS_TESTED, **LINTED)
    fmu_build = debug_folder() / "fmu-build"
    run(fmu_build, "check")
    pack(fmu_build)
    package()
    # Where the library of the FMUs has been built, also for C.
    libraries = debug_folder().parent / "fmu" / "release"
    run(PYTHON, "tests/c/run.py", "--library", libraries)
    run(PYTHON, "fuzz/run.py")
    run(PYTHON, "-m", "pytest", "tests/python", STRIBECK_LIBRARY=str(libraries), **LINTED)


def setup_faults() -> None:
    """Installs the tools for the task faults. Miri and the sanitizers are parts of nightly Rust; any version will
    do."""
    if platform.system() != "Linux" or platform.machine() != "x86_64":
        raise TaskError("this task needs Linux on x86-64")
    need("rustup", "this task needs the Rust of https://rustup.rs, which has nightly versions")
    setup()
    install_missing(FAULT_PROGRAMS)
    miri = ["cargo", "+nightly", "miri", "--version"]
    if subprocess.run(miri, capture_output=True).returncode != 0:
        run("rustup", "toolchain", "install", "nightly", "--profile", "minimal", "--component", "miri,rust-src")


def summarise(commands: list[list[str | Path]], **environment: str) -> None:
    """Runs all the commands, even if one fails, and prints their figures at the end."""
    found, failed = [], []
    for command in commands:
        shown = shlex.join(map(str, command))
        try:
            lines, status = figures(*command, **environment)
        except OSError as error:
            lines, status = [f"cannot run {command[0]}: {error}"], 1
        if status != 0:
            failed.append(f"exit code {status}: {shown}")
            # As a figure, so that the task trust shows it too if this is one of its parts.
            print(f"figure: FAILED with exit code {status}: {shown}", flush=True)
        found += ["", shown if status == 0 else f"FAILED with exit code {status}: {shown}"]
        found += [f"    {line}" for line in lines]
    print("\n\nResults of the tests:", *found, sep="\n")
    if failed:
        raise TaskError("; ".join(failed))


@task("10 to 20 minutes")
def faults() -> None:
    """Tests with importers and faults of the host, in full, with the figures at the end."""
    need_rust()
    need_c_compiler()
    setup_faults()
    setup_wasm()
    pack()
    names = ("model_description", "fmus", "exchange", "importers", "fmusim", "sources", "ssp", "supply", "studies")
    commands = [
        ["cargo", "test", "--test", "fmi", "--test", "allocation", "--", "--nocapture"],
        ["cargo", "test", "--package", "fmu-build"],
        ["cargo", "run", "--package", "fmu-build", "--", "check"],
        *([PYTHON, "-m", "pytest", "-s", "-q", f"tests/python/test_{name}.py"] for name in names),
        [PYTHON, "tests/c/run.py", "--thorough"],
        [PYTHON, "tests/sanitized.py"],
        ["cargo", "+nightly", "miri", "test", *CRATES, "--lib", "--", *UNDER_MIRI],
        ["cargo", "+nightly", "miri", "test", "--package", "stribeck", "--test", "life"],
    ]
    # Miri cannot start the second process in which the test of panics otherwise runs. By default it varies the last
    # digits of functions such as exp from call to call.
    summarise(
        commands,
        MIRIFLAGS="-Zmiri-env-set=STRIBECK_TEST_PANICS=1 -Zmiri-deterministic-floats",
        STRIBECK_KILLS="50",
        STRIBECK_PROCESSES="64",
        STRIBECK_THOROUGH="1",
    )


@task("an hour or two")
def tolerances() -> None:
    """How often a run that says that it reached its end is wrong: every law that has rates, 200 sets of parameters, at
    tolerances from 1e-3 to 1e-10, on four systems."""
    run("cargo", "bench", "--package", "stribeck-solve", "--bench", "tolerances")


@task("hours")
def identified() -> None:
    """How often the intervals of an identification hold the truth: 200 seeds of every law, and joints, sliders, mounts
    and others of simulators of their own; how fast its search is, what a camera does to it. Goes on where it ended."""
    need_rust()
    run(sys.executable, "tests/identified.py")


@task("3 to 6 minutes")
def formats() -> None:
    """MDF 4 and MAT files against asammdf and scipy, channel by channel, and damaged files."""
    need_rust()
    folder = ROOT / "target" / "formats"
    if not (folder / "venv").exists():
        run(sys.executable, "-m", "venv", folder / "venv")
    python = folder / "venv" / PYTHON.relative_to(VENV)
    run(python, "-m", "pip", "install", "--quiet", "--requirement", "tests/formats/requirements.txt")
    run(python, "tests/formats/write.py", folder / "files")
    test = ["cargo", "test", "--package", "stribeck-sheet", "--test", "binary"]
    run(*test, "--", "--nocapture", FORMATS=str(folder / "files"), RUST_BACKTRACE="0")


@task("many hours")
def trust() -> None:
    """Everything in docs/trust.md, one task after another, with the figures at the end."""
    first = [wheel, wheels, page, site, faults, platforms, release, fuzz, coverage]
    then = [broken, newcomer, mutants, tolerances, identified, formats, supply]
    summarise([[sys.executable, "tasks.py", part.__name__] for part in first + then])


def setup_tool(tool: str) -> dict[str, str]:
    """Builds a cargo tool, unless it exists; returns the environment in which cargo finds it."""
    run("cargo", "install", "--quiet", "--locked", "--root", TOOLS, tool)
    return {"PATH": f"{TOOLS / 'bin'}{os.pathsep}{os.environ['PATH']}"}


@task("5 to 10 minutes, then seconds")
def supply() -> None:
    """The rules of deny.toml for the crates of the library and of the workspace; then known vulnerabilities, including
    those of crates that only tests use."""
    need_rust()
    tools = setup_tool(SUPPLY_TOOL)
    deny = ["cargo", "deny", "--locked", "--manifest-path"]
    library, workspace = [*deny, "Cargo.toml", "--exclude-dev"], [*deny, "Cargo.toml", "--workspace"]
    # The exceptions of deny.toml are for crates that are not in the library.
    run(*library, "check", "--allow", "license-exception-not-encountered", "bans", "licenses", "sources", **tools)
    run(*workspace, "check", "licenses", "sources", **tools)
    for_tests = [[*deny, f"{folder}/Cargo.toml", "--config", "deny.toml"] for folder in ("fuzz", "tests/importers")]
    for crates in for_tests:
        run(*crates, "check", "sources", **tools)
    print("figure: licences, bans and sources of the crates: passed", flush=True)
    try:
        run(*workspace, "fetch", "db", **tools)
    except TaskError as error:
        raise TaskError(
            "advisories NOT CHECKED, everything else passed: the list of known vulnerabilities "
            "(github.com/RustSec/advisory-db) could not be fetched; repeat this where github.com is reachable"
        ) from error
    for crates in (workspace, *for_tests):
        run(*crates, "--offline", "check", "advisories", **tools)
    print("figure: no known vulnerability in a crate", flush=True)


@task("8 to 15 minutes")
def coverage() -> None:
    """Branches covered by the tests."""
    if platform.system() != "Linux":
        raise TaskError("this task needs Linux: it calls the library from programs that gcc links")
    need_rust()
    need("rustup", "this task needs the Rust of https://rustup.rs, which has the tools of LLVM")
    run("rustup", "component", "add", "llvm-tools")
    setup()
    environment = setup_tool(COVERAGE_TOOL)
    # Rust counts branches only in unstable builds; the compiler is the same.
    build = {**environment, "RUSTC_BOOTSTRAP": "1", "CARGO_PROFILE_DEV_DEBUG": "0"}
    # Otherwise counters and test programs of earlier sources would count too.
    run("cargo", "llvm-cov", "clean", "--workspace", **build)
    run("cargo", "llvm-cov", "--branch", "--no-report", *CRATES, "--lib", "--tests", **build)
    run(PYTHON, "tests/coverage.py")


@task("5 to 10 minutes")
def broken() -> None:
    """Deliberately broken copies of the library, and the tests that fail."""
    need_rust()
    need("git", "it lists what to copy, and applies the patches")
    run(sys.executable, "tests/broken/patches.py")


@task("15 to 30 minutes")
def newcomer() -> None:
    """A law that is added to a copy, as a contributor would, and everything that must take it."""
    need_rust()
    need("git", "it lists what to copy")
    setup()
    run(PYTHON, "tests/newcomer/run.py")


@task("10 to 20 minutes")
def mutants() -> None:
    """Many small changes to the laws, and how many of them the tests catch."""
    need_rust()
    if WINDOWS:
        raise TaskError("this task limits processor times, which Windows does not support")
    need("git", "it lists what to copy")
    run(sys.executable, "tests/broken/mutants.py", **setup_tool(MUTATION_TOOL))


@task("10 to 20 minutes")
def fuzz() -> None:
    """Coverage-guided fuzzing under the address sanitizer. Findings are in target/fuzz/found."""
    need_rust()
    need_c_compiler()
    # A report names the lines.
    run(sys.executable, "fuzz/run.py", "--long", "120", CARGO_PROFILE_RELEASE_DEBUG="line-tables-only")


@task("3 to 7 minutes")
def bench() -> None:
    """The benchmarks."""
    need_rust()
    run("cargo", "bench")


@task("seconds")
def clean() -> None:
    """Removes all output of the tasks."""
    for folder in (VENV, ROOT / "dist", ROOT / "out", ROOT / "target"):
        print(f"removing {folder}")
        shutil.rmtree(folder, ignore_errors=True)


def main() -> int:
    lines = [textwrap.fill(described(name), 110, initial_indent="  ", subsequent_indent="      ") for name in TASKS]
    parser = argparse.ArgumentParser(
        description=__doc__,
        epilog="\n".join(["tasks:", *lines]),
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("task", choices=TASKS, metavar="task", help="one of those below")
    name = parser.parse_args().task
    print(described(name), flush=True)
    # Python compiles each file that it imports once, not in each of many processes, and leaves nothing beside sources.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["PYTHONPYCACHEPREFIX"] = str(debug_folder().parent / "python")
    try:
        TASKS[name][0]()
    except TaskError as error:
        print(f"\n{name} failed: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"\n{name} interrupted", file=sys.stderr)
        return 130
    print(f"\n{name}: done, in {processor_time() / 60:.1f} minutes of processor time.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
