"""Every friction law in the struts of the car, side by side: runs in parallel, tables of cost and of what differs."""

import math
import multiprocessing
import time
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import dataclass, replace
from pathlib import Path

import numpy
import stribeck
from tqdm import tqdm

from examples.car.car_description import CORNERS, Car, CarError, read_car
from examples.car.car_ride import EXUDYN, Run, columns_with_units, simulate
from examples.car.car_struts import parameters_of
from examples.car.manoeuvres import MANOEUVRES, LaneChange, Manoeuvre, manoeuvre
from examples.fmpy.coupling import write_csv
from examples.fmpy.lane_change import clearance

NONE = "None"
STUDIED = ("lane-change", "four-post")
# Steps per row of the tables of a study.
EVERY = 5
DEGREES = 180.0 / numpy.pi
# Velocity of a strut, in m/s, below which a damper hardly resists.
SLOW = 0.01


@dataclass(frozen=True)
class Case:
    """One run of a study."""

    car: Path
    course: Manoeuvre
    law: str
    changes: Mapping[str, object]
    step: float
    table: Path
    code: str = EXUDYN


@dataclass(frozen=True)
class Outcome:
    """What a study keeps of a run, or why it failed."""

    law: str
    course: str
    figures: Mapping[str, float]
    columns: Mapping[str, numpy.ndarray]
    failure: str = ""


def scalar_laws() -> list[str]:
    """The laws that the struts can have, without the one that is none."""
    choices = stribeck.model("ShockAbsorber").variables["friction.model"].choices
    return [name for name, *_ in choices if name != NONE]


def laws_of(text: str | None) -> list[str]:
    """Laws from the command line, with none first: all friction is compared with it."""
    known = scalar_laws()
    chosen = known if text is None else [name for name in text.split(",") if name and name != NONE]
    for name in chosen:
        if name not in known:
            raise CarError(f"{name} is not a law of the struts; these are: {', '.join(known)}")
    return [NONE, *dict.fromkeys(chosen)]


def courses_of(names: Sequence[str], car: Car, given: Mapping[str, float]) -> dict[str, Manoeuvre]:
    """Manoeuvres by name; a number must belong to at least one of them."""
    fields = {name: MANOEUVRES[name].__dataclass_fields__ for name in names}
    for number in given:
        if not any(number in known for known in fields.values()):
            every = sorted({field for known in fields.values() for field in known})
            raise CarError(f"{' and '.join(names)}: no {number}; there are {', '.join(every)}")
    courses = {}
    for name, known in fields.items():
        own = {"width": car.width} if "width" in known else {}
        courses[name] = manoeuvre(name, **own | {number: value for number, value in given.items() if number in known})
    return courses


def run_case(case: Case) -> Outcome:
    """Computes a run in a process of its own, and writes its table."""
    began = time.process_time()
    try:
        run = simulate(
            read_car(case.car), case.course, case.law, case.changes, case.step, code=case.code, balance=False
        )
    except CarError as error:
        return Outcome(case.law, case.course.name, {}, {}, str(error))
    seconds = time.process_time() - began
    thin = {name: values[::EVERY] for name, values in run.columns.items()}
    write_csv(case.table, {name: values[::EVERY] for name, values in columns_with_units(run).items()})
    return Outcome(case.law, case.course.name, {"seconds": seconds, **figures_of(run, case.course)}, thin)


def figures_of(run: Run, course: Manoeuvre) -> dict[str, float]:
    """The numbers of a run that the tables show."""
    roll, pitch = (DEGREES * (run[name] - run[name][0]) for name in ("roll", "pitch"))
    figures = {
        "iterations": run.iterations,
        "evaluations": 4.0 * len(run["time"]),
        "strut_seconds": run.strut_seconds,
        "roll": float(numpy.abs(roll).max()),
        "roll_left": float(roll[-1]),
        "pitch": float(numpy.ptp(pitch)),
        "friction": max(float(numpy.abs(run[f"{name}.friction"]).max()) for name in CORNERS),
        "travel": 1e3 * float(numpy.ptp(run["fl.length"])),
        "load": math.sqrt(sum(float(run[f"{name}.load"].var()) for name in CORNERS) / len(CORNERS)),
        "slow": sum(float((numpy.abs(run[f"{name}.velocity"]) < SLOW).mean()) for name in CORNERS) / len(CORNERS),
        "friction_work": heat(run, "friction"),
        "damper_work": -heat(run, "force_damper"),
    }
    if isinstance(course, LaneChange):
        motion = {"position_x": run["front_x"] - 0.8 * numpy.cos(run["yaw"]), "yaw_angle": run["yaw"]}
        motion["position_y"] = run["front_y"] - 0.8 * numpy.sin(run["yaw"])
        figures["clearance"] = clearance(motion, course.lanes, course.width)
    return figures


