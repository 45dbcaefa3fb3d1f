"""A car FMU with its ShockAbsorber FMUs: functions shared by the programs that use it.

The car gives the length of each strut and its rate, and the strut returns a force; both are FMUs, connected by the
names of their variables. In each communication step the struts step first, then the car with their forces.
"""

import argparse
import csv
import math
import time as clock
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from ctypes import byref
from dataclasses import dataclass, field
from pathlib import Path

import numpy
from fmpy.fmi2 import fmi2FMUstate
from tqdm import tqdm

from examples.fmpy.car_pictures import draw_laws
from examples.fmpy.coupling import (
    Fmu,
    add_settable,
    command_line,
    not_negative,
    numbers_of,
    open_fmu,
    path_of,
    positive,
    variables_of,
    write_csv,
)

STRUT = "ShockAbsorber"

# Outputs read from each strut; the first one acts on the car.
RECORDED = ["force", "force_friction"]

# Times, and the values read and set, step by step.
Steps = Iterator[tuple[float, list[float]]]

BAR = "{l_bar}{bar}| {n:.2f} of {total:g} s [{elapsed}]"

# Breakaway level over kinetic level (chosen).
STATIC_RATIO = 1.3

# A few laws of different kinds for a comparison: two regularised ones, three with bristles, one with elements.
LAWS = ["Threlfall", "BrownMcPhee", "Dahl", "LuGre", "ElastoPlastic", "MaxwellSlip"]


@dataclass(frozen=True)
class Excitation:
    """Excitation of the car: inputs of its FMU, and their values at a time, given the car's outputs."""

    names: Sequence[str]
    values: Callable[[float, Mapping[str, float]], list[float]]


@dataclass(frozen=True)
class Layout:
    """A car FMU: its axles, each with its corners and the parameters of their struts, by the prefixes of the names."""

    car: str
    axles: Mapping[str, tuple[str, ...]]
    struts: Mapping[str, Mapping[str, float]] = field(default_factory=dict)


# Springs of 45 kN/m in front, the default, and 35 kN/m behind: the Formula Student car of the hosts' defaults.
FOUR_CORNERS = {"front.": ("fl.", "fr."), "rear.": ("rl.", "rr.")}
REAR_SPRING = {"rear.": {"spring.k": 35000.0}}
QUARTER_CAR = Layout("QuarterCar", {"": ("",)})
FOUR_POST_CAR = Layout("FourPostCar", FOUR_CORNERS, REAR_SPRING)
DOUBLE_TRACK_CAR = Layout("DoubleTrackCar", FOUR_CORNERS, REAR_SPRING)


@dataclass(frozen=True)
class Choice:
    """The user's choices: the folder of the FMUs, parameters of all struts or of those of an axle, parameters of the
    car."""

    fmus: Path
    struts: Mapping[str, object] = field(default_factory=dict)
    car: Mapping[str, object] = field(default_factory=dict)

    def of_axle(self, layout: Layout, axle: str) -> dict[str, object]:
        """Parameters of the struts of an axle; a name with the axle's prefix takes precedence over one without."""
        others = tuple(prefix for prefix in layout.axles if prefix)
        common = {name: value for name, value in self.struts.items() if not (others and name.startswith(others))}
        own = {name.removeprefix(axle): self.struts[name] for name in self.struts if axle and name.startswith(axle)}
        return dict(layout.struts.get(axle, {})) | common | own


# Friction with the levels of the strut's own parameters: those of the seals, and of the load that the spring's seat,
# beside the axis, puts on both contacts. No other side load is known to a car without joints.
BY_LOAD = None


def level(text: str) -> float | None:
    """Reads a level of friction: newtons, or `load`."""
    return BY_LOAD if text == "load" else not_negative(text)


def friction(model: str, level: float | None) -> dict[str, object]:
    """Parameters of a strut whose friction has the same level at every load, the kinetic one in newtons; or whose
    friction depends on the load."""
    if level is BY_LOAD:
        return {"friction.model": model}
    loads = {f"c{contact}.{name}": 0.0 for contact in (1, 2) for name in ("mu_s", "mu_k", "preload_s", "preload_k")}
    return loads | {"friction.model": model, "c1.preload_k": level, "c1.preload_s": STATIC_RATIO * level}


