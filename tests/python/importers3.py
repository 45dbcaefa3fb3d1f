"""Runs a system of FMUs of FMI 3.0 in importers of different origin, in the exchange scheme of importers.py, with and
without event mode."""

import platform
import re
import sys
import zipfile
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from fmi3 import FOLDER, Instance3, open_instance
from importers import in_ecos, in_rust, run_plan, rust_master
from masters import Component, Record, Signals, System, columns, split


def in_version_3(parts: System) -> System:
    """The same system with the FMUs of FMI 3.0."""
    return replace(parts, components=[replace(part, fmu=FOLDER / part.fmu.name) for part in parts.components])


def step(instance: Instance3, time: float, length: float) -> list[float]:
    """Makes a communication step, and handles the events on its way; returns their times."""
    at, end, times = time, time + length, []
    while at < end:
        event, ends, early, reached = instance.fmu.doStep(at, length if at == time else end - at)
        assert not ends
        at = reached if early else end
        if event:
            times.append(at)
            instance.fmu.enterEventMode()
            leave_event_mode(instance)
    return times


def leave_event_mode(instance: Instance3) -> None:
    """Handles an event."""
    while instance.fmu.updateDiscreteStates()[0]:
        pass
    instance.fmu.enterStepMode()


@contextmanager
def component(part: Component, events: bool, early_return: bool = True):
    """A component of a system, initialised."""
    values = {name: [float(value)] for name, value in part.parameters.items()}
    with open_instance(part.fmu, values, events=events, early_return=early_return) as instance:
        instance.fmu.enterInitializationMode(startTime=0.0)
        instance.fmu.exitInitializationMode()
        if events:
            leave_event_mode(instance)
        yield instance
        instance.fmu.terminate()


class Coupled:
    """Instances that exchange values."""

    def __init__(self, parts: System, fmus: Mapping[str, Instance3], signals: Signals) -> None:
        self.connections, self.fmus, self.signals = parts.connections, fmus, signals
        # At the start, values propagate through all components.
        for _ in fmus:
            self.give(self.outputs())

    def outputs(self) -> list[list[float]]:
        """The values that are passed on."""
        return [self.fmus[source].get(output) for (source, output), _ in self.connections]

    def give(self, values: Sequence[list[float]]) -> None:
        """Passes values on."""
        for (_, (target, variable)), value in zip(self.connections, values, strict=True):
            self.fmus[target].set(variable, value)

    def begin(self, number: int) -> None:
        """Sets the signals of the beginning of a step."""
        for (part, name), values in self.signals.items():
            self.fmus[part].set(name, [values[number]])

    def read(self, watched: Sequence[str]) -> list[float]:
        """Values of variables."""
        return [self.fmus[part].get(name)[0] for part, name in map(split, watched)]


def in_fmpy3(
    parts: System, length: float, steps: int, watched: Sequence[str], signals: Signals, events: bool = False
) -> Record:
    """The plain script on fmpy."""
    with ExitStack() as stack:
        fmus = {part.name: stack.enter_context(component(part, events)) for part in parts.components}
        coupled, rows = Coupled(parts, fmus, signals), []
        for number in range(steps):
            coupled.begin(number)
            for fmu in fmus.values():
                step(fmu, number * length, length)
            rows.append(coupled.read(watched))
            coupled.give(coupled.outputs())
        return columns(watched, rows)


def with_common_events(parts: System, length: float, steps: int, watched: Sequence[str], signals: Signals) -> Record:
    """The plain script on fmpy, as a container of the FMU manipulation toolbox does it: no step ends early; after one
    with an event all enter Event Mode, in which values are passed on once more."""
    with ExitStack() as stack:
        fmus = {part.name: stack.enter_context(component(part, True, early_return=False)) for part in parts.components}
        coupled, rows = Coupled(parts, fmus, signals), []
        for number in range(steps):
            coupled.begin(number)
            events = [fmu.fmu.doStep(number * length, length)[0] for fmu in fmus.values()]
            if any(events):
                values = coupled.outputs()
                for fmu in fmus.values():
                    fmu.fmu.enterEventMode()
                coupled.give(values)
                for fmu in fmus.values():
                    leave_event_mode(fmu)
            rows.append(coupled.read(watched))
            coupled.give(coupled.outputs())
        return columns(watched, rows)


def in_fmi(parts: System, length: float, steps: int, watched: Sequence[str], signals: Signals) -> Record:
    """The crate fmi 0.8.0 refuses descriptions with units, nominal values, ampere or kelvin: it gets others."""
    with TemporaryDirectory() as folder:
        copies = [Path(folder) / f"{part.name}.fmu" for part in parts.components]
        for part, copy in zip(parts.components, copies, strict=True):
            plainly_described(part.fmu, copy)
        return run_plan([rust_master(), "run", "fmi3"], parts, copies, length, steps, watched, signals)


def plainly_described(fmu: Path, copy: Path) -> None:
    """Copies an FMU, with what the crate fmi takes of its description."""
    with zipfile.ZipFile(fmu) as source, zipfile.ZipFile(copy, "w") as target:
        for name in ("modelDescription.xml", *(one for one in source.namelist() if one.startswith("binaries/"))):
            data = source.read(name)
            if name == "modelDescription.xml":
                text = re.sub(r"<UnitDefinitions>.*</UnitDefinitions>", "", data.decode(), flags=re.DOTALL)
                data = re.sub(r' (unit|displayUnit|nominal)="[^"]*"', "", text).encode()
            target.writestr(name, data)


IMPORTERS3: dict[str, Callable[..., Record]] = {
    "fmpy": in_fmpy3,
    "fmi": in_fmi,
    "fmi-rs": in_rust("fmi-rs3"),
    **({"ecos": in_ecos} if sys.platform == "linux" and platform.machine() == "x86_64" else {}),
}
IN_EVENT_MODE: dict[str, Callable[..., Record]] = {
    "fmpy": partial(in_fmpy3, events=True),
    "fmi-rs": in_rust("fmi-rs3-events"),
}
