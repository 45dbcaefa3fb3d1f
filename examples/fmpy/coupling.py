"""Functions shared by the example programs: open an FMU, address its variables by name, show its messages."""

import argparse
import difflib
import math
import shutil
import sys
from collections import deque
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from ctypes import byref
from dataclasses import dataclass
from pathlib import Path

import fmpy
import numpy
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave, defaultCallbacks, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.model_description import ModelDescription, ScalarVariable
from fmpy.simulation import apply_start_values

PROJECT = Path(__file__).resolve().parents[2]
FMUS = PROJECT / "dist"


class CouplingError(Exception):
    """An error in the user's input; the text says what is wrong and what would be right."""


@dataclass(frozen=True)
class Fmu:
    """An FMU that has been instantiated and initialised."""

    description: ModelDescription
    slave: FMU2Slave

    def names(self, causality: str) -> list[str]:
        """Names of all variables that are an `input`, `output`, `parameter`, ..."""
        return [variable.name for variable in self.description.modelVariables if variable.causality == causality]

    def references(self, *names: str) -> list[int]:
        """Value references of variables, as FMI's get and set functions require. Look them up once, not per step."""
        variables = _by_name(self.description)
        _refuse_unknown(self.description, names, "variable", list(variables))
        return [variables[name].valueReference for name in names]

    def along_x(self, *names: str) -> list[str]:
        """Names of the same quantities in a model in the plane or in space, whose vectors have a component along x."""
        known = _by_name(self.description)
        return [name if name in known else f"{name}_x" for name in names]


def path_of(model: str, folder: Path = FMUS) -> Path:
    """The file of a model's FMU."""
    path = Path(folder) / f"{model}.fmu"
    if not path.is_file():
        present = models_in(folder)
        hint = f"there are {', '.join(present)}" if present else "there is none: run `python3 tasks.py pack`"
        hint += _meant(model, present)
        raise CouplingError(f"no FMU of the model '{model}' in {folder}: {hint}")
    return path


def models_in(folder: Path = FMUS) -> list[str]:
    """Names of the models whose FMUs are in a folder."""
    return sorted(path.stem for path in Path(folder).glob("*.fmu"))


def friction_models_in(folder: Path = FMUS) -> list[str]:
    """Names of the models that compute a friction force from a sliding velocity along a line."""
    return [model for model in models_in(folder) if _is_friction_model(path_of(model, folder))]


def laws_in(folder: Path = FMUS) -> list[str]:
    """Names of all friction models, including those in the plane and in space."""
    return [model for model in models_in(folder) if _is_law(path_of(model, folder))]


def friction_path_of(model: str, folder: Path = FMUS) -> Path:
    """The file of a friction model's FMU."""
    path = path_of(model, folder)
    if not _is_law(path):
        raise CouplingError(f"{model} is not a friction model; there are {', '.join(laws_in(folder))}")
    return path


def variables_of(path: Path) -> dict[str, ScalarVariable]:
    """The variables of an FMU by name."""
    return _by_name(fmpy.read_model_description(str(path)))


def numbers_of(path: Path, parameters: Mapping[str, object]) -> dict[str, object]:
    """Parameters of an FMU as numbers, including those given as text or as the name of a choice; unknown names and
    invalid values are rejected."""
    return _start_values(fmpy.read_model_description(str(path)), parameters)


@contextmanager
def open_fmu(path: Path, parameters: Mapping[str, object] | None = None) -> Iterator[Fmu]:
    """Extracts, instantiates and initialises an FMU; at the end terminates it, frees it and deletes the extracted
    files.

    `parameters` are set before the initialisation, when fixed ones may still be set. If a call inside the `with` block
    fails, the reason that the FMU logged becomes the text of a `CouplingError`.
    """
    description = fmpy.read_model_description(str(path))
    values = _start_values(description, parameters or {})
    folder = fmpy.extract(str(path))
    try:
        slave = FMU2Slave(
            guid=description.guid,
            modelIdentifier=description.coSimulation.modelIdentifier,
            unzipDirectory=str(folder),
            instanceName=description.modelName,
        )
        # Without loggingOn many FMUs do not report their errors; those of this project do.
        slave.instantiate(callbacks=_CALLBACKS, loggingOn=True)
        try:
            _initialise(slave, description, values)
            yield Fmu(description, slave)
            slave.terminate()
        finally:
            slave.freeInstance()
    except FMICallException as error:
        # The exception may come from another FMU that is open at the same time: then leave it alone.
        if not _latest_message or _latest_message[0][0] != description.modelName:
            raise
        raise CouplingError(": ".join(_latest_message[0])) from error
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _initialise(slave: FMU2Slave, description: ModelDescription, values: dict[str, object]) -> None:
    slave.setupExperiment(startTime=0.0)
    apply_start_values(slave, description, values)
    slave.enterInitializationMode()
    slave.exitInitializationMode()


def _start_values(description: ModelDescription, parameters: Mapping[str, object]) -> dict[str, object]:
    variables = _by_name(description)
    # Start values of inputs and states may be set as well; parameters come first in the message for a wrong name.
    settable = [name for name, variable in variables.items() if variable.start is not None]
    settable.sort(key=lambda name: variables[name].causality != "parameter")
    _refuse_unknown(description, parameters, "parameter", settable)
    return {name: _value(variables[name], value) for name, value in parameters.items()}