@dataclass(frozen=True)
class Run:
    """A computed motion, in SI units: signals by their names, and the computational effort."""

    label: str
    time: numpy.ndarray
    signals: Mapping[str, numpy.ndarray]
    units: Mapping[str, str]
    evaluations: int
    seconds: float

    def __getitem__(self, name: str) -> numpy.ndarray:
        return self.signals[name]

    def columns(self) -> dict[str, numpy.ndarray]:
        """The columns of the CSV file."""
        return {"time [s]": self.time} | {
            f"{name} [{self.units[name]}]": values for name, values in self.signals.items()
        }


class Coupled:
    """A car and its struts, one per corner, that exchange values."""

    def __init__(self, car: Fmu, struts: Mapping[str, Fmu], excitation: Excitation):
        self.car, self.struts = car.slave, [strut.slave for strut in struts.values()]
        self.slaves = [self.car, *self.struts]
        self.excitation = excitation
        self.seen_names = real_outputs(car)
        self.seen = car.references(*self.seen_names)
        # Positions of the length and velocity of each strut among the outputs of the car.
        self.motions = [
            [self.seen_names.index(f"{corner}{name}") for name in ("length", "velocity")] for corner in struts
        ]
        self.forces = car.references(*(f"{corner}strut_force" for corner in struts))
        self.moved = car.references(*excitation.names)
        # All struts are instances of one FMU.
        strut = next(iter(struts.values()))
        self.strut_inputs, self.strut_outputs = strut.references("length", "velocity"), strut.references(*RECORDED)
        answers = [f"{corner}{name}" for corner in struts for name in RECORDED]
        self.names = [*self.seen_names, *answers, *excitation.names]
        self.units = dict(zip(answers, list(units_of(strut, RECORDED).values()) * len(struts), strict=True))
        self.units |= units_of(car, [*self.seen_names, *excitation.names])
        self.saved = [fmi2FMUstate() for _ in self.slaves]
        self.evaluations = 0
        # Some outputs, such as tyre loads, depend on the excitation, so it must be set from the beginning.
        self.car.setReal(self.moved, self._excite(0.0, self.look()))

    def look(self) -> list[float]:
        """The outputs of the car."""
        return self.car.getReal(self.seen)

    def velocities(self) -> numpy.ndarray:
        """Rates of the struts' lengths."""
        seen = self.look()
        return numpy.array([seen[velocity] for _, velocity in self.motions])

    def step(self, time: float, step: float) -> list[float]:
        """One step of the struts, then one of the car; returns the values read and set, in the order of `names`."""
        seen, answers = self.look(), []
        for strut, motion in zip(self.struts, self.motions, strict=True):
            strut.setReal(self.strut_inputs, [seen[at] for at in motion])
            strut.doStep(time, step)
            answers += strut.getReal(self.strut_outputs)
        self.evaluations += len(self.struts)
        return seen + answers + self._move(time, step, seen, answers[:: len(RECORDED)])

    def _move(self, time: float, step: float, seen: list[float], forces: list[float]) -> list[float]:
        """Steps the car; the forces of its struts are held, while the excitation varies linearly.

        Returns the excitation at the beginning.
        """
        begin, end = (self._excite(at, seen) for at in (time, time + step))
        self.car.setReal(self.forces, forces)
        self.car.setReal(self.moved, begin)
        slopes = [(after - before) / step for before, after in zip(begin, end, strict=True)]
        self.car.setRealInputDerivatives(self.moved, [1] * len(slopes), slopes)
        self.car.doStep(time, step)
        return begin

    def _excite(self, time: float, seen: list[float]) -> list[float]:
        """The excitation of the car at a time."""
        return self.excitation.values(time, dict(zip(self.seen_names, seen, strict=True)))

    def save(self) -> None:
        """Saves the state of everything."""
        for slave, state in zip(self.slaves, self.saved, strict=True):
            slave.fmi2GetFMUstate(slave.component, byref(state))

    def restore(self) -> None:
        """Restores the saved state."""
        for slave, state in zip(self.slaves, self.saved, strict=True):
            slave.setFMUState(state)

    def free(self) -> None:
        """Frees the saved state."""
        for slave, state in zip(self.slaves, self.saved, strict=True):
            slave.freeFMUState(state)


def real_outputs(fmu: Fmu) -> list[str]:
    """Names of the outputs that are numbers."""
    outputs = [variable for variable in fmu.description.modelVariables if variable.causality == "output"]
    return [variable.name for variable in outputs if variable.type == "Real"]


def units_of(fmu: Fmu, names: Sequence[str]) -> dict[str, str]:
    """Units of variables."""
    units = {variable.name: variable.unit for variable in fmu.description.modelVariables}
    return {name: units[name] for name in names}


