"""What `make demo` shows: a law with its curves as soon as there can be one, FMUs in Python, laws on the belt of the
thesis, and a fit. Commands of one stage run side by side.

    python3 tasks.py demo
"""

import shlex
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import tasks

# Crates that a few runs and one fit do not repay optimising further.
FOR_A_FEW_RUNS = [f"--config=profile.dev.package.stribeck-{it}.opt-level=1" for it in ("solve", "measured", "fit")]
# Those of Table 6.5 of the thesis.
LAWS_ON_BELT = ["Karnopp", "BengisuAkay", "Andersson", "Awrejcewicz"]
LAWS_ON_BELT += ["Specker", "LinearStiction", "Hollars", "BrownMcPhee"]

FMU_BUILD = ["cargo", "run", "--package", "fmu-build", "--"]
# Run half a minute longer than optimised, and built in five minutes less; solvers of other crates would take one more.
OF_PROGRAM = [*FOR_A_FEW_RUNS, "--package", "stribeck-cli", "--no-default-features"]
PACKAGES = [sys.executable, "-m", "examples.demo", "packages"]
PAGE = Path("out/pages/LuGre/documentation/index.html")

NEXT = """
{program} show LuGre
    the variables of a law; --help says what else the program does
dist/*.fmu
    for your tool: docs/fmu.md says which file, and how to connect it
python3 -m venv out/env, then out/env/bin/python -m pip install ./python
    laws as functions on arrays: docs/python.md
docs/start.md
    five minutes for each of five kinds of users
""".strip()

BEGIN = time.monotonic()


def stage(title: str, *commands: list[str | Path]) -> None:
    """Runs commands side by side, and prints how long they took together; a failure ends the demo."""
    begin, used = time.monotonic(), tasks.processor_time()
    print(f"\n== {title}", flush=True)
    for command in commands:
        print(f"> {shlex.join(map(str, command))}", flush=True)
    try:
        running = [subprocess.Popen(list(map(str, command)), cwd=tasks.ROOT) for command in commands]
    except OSError as error:
        raise tasks.TaskError(f"cannot run {error.filename}: {error.strerror}") from error
    ended = [process.wait() for process in running]
    now, used = time.monotonic(), tasks.processor_time() - used
    print(f"{now - begin:.0f} s, of the processor {used:.0f} s; {now - BEGIN:.0f} s since the beginning", flush=True)
    for command, status in zip(commands, ended, strict=True):
        if status != 0:
            raise tasks.TaskError(f"exit code {status}: {shlex.join(map(str, command))}")


def show(what: str, path: Path) -> None:
    """Says where a picture is."""
    print(f"\n*** {what}: {path}", flush=True)


def main() -> None:
    tasks.need_rust()
    stage("Packages of Python, and a first page", PACKAGES, [*FMU_BUILD, "pages", "LuGre"])
    show("First picture, a law with equations and curves; open it in a browser", PAGE)
    # The library is optimised as a whole, on one processor. Started by cargo, it would wait for the other command.
    pack = [tasks.debug_folder() / "fmu-build", "pack", "--out", "dist"]
    stage("FMUs of all models, and the program", pack, ["cargo", "build", *OF_PROGRAM])
    program = tasks.debug_folder() / "stribeck"
    stage("FMUs in Python", [tasks.PYTHON, "-m", "examples.fmpy.demo"])
    stage("Laws on the belt of the thesis", [program, "compare", "--law", *LAWS_ON_BELT, "--pictures", "out/belt"])
    show("Motion, friction and loops of each law", Path("out/belt"))
    stage("A record of a virtual rig", [program, "rig", "--law", "LuGre", "--out", "out/rig"])
    known = ["--law", "LuGre", "--mass", "2", "--normal-force", "20", "--reference", "out/rig/truth.toml"]
    report = Path("out/identification.html")
    stage("A fit of it", [program, "identify", "out/rig/force.csv", *known, "--report", report])
    show("What the record says of the law", report)
    print(f"\nWhat next:\n{textwrap.indent(NEXT.format(program=program), '    ')}")


if __name__ == "__main__":
    try:
        if sys.argv[1:] == ["packages"]:
            tasks.setup(tasks.REQUIREMENTS_OF_DEMO)
        else:
            main()
    except tasks.TaskError as error:
        sys.exit(f"\ndemo failed: {error}")
    except KeyboardInterrupt:
        sys.exit(130)
