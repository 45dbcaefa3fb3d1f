"""What the inflation pressure of the tyres does: radii, the lane change and the posts."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import stribeck

from examples.car.car_accuracy import Job, answers
from examples.car.car_description import CarError, read_car
from examples.car.car_study import printed
from examples.car.car_tyres import CarTyre, read_tyre
from examples.car.manoeuvres import Manoeuvre

# A tyre of Magic Formula 6.1, which knows pressures.
TYRE = Path(__file__).resolve().parents[1] / "tyres" / "formula_student_61.tir"

# Heading, figure of the lane change or of the posts, digits.
ROAD = [
    ("roll [deg]", "largest roll [deg]", 3),
    ("yaw rate [rad/s]", "largest yaw rate [rad/s]", 4),
    ("by friction [J]", "work of friction [J]", 2),
]
POSTS = [
    ("pitch [deg]", "pitch, peak to peak [deg]", 3),
    ("tyre load fl [N]", "tyre load fl, peak to peak [N]", 1),
    ("strut fl [mm]", "strut fl, peak to peak [mm]", 2),
]


def report_pressures(
    car: Path,
    file: Path,
    pressures: Sequence[float],
    courses: Mapping[str, Manoeuvre],
    law: str,
    given: Mapping[str, object],
    step: float,
    code: str,
    jobs: int,
) -> str:
    """A table: a row for each pressure."""
    tyres = [{"file": file, "pressure": pressure} for pressure in pressures]
    radii = [_radii(car, tyre) for tyre in tyres]
    runs = [Job(car, course, law, given, step, code, tyre) for tyre in tyres for course in courses.values()]
    found = iter(answers(runs, jobs))
    heads = ["loaded radius [mm]", "rolling radius [mm]", "stiffness [N/mm]"]
    rows = [[f"{law}, {code}, {1e3 * step:g} ms", *heads, *(name for name, *_ in ROAD + POSTS)]]
    for pressure, cells in zip(pressures, radii, strict=True):
        road, posts = (next(found).figures for _ in courses)
        numbers = [(road[figure], digits) for _, figure, digits in ROAD]
        numbers += [(posts[figure], digits) for _, figure, digits in POSTS]
        rows.append([f"{1e-3 * pressure:g} kPa", *cells, *(f"{value:.{digits}f}" for value, digits in numbers)])
    return printed(rows)


def _radii(car: Path, changes: Mapping[str, object]) -> list[str]:
    """Radii and stiffness under a quarter of the weight, upright."""
    described = read_car(car)
    described = replace(described, tyre=replace(described.tyre, **changes))
    tyre = read_tyre(described)
    load = 0.25 * described.mass * described.gravity
    try:
        radii = tyre.formula.radii(load, pressure=tyre.pressure)
        slope = _slope(tyre, load)
    except stribeck.Refused as refusal:
        raise CarError(f"tyre: {refusal}") from None
    rolling = tyre.rolling_radius(load, radii.deflection, 0.0)
    return [f"{1e3 * radii.loaded_radius:.2f}", f"{1e3 * rolling:.2f}", f"{1e-3 * slope:.1f}"]


def _slope(tyre: CarTyre, load: float) -> float:
    """Change of the load with the deflection, by a difference of 1 N."""
    deep, shallow = (tyre.formula.radii(load + end, pressure=tyre.pressure).loaded_radius for end in (0.5, -0.5))
    return 1.0 / (shallow - deep)