def fixed_steps(coupled: Coupled, end: float, step: float) -> Steps:
    """Runs to the end in equal steps of about `step`."""
    steps = max(1, round(end / step))
    for at in range(steps):
        yield end * at / steps, coupled.step(end * at / steps, end / steps)


def controlled_steps(coupled: Coupled, end: float, longest: float, tolerance: float) -> Steps:
    """Runs to the end in steps with an error of the struts' velocities below `tolerance` (m/s) each.

    Each step is made once as a whole and once in halves, which are kept. The difference is the error; it is
    proportional to the square of the step because the forces are held.
    """
    time, step = 0.0, longest
    try:
        while end - time > 1e-9 * end:
            step = min(step, end - time)
            coupled.save()
            coupled.step(time, step)
            whole = coupled.velocities()
            coupled.restore()
            middle = time + 0.5 * step
            halves = [(time, coupled.step(time, 0.5 * step)), (middle, coupled.step(middle, 0.5 * step))]
            error = float(abs(coupled.velocities() - whole).max()) / tolerance
            if error <= 1.0:
                yield from halves
                time += step
            else:
                coupled.restore()
            step = min(longest, step * min(2.0, max(0.2, 0.9 / math.sqrt(max(error, 1e-6)))))
    finally:
        coupled.free()


@contextmanager
def coupled_fmus(layout: Layout, excitation: Excitation, choice: Choice) -> Iterator[Coupled]:
    """The car and its struts, opened, at rest."""
    parameters = {axle: choice.of_axle(layout, axle) for axle in layout.axles}
    rest = {f"{axle}static_force": rest_force(layout, axle, choice) for axle in layout.axles}
    strut = path_of(STRUT, choice.fmus)
    with ExitStack() as stack:
        car = stack.enter_context(open_fmu(path_of(layout.car, choice.fmus), rest | dict(choice.car)))
        struts = {
            corner: stack.enter_context(open_fmu(strut, parameters[axle]))
            for axle, corners in layout.axles.items()
            for corner in corners
        }
        yield Coupled(car, struts, excitation)


def number_of(layout: Layout, name: str, chosen: Mapping[str, object], fmus: Path) -> float:
    """A parameter of the car: the user's choice, or its default."""
    return float(chosen.get(name, variables_of(path_of(layout.car, fmus))[name].start))


def rest_force(layout: Layout, axle: str, choice: Choice) -> float:
    """Force of a strut at rest at the length that it has in the car, without its friction."""
    length = number_of(layout, f"{axle}static_length", choice.car, choice.fmus)
    state = {"friction.model": "None", "length": length, "velocity": 0.0}
    with open_fmu(path_of(STRUT, choice.fmus), choice.of_axle(layout, axle) | state) as strut:
        return strut.slave.getReal(strut.references("force"))[0]


def run_car(
    layout: Layout,
    excitation: Excitation,
    choice: Choice,
    end: float,
    step: float = 1e-3,
    tolerance: float | None = None,
    label: str = "",
) -> Run:
    """Moves a car from rest until `end`, in steps of `step`, or with a `tolerance`, in steps as short as it
    requires."""
    with coupled_fmus(layout, excitation, choice) as coupled:
        steps = (
            fixed_steps(coupled, end, step) if tolerance is None else controlled_steps(coupled, end, step, tolerance)
        )
        begin, times, rows = clock.perf_counter(), [], []
        # The bar is hidden if the output is not a terminal.
        with tqdm(total=end, desc=label, unit="s", bar_format=BAR, disable=None, leave=False) as bar:
            for time, row in steps:
                bar.update(time - bar.n)
                times.append(time)
                rows.append(row)
        seconds = clock.perf_counter() - begin
        # At the end there is a motion but no further force.
        times.append(end)
        rows.append(coupled.look() + rows[-1][len(coupled.seen) :])
        signals = dict(zip(coupled.names, numpy.array(rows).T, strict=True))
        return Run(label, numpy.array(times), signals, coupled.units, coupled.evaluations, seconds)


