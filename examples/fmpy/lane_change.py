"""A double lane change at 72 km/h, with and without friction in the four struts, and with several laws.

    python -m examples.fmpy.lane_change --levels 0 20 50
    python -m examples.fmpy.lane_change --steer path --laws
    python -m examples.fmpy.lane_change --levels 0 load     # friction of the seals, and from the load of the seat

Couples DoubleTrackCar and four ShockAbsorbers. `--steer` is

    open-loop   two periods of a sine of 3.6 degrees at 0.9 Hz, the second one mirrored, with a pause of 0.35 s (chosen)
    path        a driver who follows a path through the cones of ISO 3888-2

Writes

    <out>_<level>.csv     the motion for each level of friction
    <out>.png             the motions side by side
    <out>_path.png        the path through the cones, for `--steer path`
    <out>_laws.png        friction over velocity for each law at the highest level
    <out>_laws.csv        evaluations and run time of each law, absolute and relative to the lowest

After the manoeuvre the struts hold the body where friction brings it to rest: some roll remains, which springs and
dampers alone cannot cause.
"""

import argparse
import itertools
import math
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy

from examples.fmpy.car_pictures import draw_course, draw_lane_change
from examples.fmpy.coupling import main, positive
from examples.fmpy.vehicle import (
    DOUBLE_TRACK_CAR,
    Choice,
    Excitation,
    Run,
    add_laws,
    check_laws,
    choices_of,
    number_of,
    options_of,
    report_laws,
    run_car,
    run_laws,
    write_runs,
)

# Open loop: when the car begins to steer, and the sine (chosen).
BEGIN, AMPLITUDE, FREQUENCY, PAUSE = 0.5, math.radians(3.6), 0.9, 0.35

# The driver (chosen): where he leaves a lane, in m before its end, and reaches the next one, in m after its beginning;
# his preview time in s; and his steering per lateral deviation there, in rad/m.
LEAVING, ARRIVING, PREVIEW, GAIN = 2.7, 5.7, 0.16, 0.3


def open_loop(time: float, _seen: Mapping[str, float]) -> list[float]:
    """Steering angle of two single sines, the second one mirrored."""
    period = 1.0 / FREQUENCY
    for begin, sign in ((BEGIN, 1.0), (BEGIN + period + PAUSE, -1.0)):
        if 0.0 < time - begin < period:
            return [sign * AMPLITUDE * math.sin(2.0 * math.pi * FREQUENCY * (time - begin))]
    return [0.0]


@dataclass(frozen=True)
class Lane:
    """A lane between cones: its beginning and end, and its right and left edge; from the starting point of the car, in
    m."""

    begin: float
    end: float
    right: float
    left: float

    @property
    def middle(self) -> float:
        """Lateral position of the middle, positive to the left."""
        return 0.5 * (self.right + self.left)

    def cones(self) -> list[tuple[float, float]]:
        """Six pairs."""
        return [(x, y) for x in numpy.linspace(self.begin, self.end, 6) for y in (self.right, self.left)]

    def clearance(self, x: numpy.ndarray, y: numpy.ndarray) -> float:
        """Smallest distance of the points of a track from the edges; negative outside."""
        inside = (x >= self.begin) & (x <= self.end)
        return float(numpy.minimum(y - self.right, self.left - y)[inside].min(initial=math.inf))


def lanes(width: float, run_up: float = 20.0) -> list[Lane]:
    """The track of ISO 3888-2 for a car of a width, after a run-up in the middle of the first lane.

    Lanes of 12, 11 and 12 m with gaps of 13.5 and 12.5 m; the second lane begins 1 m to the left of the first. The
    right edge of the third one is in line with that of the first (chosen).
    """
    first, second, third = 1.1 * width + 0.25, width + 1.0, max(3.0, 1.3 * width + 0.25)
    right = -0.5 * first
    edges = [(right, -right), (1.0 - right, 1.0 - right + second), (right, right + third)]
    places = [(0.0, 12.0), (25.5, 36.5), (49.0, 61.0)]
    return [Lane(run_up + b, run_up + e, r, left) for (b, e), (r, left) in zip(places, edges, strict=True)]


