"""An importer that integrates: FMUs for Model Exchange, coupled by their inputs and outputs, and SciPy's solver."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from ctypes import c_double
from dataclasses import dataclass, field

import fmpy
import numpy
from fmpy.fmi2 import FMU2Model
from fmpy.simulation import apply_start_values
from scipy.integrate import BDF, DOP853, LSODA, RK45, Radau
from scipy.optimize import brentq

from examples.fmpy.coupling import path_of


@dataclass
class Part:
    """An instance for Model Exchange, after its initialisation."""

    fmu: FMU2Model
    references: dict[str, int]
    states: int
    indicators: int

    def get(self, name: str) -> float:
        """Value of a variable."""
        return self.fmu.getReal([self.references[name]])[0]

    def set(self, name: str, value: float) -> None:
        """Sets an input."""
        self.fmu.setReal([self.references[name]], [value])

    @property
    def x(self) -> numpy.ndarray:
        """The states."""
        return self._read(self.fmu.getContinuousStates, self.states)

    @x.setter
    def x(self, values: numpy.ndarray) -> None:
        self.fmu.setContinuousStates((c_double * self.states)(*values), self.states)

    def rates(self) -> numpy.ndarray:
        """Time derivatives of the states."""
        return self._read(self.fmu.getDerivatives, self.states)

    def event_indicators(self) -> numpy.ndarray:
        """The event indicators."""
        return self._read(self.fmu.getEventIndicators, self.indicators)

    def directional(self, unknown: str, known: str) -> float:
        """Derivative of one variable with respect to another."""
        return self.fmu.getDirectionalDerivative([self.references[unknown]], [self.references[known]], [1.0])[0]

    def settle(self) -> None:
        """Processes an event and returns to continuous time."""
        while self.fmu.newDiscreteStates()[0]:
            pass
        self.fmu.enterContinuousTimeMode()

    def at_event(self) -> None:
        """Processes an event."""
        self.fmu.enterEventMode()
        self.settle()

    def completed_step(self) -> bool:
        """Reports the end of a solver's step; returns whether the part requests an event."""
        asks, ends = self.fmu.completedIntegratorStep()
        assert not ends
        return bool(asks)

    @staticmethod
    def _read(function, count: int) -> numpy.ndarray:
        values = (c_double * count)()
        function(values, count)
        return numpy.array(values)


@contextmanager
def open_part(model: str, **parameters: float) -> Iterator[Part]:
    """Instantiates and initialises an FMU for Model Exchange; it is left in continuous-time mode."""
    path = path_of(model)
    description = fmpy.read_model_description(str(path))
    folder = fmpy.extract(str(path))
    fmu = FMU2Model(
        guid=description.guid,
        modelIdentifier=description.modelExchange.modelIdentifier,
        unzipDirectory=str(folder),
        instanceName=model,
    )
    try:
        fmu.instantiate()
        fmu.setupExperiment(startTime=0.0)
        apply_start_values(fmu, description, dict(parameters))
        fmu.enterInitializationMode()
        fmu.exitInitializationMode()
        references = {variable.name: variable.valueReference for variable in description.modelVariables}
        part = Part(fmu, references, description.numberOfContinuousStates, description.numberOfEventIndicators)
        part.settle()
        yield part
        fmu.terminate()
        fmu.freeInstance()
    finally:
        shutil.rmtree(folder, ignore_errors=True)


@dataclass(frozen=True)
class System:
    """Parts whose outputs are the inputs of others; `links` are (from, output, to, input), in the order of transfer."""

    parts: list[Part]
    links: list[tuple[Part, str, Part, str]]

    def put(self, time: float, x: numpy.ndarray) -> None:
        """Gives all parts their time, states and inputs."""
        for part in self.parts:
            part.fmu.setTime(time)
            part.x, x = x[: part.states], x[part.states :]
        for source, output, target, wanted in self.links:
            target.set(wanted, source.get(output))

    def x(self) -> numpy.ndarray:
        """The states of all parts."""
        return numpy.concatenate([part.x for part in self.parts])

    def rates(self, time: float, x: numpy.ndarray) -> numpy.ndarray:
        """Their time derivatives."""
        self.put(time, x)
        return numpy.concatenate([part.rates() for part in self.parts])

    def indicators(self, time: float, x: numpy.ndarray) -> numpy.ndarray:
        """The event indicators of all parts."""
        self.put(time, x)
        return numpy.concatenate([part.event_indicators() for part in self.parts])

    def completed_step(self, time: float, x: numpy.ndarray) -> bool:
        """Reports the end of a solver's step to all parts; returns whether one of them requests an event."""
        self.put(time, x)
        return sum(part.completed_step() for part in self.parts) > 0

    def at_event(self, time: float, x: numpy.ndarray) -> numpy.ndarray:
        """Processes an event in all parts; returns the states after it."""
        self.put(time, x)
        for part in self.parts:
            part.at_event()
        return self.x()


# A solver that finds an event stops after it: by so much, in s.
BEHIND = 1e-11

# More events than that in a run are chattering.
MOST_EVENTS = 1000


@dataclass
class Run:
    """A run of a system: its states at the requested times, and the times of its events."""

    states: list[numpy.ndarray] = field(default_factory=list)
    events: list[float] = field(default_factory=list)


METHODS = {solver.__name__: solver for solver in (BDF, DOP853, LSODA, RK45, Radau)}


def integrate(system: System, times: numpy.ndarray, method: str, tolerance: float) -> Run:
    """Integrates a system and stops at its events."""
    run, time, end = Run(), float(times[0]), float(times[-1])
    x = system.at_event(time, system.x())
    while len(run.events) < MOST_EVENTS:
        nominal = numpy.maximum(numpy.abs(x), 1e-5)
        solver = METHODS[method](system.rates, time, x, end, rtol=tolerance, atol=tolerance * nominal, max_step=0.05)
        event = _until_event(system, solver, times, run)
        if event is None:
            return run
        time, x = event
        run.events.append(time)
        if time >= end:
            return run
        x = system.at_event(time, x)
    raise AssertionError(f"more than {MOST_EVENTS} events until {time} s")


def _until_event(system: System, solver, times: numpy.ndarray, run: Run) -> tuple[float, numpy.ndarray] | None:
    """Makes steps, and keeps the requested states, up to the next event: its time and the states there, if any."""
    before = system.indicators(solver.t, solver.y)
    while solver.status == "running":
        message = solver.step()
        assert solver.status != "failed", message
        begin, time, state = solver.t_old, solver.t, solver.dense_output()
        after = system.indicators(time, solver.y)
        crossed = numpy.flatnonzero((before > 0.0) != (after > 0.0))
        if len(crossed) > 0:
            # A solver that finds an event stops after it.
            time = min(_crossing(system, state, at, begin, time) for at in crossed) + BEHIND
        asks = system.completed_step(time, state(time))
        is_first = len(run.states) == 0
        run.states += [state(at) for at in times if begin < at <= time or (is_first and at == begin)]
        if asks or len(crossed) > 0:
            return time, state(time)
        before = after
    return None


def _crossing(system: System, state, at: int, begin: float, end: float) -> float:
    """The time at which an indicator changes its sign."""

    def indicator(time: float) -> float:
        return system.indicators(time, state(time))[at]

    # A change that is not found along the interpolated states is at the end of the step.
    if (indicator(begin) > 0.0) == (indicator(end) > 0.0):
        return end
    return brentq(indicator, begin, end, xtol=1e-15, rtol=1e-15)