def _value(variable: ScalarVariable, value: object) -> object:
    """The value of a parameter, which may be given as text, or for an enumeration as the name of a choice."""
    choices = {item.name: item.value for item in (variable.declaredType.items or [])} if variable.declaredType else {}
    if value in choices:
        return choices[value]
    try:
        return float(value) if variable.type == "Real" else int(value)
    except ValueError:
        wanted = f"one of {', '.join(choices)}" if choices else f"a number ({variable.type})"
        raise CouplingError(f"{variable.name} = '{value}': must be {wanted}") from None


def _by_name(description: ModelDescription) -> dict[str, ScalarVariable]:
    return {variable.name: variable for variable in description.modelVariables}


def _is_friction_model(path: Path, axis: str = "") -> bool:
    causality = {name: variable.causality for name, variable in variables_of(path).items()}
    # A contact with a choice of laws is a part of the shock absorber.
    is_law = "friction.model" not in causality
    moves = causality.get(f"velocity{axis}") == causality.get("normal_force") == "input"
    return is_law and moves and causality.get(f"friction_force{axis}") == "output"


def _is_law(path: Path) -> bool:
    return _is_friction_model(path) or _is_friction_model(path, "_x")


def _refuse_unknown(description: ModelDescription, names: object, kind: str, known: list[str]) -> None:
    for name in names:
        if name not in known:
            text = f"{description.modelName} has no {kind} '{name}'; it has {', '.join(known)}"
            raise CouplingError(text + _meant(name, known))


def _meant(name: str, known: list[str]) -> str:
    """A hint with the known names nearest to an unknown one."""
    folded = {one.lower(): one for one in known}
    near = [folded[one] for one in difflib.get_close_matches(name.lower(), folded)]
    return f". Did you mean {' or '.join(near)}?" if near else ""


# Instance name and text of the latest message of any FMU.
_latest_message: deque[tuple[str, str]] = deque(maxlen=1)


def _show(_environment: int, instance: bytes, _status: int, category: bytes, message: bytes) -> None:
    """Prints a log message of an FMU and keeps it as the reason of a failing call."""
    name, kind, text = instance.decode(), category.decode(), message.decode()
    _latest_message.append((name, text))
    print(f"{name}: {text} [{kind}]", file=sys.stderr)


def _callbacks() -> fmi2CallbackFunctions:
    callbacks = fmi2CallbackFunctions()
    callbacks.logger = fmi2CallbackLoggerTYPE(_show)
    callbacks.allocateMemory = defaultCallbacks.allocateMemory
    callbacks.freeMemory = defaultCallbacks.freeMemory
    # FMI's logger takes printf arguments, which ctypes cannot receive; fmpy brings a small library that formats them,
    # for the platforms it knows.
    try:
        from fmpy.logging import addLoggerProxy
    except OSError:
        return callbacks
    addLoggerProxy(byref(callbacks))
    return callbacks


# One record for all FMUs: fmpy's formatting library keeps the last logger set, for the whole process.
_CALLBACKS = _callbacks()


def command_line(about: str, model: str, out: str, of: str = "the friction model") -> argparse.ArgumentParser:
    """The options that all programs have; `of` names the owner of the parameters."""
    parser = argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--model", default=model, help=f"friction model (default: {model})")
    add_settable(parser, "--set", f"parameter of {of}")
    parser.add_argument("--fmus", type=Path, default=FMUS, help="folder of the FMUs (default: dist)")
    parser.add_argument("--out", default=out, help=f"result files, without extension (default: {out})")
    return parser


def add_settable(parser: argparse.ArgumentParser, flag: str, meaning: str, **more: str) -> None:
    """Adds an option that sets a value by its name."""
    setting = {"type": parameter, "action": "append", "default": [], "metavar": "NAME=VALUE"}
    parser.add_argument(flag, help=f"{meaning}; repeatable", **setting, **more)


def parameter(text: str) -> tuple[str, str]:
    """Reads `name=value` from the command line."""
    name, equals, value = text.partition("=")
    if not (name and equals and value):
        raise argparse.ArgumentTypeError(f"'{text}' is not of the form name=value")
    return name, value


def number(text: str) -> float:
    """Reads a finite number from the command line."""
    try:
        value = float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number") from None
    if not math.isfinite(value):
        raise argparse.ArgumentTypeError(f"'{text}' must be finite")
    return value


def positive(text: str) -> float:
    """Reads a number > 0 from the command line."""
    value = number(text)
    if value <= 0.0:
        raise argparse.ArgumentTypeError(f"'{text}' must be > 0 and finite")
    return value


def not_negative(text: str) -> float:
    """Reads a number >= 0 from the command line."""
    value = number(text)
    if value < 0.0:
        raise argparse.ArgumentTypeError(f"'{text}' must be >= 0 and finite")
    return value


def write_csv(path: Path, columns: Mapping[str, numpy.ndarray]) -> None:
    """Writes columns under headings with units, such as `velocity [m/s]`."""
    path.parent.mkdir(parents=True, exist_ok=True)
    table = numpy.column_stack(list(columns.values()))
    with path.open("w", encoding="utf-8", newline="\n") as file:
        numpy.savetxt(file, table, fmt="%.10g", delimiter=",", header=",".join(columns), comments="")


def main(program) -> int:
    """Runs a program; errors that the user can correct are reported in one line, without a traceback."""
    try:
        program()
    except CouplingError as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0
