"""What rubber mounts in the struts change: on the posts, and on posts that shake the car."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from examples.car.car_accuracy import Answer, Job, answers
from examples.car.car_study import NONE, printed
from examples.car.manoeuvres import FourPost

# Strokes in m and frequencies in Hz of posts that rise together: the struts slide, and stick.
SHAKING = ((4e-3, 10.0), (4e-4, 10.0), (1e-4, 40.0), (1e-4, 80.0))
# Longest time in s for which they shake the car.
LONGEST = 1.0
ACCELERATION = ("heave acceleration, rms [m/s2]", 4)
ON_THE_POSTS = (
    ("pitch, peak to peak [deg]", 3),
    ("tyre load fl, peak to peak [N]", 1),
    ("strut fl, peak to peak [mm]", 2),
    ("work of friction [J]", 2),
    ("work of the dampers [J]", 2),
    ACCELERATION,
)


def shaken(posts: FourPost) -> dict[str, FourPost]:
    """Posts that shake the car, by name."""
    duration = min(posts.duration, LONGEST)
    return {
        f"{1e3 * stroke:g} mm at {frequency:g} Hz": replace(
            posts, stroke=stroke, frequency=frequency, lag=0.0, duration=duration
        )
        for stroke, frequency in SHAKING
    }


def report_mounts(
    car: Path, posts: FourPost, law: str, given: Mapping[str, object], step: float, code: str, jobs: int
) -> str:
    """A table: without friction and with it, on rigid mounts and on rubber."""
    cases = [(one, has_mounts) for one in (NONE, law) for has_mounts in (False, True)]
    shaking = shaken(posts)
    runs = [
        Job(car, course, one, given, step, code, has_mounts=has_mounts)
        for course in (posts, *shaking.values())
        for one, has_mounts in cases
    ]
    found = iter(answers(runs, jobs))
    heads = [f"{one}, {'rubber' if has_mounts else 'rigid'}" for one, has_mounts in cases]
    rows = [[f"{code}, {1e3 * step:g} ms", *heads]]
    seen = [next(found) for _ in cases]
    rows += [_row(f"{posts.name}: {figure}", seen, figure, digits) for figure, digits in ON_THE_POSTS]
    rows += [_row(f"{name}: {ACCELERATION[0]}", [next(found) for _ in cases], *ACCELERATION) for name in shaking]
    return printed(rows)


def _row(label: str, seen: list[Answer], figure: str, digits: int) -> list[str]:
    return [label, *(f"{one.figures[figure]:.{digits}f}" for one in seen)]
