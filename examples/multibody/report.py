"""Functions shared by the quarter cars of all multibody examples: command line, record, figures, CSV and picture."""

import argparse
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy

from examples.fmpy.coupling import FMUS, CouplingError, add_settable, positive, write_csv
from examples.multibody.friction_pictures import Quantity, draw_runs
from examples.multibody.hosted_strut import Strut
from examples.multibody.suspension import BUMP

COLUMNS = {
    "time": "s",
    "road_height": "m",
    "body_height": "m",
    "wheel_height": "m",
    "length": "m",
    "velocity": "m/s",
    "force": "N",
    "friction": "N",
    "normal_1": "N",
    "normal_2": "N",
}

FRICTION = Quantity("friction", "friction force [N]")
COMPRESSION = Quantity("compression", "compression of the strut [mm]", 1e3)
OVER_TIME = [Quantity("body_height", "height of the body [mm]", 1e3), COMPRESSION, FRICTION]
LOOPS = [
    (Quantity("velocity", "velocity of the strut [m/s]"), Quantity("force", "force of the strut [kN]", 1e-3)),
    (COMPRESSION, FRICTION),
]


@dataclass(frozen=True)
class Run:
    """A computed motion: one entry of each array per step. Heights are deviations from the design position."""

    label: str
    design_length: float
    time: numpy.ndarray
    road_height: numpy.ndarray
    body_height: numpy.ndarray
    wheel_height: numpy.ndarray
    length: numpy.ndarray
    velocity: numpy.ndarray
    force: numpy.ndarray
    friction: numpy.ndarray
    normal_1: numpy.ndarray
    normal_2: numpy.ndarray

    def rest_height(self) -> float:
        """Height of the body just before the bump, or at the end of a run that ends before it."""
        return float(numpy.interp(BUMP.start, self.time, self.body_height))

    def largest_stroke(self) -> float:
        """Largest compression of the strut from its design length."""
        return self.design_length - float(self.length.min())

    def drawn(self) -> dict[str, numpy.ndarray]:
        """The quantities in the picture, by name."""
        return {**{name: getattr(self, name) for name in COLUMNS}, "compression": self.design_length - self.length}

    def summary(self) -> str:
        """The figures of the run."""
        rest, stroke, friction = 1e3 * self.rest_height(), 1e3 * self.largest_stroke(), numpy.abs(self.friction).max()
        return f"rest height {rest:.4f} mm, largest stroke {stroke:.4f} mm, largest friction {friction:.1f} N"

    def columns(self) -> dict[str, numpy.ndarray]:
        """The columns of the CSV file."""
        return {f"{name} [{unit}]": getattr(self, name) for name, unit in COLUMNS.items()}


class Recorder:
    """Rows of a run, written one after the other."""

    def __init__(self):
        self.rows: list[list[float]] = []

    def add(self, strut: Strut, **values: float) -> None:
        """Writes one row, with the height of the road and the contacts of the strut."""
        values |= {"road_height": BUMP.at(values["time"])[0], "friction": strut.friction()}
        values |= zip(("normal_1", "normal_2"), strut.contact_loads(), strict=True)
        self.rows.append([values[name] for name in COLUMNS])

    def run(self, label: str, design_length: float) -> Run:
        """The recorded run."""
        return Run(label, design_length, *numpy.array(self.rows).T)


def steps_of(time: float, step: float) -> range:
    """The steps of a run."""
    steps = round(time / step)
    if steps < 1:
        raise CouplingError(f"time = {time} s: must be at least one step of {step} s")
    return range(steps)


def quarter_car_options(about: str, out: str) -> argparse.ArgumentParser:
    """The options that all quarter cars have."""
    parser = argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--step", type=positive, default=1e-3, help="communication step in s (default: 1e-3)")
    parser.add_argument("--time", type=positive, default=4.0, help="simulated time in s (default: 4)")
    parser.add_argument("--law", default="LuGre", help="friction law of the strut (default: LuGre)")
    parser.add_argument("--no-friction", action="store_true", help="only the run without friction")
    parser.add_argument("--native", action="store_true", help="a strut written in Python instead of the FMU")
    add_settable(parser, "--set", "parameter of the ShockAbsorber")
    parser.add_argument("--fmus", type=Path, default=FMUS, help="folder of the FMUs (default: dist)")
    parser.add_argument("--out", default=out, help=f"result files, without extension (default: {out})")
    return parser


def cases_of(options: argparse.Namespace, parameters: Mapping[str, object]) -> dict[str, dict[str, object]]:
    """Parameters of the run with friction, if requested, and of the one without."""
    chosen = {**parameters, "friction.model": options.law, **dict(options.set)}
    without = {"without friction": {**chosen, "friction.model": "None"}}
    return without if options.no_friction else {"with friction": chosen, **without}


def report_quarter_car(title: str, runs: list[Run], out: str) -> None:
    """Prints the figures of the runs, writes a CSV file of each and one picture."""
    for run in runs:
        table = Path(f"{out}_{run.label.replace(' ', '_')}.csv")
        write_csv(table, run.columns())
        print(f"{run.label}: {run.summary()}\n{table}")
    picture = Path(f"{out}.png")
    draw_runs(title, {run.label: run.drawn() for run in runs}, OVER_TIME, LOOPS, picture)
    print(picture)