def heat(run: Run, column: str) -> float:
    """Work of a force of all struts along their motion."""
    total = 0.0
    for name in CORNERS:
        force, length = run[f"{name}.{column}"], run[f"{name}.length"] + run[f"{name}.mount"]
        total += 0.5 * float((force[1:] + force[:-1]) @ numpy.diff(length))
    return total


def run_study(cases: Sequence[Case], jobs: int) -> Iterator[Outcome]:
    """The outcomes, as they come, with a bar that shows how far the study is."""
    # Processes that share nothing: exudyn keeps state of its own.
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(jobs, mp_context=context) as pool:
        waiting = [pool.submit(run_case, case) for case in cases]
        for done in tqdm(as_completed(waiting), total=len(waiting), unit="run", disable=None):
            yield done.result()


# Columns of the printed table: heading, figure, digits.
COST = [
    ("run time [s]", "seconds", 2),
    ("struts [s]", "strut_seconds", 3),
    ("iterations", "iterations", 0),
    ("evaluations", "evaluations", 0),
]
EFFECT = {
    "lane-change": [
        ("roll [deg]", "roll", 3),
        ("left [deg]", "roll_left", 4),
        ("friction [N]", "friction", 1),
        ("by friction [J]", "friction_work", 2),
        ("by dampers [J]", "damper_work", 2),
        ("clearance [m]", "clearance", 3),
        ("slow [1]", "slow", 2),
        ("path [mm]", "path", 1),
    ],
    "four-post": [
        ("pitch [deg]", "pitch", 3),
        ("strut fl [mm]", "travel", 2),
        ("tyre load [N]", "load", 1),
        ("friction [N]", "friction", 1),
        ("by friction [J]", "friction_work", 2),
        ("by dampers [J]", "damper_work", 2),
    ],
}


def with_paths(outcomes: Sequence[Outcome]) -> list[Outcome]:
    """The outcomes of a manoeuvre with the largest distance of each path from that without friction."""
    free = next((one.columns["front_y"] for one in outcomes if one.law == NONE and not one.failure), None)
    found = []
    for one in outcomes:
        apart = math.nan if free is None or one.failure else 1e3 * float(numpy.abs(one.columns["front_y"] - free).max())
        found.append(replace(one, figures={**one.figures, "path": apart}))
    return found


def table_of(outcomes: Sequence[Outcome], course: str) -> list[list[str]]:
    """Rows of text: the cost of each law, absolute and relative to none, and its effect on the car."""
    rows = [["law", *(name for name, _, _ in COST), "relative", *(name for name, _, _ in EFFECT[course])]]
    done = with_paths([outcome for outcome in outcomes if outcome.course == course])
    least = next((o.figures["seconds"] for o in done if o.law == NONE and not o.failure), None)
    for outcome in done:
        if outcome.failure:
            rows.append([outcome.law, f"failed: {outcome.failure}"])
            continue
        seen = outcome.figures
        cost = [f"{seen[figure]:.{digits}f}" for _, figure, digits in COST]
        relative = f"{seen['seconds'] / least:.2f}" if least else "-"
        effect = [f"{seen[figure]:.{digits}f}" for _, figure, digits in EFFECT[course]]
        rows.append([outcome.law, *cost, relative, *effect])
    return rows


def contacts_of(car: Car, changes: Mapping[str, object]) -> list[list[str]]:
    """The levels of both contacts, the same for every law (Table 9.3)."""
    given = parameters_of(car, NONE, changes)["fl"]
    names = ("mu_s", "mu_k", "preload_s", "preload_k")
    rows = [["contact", *(f"{name} [{'1' if name.startswith('mu') else 'N'}]" for name in names)]]
    for contact, where in (("c1", "rod guide"), ("c2", "piston")):
        rows.append([where, *(f"{given[f'{contact}.{name}']:g}" for name in names)])
    return rows


def printed(rows: Sequence[Sequence[str]]) -> str:
    """A table in columns of equal width."""
    full = [row for row in rows if len(row) == len(rows[0])]
    widths = [max(len(row[at]) for row in full) for at in range(len(rows[0]))]
    lines = []
    for row in rows:
        first = f"{row[0]:{widths[0]}}"
        lines.append(
            "  ".join([first, *(f"{cell:>{width}}" for cell, width in zip(row[1:], widths[1:], strict=False))])
        )
    return "\n".join(lines)
