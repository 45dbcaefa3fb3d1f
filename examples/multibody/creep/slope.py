"""The block on a slope with which docs/creep.md measures creep: one scene for all simulators."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy

GRAVITY = 9.81  # m/s2
MASS = 1.0  # kg
MU = 0.5  # static and kinetic coefficient of friction: most simulators have one
STEP = 1e-3  # s
LOADS = (0.5, 0.9, 0.99)  # pull of gravity along the slope, as a part of the static level
SETTLED = 1.0  # s, from where drift is measured
DURATION = 60.0  # s, over which it is measured
SLIDING_LOAD = 1.1  # a load that moves the block, to see that the level is the same everywhere

# A box on four spherical feet, whose lowest points touch the plane z = 0: every simulator has the same four contact
# points, and the block stands too wide to tilt.
HALF_LENGTH, HALF_HEIGHT, FOOT = 0.22, 0.05, 0.02  # m
CENTRE = 0.07  # m, height of the centre of mass
FEET = [(x, y, FOOT) for x in (-0.2, 0.2) for y in (-0.2, 0.2)]
INERTIA = (
    MASS * (HALF_LENGTH**2 + HALF_HEIGHT**2) / 3.0,
    MASS * (HALF_LENGTH**2 + HALF_HEIGHT**2) / 3.0,
    MASS * 2.0 * HALF_LENGTH**2 / 3.0,
)


@dataclass(frozen=True)
class Slope:
    """A slope on which gravity pulls with a part `load` of the static level. x points down the slope, z out of it."""

    load: float

    @property
    def angle(self) -> float:
        """Angle above the horizontal in rad."""
        return math.atan(self.load * MU)

    @property
    def pull(self) -> float:
        """Weight along the slope in N."""
        return MASS * GRAVITY * math.sin(self.angle)

    @property
    def normal_force(self) -> float:
        """Weight across the slope in N."""
        return MASS * GRAVITY * math.cos(self.angle)

    @property
    def level(self) -> float:
        """Static level of friction in N."""
        return MU * self.normal_force

    @property
    def gravity(self) -> list[float]:
        """The vector of gravity in m/s2: the plane stays level and gravity is turned, which is the same."""
        return [self.pull / MASS, 0.0, -self.normal_force / MASS]


# Makes so many steps from rest and returns the positions down the slope, with the one at the beginning.
Measure = Callable[[Slope, int], numpy.ndarray]


@dataclass(frozen=True)
class Case:
    """A kind of friction in a simulator, with options, and how it is run."""

    simulator: str
    friction: str
    options: str
    measure: Measure
    # Speed of creep in m/s that theory gives for a load, if there is a formula.
    speed: Callable[[float], float] | None = None


def slid(measure: Measure) -> float:
    """Distance of a block that slides from rest for a second, as a part of that under Coulomb friction."""
    slope = Slope(SLIDING_LOAD)
    expected = 0.5 * (slope.pull - slope.level) / MASS
    return float(measure(slope, round(1.0 / STEP))[-1]) / expected


def drift(positions: numpy.ndarray) -> float:
    """Displacement from the time at which the block has settled to the end, in m."""
    return float(positions[-1] - positions[round(SETTLED / STEP)])
