"""The belt benchmark in closed form, and the measurement of a computed motion for comparison.

A block of mass m on a belt of velocity v_b, held by a spring k: m d2x/dt2 = -k x - f_f(v), v = dx/dt - v_b, starting
from x = 0 at rest on the belt. With kinetic level f_C and static level f_s, w = sqrt(k / m) and D = (f_s - f_C) / k:

    stick   x = x_on + v_b t until k x = f_s
    slip    x = f_C / k + D cos w t + (v_b / w) sin w t until the block reaches the velocity of the belt again
"""

from dataclasses import dataclass
from math import atan2, hypot, isnan, pi, sqrt

import numpy

GRAVITY = 9.81  # m/s2

# Two runs agree if they differ by less than this. The coupling is of first order: a run is twice as far from a
# converged one as from the run with half its step.
AGREEMENT = 5e-3

# The benchmark of F. Novais, MSc thesis, University of Minho (2024), Table 6.1; SI units.
BENCHMARK = {
    "mass": 1.0,
    "stiffness": 2.0,
    "belt_velocity": 0.1,
    "mu_k": 0.1,
    "mu_s": 0.15,
    "normal_force": GRAVITY,
}


@dataclass(frozen=True)
class Cycle:
    """The periodic motion of the block on the belt; times in s, positions in m."""

    first_slip: float
    first_maximum: float
    period: float
    x_min: float
    x_max: float


def difference(cycle: Cycle, other: Cycle, is_random: bool) -> float:
    """The relative difference of two motions of a law that is largest: of the first maximum, the period and the height
    of the maxima, or of the first maximum alone if the law is random. What did not happen in both is left out."""
    names = ["first_maximum"] if is_random else ["first_maximum", "period", "x_max"]
    pairs = [(getattr(cycle, name), getattr(other, name)) for name in names]
    return max((a / b - 1.0 for a, b in pairs if not isnan(a / b)), key=abs)


def stick_slip(mass, stiffness, belt_velocity, mu_k, mu_s, normal_force) -> Cycle:
    """The exact cycle of Coulomb friction with stiction.

    The slip lasts (2 / w) (pi - arctan(D w / v_b)); the belt then carries the block over 2 D to the next onset.
    """
    w = sqrt(stiffness / mass)
    centre = mu_k * normal_force / stiffness
    d = (mu_s - mu_k) * normal_force / stiffness
    slip = 2.0 / w * (pi - atan2(d * w, belt_velocity))
    amplitude = hypot(d, belt_velocity / w)
    first_slip = (centre + d) / belt_velocity
    return Cycle(
        first_slip=first_slip,
        first_maximum=first_slip + atan2(belt_velocity, d * w) / w,
        period=2.0 * d / belt_velocity + slip,
        x_min=centre - amplitude,
        x_max=centre + amplitude,
    )


def without_stiction(mass, stiffness, belt_velocity, mu_k, normal_force) -> Cycle:
    """The exact cycle of Coulomb friction alone: after the first slip an undamped oscillation about f_C / k."""
    w = sqrt(stiffness / mass)
    centre = mu_k * normal_force / stiffness
    amplitude = belt_velocity / w
    return Cycle(
        first_slip=centre / belt_velocity,
        first_maximum=centre / belt_velocity + 0.5 * pi / w,
        period=2.0 * pi / w,
        x_min=centre - amplitude,
        x_max=centre + amplitude,
    )


def maxima(time: numpy.ndarray, position: numpy.ndarray) -> tuple[numpy.ndarray, numpy.ndarray]:
    """Times and heights of the maxima of an oscillation, between the samples.

    One maximum for each excursion above the middle of the range, so that ripple does not count; each is found by a
    parabola through the highest sample and its neighbours. An excursion truncated by the record is omitted.
    """
    settled = position[int(numpy.argmax(position)) :]
    middle = 0.5 * (settled.min() + settled.max())
    crossings = numpy.diff((position > middle).astype(int))
    begins, ends = numpy.flatnonzero(crossings > 0) + 1, numpy.flatnonzero(crossings < 0) + 1
    # The first excursion of a record that begins above the middle is truncated.
    ends = ends[ends > begins[0]] if len(begins) else ends
    found = [_vertex(time, position, begin, end) for begin, end in zip(begins, ends, strict=False)]
    instants, heights = zip(*found, strict=True) if found else ((), ())
    return numpy.array(instants), numpy.array(heights)


def _vertex(time: numpy.ndarray, position: numpy.ndarray, begin: int, end: int) -> tuple[float, float]:
    at = begin + int(numpy.argmax(position[begin:end]))
    left, top, right = position[at - 1 : at + 2]
    curvature = left - 2.0 * top + right
    shift = 0.5 * (left - right) / curvature if curvature < 0.0 else 0.0
    return time[at] + shift * (time[at + 1] - time[at]), top - 0.25 * (left - right) * shift


def measure(time: numpy.ndarray, position: numpy.ndarray, sticking: numpy.ndarray) -> Cycle:
    """The cycle of a computed motion that starts at rest on the belt; NaN for events that did not happen.

    The period is the distance between the last two maxima of the position, `x_max` the height of the last one, and
    `x_min` the lowest position after the first.
    """
    instants, heights = maxima(time, position)
    slipping = numpy.flatnonzero(~sticking)
    return Cycle(
        first_slip=time[slipping[0]] if len(slipping) else numpy.nan,
        first_maximum=instants[0] if len(instants) else numpy.nan,
        period=instants[-1] - instants[-2] if len(instants) > 1 else numpy.nan,
        x_min=position[time > instants[0]].min() if len(instants) else numpy.nan,
        x_max=heights[-1] if len(heights) else numpy.nan,
    )
