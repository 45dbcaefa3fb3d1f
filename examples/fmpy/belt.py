#!/usr/bin/env python3
"""Stick-slip of a block on a moving belt: the BeltRig FMU coupled with a friction FMU of your choice.

    python examples/fmpy/belt.py --model LuGre --set mu_s=0.2 --step 5e-4

Writes <out>.csv and <out>.png. The parameters are those of the benchmark in F. Novais, MSc thesis, University of Minho
(2024): m = 1 kg, k = 2 N/m, v_b = 0.1 m/s, mu_k = 0.1, mu_s = 0.15. `--exchange` is the order of the co-simulation:

    sequential   the friction FMU steps first, the rig then steps with its force (Gauss-Seidel)
    feedthrough  the force is read as soon as the inputs are set, then both step
    parallel     both step, then exchange all values (Jacobi): what most masters do
"""

import argparse
import math
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy
from analysis import Cycle, measure
from coupling import (
    FMUS,
    CouplingError,
    Fmu,
    command_line,
    friction_path_of,
    main,
    open_fmu,
    path_of,
    positive,
    variables_of,
    write_csv,
)
from pictures import draw_belt

EXCHANGES = ("sequential", "feedthrough", "parallel")

# What is read from the rig at each communication point, in this order; the last two may be inputs of a friction model.
RIG_OUTPUTS = ["position", "block_velocity", "velocity", "external_force"]


@dataclass(frozen=True)
class BeltRun:
    """The computed motion: one entry of each array per communication point, in SI units.

    `friction_force` is the force on which the rig takes its next step. `velocity` is that of the block relative to the
    belt, `block_velocity` the one relative to the ground.
    """

    model: str
    time: numpy.ndarray
    position: numpy.ndarray
    block_velocity: numpy.ndarray
    velocity: numpy.ndarray
    external_force: numpy.ndarray
    friction_force: numpy.ndarray
    sticking: numpy.ndarray

    def columns(self) -> dict[str, numpy.ndarray]:
        """The columns of the CSV file."""
        return {
            "time [s]": self.time,
            "position [m]": self.position,
            "block_velocity [m/s]": self.block_velocity,
            "velocity [m/s]": self.velocity,
            "external_force [N]": self.external_force,
            "friction_force [N]": self.friction_force,
            "sticking": self.sticking,
        }


class Coupling:
    """The rig and a friction FMU, connected by the names of their variables."""

    def __init__(self, rig: Fmu, friction: Fmu):
        self.rig, self.friction = rig.slave, friction.slave
        shared = [name for name in RIG_OUTPUTS if name in friction.names("input")]
        self.passed_on = [RIG_OUTPUTS.index(name) for name in shared]
        self.rig_outputs = rig.references(*RIG_OUTPUTS)
        self.rig_force = rig.references("friction_force")
        self.friction_inputs = friction.references(*shared)
        self.friction_force = friction.references("friction_force")
        self.friction_sticking = friction.references("sticking")

    def look(self) -> list[float]:
        """The outputs of the rig."""
        return self.rig.getReal(self.rig_outputs)

    def inform_friction(self, seen: list[float]) -> None:
        """Sets the inputs of the friction FMU."""
        self.friction.setReal(self.friction_inputs, [seen[at] for at in self.passed_on])

    def force(self) -> list[float]:
        """The output of the friction FMU."""
        return self.friction.getReal(self.friction_force)

    def sequential(self, seen: list[float], time: float, step: float) -> list[float]:
        """One step in which the rig uses the force at the end of the friction FMU's step."""
        self.inform_friction(seen)
        self.friction.doStep(time, step)
        force = self.force()
        self.rig.setReal(self.rig_force, force)
        self.rig.doStep(time, step)
        return force

    def feedthrough(self, seen: list[float], time: float, step: float) -> list[float]:
        """One step in which the rig uses the force at its beginning."""
        self.inform_friction(seen)
        force = self.force()
        self.rig.setReal(self.rig_force, force)
        self.friction.doStep(time, step)
        self.rig.doStep(time, step)
        return force

    def parallel(self, seen: list[float], time: float, step: float) -> list[float]:
        """One step in which the rig uses the force that the friction FMU computed from values one step old."""
        force = self.force()
        self.inform_friction(seen)
        self.rig.setReal(self.rig_force, force)
        self.friction.doStep(time, step)
        self.rig.doStep(time, step)
        return force

    def run(self, exchange: str, step: float, steps: int) -> tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
        """Makes `steps` steps; returns the rig's outputs, the force and whether the contact sticks."""
        advance = dict(zip(EXCHANGES, (self.sequential, self.feedthrough, self.parallel), strict=True))[exchange]
        outputs = numpy.empty((steps + 1, len(RIG_OUTPUTS)))
        forces = numpy.empty(steps + 1)
        sticking = numpy.empty(steps + 1, dtype=bool)
        for at in range(steps):
            seen = self.look()
            outputs[at] = seen
            forces[at] = advance(seen, at * step, step)[0]
            sticking[at] = self.friction.getBoolean(self.friction_sticking)[0]
        # After the last step there is a motion but no further force.
        outputs[steps], forces[steps], sticking[steps] = self.look(), forces[steps - 1], sticking[steps - 1]
        return outputs, forces, sticking


