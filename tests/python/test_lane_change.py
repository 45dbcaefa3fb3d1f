"""The lane change with four struts, five FMUs, compared with scipy, and the remaining roll that only friction
causes."""

import functools
import math

import cars
import numpy
import pytest

from examples.fmpy.coupling import FMUS
from examples.fmpy.lane_change import clearance, driver, lanes, open_loop, run_lane_change, way
from examples.fmpy.vehicle import Choice, choice_of, friction, options_of

NO_GAS = {"gas.enabled": False}

# Remaining roll at 5 s, in deg, from another model of the same car: its tyres are simpler, and the whole lateral force
# acts on its body at one height. The remaining roll depends only on springs, tyres and friction, which are the same.
LEFT = {0.0: 0.0, 20.0: 0.051, 50.0: 0.123}


@functools.cache
def run(level: float, step: float = 1e-3):
    """Open loop."""
    return run_lane_change(Choice(FMUS, friction("LuGre", level) | NO_GAS), step=step)


@functools.cache
def solution(level: float) -> cars.Solution:
    """The same from the equations."""
    plane = cars.Plane(lambda time: open_loop(time, {})[0])
    times = numpy.linspace(0.0, 5.0, 1001)
    return cars.solve(cars.four_post_car(**NO_GAS), lambda _: cars.NO_ROAD, level, times, plane, longest=1e-2)


@pytest.mark.parametrize("level", LEFT)
def test_friction_leaves_roll_behind(level):
    left = math.degrees(run(level)["roll"][-1])
    assert left == pytest.approx(LEFT[level], abs=1e-3 if level == 0.0 else 0.1 * LEFT[level])
    assert left == pytest.approx(math.degrees(solution(level).body[-1, 2]), rel=0.03, abs=1e-4)


@pytest.mark.parametrize("level", LEFT)
def test_motion_is_that_of_the_equations(level):
    found, exact = run(level, 5e-4), solution(level)

    def off(name: str, expected: numpy.ndarray) -> float:
        return abs(numpy.interp(exact.time, found.time, found[name]) - expected).max()

    assert off("roll", exact.body[:, 2]) < 0.01 * abs(exact.body[:, 2]).max()
    assert off("position_y", exact.extra[:, 0]) < 0.01
    assert off("yaw_rate", exact.extra[:, 3]) < 0.005 * abs(exact.extra[:, 3]).max()
    assert off("fl.length", 0.1775 + 1.011 * exact.travel[:, 0]) < 2e-4
    assert off("fl.tyre_load", exact.tyre_load[:, 0]) < 5.0


def test_the_manoeuvre_is_as_hard_as_intended():
    """Above 1 g; friction reduces the largest roll a little and hardly affects the track."""
    free, rough = run(0.0), run(50.0)
    assert abs(free["lateral_acceleration"]).max() == pytest.approx(1.13 * 9.81, rel=0.05)
    most = [math.degrees(abs(one["roll"]).max()) for one in (free, rough)]
    assert 0.05 < most[0] - most[1] < 0.2
    assert abs(free["position_y"] - rough["position_y"]).max() < 0.02


def test_the_struts_stand_still_at_the_end():
    found = run(50.0)
    end = found.time > 4.8
    assert max(abs(found[f"{corner}velocity"][end]).max() for corner in ("fl.", "fr.", "rl.", "rr.")) < 1e-4
    assert all(5.0 < abs(found[f"{corner}force_friction"][-1]) < 65.0 for corner in ("fl.", "fr.", "rl.", "rr."))


def test_lanes_have_the_lengths_and_widths_of_the_standard():
    first, second, third = lanes(1.4, run_up=0.0)
    assert (third.end, first.end, second.begin, second.end, third.begin) == (61.0, 12.0, 25.5, 36.5, 49.0)
    widths = [lane.left - lane.right for lane in (first, second, third)]
    assert widths == pytest.approx([1.79, 2.4, 3.0])
    assert second.right - first.left == pytest.approx(1.0)
    assert lanes(2.5)[2].left - lanes(2.5)[2].right == pytest.approx(3.5)
    assert first.middle == 0.0


def test_the_path_leads_from_middle_to_middle_without_a_jump():
    course = lanes(1.4)
    for lane in course:
        assert way(course, 0.5 * (lane.begin + lane.end)) == pytest.approx(lane.middle, abs=0.02)
    heights = [way(course, 0.01 * k) for k in range(12_000)]
    assert abs(numpy.diff(heights)).max() < 0.01 * 0.5


@pytest.mark.parametrize("level", [0.0, 50.0])
def test_the_driver_gets_through_the_cones(level):
    course = lanes(1.4)
    found = run_lane_change(Choice(FMUS, friction("LuGre", level)), driver(course, 20.0))
    assert clearance(found, course, 1.4) > 0.0
    assert clearance(run(level), course, 1.4) < 0.0, "the open loop does not know where the cones are"
    assert found["position_y"][-1] == pytest.approx(course[2].middle, abs=0.05)


def test_parameters_of_a_file(tmp_path):
    file = tmp_path / "tyre.csv"
    file.write_text("variable,value,unit\ntyre.lmuy,0.6,1\n", encoding="utf-8")
    options = options_of("", "out").parse_args(["--car-file", str(file)])
    slippery = run_lane_change(choice_of(options, "LuGre", 0.0))
    hardest = [numpy.abs(motion["lateral_acceleration"]).max() for motion in (slippery, run(0.0))]
    assert hardest[0] < 0.75 * hardest[1]
    with pytest.raises(SystemExit):
        options_of("", "out").parse_args(["--car-file", str(tmp_path / "none.csv")])
    file.write_text("name;value\n", encoding="utf-8")
    with pytest.raises(SystemExit):
        options_of("", "out").parse_args(["--strut-file", str(file)])
