"""Friction force along a recorded motion: a friction FMU driven by a CSV file.

    python -m examples.fmpy.replay --model LuGre --motion examples/fmpy/motion.csv --set sigma_0=2e6

Writes <out>.csv and <out>.png. The file must have the columns `time [s]`, `position [m]`, `velocity [m/s]` and
`normal_force [N]`; others are ignored. Between two samples the inputs move linearly (fmi2SetRealInputDerivatives), if
the FMU supports it; with --hold they keep their values until the next sample.
"""

import argparse
import csv
import math
import sys
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy

from examples.fmpy.coupling import CouplingError, Fmu, command_line, friction_path_of, main, open_fmu, write_csv
from examples.fmpy.make_motion import MOTION
from examples.fmpy.pictures import draw_replay

COLUMNS = ["time [s]", "position [m]", "velocity [m/s]", "normal_force [N]"]


@dataclass(frozen=True)
class Motion:
    """A recorded motion: one entry of each array per sample, in SI units."""

    time: numpy.ndarray
    position: numpy.ndarray
    velocity: numpy.ndarray
    normal_force: numpy.ndarray


@dataclass(frozen=True)
class Replay:
    """The friction force at the samples of a motion."""

    model: str
    motion: Motion
    friction_force: numpy.ndarray
    dissipated_energy: numpy.ndarray

    def columns(self) -> dict[str, numpy.ndarray]:
        """The columns of the CSV file."""
        motion = self.motion
        recorded = dict(zip(COLUMNS, (motion.time, motion.position, motion.velocity, motion.normal_force), strict=True))
        return recorded | {"friction_force [N]": self.friction_force, "dissipated_energy [J]": self.dissipated_energy}


def read_motion(path: Path) -> Motion:
    """Reads a motion; errors in a file are reported with the line."""
    try:
        with Path(path).open(encoding="utf-8-sig", newline="") as file:
            lines = list(csv.reader(file))
    except OSError as error:
        raise CouplingError(f"cannot read {path}: {error.strerror}") from None
    except UnicodeDecodeError:
        raise CouplingError(f"{path} is not a text file in UTF-8") from None
    if len(lines) < 3:
        raise CouplingError(f"{path}: must have a heading and at least two samples, has {len(lines)} lines")
    heading = [name.strip() for name in lines[0]]
    for name in COLUMNS:
        if name not in heading:
            raise CouplingError(f"{path}: no column '{name}'; it has {', '.join(heading)}")
    places = [heading.index(name) for name in COLUMNS]
    rows = [_numbers(path, number, line, places) for number, line in enumerate(lines[1:], start=2)]
    motion = Motion(*numpy.array(rows).T)
    backwards = numpy.flatnonzero(numpy.diff(motion.time) <= 0.0)
    if len(backwards):
        before, after = motion.time[backwards[0] : backwards[0] + 2]
        raise CouplingError(f"{path}, line {backwards[0] + 3}: time {after} s is not after {before} s")
    return motion


def _numbers(path: Path, number: int, line: list[str], places: list[int]) -> list[float]:
    """The numbers of one line of the file."""
    values = []
    for place, name in zip(places, COLUMNS, strict=True):
        text = line[place] if place < len(line) else ""
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if not math.isfinite(value):
            raise CouplingError(f"{path}, line {number}: {name} is '{text}', must be a finite number")
        values.append(value)
    return values


def drive(friction: Fmu, motion: Motion, interpolate: bool) -> tuple[numpy.ndarray, numpy.ndarray]:
    """Steps the FMU from sample to sample; returns friction force and dissipated energy at the samples."""
    slave = friction.slave
    inputs = friction.references(*friction.along_x("velocity", "normal_force"))
    outputs = friction.references(*friction.along_x("friction_force", "dissipated_energy"))
    samples = numpy.column_stack((motion.velocity, motion.normal_force))
    steps = numpy.diff(motion.time)
    slopes = (numpy.diff(samples, axis=0) / steps[:, None]).tolist()
    samples, steps = samples.tolist(), steps.tolist()
    time = (motion.time - motion.time[0]).tolist()
    results = numpy.empty((len(samples), 2))
    for at, sample in enumerate(samples):
        slave.setReal(inputs, sample)
        results[at] = slave.getReal(outputs)
        if at < len(steps):
            if interpolate:
                slave.setRealInputDerivatives(inputs, [1, 1], slopes[at])
            slave.doStep(time[at], steps[at])
    return results[:, 0], results[:, 1]


def replay(path: Path, motion: Motion, parameters: Mapping[str, object] | None = None, hold: bool = False) -> Replay:
    """Computes the friction force of an FMU along a motion."""
    with open_fmu(path, parameters) as friction:
        can_interpolate = friction.description.coSimulation.canInterpolateInputs
        force, energy = drive(friction, motion, interpolate=can_interpolate and not hold)
        return Replay(friction.description.modelName, motion, force, energy)


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = command_line(__doc__, model="LuGre", out="out/replay")
    parser.add_argument("--motion", type=Path, default=MOTION, help="CSV file (default: examples/fmpy/motion.csv)")
    parser.add_argument("--hold", action="store_true", help="hold the inputs between the samples")
    return parser.parse_args()


def program() -> None:
    """Runs the simulation selected on the command line."""
    options = arguments()
    motion = read_motion(options.motion)
    result = replay(friction_path_of(options.model, options.fmus), motion, dict(options.set), options.hold)
    table, picture = Path(f"{options.out}.csv"), Path(f"{options.out}.png")
    write_csv(table, result.columns())
    draw_replay(result, picture)
    span = motion.time[-1] - motion.time[0]
    print(f"{result.model}: {result.dissipated_energy[-1]:.4g} J dissipated in {span:.4g} s")
    print(f"{table}\n{picture}")


if __name__ == "__main__":
    sys.exit(main(program))
