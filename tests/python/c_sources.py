"""C sources of the laws: made by fmu-build, compiled, and driven along random motions beside the library."""

import ctypes
import os
import random
import struct
import subprocess
import sys
from functools import cache
from pathlib import Path
from unittest import mock

import pytest
from fmpy import extract, instantiate_fmu, read_model_description
from fmpy.build import build_platform_binary

ROOT = Path(__file__).resolve().parents[2]
DRIVER = ROOT / "tests" / "sources" / "drive.c"
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
FMU_BUILD = TARGET / "debug" / ("fmu-build.exe" if os.name == "nt" else "fmu-build")
NAMES = {"win32": "stribeck.dll", "darwin": "libstribeck.dylib"}
WARNINGS = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-ffp-contract=off"]


LIBRARY = ["rustc", "--print", "target-libdir", "--target", "wasm32-unknown-unknown"]
FOLDER = Path(subprocess.run(LIBRARY, capture_output=True, text=True).stdout.strip())
needs_wasm = pytest.mark.skipif(
    not any(FOLDER.glob("libstd-*.rlib")), reason="C sources need `rustup target add wasm32-unknown-unknown`"
)


def make(*arguments: str | Path) -> None:
    """Runs fmu-build."""
    command = [FMU_BUILD, "--project", ROOT, *arguments]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@cache
def described(model: str):
    """The variables in the description of a model."""
    return read_model_description(str(ROOT / "modelDescription" / f"{model}.xml"), validate=False).modelVariables


def variables(model: str):
    """Real inputs and outputs of a model."""
    reals = [one for one in described(model) if one.type == "Real"]
    return [[one for one in reals if one.causality == causality] for causality in ("input", "output")]


def parameters(model: str):
    """Parameters of a model that are numbers, choices or yes and no."""
    kinds = ("Real", "Enumeration", "Boolean")
    return [one for one in described(model) if one.causality == "parameter" and one.type in kinds]


def with_sources() -> list[str]:
    """Models that have C sources: those without a choice of law."""
    descriptions = (ROOT / "modelDescription").glob("*.xml")
    return sorted(path.stem for path in descriptions if 'friction.model"' not in path.read_text(encoding="utf-8"))


def motion(model: str, steps: int, seed: int = 1) -> list[tuple[float, list[float]]]:
    """Steps of random lengths with random inputs, within the bounds of the inputs: often slow, sometimes at rest."""
    inputs, _ = variables(model)
    source = random.Random(f"{model} {seed}")
    rows = []
    for _ in range(steps):
        values = []
        for one in inputs:
            start, size = float(one.start or 0.0), 10.0 ** source.uniform(-6.0, 0.5)
            value = start * source.uniform(0.5, 1.5) if start else source.choice([-size, 0.0, size, size])
            if one.min is not None:
                value = max(value, float(one.min))
            values.append(min(value, float(one.max)) if one.max is not None else value)
        rows.append((10.0 ** source.uniform(-5.0, -2.0), values))
    return rows


def drawn(source: random.Random, parameter) -> float:
    """A value of a parameter: a number near its start value, within its bounds, or any choice."""
    if parameter.type == "Boolean":
        return float(source.random() < 0.5)
    if parameter.type == "Enumeration":
        return float(source.choice(parameter.declaredType.items).value)
    value = float(parameter.start) * source.uniform(0.8, 1.25)
    value = max(value, float(parameter.min)) if parameter.min is not None else value
    return min(value, float(parameter.max)) if parameter.max is not None else value


def with_parameters(model: str, rows, seed: int = 1):
    """The steps of a motion, in which every row also gives the parameters, with values that are drawn once."""
    source = random.Random(f"parameters of {model} {seed}")
    values = [drawn(source, one) for one in parameters(model)]
    return [(dt, [*inputs, *values]) for dt, inputs in rows]


def given(model: str, rows):
    """What the rows of a motion give: inputs, and parameters if there are any values for them."""
    return [*variables(model)[0], *parameters(model)][: len(rows[0][1])]


def bits(value: float) -> str:
    return struct.pack(">d", value).hex()


def question(model: str, rows) -> str:
    """A motion as the driver reads it."""
    inputs, outputs = given(model, rows), variables(model)[1]
    lines = [f"{len(inputs)} {len(outputs)} {len(rows)}"]
    lines += [" ".join(str(one.valueReference) for one in group) for group in (inputs, outputs)]
    lines += [" ".join([bits(dt), *map(bits, values)]) for dt, values in rows]
    return "\n".join(lines) + "\n"


