"""The car on four posts with four struts, five FMUs, compared with scipy, published numbers, and required properties of
friction."""

import functools
import math

import cars
import numpy
import pytest

from examples.fmpy.coupling import FMUS
from examples.fmpy.four_post import measure, posts, run_four_post
from examples.fmpy.vehicle import BY_LOAD, FOUR_POST_CAR, Choice, choices_of, friction, options_of, run_car

FREQUENCY = 2.0
NO_GAS = {"gas.enabled": False}

# At 0 N, 20 N and 50 N and 2 Hz: heave in mm, pitch in deg, fastest damper in front in m/s, work of friction in J per
# cycle, travel of the front left wheel in mm, its minimum load in N.
CYCLES = {
    0.0: (38.06, 3.025, 0.058, 0.0, 8.52, 407.0),
    20.0: (37.06, 2.935, 0.051, 1.44, 7.57, 407.0),
    50.0: (35.91, 2.826, 0.042, 2.62, 5.94, 418.0),
}
MOTION_RATIO = 1.011


@functools.cache
def run(level: float, step: float = 1e-3):
    """Eight periods."""
    return run_four_post(Choice(FMUS, friction("LuGre", level) | NO_GAS), time=4.0, step=step)


def controlled(law: str, level: float, tolerance: float, **strut):
    """Two periods with error control."""
    choice = Choice(FMUS, friction(law, level) | NO_GAS | strut)
    return run_car(FOUR_POST_CAR, posts(FREQUENCY, 0.04, 0.5 * math.pi), choice, 1.0, 1e-2, tolerance, law)


@functools.cache
def solution(level: float) -> cars.Solution:
    """The last cycle from the equations."""
    times = numpy.r_[0.0, numpy.linspace(3.5, 4.0, 1001)]
    return cars.solve(cars.four_post_car(**NO_GAS), cars.posts(FREQUENCY, 0.04, 0.5 * math.pi), level, times)


@pytest.mark.parametrize("level", CYCLES)
def test_the_last_cycle_with_and_without_friction(level):
    heave, pitch, velocity, work, travel, load = CYCLES[level]
    found = run(level)
    cycle = measure(found, FREQUENCY)
    assert 1e3 * cycle.heave == pytest.approx(heave, rel=0.05)
    assert math.degrees(cycle.pitch) == pytest.approx(pitch, rel=0.05)
    assert abs(found["fl.velocity"][found.time > 3.5]).max() == pytest.approx(velocity, rel=0.05)
    # Without friction there is the drag of the viscous coefficient, 0.1 N.s/m in each contact.
    assert cycle.friction_work == pytest.approx(work, rel=0.05, abs=2e-3)
    assert 1e3 * cycle.travel / MOTION_RATIO == pytest.approx(travel, rel=0.05)
    assert cycle.least_load == pytest.approx(load, rel=0.05)


@pytest.mark.parametrize("level", CYCLES)
def test_the_equations_give_the_published_cycle(level):
    heave, pitch, velocity, work, travel, load = CYCLES[level]
    solved = solution(level)
    body, travels, loads = solved.body[1:], solved.travel[1:, 0], solved.tyre_load[1:, 0]
    assert 1e3 * numpy.ptp(body[:, 0]) == pytest.approx(heave, rel=2e-3)
    assert math.degrees(numpy.ptp(body[:, 1])) == pytest.approx(pitch, rel=2e-3)
    assert abs(solved.velocity[1:, 0]).max() == pytest.approx(velocity, abs=6e-4)
    power = (solved.friction * solved.velocity).sum(axis=1)[1:]
    assert numpy.trapezoid(power, solved.time[1:]) == pytest.approx(work, rel=2e-3)
    assert 1e3 * numpy.ptp(travels) == pytest.approx(travel, rel=2e-3)
    assert loads.min() == pytest.approx(load, rel=2e-3)


def test_motion_without_friction_converges_to_that_of_the_equations():
    """The force of a strut is held for a step, so the error falls with the step."""
    exact = solution(0.0)
    errors = []
    for step in (1e-3, 2.5e-4):
        found = run(0.0, step)
        last = numpy.interp(exact.time[1:], found.time, found["heave"])
        errors.append(abs(last - exact.body[1:, 0]).max())
    assert errors[1] < 0.35 * errors[0]
    assert errors[1] < 2e-3 * 38.06e-3


