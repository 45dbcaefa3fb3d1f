"""A quarter car on a sine road: effect of strut friction on the ride, for several levels of friction.

    python -m examples.fmpy.quarter_car --levels 0 20 50 --amplitude 2e-3
    python -m examples.fmpy.quarter_car --frequencies 1 2 3.9 5 --set gas.enabled=0

Couples QuarterCar and ShockAbsorber. At each frequency the car runs until the motion is periodic; its first harmonic is
then compared with that of the road. Writes

    <out>.csv             body motion and strut travel over road motion, for each frequency and level
    <out>_<level>.csv     the motion at --loop Hz
    <out>.png             both over frequency
    <out>_loops.png       force over velocity and over displacement at --loop Hz

Friction carries the car over small bumps like a rigid rod: less travel and less body motion below the resonance of the
body on its spring, but more above it, where the body begins to oscillate on the tyre. No damper has both effects.
"""

import argparse
import math
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy
from tqdm import tqdm

from examples.fmpy.car_pictures import draw_loops, draw_transmissibility
from examples.fmpy.coupling import main, positive, write_csv
from examples.fmpy.vehicle import QUARTER_CAR, Choice, Excitation, Run, choices_of, options_of, run_car, write_runs

# Measured periods, after those in which the motion settles (chosen).
MEASURED, SETTLING = 4, 4


@dataclass(frozen=True)
class Transmission:
    """Amplitudes of body height and of travel between body and wheel, relative to the road, at each frequency."""

    label: str
    frequency: numpy.ndarray
    body: numpy.ndarray
    travel: numpy.ndarray


def sine_road(frequency: float, amplitude: float) -> Excitation:
    """A sine road under the wheel."""
    angular = 2.0 * math.pi * frequency

    def values(time: float, _seen) -> list[float]:
        return [amplitude * math.sin(angular * time), amplitude * angular * math.cos(angular * time)]

    return Excitation(("road_height", "road_velocity"), values)


def run_road(choice: Choice, frequency: float, amplitude: float, step: float, label: str = "") -> Run:
    """The motion until it is periodic, and the periods after that; a period is a whole number of steps."""
    period = 1.0 / frequency
    fitting = period / math.ceil(period / step - 1e-9)
    periods = MEASURED + max(SETTLING, math.ceil(frequency))
    return run_car(QUARTER_CAR, sine_road(frequency, amplitude), choice, periods * period, fitting, label=label)


def harmonic(run: Run, signal: numpy.ndarray, frequency: float) -> float:
    """Amplitude of the first harmonic in the measured periods."""
    settled = run.time > run.time[-1] - (MEASURED - 1e-9) / frequency
    turning = numpy.exp(-2j * math.pi * frequency * run.time[settled])
    return 2.0 * abs(numpy.mean(signal[settled] * turning))


def transmission(label: str, choice: Choice, frequencies, amplitude: float, step: float) -> Transmission:
    """The car at each frequency."""
    ratios = []
    for frequency in tqdm(frequencies, desc=label, unit="run", disable=None, leave=False):
        run = run_road(choice, frequency, amplitude, step)
        body, travel = run["body_height"], run["body_height"] - run["wheel_height"]
        ratios.append([harmonic(run, signal, frequency) / amplitude for signal in (body, travel)])
    return Transmission(label, numpy.array(frequencies), *numpy.array(ratios).T)


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = options_of(__doc__, out="out/quarter_car")
    parser.add_argument(
        "--frequencies",
        type=positive,
        nargs="+",
        default=[1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 3.9, 4.3, 4.7, 5.0, 5.5, 6.0, 7.0, 8.5, 10.0, 12.0, 14.0, 17.0, 20.0],
        metavar="HZ",
        help="frequencies of the road in Hz (default: 19 from 1 to 20)",
    )
    parser.add_argument("--amplitude", type=positive, default=2e-3, help="amplitude of the road in m (default: 2e-3)")
    parser.add_argument("--loop", type=positive, default=3.9, help="frequency of the loops in Hz (default: 3.9)")
    return parser.parse_args()


def program() -> None:
    """Runs the simulations selected on the command line."""
    options = arguments()
    choices = choices_of(options)
    found = [
        transmission(label, choice, options.frequencies, options.amplitude, options.step)
        for label, choice in choices.items()
    ]
    columns = {"frequency [Hz]": found[0].frequency}
    for one in found:
        columns |= {f"body; {one.label}": one.body, f"travel; {one.label}": one.travel}
    loops = [
        run_road(choice, options.loop, options.amplitude, options.step, label) for label, choice in choices.items()
    ]
    table, picture = Path(f"{options.out}.csv"), Path(f"{options.out}.png")
    write_csv(table, columns)
    written = write_runs(loops, options.out)
    draw_transmissibility(found, options.amplitude, picture)
    draw_loops(loops, options.loop, MEASURED, Path(f"{options.out}_loops.png"))
    print("body and travel relative to the road, as ratios of amplitudes:\n")
    print(f"{'f [Hz]':>7} " + " ".join(f"{one.label:>15}" for one in found))
    for at, frequency in enumerate(options.frequencies):
        print(f"{frequency:7.2f} " + " ".join(f"  {one.body[at]:6.3f} {one.travel[at]:6.3f}" for one in found))
    print("", table, picture, *written, f"{options.out}_loops.png", sep="\n")


if __name__ == "__main__":
    sys.exit(main(program))
