"""How accurate a manoeuvre is: the step is halved, the balance of energy closed, and the other code asked."""

import multiprocessing
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy

from examples.car.car_description import CORNERS, CarError, read_car
from examples.car.car_rest import on_rubber
from examples.car.car_ride import EXUDYN, MUJOCO, Run, simulate
from examples.car.car_study import DEGREES, NONE, heat, printed
from examples.car.manoeuvres import Manoeuvre


def _largest(column: str, factor: float = 1.0) -> Callable[[Run], float]:
    """Largest deviation of a column from its start."""
    return lambda run: factor * float(numpy.abs(run[column] - run[column][0]).max())


def _range(column: str, factor: float = 1.0) -> Callable[[Run], float]:
    return lambda run: factor * float(numpy.ptp(run[column]))


def _shaking(run: Run) -> float:
    """Root mean square of the chassis' vertical acceleration in the second half of a run."""
    late = run["heave"][len(run["heave"]) // 2 :]
    return float(numpy.sqrt(numpy.mean((numpy.diff(late, 2) / run.step**2) ** 2)))


def _contacts(column: str) -> Callable[[Run], float]:
    """Largest value at any contact of any strut."""
    return lambda run: max(float(numpy.abs(run[f"{name}.{column}"]).max()) for name in CORNERS)


# Name, figure, digits.
Quantity = tuple[str, Callable[[Run], float], int]
STRUTS: list[Quantity] = [
    ("largest normal force [N]", lambda run: max(_contacts("normal_1")(run), _contacts("normal_2")(run)), 1),
    ("largest friction [N]", _contacts("friction"), 1),
    ("work of friction [J]", lambda run: heat(run, "friction"), 4),
    ("work of the dampers [J]", lambda run: -heat(run, "force_damper"), 4),
]
ON_THE_ROAD: list[Quantity] = [
    ("largest roll [deg]", _largest("roll", DEGREES), 4),
    ("largest yaw rate [rad/s]", _largest("yaw_rate"), 4),
    *((f"change of the tyre load {name} [N]", _largest(f"{name}.load"), 1) for name in CORNERS),
    ("change of the strut fl [mm]", _largest("fl.length", 1e3), 4),
    *STRUTS,
]
ON_POSTS: list[Quantity] = [
    ("pitch, peak to peak [deg]", _range("pitch", DEGREES), 4),
    ("heave, peak to peak [mm]", _range("heave", 1e3), 3),
    ("heave acceleration, rms [m/s2]", _shaking, 4),
    ("tyre load fl, peak to peak [N]", _range("fl.load"), 1),
    ("strut fl, peak to peak [mm]", _range("fl.length", 1e3), 4),
    *STRUTS,
]


@dataclass(frozen=True)
class Job:
    """One run; with another tyre and pressure than those of the car if they are given, and with rubber mounts."""

    car: Path
    course: Manoeuvre
    law: str
    changes: Mapping[str, object]
    step: float
    code: str
    tyre: Mapping[str, object] = field(default_factory=dict)
    has_mounts: bool = False


@dataclass(frozen=True)
class Answer:
    """Figures of a run by their names, and its balance of energy: what friction, dampers, tyres have taken, and what is
    missing; none from MuJoCo."""

    figures: Mapping[str, float]
    works: tuple[float, float, float, float] | None


def quantities_of(course: Manoeuvre) -> list[Quantity]:
    """What is compared in a manoeuvre."""
    return ON_THE_ROAD if course.speed > 0.0 else ON_POSTS


def answer(job: Job) -> Answer:
    """Computes a run in a process of its own."""
    car = read_car(job.car)
    car = replace(car, tyre=replace(car.tyre, **job.tyre))
    if job.has_mounts:
        car = on_rubber(car, job.changes)
    run = simulate(car, job.course, job.law, job.changes, job.step, code=job.code)
    works = run.works
    booked = works and (-works.friction, -works.dampers, -works.tyres, works.residual)
    return Answer({name: figure(run) for name, figure, _ in quantities_of(job.course)}, booked)


def answers(jobs: Sequence[Job], workers: int) -> list[Answer]:
    """The figures of runs, some at a time."""
    with ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("spawn")) as pool:
        return list(pool.map(answer, jobs))