@pytest.mark.parametrize("level", [20.0, 50.0])
def test_friction_is_that_of_the_equations(level):
    """Over the last cycle, front left; the flanks are steep, so the mean over the cycle is compared."""
    exact, found = solution(level), run(level, 2.5e-4)
    friction_force = -numpy.interp(exact.time[1:], found.time, found["fl.force_friction"])
    assert abs(friction_force - exact.friction[1:, 0]).mean() < 0.01 * level


def test_posts_in_step_neither_roll_nor_excite_one_side_more():
    found = run(50.0)
    assert abs(found["roll"]).max() < 1e-12
    for name in ("length", "tyre_load", "force"):
        assert found[f"fl.{name}"] == pytest.approx(found[f"fr.{name}"], abs=1e-9)


def test_friction_never_exceeds_its_level_and_dissipates_energy():
    for level in (20.0, 50.0):
        found = run(level)
        assert abs(found["fl.force_friction"]).max() < 1.3 * level
        assert measure(found, FREQUENCY).heave < measure(run(0.0), FREQUENCY).heave


@pytest.mark.parametrize("law", ["Threlfall", "BrownMcPhee", "Dahl", "LuGre", "ElastoPlastic"])
def test_laws_of_one_level_move_the_car_alike(law):
    """All slide at 50 N; only pre-sliding and breakaway differ."""
    found = controlled(law, 50.0, 1e-4)
    other = controlled("LuGre", 50.0, 1e-4)
    last, others = found.time > 0.5, other.time > 0.5
    assert numpy.ptp(found["heave"][last]) == pytest.approx(numpy.ptp(other["heave"][others]), rel=0.03)


def test_error_control_tightens_with_its_tolerance():
    times = numpy.linspace(0.0, 1.0, 201)
    road = cars.posts(FREQUENCY, 0.04, 0.0)
    exact = cars.solve(cars.four_post_car(**NO_GAS), road, 0.0, times)
    errors, evaluations = [], []
    for tolerance in (1e-3, 1e-4, 1e-5):
        choice = Choice(FMUS, friction("LuGre", 0.0) | NO_GAS)
        found = run_car(FOUR_POST_CAR, posts(FREQUENCY, 0.04, 0.0), choice, 1.0, 1e-2, tolerance)
        assert found.time[-1] == 1.0
        heave = numpy.interp(times, found.time, found["heave"])
        errors.append(abs(heave - exact.body[:, 0]).max())
        evaluations.append(found.evaluations)
    assert errors[0] > 1.5 * errors[1] > 2.25 * errors[2]
    assert evaluations[0] < evaluations[1] < evaluations[2]


def test_a_steep_law_needs_more_evaluations_than_bristles():
    """Bristles of 1e5 N/m against a slope of 65 N in half a mm/s."""
    assert controlled("BrownMcPhee", 50.0, 1e-3).evaluations > 2 * controlled("LuGre", 50.0, 1e-3).evaluations


def test_parameters_of_an_axle_take_precedence_over_common_ones():
    choice = Choice(FMUS, {"spring.k": 4e4, "rear.spring.k": 3e4, "damper.scale": 0.5})
    assert choice.of_axle(FOUR_POST_CAR, "front.") == {"spring.k": 4e4, "damper.scale": 0.5}
    assert choice.of_axle(FOUR_POST_CAR, "rear.") == {"spring.k": 3e4, "damper.scale": 0.5}
    assert Choice(FMUS).of_axle(FOUR_POST_CAR, "rear.") == {"spring.k": 35000.0}


def test_friction_by_load_follows_the_spring_whose_seat_is_beside_the_axis():
    """A couple: the spring's force on an arm of 3 mm, over the overlap of 230 mm less the length."""
    strut = friction("Coulomb", BY_LOAD) | NO_GAS
    found = run_four_post(Choice(FMUS, strut), time=1.5)
    length, velocity = found["fl.length"], found["fl.velocity"]
    spring = 150.0 + 45000.0 * (0.2 - length)
    normal = 0.003 * spring / numpy.hypot(0.23 - length, 0.002)
    wanted = 8.0 + 6.0 + (0.10 + 0.08) * normal
    sliding = numpy.abs(velocity) > 0.02
    assert numpy.abs(found["fl.force_friction"])[sliding] == pytest.approx(wanted[sliding], rel=5e-3)
    assert numpy.ptp(wanted[sliding]) > 1.0


def test_levels_are_numbers_or_the_load():
    options = options_of("", "out").parse_args(["--levels", "0", "20", "load"])
    assert list(choices_of(options)) == ["no friction", "20 N", "by load"]
    for text in ("-1", "loads"):
        with pytest.raises(SystemExit):
            options_of("", "out").parse_args(["--levels", text])
