"""Stick-slip of a block on a moving belt: the BeltRig FMU coupled with a friction FMU by fmpy.

The start values are those of the benchmark in F. Novais, MSc thesis, University of Minho (2024): m = 1 kg, k = 2 N/m,
v_b = 0.1 m/s, mu_k = 0.1, mu_s = 0.15. By default the block starts at rest on the belt, and presses on it with its
weight. Models in the plane and in space slide along x. The orders of the co-simulation:

    sequential   the friction FMU steps first, the rig then steps with its force (Gauss-Seidel)
    feedthrough  the force is read as soon as the inputs are set, then both step
    parallel     both step, then exchange all values (Jacobi): what most masters do
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy
from prepared import Clock, Flag, Reals, make

from examples.fmpy.coupling import (
    FMUS,
    CouplingError,
    Fmu,
    friction_path_of,
    numbers_of,
    open_fmu,
    path_of,
    variables_of,
)

EXCHANGES = ("sequential", "feedthrough", "parallel")

# Recorded variables of the rig at each communication point, in this order.
RECORDED = ("position", "block_velocity", "velocity", "external_force", "der(block_velocity)")

# Inputs of friction models, and the variable of the rig that is passed on to them. The belt does not accelerate.
CONNECTIONS = {"velocity": "velocity", "external_force": "external_force", "acceleration": "der(block_velocity)"}


@dataclass(frozen=True)
class BeltRun:
    """The computed motion: one entry of each array per recorded communication point, in SI units.

    `friction_force` is the force with which the rig takes its next step, `acceleration` that at the beginning of this
    step. `velocity` is that of the block relative to the belt, `block_velocity` that relative to the ground.
    """

    model: str
    time: numpy.ndarray
    position: numpy.ndarray
    block_velocity: numpy.ndarray
    velocity: numpy.ndarray
    external_force: numpy.ndarray
    acceleration: numpy.ndarray
    friction_force: numpy.ndarray
    sticking: numpy.ndarray


class Coupling:
    """The rig and a friction FMU, connected by the names of their variables."""

    def __init__(self, rig: Fmu, friction: Fmu, step: float):
        self.clock = Clock(step)
        inputs = dict(zip(friction.along_x(*CONNECTIONS), CONNECTIONS.values(), strict=True))
        passed_on = {name: source for name, source in inputs.items() if name in friction.names("input")}
        # The outputs of one FMU and the inputs of the other share memory.
        self.to_friction = Reals(friction, *passed_on)
        self.from_rig = Reals(rig, *passed_on.values(), values=self.to_friction.values)
        self.force = Reals(friction, *friction.along_x("friction_force"))
        self.to_rig = Reals(rig, "friction_force", values=self.force.values)
        self.recorded = Reals(rig, *RECORDED)
        self.sticking = Flag(friction, "sticking")
        self.friction_step, self.rig_step = self.clock.do_step(friction), self.clock.do_step(rig)

    def calls(self, exchange: str) -> list:
        """The calls of each step, up to the step of the rig."""
        inform, force = [self.from_rig.get, self.to_friction.set], [self.force.get, self.to_rig.set]
        return {
            "sequential": [*inform, self.friction_step, *force],
            "feedthrough": [*inform, *force, self.friction_step],
            "parallel": [*force, *inform, self.friction_step],
        }[exchange]

    def record(self) -> list[float]:
        """The state of the rig, the force with which it takes its next step, and whether the contact sticks."""
        make(self.recorded.get, self.sticking.get)
        return [*self.recorded.values, self.force.values[0], self.sticking.values[0]]

    def run(self, exchange: str, steps: int, every: int) -> numpy.ndarray:
        """Makes `steps` steps; returns a row for each communication point whose number is divisible by `every`."""
        calls, step = self.calls(exchange), self.clock.step.value
        rows = numpy.empty((steps // every + 1, len(RECORDED) + 2))
        for at in range(steps):
            self.clock.time.value = at * step
            if at % every:
                make(*calls, self.rig_step)
            else:
                make(*calls)
                rows[at // every] = self.record()
                make(self.rig_step)
        # After the last step there is a motion but no further force.
        if steps % every == 0:
            rows[-1] = self.record()
        return rows


def rig_values(rig_path: Path, chosen: Mapping[str, object]) -> dict[str, float]:
    """Start values of the rig; the block starts at rest on the belt unless `chosen` gives it another velocity."""
    variables = variables_of(rig_path)
    names = ("mass", "stiffness", "belt_velocity", "gravity", "position")
    values = {name: float(variables[name].start) for name in names}
    values |= numbers_of(rig_path, chosen)
    return {"block_velocity": values["belt_velocity"]} | values


def friction_values(
    friction_path: Path, rig: Mapping[str, float], exchange: str, chosen: Mapping[str, object]
) -> dict[str, object]:
    """Values of the law: the weight of the block; for a law that holds a body at rest, its mass and the order of
    exchange; for one with two branches that the forces decide between them; `chosen` takes precedence.
    """
    values = {"normal_force": rig["mass"] * rig["gravity"]}
    if "acceleration_source" in variables_of(friction_path):
        values |= {"acceleration_source": "Balance"}
    if "mass" in variables_of(friction_path):
        values |= {"mass": rig["mass"], "exchange": "Parallel" if exchange == "parallel" else "Sequential"}
    return values | dict(chosen)


def is_random(model: str, fmu_dir: Path = FMUS) -> bool:
    """Whether the motion of a law is random, with other random numbers for another step."""
    return "seed" in variables_of(friction_path_of(model, fmu_dir))


def limit_of_step(
    model: str,
    fmu_dir: Path = FMUS,
    parameters: Mapping[str, object] | None = None,
    rig: Mapping[str, object] | None = None,
) -> float:
    """Largest communication step at which a block at rest on the belt does not chatter; infinite without such a limit.

    A law that knows the mass looks ahead to the end of the step. Otherwise a force exchanged once per step is stable
    below 2 m / (df/dv), with the slope of the law at rest.
    """
    friction_path = friction_path_of(model, fmu_dir)
    start = rig_values(path_of("BeltRig", fmu_dir), rig or {})
    chosen = friction_values(friction_path, start, "sequential", parameters or {})
    if float(chosen.get("mass", 0.0)) > 0.0:
        return math.inf
    with open_fmu(friction_path, chosen) as friction:
        force, velocity = (friction.references(*friction.along_x(name)) for name in ("friction_force", "velocity"))
        slope = friction.slave.getDirectionalDerivative(force, velocity, [1.0])[0]
    return 2.0 * start["mass"] / slope if slope > 0.0 else math.inf


def run_belt(
    fmu_dir: Path = FMUS,
    model: str = "CoulombStiction",
    step: float = 1e-3,
    time: float = 40.0,
    exchange: str = "sequential",
    parameters: Mapping[str, object] | None = None,
    rig: Mapping[str, object] | None = None,
    every: int = 1,
) -> BeltRun:
    """Couples the BeltRig FMU with a friction FMU; `parameters` are those of the friction FMU, `rig` start values of
    the rig. Every `every`-th communication point is recorded.
    """
    steps = round(time / step) if math.isfinite(time) else 0
    if steps < 1:
        raise CouplingError(f"time = {time} s: must be at least one step of {step} s")
    rig_path, friction_path = path_of("BeltRig", fmu_dir), friction_path_of(model, fmu_dir)
    start = rig_values(rig_path, rig or {})
    chosen = friction_values(friction_path, start, exchange, parameters or {})
    with open_fmu(rig_path, start) as block, open_fmu(friction_path, chosen) as friction:
        rows = Coupling(block, friction, step).run(exchange, steps, every)
    position, block_velocity, velocity, external_force, acceleration, force, sticking = rows.T
    times = step * every * numpy.arange(len(rows))
    moving = position, block_velocity, velocity, external_force, acceleration
    return BeltRun(model, times, *moving, force, sticking.astype(bool))
