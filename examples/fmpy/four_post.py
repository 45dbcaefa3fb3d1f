"""A car on four posts that move up and down, with and without friction in its four struts, and with several laws.

    python -m examples.fmpy.four_post --frequency 2 --stroke 0.04 --delay 90 --levels 0 20 50
    python -m examples.fmpy.four_post --laws BrownMcPhee LuGre Dahl
    python -m examples.fmpy.four_post --levels 0 load       # friction of the seals, and from the load of the seat

Couples FourPostCar and four ShockAbsorbers. Each post rises by the stroke and returns; the rear ones are delayed.
Writes

    <out>_<level>.csv     the motion for each level of friction
    <out>.png             the motions side by side
    <out>_laws.png        friction over velocity for each law at the highest level
    <out>_laws.csv        evaluations and run time of each law, absolute and relative to the lowest

The laws run with individual steps, as short as --tolerance requires, so a steep law needs more of them.
"""

import argparse
import math
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy

from examples.fmpy.car_pictures import draw_four_post
from examples.fmpy.coupling import main, number, positive
from examples.fmpy.vehicle import (
    FOUR_POST_CAR,
    Choice,
    Excitation,
    Run,
    add_laws,
    check_laws,
    choices_of,
    options_of,
    report_laws,
    run_car,
    run_laws,
    write_runs,
)

CORNERS = ("fl.", "fr.", "rl.", "rr.")


@dataclass(frozen=True)
class Cycle:
    """The measured values of the last cycle, in SI units; heave, pitch and travel are peak to peak."""

    heave: float
    pitch: float
    travel: float
    fastest: float
    friction_work: float
    least_load: float


def posts(frequency: float, stroke: float, delay: float) -> Excitation:
    """Posts that rise by `stroke` and return, the rear ones delayed by the angle `delay` in rad."""
    angular = 2.0 * math.pi * frequency
    names = [f"{corner}{name}" for corner in CORNERS for name in ("post_height", "post_velocity")]

    def post(angle: float) -> list[float]:
        # A post waits at the bottom until its motion begins.
        if angle < 0.0:
            return [0.0, 0.0]
        return [0.5 * stroke * (1.0 - math.cos(angle)), 0.5 * stroke * angular * math.sin(angle)]

    def values(time: float, _seen) -> list[float]:
        front, rear = post(angular * time), post(angular * time - delay)
        return front + front + rear + rear

    return Excitation(names, values)


def run_four_post(
    choice: Choice,
    frequency: float = 2.0,
    stroke: float = 0.04,
    delay: float = 0.5 * math.pi,
    time: float = 4.0,
    step: float = 1e-3,
    label: str = "",
) -> Run:
    """The car on its posts, from rest; the delay is an angle in rad."""
    return run_car(FOUR_POST_CAR, posts(frequency, stroke, delay), choice, time, step, label=label)


def measure(run: Run, frequency: float) -> Cycle:
    """The last cycle of a run: the body, the front left corner, the fastest strut and the friction of all four."""
    last = run.time >= run.time[-1] - (1.0 + 1e-9) / frequency
    power = sum(-run[f"{corner}force_friction"] * run[f"{corner}velocity"] for corner in CORNERS)
    return Cycle(
        heave=numpy.ptp(run["heave"][last]),
        pitch=numpy.ptp(run["pitch"][last]),
        travel=numpy.ptp(run["fl.length"][last]),
        fastest=max(abs(run[f"{corner}velocity"][last]).max() for corner in CORNERS),
        friction_work=numpy.trapezoid(power[last], run.time[last]),
        least_load=run["fl.tyre_load"][last].min(),
    )


def report(runs: Sequence[Run], frequency: float) -> None:
    """Prints the measured values of each run."""
    print("last period; strut travel and tyre load front left, friction work of all struts:\n")
    heading = ["heave [mm]", "pitch [deg]", "travel [mm]", "fastest [m/s]", "friction [J]", "least load [N]"]
    print(f"{'':12}" + " ".join(f"{name:>14}" for name in heading))
    for run in runs:
        cycle = measure(run, frequency)
        values = [1e3 * cycle.heave, math.degrees(cycle.pitch), 1e3 * cycle.travel, cycle.fastest, cycle.friction_work]
        print(f"{run.label:12}" + " ".join(f"{value:14.3f}" for value in values) + f" {cycle.least_load:14.1f}")


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = options_of(__doc__, out="out/four_post")
    parser.add_argument("--frequency", type=positive, default=2.0, help="frequency of the posts in Hz (default: 2)")
    parser.add_argument("--stroke", type=positive, default=0.04, help="stroke of the posts in m (default: 0.04)")
    parser.add_argument("--delay", type=number, default=90.0, help="delay of the rear posts in degrees (default: 90)")
    parser.add_argument("--time", type=positive, default=4.0, help="simulated time in s (default: 4)")
    add_laws(parser)
    options = parser.parse_args()
    if options.time * options.frequency < 2.0:
        parser.error(f"argument --time: must be at least two periods, {2.0 / options.frequency:g} s")
    return options


def program() -> None:
    """Runs the simulations selected on the command line."""
    options = arguments()
    check_laws(options)
    delay = math.radians(options.delay)
    runs = [
        run_four_post(choice, options.frequency, options.stroke, delay, options.time, options.step, label)
        for label, choice in choices_of(options).items()
    ]
    picture = Path(f"{options.out}.png")
    written = write_runs(runs, options.out)
    draw_four_post(runs, options.frequency, picture)
    report(runs, options.frequency)
    if options.laws:
        laws = run_laws(FOUR_POST_CAR, posts(options.frequency, options.stroke, delay), options)
        written += report_laws(laws, 1.0 / options.frequency, options.out)
    print("", picture, *written, sep="\n")


if __name__ == "__main__":
    sys.exit(main(program))
