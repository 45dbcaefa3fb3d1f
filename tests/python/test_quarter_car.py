"""The quarter car on its strut, both FMUs, against the same equations solved by scipy and against published ratios."""

import functools
import math

import cars
import numpy
import pytest

from examples.fmpy.coupling import FMUS
from examples.fmpy.quarter_car import harmonic, run_road
from examples.fmpy.vehicle import Choice, friction

AMPLITUDE = 2e-3
NO_GAS = {"gas.enabled": False}

# Frequency in Hz: body motion and travel over a road of 2 mm, at 0 N, 20 N and 50 N; springs without gas.
RATIOS = {
    1.0: [(1.079, 0.047), (1.047, 0.015), (1.047, 0.015)],
    2.0: [(1.350, 0.217), (1.216, 0.072), (1.215, 0.068)],
    3.9: [(2.569, 1.232), (2.436, 0.997), (2.446, 0.744)],
    5.0: [(2.069, 1.415), (2.254, 1.390), (2.588, 1.381)],
}
CASES = [
    (frequency, level, *ratios)
    for frequency, row in RATIOS.items()
    for level, ratios in zip((0.0, 20.0, 50.0), row, strict=True)
]


@functools.cache
def run(frequency: float, level: float, step: float = 1e-3, **strut):
    """The FMUs; a cached run must be called with the same arguments."""
    choice = Choice(FMUS, friction("LuGre", level) | NO_GAS | strut)
    return run_road(choice, frequency, AMPLITUDE, step)


def ratios_of(frequency: float, level: float, step: float = 1e-3) -> list[float]:
    """Body motion and travel over road motion, through the FMUs."""
    found = run(frequency, level, step)
    signals = (found["body_height"], found["body_height"] - found["wheel_height"])
    return [harmonic(found, signal, frequency) / AMPLITUDE for signal in signals]


def solved_ratios(frequency: float, level: float) -> list[float]:
    """The same from the equations."""
    end = max(8.0, frequency) / frequency + 4.0 / frequency
    times = numpy.linspace(end - 4.0 / frequency, end, 2001)
    solution = cars.solve(cars.quarter_car(**NO_GAS), cars.sine_road(frequency, AMPLITUDE), level, numpy.r_[0.0, times])
    signals = (solution.body[1:, 0], solution.travel[1:, 0])
    return [cars.fundamental(times, signal, frequency) / AMPLITUDE for signal in signals]


@pytest.mark.parametrize(("frequency", "level", "body", "travel"), CASES)
def test_transmissibility_with_and_without_friction(frequency, level, body, travel):
    # Half a unit of the last digit printed, 5e-4, is 3 % of the smallest ratio.
    assert ratios_of(frequency, level) == pytest.approx([body, travel], rel=0.03, abs=5e-4)
    assert solved_ratios(frequency, level) == pytest.approx([body, travel], abs=1.5e-3)


def test_friction_carries_more_above_the_resonance_and_less_below():
    """The signature of friction: no change of the damper has both effects."""
    assert ratios_of(2.0, 50.0)[0] < 0.92 * ratios_of(2.0, 0.0)[0]
    assert ratios_of(5.0, 50.0)[0] > 1.2 * ratios_of(5.0, 0.0)[0]


@pytest.mark.parametrize("level", [0.0, 20.0])
def test_the_error_of_the_coupling_falls_with_the_step(level):
    exact = solved_ratios(3.9, level)[0]
    coarse, fine = (abs(ratios_of(3.9, level, step)[0] - exact) for step in (1e-3, 2e-4))
    assert fine < 0.3 * coarse
    assert fine < 4e-3 * exact


def test_motion_without_friction_is_that_of_the_equations():
    found = run(2.0, 0.0, 2e-4)
    solution = cars.solve(cars.quarter_car(**NO_GAS), cars.sine_road(2.0, AMPLITUDE), 0.0, found.time)
    assert abs(found["body_height"] - solution.body[:, 0]).max() < 5e-3 * AMPLITUDE
    assert abs(found["wheel_height"] - solution.wheels[:, 0]).max() < 5e-3 * AMPLITUDE
    assert abs(found["tyre_load"] - solution.tyre_load[:, 0]).max() < 0.5


def test_a_strut_that_never_breaks_away_leaves_the_car_to_its_tyre():
    """Both masses on the tyre alone, in closed form; bristles so stiff that they hardly bend."""
    frequency = 3.0
    parameters = friction("LuGre", 1e4) | {"friction.sigma_0": 1e7, "friction.sigma_1": 0.0}
    found = run_road(Choice(FMUS, parameters), frequency, AMPLITUDE, 2e-4)
    angular = 2.0 * math.pi * frequency
    tyre = 87563.5 + 95.8j * angular
    rigid = abs(tyre / (tyre - (52.91 + 16.36) * angular**2))
    assert harmonic(found, found["body_height"], frequency) / AMPLITUDE == pytest.approx(rigid, rel=0.01)


def test_the_car_stays_at_rest_on_a_level_road():
    """The static force given to the car is that of its strut, whatever the spring."""
    for strut in ({}, {"spring.k": 30000.0}, NO_GAS):
        found = run_road(Choice(FMUS, friction("LuGre", 20.0) | strut), 2.0, 1e-12, 1e-3)
        assert abs(found["body_height"]).max() < 1e-11
        assert found["force"][0] == pytest.approx(found["force"][-1], abs=1e-6)
