"""Compiles the actuator plugin against the headers and the library in the mujoco package, and against libstribeck.

    python -m examples.multibody.plugin.build_plugin

Needs a C++ compiler: c++, or the one in CXX; and cargo, unless
STRIBECK_LIBRARY names the folder of libstribeck. Linux and macOS only.
"""

import json
import os
import platform
import shlex
import subprocess
import sys
from pathlib import Path

import mujoco

from examples.fmpy.coupling import PROJECT, CouplingError, main

SOURCE = Path(__file__).resolve().parent / "shock_absorber.cpp"
ENDING = ".dylib" if platform.system() == "Darwin" else ".so"


def run(*command: str | Path) -> str:
    """Runs a command that must succeed and returns what it prints."""
    words = [str(word) for word in command]
    try:
        done = subprocess.run(words, cwd=PROJECT, capture_output=True, text=True)
    except OSError as error:
        raise CouplingError(f"cannot run {words[0]}: {error}") from error
    if done.returncode != 0:
        raise CouplingError(f"{shlex.join(words)}\n{done.stdout}{done.stderr}")
    return done.stdout


def library() -> Path:
    """The path of libstribeck, which is built unless it is in the folder that STRIBECK_LIBRARY names."""
    folder = os.environ.get("STRIBECK_LIBRARY")
    if folder is None:
        run("cargo", "build", "--release", "--lib", "--package", "libstribeck")
        target = json.loads(run("cargo", "metadata", "--format-version", "1", "--no-deps"))["target_directory"]
        folder = Path(target) / "release"
    return Path(folder).resolve() / f"libstribeck{ENDING}"


def build(folder: Path = PROJECT / "out") -> Path:
    """Compiles the plugin into a folder and returns its path."""
    if os.name == "nt":
        raise CouplingError("this script builds the plugin on Linux and macOS only")
    package = Path(mujoco.__file__).parent
    simulator = next(package.glob(f"libmujoco*{ENDING}*"))
    stribeck = library()
    plugin = folder / f"libshock_absorber{ENDING}"
    folder.mkdir(parents=True, exist_ok=True)
    warnings = ["-Wall", "-Wextra", "-Werror"]
    includes = ["-I", PROJECT / "include", "-isystem", package / "include"]
    paths = [f"-Wl,-rpath,{path.parent}" for path in (simulator, stribeck)]
    compiler = shlex.split(os.environ.get("CXX", "c++"))
    command = [*compiler, "-std=c++17", "-O2", "-fPIC", "-shared", *warnings, *includes, SOURCE, simulator, stribeck]
    run(*command, *paths, "-o", plugin)
    return plugin


def program() -> None:
    """Builds the plugin and prints its path."""
    print(build())


if __name__ == "__main__":
    sys.exit(main(program))
