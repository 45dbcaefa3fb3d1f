"""An importer of FMI 3.0: an instance whose variables are read and set by name, whatever their type."""

import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import fmpy
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.model_description import ModelDescription, ScalarVariable

from examples.fmpy.coupling import FMUS

FOLDER = FMUS / "fmi3"
# Enumerations are set and read as Int64.
NAMES = {"Enumeration": "Int64"}


@dataclass
class Instance3:
    """An instance of an FMU for FMI 3.0."""

    fmu: FMU3Slave | FMU3Model
    description: ModelDescription
    variables: dict[str, ScalarVariable] = field(init=False)

    def __post_init__(self) -> None:
        self.variables = {variable.name: variable for variable in self.description.modelVariables}

    def reference(self, name: str) -> int:
        """Value reference of a variable."""
        return self.variables[name].valueReference

    def _access(self, verb: str, name: str):
        kind = self.variables[name].type
        return getattr(self.fmu, f"{verb}{NAMES.get(kind, kind)}")

    def get(self, name: str, count: int | None = None) -> list[float]:
        """Values of a variable: as many as the description says it has, or `count`."""
        size = 1
        for length in self.variables[name].shape or ():
            size *= length
        values = self._access("get", name)([self.reference(name)], size if count is None else count)
        return [float(value) for value in values]

    def set(self, name: str, values: list[float]) -> None:
        """Sets a variable with all its elements."""
        is_float = self.variables[name].type == "Float64"
        self._access("set", name)([self.reference(name)], values if is_float else [int(value) for value in values])


@contextmanager
def open_instance(
    model: str | Path,
    values: Mapping[str, list[float]] | None = None,
    exchange: bool = False,
    events: bool = False,
    early_return: bool = True,
) -> Iterator[Instance3]:
    """Makes an instance that is ready to be initialised, with these start values; frees it at the end. With `events` it
    is one for co-simulation in event mode, whose steps end early at an event if they may."""
    path = str(model if isinstance(model, Path) else FOLDER / f"{model}.fmu")
    description, folder = fmpy.read_model_description(path, validate=False), fmpy.extract(path)
    try:
        kind, interface = (FMU3Model, description.modelExchange) if exchange else (FMU3Slave, description.coSimulation)
        fmu = kind(
            guid=description.guid,
            modelIdentifier=interface.modelIdentifier,
            unzipDirectory=str(folder),
            instanceName=description.modelName,
        )
        modes = {"eventModeUsed": events, "earlyReturnAllowed": events and early_return}
        fmu.instantiate(loggingOn=True, **({} if exchange else modes))
        try:
            instance = Instance3(fmu, description)
            for name, given in (values or {}).items():
                instance.set(name, given)
            yield instance
        finally:
            fmu.freeInstance()
    finally:
        shutil.rmtree(Path(folder), ignore_errors=True)


@contextmanager
def stepping(model: str, values: Mapping[str, list[float]] | None = None) -> Iterator[Instance3]:
    """An instance for co-simulation after its initialisation."""
    with open_instance(model, values) as instance:
        instance.fmu.enterInitializationMode(startTime=0.0)
        instance.fmu.exitInitializationMode()
        yield instance
        instance.fmu.terminate()


@contextmanager
def integrating(model: str, values: Mapping[str, list[float]] | None = None) -> Iterator[Instance3]:
    """An instance for Model Exchange in continuous-time mode."""
    with open_instance(model, values, exchange=True) as instance:
        instance.fmu.enterInitializationMode(startTime=0.0)
        instance.fmu.exitInitializationMode()
        while instance.fmu.updateDiscreteStates()[0]:
            pass
        instance.fmu.enterContinuousTimeMode()
        yield instance
        instance.fmu.terminate()
