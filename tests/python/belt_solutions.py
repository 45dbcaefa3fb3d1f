"""The belt benchmark solved without the library: the correct periods of the laws, each by an independent method.

Forces and velocities here are those of the block relative to the belt while it lags: v < 0, and `level` is the force
that holds it.
"""

import functools
import math

import numpy
from analysis import BENCHMARK, stick_slip, without_stiction
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

MASS, STIFFNESS, BELT = BENCHMARK["mass"], BENCHMARK["stiffness"], BENCHMARK["belt_velocity"]
KINETIC = BENCHMARK["mu_k"] * BENCHMARK["normal_force"]
STATIC = BENCHMARK["mu_s"] * BENCHMARK["normal_force"]
WITHOUT_STICTION = without_stiction(**{name: BENCHMARK[name] for name in BENCHMARK if name != "mu_s"}).period

# LSODA at 1e-10 and Radau at 1e-8 agree to all digits on the closed systems of these laws.
INTEGRATED = {
    "BengisuAkay": 6.002634,
    "Hollars": 7.577867,
    "LinearStiction": 7.565661,
    "BrownMcPhee": 7.634115,
    "LuGre": 7.073670,
    "LuGrePlanar": 7.073670,
    "ResetIntegrator": 7.52731,
}

# Below the kinetic level there is no stiction: once sliding, the block oscillates about f_C / k.
OSCILLATING = ["Ambrosio", "Bernard", "Coulomb", "Dahl", "Dankowicz", "RooneyDeravi", "Threlfall", "ThrelfallModified"]


def frictional_lag(time_lag=0.005, stribeck_velocity=1e-3, step=1e-4) -> float:
    """The delay differential equation of a slip from the static level, by the midpoint rule; then the belt carries
    the block to the static level again."""
    delay = round(time_lag / step)
    speeds, position, velocity = [0.0] * (delay + 1), STATIC / STIFFNESS, -1e-12
    while velocity < 0.0:
        delayed = 0.5 * (speeds[-1 - delay] + speeds[-delay])
        level = KINETIC + (STATIC - KINETIC) * math.exp(-((delayed / stribeck_velocity) ** 2))
        middle = position + 0.5 * step * (BELT + velocity)
        after = velocity + step * (level - STIFFNESS * middle) / MASS
        position += step * (BELT + 0.5 * (velocity + after))
        velocity = after
        speeds.append(velocity)
    slip = (len(speeds) - delay - 1) * step
    return slip + (STATIC / STIFFNESS - position) / BELT


def _curves(velocity: float, stop: float, decay=500.0) -> tuple[float, float]:
    """Levels while slowing down and while speeding up; `stop` is where the lower one ends."""
    fading = math.exp(-decay * abs(velocity))
    return KINETIC - (KINETIC - stop) * fading, KINETIC + (STATIC - KINETIC) * fading


def _slide(level, start, end=40.0):
    """Slides until the velocity of the belt is reached, if ever; returns the times of the maxima of the position, and
    time, position and velocity at the end."""

    def motion(_, state):
        position, velocity = state
        return [BELT + velocity, (level(STIFFNESS * position, velocity) - STIFFNESS * position) / MASS]

    def top(_, state):
        return BELT + state[1]

    def rest(_, state):
        return state[1]

    top.direction, rest.direction, rest.terminal = -1.0, 1.0, True
    done = solve_ivp(motion, (start[0], end), start[1:], rtol=1e-8, atol=1e-12, max_step=1e-2, events=[top, rest])
    return list(done.t_events[0]), (done.t[-1], *done.y[:, -1])


def wojewoda(sigma_0=1e5) -> float:
    """Two slips. While the contact sticks the block vibrates on it in closed form. Between the levels neither
    curve is consistent with the sign of the acceleration: there the acceleration is 0."""
    end_of_lower = 2.0 * KINETIC - STATIC

    def level(pull, velocity):
        return min(max(pull, _curves(velocity, end_of_lower)[0]), _curves(velocity, end_of_lower)[1])

    maxima, at = [], (0.0, 0.0, 0.0)
    for deflection in (0.0, -end_of_lower / sigma_0):
        onset = _breakaway(at, deflection, sigma_0)
        found, at = _slide(level, onset)
        maxima += found
    return maxima[1] - maxima[0]


def _breakaway(at, deflection, sigma_0) -> tuple[float, float, float]:
    """Time, position and velocity at which a block at rest on the belt has strained the contact to f_s.

    With y the displacement against the belt: m d2y/dt2 = -(k + sigma_0) y - c_0 - k v_b t.
    """
    start, position, _ = at
    total = STIFFNESS + sigma_0
    w = math.sqrt(total / MASS)
    c_0, c_1 = STIFFNESS * position + sigma_0 * deflection, STIFFNESS * BELT

    def way(t):
        return (c_0 * (numpy.cos(w * t) - 1.0) + c_1 * (numpy.sin(w * t) / w - t)) / total

    def excess(t):
        return -sigma_0 * (deflection + way(t)) - STATIC

    times = numpy.arange(0.0, 8.0, 2e-4)
    first = int(numpy.argmax(excess(times) > 0.0))
    t = brentq(excess, times[first - 1], times[first])
    velocity = (-c_0 * w * math.sin(w * t) + c_1 * (math.cos(w * t) - 1.0)) / total
    return start + t, position + BELT * t + way(t), velocity


def non_reversible() -> float:
    """From the first slip to the second: the block never rests again. Between its two curves the contact carries what
    pulls at it, so that the block keeps its velocity."""

    def level(pull, velocity):
        lower, upper = _curves(velocity, 0.0)
        return min(max(pull, lower), upper)

    # It rests until the pull is the static level.
    onset = STATIC / STIFFNESS
    maxima, _ = _slide(level, (onset / BELT, onset, -1e-9), 15.0)
    return maxima[1] - maxima[0]


@functools.cache
def periods() -> dict[str, float]:
    """The last period of each law within 20 s."""
    return {
        **dict.fromkeys(OSCILLATING, WITHOUT_STICTION),
        **INTEGRATED,
        "CoulombStiction": stick_slip(**BENCHMARK).period,
        "FrictionalLag": frictional_lag(),
        "Wojewoda": wojewoda(),
        "NonReversible": non_reversible(),
    }