def limit_of(coarse: float, fine: float, ratio: float) -> float:
    """The value for a step of 0, of a method whose error is proportional to the square of the step."""
    return fine + (fine - coarse) / (ratio**2 - 1.0)


def report_accuracy(
    car: Path, course: Manoeuvre, law: str, changes: Mapping[str, object], steps: Sequence[float], workers: int
) -> str:
    """Text of the comparison: each figure for each step and in MuJoCo, with friction and without."""
    if len(steps) < 2 or sorted(steps, reverse=True) != list(steps) or len(set(steps)) < len(steps):
        raise CarError(f"steps = {list(steps)}: must be at least two, the longest first")
    kinds = [(EXUDYN, step) for step in steps] + [(MUJOCO, steps[-1])]
    laws = [law, NONE] if law != NONE else [NONE]
    jobs = [Job(car, course, one, changes, step, code) for one in laws for code, step in kinds]
    found = answers(jobs, workers)
    by_law = {one: found[at * len(kinds) : (at + 1) * len(kinds)] for at, one in enumerate(laws)}
    parts = [_table(one, course, kinds, by_law[one]) for one in laws]
    parts += [_balance(one, steps, by_law[one]) for one in laws]
    if law != NONE:
        parts.append(_changes(law, course, steps, by_law))
    return "\n\n".join(parts)


def _table(law: str, course: Manoeuvre, kinds: Sequence[tuple[str, float]], found: Sequence[Answer]) -> str:
    *_, before, last, other = found
    ratio = kinds[-3][1] / kinds[-2][1]
    heads = [f"{code} {1e3 * step:g} ms" for code, step in kinds]
    rows = [[f"{course.name}, {law}", *heads[:-1], "limit", "first step off by", heads[-1], "codes differ by"]]
    for name, _, digits in quantities_of(course):
        values = [one.figures[name] for one in found]
        limit = limit_of(before.figures[name], last.figures[name], ratio)
        rows.append(
            [
                name,
                *(f"{value:.{digits}f}" for value in values[:-1]),
                f"{limit:.{digits}f}",
                _relative(values[0], limit),
                f"{other.figures[name]:.{digits}f}",
                _relative(other.figures[name], limit),
            ]
        )
    return printed(rows)


def _balance(law: str, steps: Sequence[float], found: Sequence[Answer]) -> str:
    heads = ["friction [J]", "dampers [J]", "tyres [J]", "missing [J]", "per friction and dampers", "per all three"]
    rows = [[f"balance of energy, {law}", *heads]]
    for step, one in zip(steps, found, strict=False):
        friction, dampers, tyres, missing = one.works
        struts = friction + dampers
        shares = (f"{abs(missing) / value:.1e}" for value in (struts, struts + tyres))
        rows.append([f"{1e3 * step:g} ms", *(f"{value:.4f}" for value in one.works), *shares])
    return printed(rows)


def _changes(law: str, course: Manoeuvre, steps: Sequence[float], by_law: Mapping[str, Sequence[Answer]]) -> str:
    rows = [[f"what {law} changes, {1e3 * steps[-1]:g} ms", EXUDYN, MUJOCO, "codes differ by"]]
    for name, _, digits in quantities_of(course):
        one, other = (by_law[law][at].figures[name] - by_law[NONE][at].figures[name] for at in (-2, -1))
        rows.append([name, f"{one:.{digits}f}", f"{other:.{digits}f}", _relative(other, one)])
    return printed(rows)


def _relative(value: float, reference: float) -> str:
    return f"{100.0 * (value / reference - 1.0):+.2f} %" if reference else "-"
