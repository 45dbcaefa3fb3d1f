"""What a designer can do about friction: seat of the spring, seals, overlap; in the lane change and on the posts."""

from collections.abc import Mapping
from pathlib import Path

from examples.car.car_accuracy import Job, answers
from examples.car.car_study import NONE, printed
from examples.car.manoeuvres import Manoeuvre

NO_PRELOAD = {f"{contact}.preload_{level}": 0.0 for contact in ("c1", "c2") for level in "sk"}
LONGER = {"geom.d_i": 0.135, "geom.d_j": 0.125}
DESIGNS = {
    "seat on the axis": {"side.offset_m": 0.0},
    "seat 3 mm off": {"side.offset_m": 0.003},
    "seat 3 mm off, seals without preload": {"side.offset_m": 0.003, **NO_PRELOAD},
    "seat 6 mm off": {"side.offset_m": 0.006},
    "seat 6 mm off, overlap longer by 30 mm": {"side.offset_m": 0.006, **LONGER},
}


def report_designs(
    car: Path,
    courses: Mapping[str, Manoeuvre],
    law: str,
    given: Mapping[str, object],
    step: float,
    code: str,
    jobs: int,
) -> str:
    """A table: a row for each design, and one without friction."""
    cases = [("without friction", NONE, {}), *((label, law, changes) for label, changes in DESIGNS.items())]
    runs = [
        Job(car, course, one, {**changes, **given}, step, code)
        for _, one, changes in cases
        for course in courses.values()
    ]
    found = iter(answers(runs, jobs))
    heads = ["normal force [N]", "friction [N]", "roll [deg]", "by friction [J]", "pitch [deg]", "strut travel [mm]"]
    rows = [[f"{law}, {code}, {1e3 * step:g} ms", *heads]]
    for label, _, _ in cases:
        road, posts = (next(found).figures for _ in courses)
        largest = [max(road[name], posts[name]) for name in ("largest normal force [N]", "largest friction [N]")]
        cells = [f"{value:.1f}" for value in largest]
        cells += [f"{road['largest roll [deg]']:.3f}", f"{road['work of friction [J]']:.2f}"]
        cells += [f"{posts['pitch, peak to peak [deg]']:.3f}", f"{posts['strut fl, peak to peak [mm]']:.2f}"]
        rows.append([label, *cells])
    return printed(rows)
