"""The FMUs packed by `python3 tasks.py platforms`, and wine as needed by the tests."""

import os
import subprocess

import pytest
from machines import ARM, FMUS, FMUS_OF_COPY, MAC_ARM, WINE, WINE_FILES, Machine, for_linux, library_of

from examples.fmpy.coupling import models_in

COMMAND = """#!/bin/sh
# fmpy passes a lock file as third argument. Its lock is not seen by wine, and the server would end at once.
exec {wine} "$1" "$2"
"""


def pytest_sessionstart() -> None:
    """Fails without FMUs."""
    for folder in (FMUS, FMUS / ARM, FMUS_OF_COPY):
        if not models_in(folder):
            pytest.exit(f"no FMUs in {folder}: run `python3 tasks.py platforms`", returncode=1)


@pytest.fixture(scope="session")
def wine() -> dict[str, str]:
    """Environment of programs that run under wine, with a command `wine64` as fmpy needs it."""
    programs = WINE_FILES / "bin"
    programs.mkdir(parents=True, exist_ok=True)
    command = programs / "wine64"
    command.write_text(COMMAND.format(wine=WINE), encoding="utf-8")
    command.chmod(0o755)
    environment = {
        "WINEPREFIX": str(WINE_FILES / "prefix"),
        "WINEDEBUG": "-all",
        "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}",
    }
    # Creates the prefix the first time.
    subprocess.run([WINE, "wineboot", "-i"], check=True, capture_output=True, env={**os.environ, **environment})
    return environment


@pytest.fixture(scope="session")
def machines(wine, tmp_path_factory) -> dict[str, Machine]:
    """The platforms by name, each with the library of a packed FMU."""
    folder = tmp_path_factory.mktemp("libraries")
    model = models_in(FMUS)[0]
    fmu, fmu_for_arm = FMUS / f"{model}.fmu", FMUS / ARM / f"{model}.fmu"
    arm_root = "/usr/aarch64-linux-gnu"
    linux = library_of(fmu, "linux64", ".so", folder)
    windows = library_of(fmu, "win64", ".dll", folder)
    arm = library_of(fmu_for_arm, ARM, ".so", folder)
    mac = library_of(fmu, "darwin64", ".dylib", folder)
    arm_compiler, arm_runner = ["aarch64-linux-gnu-gcc"], ["qemu-aarch64-static", "-L", arm_root]
    machines = [
        Machine("linux64", ["cc"], [], linux, {}),
        Machine("win64", ["x86_64-w64-mingw32-gcc"], [str(WINE)], windows, wine),
        Machine(ARM, arm_compiler, arm_runner, arm, {}),
        Machine("darwin64", ["cc"], [], for_linux(mac, "Intel", ["cc"]), {}),
        Machine(MAC_ARM, arm_compiler, arm_runner, for_linux(mac, "Apple", arm_compiler), {}),
    ]
    return {machine.platform: machine for machine in machines}
