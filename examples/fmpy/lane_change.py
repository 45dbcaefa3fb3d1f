#!/usr/bin/env python3
"""A double lane change at 72 km/h, with and without friction in the four struts, and with several laws.

    python examples/fmpy/lane_change.py --levels 0 20 50
    python examples/fmpy/lane_change.py --steer path --laws

Couples DoubleTrackCar and four ShockAbsorbers. `--steer` is

    open-loop   two periods of a sine of 3.6 degrees at 0.9 Hz, the second one mirrored, with a pause of 0.35 s (chosen)
    path        a driver who follows a way through the cones of ISO 3888-2

Writes

    <out>_<level>.csv     the motion for each level of friction
    <out>.png             the same side by side
    <out>_path.png        the way through the cones, for `--steer path`
    <out>_laws.png        friction over velocity for each law at the highest level
    <out>_laws.csv        evaluations and run time of each law, absolute and relative to the lowest

After the manoeuvre the struts hold the body where friction lets it come to rest: some roll is left, which springs and
dampers alone cannot do.
"""

import argparse
import math
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy
from car_pictures import draw_course, draw_lane_change, draw_laws
from coupling import main, positive
from vehicle import (
    DOUBLE_TRACK_CAR,
    Choice,
    Excitation,
    Run,
    add_laws,
    choices_of,
    options_of,
    report_laws,
    run_car,
    run_laws,
    write_runs,
)

# When the car begins to steer in open loop, and the sine (chosen).
BEGIN, AMPLITUDE, FREQUENCY, PAUSE = 0.5, math.radians(3.6), 0.9, 0.35


def open_loop(time: float, _seen: Mapping[str, float]) -> list[float]:
    """Steering angle of two single sines, the second one the other way round."""
    period = 1.0 / FREQUENCY
    for begin, sign in ((BEGIN, 1.0), (BEGIN + period + PAUSE, -1.0)):
        if 0.0 < time - begin < period:
            return [sign * AMPLITUDE * math.sin(2.0 * math.pi * FREQUENCY * (time - begin))]
    return [0.0]


@dataclass(frozen=True)
class Course:
    """The cones of ISO 3888-2 for a car of a width, after a run-up; x forward, y to the left, from the first right cone.

    Three lanes of 12, 11 and 12 m with gaps of 13.5 and 12.5 m. The second lane begins 1 m to the left of the first;
    the third one has its right edge in line with the first (chosen).
    """

    width: float
    run_up: float = 20.0

    def lanes(self) -> list[tuple[float, float, float, float]]:
        """Begin, end, right and left edge of each lane."""
        first, second, third = 1.1 * self.width + 0.25, self.width + 1.0, max(3.0, 1.3 * self.width + 0.25)
        begins, lengths = (0.0, 25.5, 49.0), (12.0, 11.0, 12.0)
        edges = ((0.0, first), (first + 1.0, first + 1.0 + second), (0.0, third))
        return [
            (self.run_up + begin, self.run_up + begin + length, right, left)
            for begin, length, (right, left) in zip(begins, lengths, edges, strict=True)
        ]

    def cones(self) -> list[tuple[float, float]]:
        """Six pairs in each lane, on its edges."""
        return [
            (x, edge)
            for begin, end, right, left in self.lanes()
            for edge in (right, left)
            for x in numpy.linspace(begin, end, 6)
        ]

    def way(self, x: float) -> tuple[float, float]:
        """How far to the left the way is, and its curvature: half cosines between the middles of the lanes."""
        (_, end, *first), (begin, back, *second), (last, _, *third) = self.lanes()
        height, curvature = sum(first) / 2.0, 0.0
        for leave, arrive, old, new in ((end, begin, first, second), (back, last, second, third)):
            length, rise = arrive - leave + 2.0 * REACH, (sum(new) - sum(old)) / 2.0
            angle = math.pi * min(max((x - leave + REACH) / length, 0.0), 1.0)
            height += rise * (1.0 - math.cos(angle)) / 2.0
            curvature += rise / 2.0 * (math.pi / length) ** 2 * math.cos(angle) * (0.0 < angle < math.pi)
        return height, curvature
