"""Speeds of creep in closed form: where a regularised curve of friction over velocity carries the load."""

import math
from collections.abc import Callable

from scipy.optimize import brentq

from examples.multibody.creep.slope import MASS, STEP, Slope

# Start values of the laws.
TRANSITION_VELOCITY = 1e-3  # m/s, of Threlfall
SPECKER_TRANSITION, SPECKER_PEAK = 2.5e-4, 5e-4  # m/s
TRANSITION_SLOPE = 1e4  # s/m, of Andersson


def threlfall(load: float) -> float:
    """Solution of 1 - exp(-3 v / v_0) = load."""
    return -TRANSITION_VELOCITY / 3.0 * math.log1p(-load)


def andersson(load: float) -> float:
    """Solution of tanh(k_t v) = load: static and kinetic level are the same."""
    return math.atanh(load) / TRANSITION_SLOPE


def specker(load: float) -> float:
    """Speed below the peak at which its curve carries the load, by a search for the root."""
    peak = 1.0 - math.tanh(SPECKER_PEAK / SPECKER_TRANSITION)

    def excess(v: float) -> float:
        part = v / SPECKER_PEAK
        return math.tanh(v / SPECKER_TRANSITION) + peak * part * math.exp(0.5 * (1.0 - part * part)) - load

    return brentq(excess, 0.0, SPECKER_PEAK, xtol=1e-18, rtol=1e-14)


def untold(load: float) -> float:
    """Speed that a law with the mass, but without the load, takes from the body in each step: h f_e / m."""
    return STEP * Slope(load).pull / MASS


LAWS: dict[str, Callable[[float], float]] = {"Threlfall": threlfall, "Andersson": andersson, "Specker": specker}


def mujoco_joint(time_constant: float, low: float, high: float, load: float) -> float:
    """Friction loss of MuJoCo, a constraint without position: R f = b v, R = (1 - d) / (d m), b = 2 / (d_max t)."""
    return Slope(load).pull * (1.0 - low) / (low * MASS) * 0.5 * high * time_constant


def exudyn_zone(zone: float, load: float) -> float:
    """Straight line up to the level at `zone`."""
    return load * zone


def drake_lagged(tolerance: float, load: float) -> float:
    """Found by measuring: f = mu f_n s / sqrt(1 + s^2), s = v / tolerance."""
    return tolerance * load / math.sqrt(1.0 - load * load)


def drake_tamsi(tolerance: float, load: float) -> float:
    """Found by measuring: f = mu f_n s (2 - s), s = v / tolerance < 1."""
    return tolerance * (1.0 - math.sqrt(1.0 - load))