def library_at(path: Path | None = None) -> ctypes.CDLL:
    """The library, as the FMUs have it."""
    folder = Path(os.environ.get("STRIBECK_LIBRARY", TARGET / "fmu" / "release"))
    return ctypes.CDLL(str(path or folder / NAMES.get(sys.platform, "libstribeck.so")))


def of_library(model: str, rows, path: Path | None = None, values: dict[str, float] | None = None) -> list[list[str]]:
    """What the library answers with these values, as bits; the status of a step that it refuses."""
    library = library_at(path)
    instance, value = ctypes.c_void_p(), ctypes.c_double()
    assert library.stribeck_create(model.encode(), ctypes.byref(instance)) == 0
    for name, number in (values or {}).items():
        assert library.stribeck_set_by_name(instance, name.encode(), ctypes.c_double(number)) == 0
    inputs, outputs = given(model, rows), variables(model)[1]
    answers = []
    for dt, values in rows:
        statuses = [
            library.stribeck_set(instance, ctypes.c_uint32(one.valueReference), ctypes.c_double(number))
            for one, number in zip(inputs, values, strict=True)
        ]
        refusals = [status for status in statuses if status] or [library.stribeck_step(instance, ctypes.c_double(dt))]
        if refusals[-1]:
            answers.append([str(refusals[-1])])
            continue
        answer = []
        for one in outputs:
            assert library.stribeck_get(instance, ctypes.c_uint32(one.valueReference), ctypes.byref(value)) == 0
            answer.append(bits(value.value))
        answers.append(answer)
    library.stribeck_free(instance)
    return answers


def headers(folder: Path) -> dict[str, Path]:
    """The headers of sources in a folder, by model: a header begins with the names of both."""
    return {path.read_text(encoding="ascii").split(": ")[1]: path for path in folder.glob("*.h")}


def compiled(header: Path, compiler: list[str], out: str) -> Path:
    """A program of the driver and the sources of one model."""
    folder, name = header.parent, header.stem
    program = folder / f"{name}{out}"
    law = [f"-DLAW={name}", f'-DHEADER="{header.name}"', f"-DSTATE_OF_{name}={name.upper()}_STATE", f"-I{folder}"]
    command = [*compiler, *law, str(DRIVER), str(folder / f"{name}.c"), "-o", str(program), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, f"{command}\n{done.stderr[:3000]}"
    return program


def answer(command: list[str], text: str) -> list[list[str]]:
    """What a program answers to a motion."""
    done = subprocess.run(command, input=text, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, f"{command}: exit code {done.returncode}"
    return [line.split() for line in done.stdout.splitlines()]


def built(fmu: Path, folder: Path) -> Path:
    """The files of an FMU in a folder, with a library that fmpy has compiled of its sources."""
    extract(str(fmu), str(folder))
    work = folder / "build"
    work.mkdir()
    # fmpy calls cmake, which is beside this Python.
    programs = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    with mock.patch.dict(os.environ, PATH=programs):
        build_platform_binary(folder, build_dir=work)
    return folder


def begun(folder, values=(), logger=None):
    """An instance that has been initialised, after these choices were made."""
    described = read_model_description(str(folder), validate=False)
    fmu = instantiate_fmu(str(folder), described, "CoSimulation", debug_logging=logger is not None, logger=logger)
    is_two = described.fmiVersion == "2.0"
    for reference, number in values:
        (fmu.setInteger if is_two else fmu.setInt64)([reference], [number])
    if is_two:
        fmu.setupExperiment(startTime=0.0)
        fmu.enterInitializationMode()
    else:
        fmu.enterInitializationMode(startTime=0.0)
    fmu.exitInitializationMode()
    return fmu


def moved(fmu, model: str) -> list[list[float]]:
    """The outputs after each step of a motion, of an instance of either version."""
    is_two = hasattr(fmu, "setReal")
    inputs, outputs = ([one.valueReference for one in group] for group in variables(model))
    results, time = [], 0.0
    for dt, values in motion(model, 400):
        (fmu.setReal if is_two else fmu.setFloat64)(inputs, values)
        fmu.doStep(time, dt)
        time += dt
        results.append((fmu.getReal if is_two else fmu.getFloat64)(outputs))
    fmu.freeInstance()
    return results