def time_stepping(friction_path: Path, rig_path: Path, exchange: str) -> dict[str, object]:
    """What a law that holds a body at rest must be told: the mass of the body, and how values are exchanged."""
    known = variables_of(friction_path)
    values = {
        "mass": variables_of(rig_path)["mass"].start,
        "exchange": "Parallel" if exchange == "parallel" else "Sequential",
    }
    return values if "mass" in known else {}


def limit_of_step(model: str, fmu_dir: Path = FMUS, parameters: Mapping[str, object] | None = None) -> float:
    """Largest communication step at which a block at rest on the belt does not chatter; infinite if any will do.

    A law that knows the mass looks ahead to the end of the step. Otherwise a force that is exchanged once per step is
    stable below 2 m / (df/dv), with the slope of the law at rest.
    """
    rig_path, friction_path = path_of("BeltRig", fmu_dir), friction_path_of(model, fmu_dir)
    chosen = time_stepping(friction_path, rig_path, "sequential") | dict(parameters or {})
    if float(chosen.get("mass", 0.0)) > 0.0:
        return math.inf
    with open_fmu(friction_path, chosen) as friction:
        force, velocity = friction.references("friction_force"), friction.references("velocity")
        slope = friction.slave.getDirectionalDerivative(force, velocity, [1.0])[0]
    return 2.0 * float(variables_of(rig_path)["mass"].start) / slope if slope > 0.0 else math.inf


def run_belt(
    fmu_dir: Path = FMUS,
    model: str = "CoulombStiction",
    step: float = 1e-3,
    time: float = 40.0,
    exchange: str = "sequential",
    parameters: Mapping[str, object] | None = None,
) -> BeltRun:
    """Couples the BeltRig FMU with a friction FMU; `parameters` are those of the friction FMU."""
    steps = round(time / step)
    if steps < 1:
        raise CouplingError(f"time = {time} s: must be at least one step of {step} s")
    rig_path, friction_path = path_of("BeltRig", fmu_dir), friction_path_of(model, fmu_dir)
    chosen = time_stepping(friction_path, rig_path, exchange) | dict(parameters or {})
    with open_fmu(rig_path) as rig, open_fmu(friction_path, chosen) as friction:
        outputs, forces, sticking = Coupling(rig, friction).run(exchange, step, steps)
    return BeltRun(model, step * numpy.arange(steps + 1), *outputs.T, forces, sticking)


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = command_line(__doc__, model="CoulombStiction", out="out/belt")
    parser.add_argument("--step", type=positive, default=1e-3, help="communication step in s (default: 1e-3)")
    parser.add_argument("--time", type=positive, default=40.0, help="simulated time in s (default: 40)")
    parser.add_argument("--exchange", choices=EXCHANGES, default="sequential", help="default: sequential")
    return parser.parse_args()


def summary(cycle: Cycle) -> str:
    """Says in words what was measured."""
    if math.isnan(cycle.first_slip):
        return "the block never slips"
    if math.isnan(cycle.period):
        return f"first slip at {cycle.first_slip:.4f} s; too short for a period"
    return f"first slip at {cycle.first_slip:.4f} s, then a period of {cycle.period:.4f} s"


def program() -> None:
    """Runs what the command line asks for."""
    options = arguments()
    run = run_belt(options.fmus, options.model, options.step, options.time, options.exchange, dict(options.set))
    table, picture = Path(f"{options.out}.csv"), Path(f"{options.out}.png")
    write_csv(table, run.columns())
    draw_belt(run, picture)
    print(f"{run.model}: {summary(measure(run.time, run.position, run.sticking))}")
    limit = limit_of_step(options.model, options.fmus, dict(options.set))
    if options.step > limit:
        print(f"the law is steep: a block at rest chatters unless --step is below {limit:.1e} s")
    print(f"{table}\n{picture}")


if __name__ == "__main__":
    sys.exit(main(program))