def options_of(about: str, out: str) -> argparse.ArgumentParser:
    """The options that all programs with a car have."""
    parser = command_line(about, model="LuGre", out=out, of="the struts; front.NAME or rear.NAME for those of an axle")
    add_settable(parser, "--car", "parameter of the car")
    files = {
        "--strut-file": "parameters of the struts, as `stribeck damper` writes them; for their friction see --levels",
        "--car-file": "parameters of the car, as `stribeck tyre` writes them",
    }
    for flag, meaning in files.items():
        parser.add_argument(flag, type=parameter_set, default={}, metavar="CSV", help=meaning)
    parser.add_argument(
        "--levels",
        type=level,
        nargs="+",
        default=[0.0, 20.0, 50.0],
        metavar="N",
        help="kinetic friction of each strut in N, side by side (default: 0 20 50); breakaway is 1.3 times as high. "
        "load: friction of the seals, and of both contacts under the side load of the spring's seat",
    )
    parser.add_argument("--step", type=positive, default=1e-3, help="communication step in s (default: 1e-3)")
    return parser


def choices_of(options: argparse.Namespace) -> dict[str, Choice]:
    """The choices of the command line, once for each level of friction, by its label."""
    return {label_of(level): choice_of(options, options.model, level) for level in options.levels}


def choice_of(options: argparse.Namespace, model: str, level: float | None) -> Choice:
    """The choices of the command line, with the given law and level."""
    struts = options.strut_file | friction(model, level) | dict(options.set)
    return Choice(options.fmus, struts, options.car_file | dict(options.car))


def parameter_set(text: str) -> dict[str, str]:
    """Reads a file of parameters: CSV with the columns `variable` and `value`."""
    path = Path(text)
    if not path.is_file():
        raise argparse.ArgumentTypeError(f"there is no file {text}")
    with path.open(encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file)
        if not {"variable", "value"} <= set(rows.fieldnames or []):
            raise argparse.ArgumentTypeError(f"{text} has no columns named variable and value")
        return {row["variable"]: row["value"] for row in rows}


def label_of(level: float | None) -> str:
    """Label of a level of friction."""
    if level is BY_LOAD:
        return "by load"
    return f"{level:g} N" if level > 0.0 else "no friction"


def write_runs(runs: Sequence[Run], out: str) -> list[Path]:
    """Writes the motion of each run; returns the files."""
    paths = [Path(f"{out}_{run.label.replace(' ', '_')}.csv") for run in runs]
    for run, path in zip(runs, paths, strict=True):
        write_csv(path, run.columns())
    return paths


def add_laws(parser: argparse.ArgumentParser) -> None:
    """Options of a comparison of laws."""
    parser.add_argument(
        "--laws",
        nargs="*",
        default=LAWS,
        metavar="LAW",
        help="laws to compare at the highest level, or by load if that is one of the levels; none to skip the "
        f"comparison (default: {' '.join(LAWS)})",
    )
    parser.add_argument(
        "--tolerance",
        type=positive,
        default=1e-4,
        help="error of a strut's velocity per step in that comparison in m/s (default: 1e-4)",
    )


def check_laws(options: argparse.Namespace) -> None:
    """Rejects laws that do not exist before anything runs."""
    for law in options.laws:
        numbers_of(path_of(STRUT, options.fmus), {"friction.model": law})


def run_laws(layout: Layout, excitation: Excitation, options: argparse.Namespace) -> list[Run]:
    """The same motion with each of several laws, each with its own steps, up to ten times as long as in the other
    runs."""
    level = BY_LOAD if BY_LOAD in options.levels else max(options.levels)
    longest = 10.0 * options.step
    return [
        run_car(layout, excitation, choice_of(options, law, level), options.time, longest, options.tolerance, law)
        for law in options.laws
    ]


def report_laws(runs: Sequence[Run], last: float, out: str) -> list[Path]:
    """Prints and writes evaluations of the law and run time, absolute and relative to the lowest; draws the laws.

    The last `last` seconds are drawn. Returns the files.
    """
    heading = ["law", "evaluations", "run time [s]", "evaluations, relative", "run time, relative"]
    fewest, shortest = min(run.evaluations for run in runs), min(run.seconds for run in runs)
    rows = [(run.label, run.evaluations, run.seconds, run.evaluations / fewest, run.seconds / shortest) for run in runs]
    table, picture = Path(f"{out}_laws.csv"), Path(f"{out}_laws.png")
    table.parent.mkdir(parents=True, exist_ok=True)
    with table.open("w", encoding="utf-8", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([heading, *rows])
    draw_laws(runs, last, picture)
    print(f"\n{'law':19} {'evaluations':>11} {'relative':>9} {'run time':>10} {'relative':>9}")
    for law, evaluations, seconds, more, longer in rows:
        print(f"{law:19} {evaluations:11} {more:9.2f} {seconds:8.2f} s {longer:9.2f}")
    return [table, picture]
