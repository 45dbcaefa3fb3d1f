"""A mass under a PID controller with LuGre friction, solved by scipy from equations written here."""

import math

import numpy
import pytest
import stribeck
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicHermiteSpline

# Canudas de Wit et al. (1995): mass, gains, and friction of Table 1.
MASS, K_V, K_P, K_I = 1.0, 6.0, 3.0, 4.0
SIGMA_0, SIGMA_1, SIGMA_2 = 1e5, math.sqrt(1e5), 0.4
KINETIC, STATIC, STRIBECK = 1.0, 1.5, 1e-3
EVERY = 0.01


def bristles(velocity, deflection):
    """Rate of the deflection."""
    level = KINETIC + (STATIC - KINETIC) * math.exp(-((velocity / STRIBECK) ** 2))
    return velocity - SIGMA_0 * abs(velocity) * deflection / level


def motion(until, gain=None):
    """Error and velocity on the way to 1 m; with a gain, an observer makes up for the friction."""

    def rates(_time, states):
        error, velocity, integral, deflection = states[:4]
        slip = bristles(velocity, deflection)
        force = -K_V * velocity - K_P * error - K_I * integral
        force -= SIGMA_0 * deflection + SIGMA_1 * slip + SIGMA_2 * velocity
        seen = []
        if gain is not None:
            seen = [bristles(velocity, states[4]) - gain * error]
            force += SIGMA_0 * states[4] + SIGMA_1 * seen[0] + SIGMA_2 * velocity
        return [velocity, force / MASS, error, slip, *seen]

    count = 4 if gain is None else 5
    solution = solve_ivp(
        rates,
        (0.0, until),
        [-1.0, 0.0, 0.0, 0.0, 0.0][:count],
        method="Radau",
        t_eval=EVERY * numpy.arange(round(until / EVERY) + 1),
        rtol=1e-9,
        atol=[1e-12, 1e-12, 1e-12, 1e-15, 1e-15][:count],
    )
    assert solution.success, solution.message
    return solution.t, solution.y[0], solution.y[1]


def solved(until, **values):
    """The same by the workbench."""
    record = ["servo.position", "servo.velocity"]
    run = stribeck.solve("servo", "LuGre", tol=1e-10, until=until, every=EVERY, record=record, set=values)
    return run["time"], run["servo.position"] - 1.0, run["servo.velocity"]


def last_cycle(time, error, velocity):
    """Length of the last cycle from one rise through 0 to the next, and its largest error."""
    spline = CubicHermiteSpline(time, error, velocity)
    rises = [root for root in spline.roots(extrapolate=False) if spline(root, 1) > 0.0]
    first, last = rises[-2:]
    return last - first, numpy.abs(error[(time > first) & (time < last)]).max()


def test_hunting_has_the_period_and_the_amplitude_of_another_solver():
    expected = last_cycle(*motion(80.0))
    assert last_cycle(*solved(80.0)) == pytest.approx(expected, rel=1e-6)
    # Most of a cycle the mass rests at the largest error.
    assert expected[0] > 10.0
    assert expected[1] > 0.05


def test_an_observer_takes_the_path_of_another_solver():
    _, expected, _ = motion(10.0, gain=1e-4)
    _, error, _ = solved(10.0, **{"servo.compensation": "Observer"})
    assert numpy.abs(error - expected).max() < 1e-6