def way(course: Sequence[Lane], x: float, leave: float = LEAVING, arrive: float = ARRIVING) -> float:
    """Lateral position of the path through the lanes: from middle to middle in half cosines."""
    y = course[0].middle
    for old, new in itertools.pairwise(course):
        leaving, arriving = old.end - leave, new.begin + arrive
        share = min(max((x - leaving) / (arriving - leaving), 0.0), 1.0)
        y += (new.middle - old.middle) * 0.5 * (1.0 - math.cos(math.pi * share))
    return y


def driver(course: Sequence[Lane], speed: float):
    """Steers in proportion to the distance between the path ahead and the position that the car would reach without
    steering."""

    def steer(_time: float, seen: Mapping[str, float]) -> list[float]:
        distance = PREVIEW * speed
        expected = seen["position_y"] + distance * math.sin(seen["yaw_angle"])
        return [GAIN * (way(course, seen["position_x"] + distance) - expected)]

    return steer


def clearance(run: Run | Mapping[str, numpy.ndarray], course: Sequence[Lane], width: float) -> float:
    """Smallest distance of the car's sides from the cones, at its axles; negative if it hits one."""
    sides = []
    for ahead, side in itertools.product((0.8, -0.8), (0.5 * width, -0.5 * width)):
        x = run["position_x"] + ahead * numpy.cos(run["yaw_angle"]) - side * numpy.sin(run["yaw_angle"])
        y = run["position_y"] + ahead * numpy.sin(run["yaw_angle"]) + side * numpy.cos(run["yaw_angle"])
        sides += [lane.clearance(x, y) for lane in course]
    return min(sides)


def run_lane_change(choice: Choice, steer=open_loop, time: float = 5.0, step: float = 1e-3, label: str = "") -> Run:
    """The car at constant speed, starting straight ahead."""
    return run_car(DOUBLE_TRACK_CAR, Excitation(["steering_angle"], steer), choice, time, step, label=label)


def report(runs: Sequence[Run]) -> None:
    """Prints the largest roll, the roll at the end, and the largest differences from the first run."""
    heading = ["max. roll [deg]", "left [deg]", "lateral [g]", "strut [N]", "tyre load [N]", "track [mm]"]
    print(f"largest roll, roll at {runs[0].time[-1]:g} s, and largest difference from the first run, front left:\n")
    print(f"{'':12}" + " ".join(f"{name:>15}" for name in heading))
    first = runs[0]
    for run in runs:
        values = [math.degrees(abs(run["roll"]).max()), math.degrees(run["roll"][-1])]
        values.append(abs(run["lateral_acceleration"]).max() / 9.81)
        values += [abs(run[name] - first[name]).max() for name in ("fl.force", "fl.tyre_load")]
        values.append(1e3 * abs(run["position_y"] - first["position_y"]).max())
        print(f"{run.label:12}" + " ".join(f"{value:15.3f}" for value in values))


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = options_of(__doc__, out="out/lane_change")
    parser.add_argument("--time", type=positive, default=5.0, help="simulated time in s (default: 5)")
    parser.add_argument("--steer", choices=("open-loop", "path"), default="open-loop", help="default: open-loop")
    parser.add_argument(
        "--width", type=positive, default=1.4, help="width of the car in m, for the cones (default: 1.4)"
    )
    add_laws(parser)
    return parser.parse_args()


def program() -> None:
    """Runs the simulations selected on the command line."""
    options = arguments()
    check_laws(options)
    course = lanes(options.width)
    speed = number_of(DOUBLE_TRACK_CAR, "speed", dict(options.car), options.fmus)
    steer = driver(course, speed) if options.steer == "path" else open_loop
    runs = [
        run_lane_change(choice, steer, options.time, options.step, label)
        for label, choice in choices_of(options).items()
    ]
    picture = Path(f"{options.out}.png")
    written = [picture, *write_runs(runs, options.out)]
    draw_lane_change(runs, picture)
    report(runs)
    if options.steer == "path":
        track = Path(f"{options.out}_path.png")
        draw_course(runs, course, options.width, track)
        written.append(track)
        for run in runs:
            print(f"{run.label}: {1e3 * clearance(run, course, options.width):.0f} mm from the nearest cone")
    if options.laws:
        laws = run_laws(DOUBLE_TRACK_CAR, Excitation(["steering_angle"], steer), options)
        written += report_laws(laws, options.time, options.out)
    print("", *written, sep="\n")


if __name__ == "__main__":
    sys.exit(main(program))
