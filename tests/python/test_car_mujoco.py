"""The Formula Student car in MuJoCo: the same degrees of freedom, positions and side loads, and the same motion."""

import numpy
import pytest
from car_kinematics import position

from examples.car import car_ride
from examples.car.car_description import CORNERS, read_car
from examples.car.car_rest import relax
from examples.car.car_struts import parameters_of
from examples.car.car_tyres import read_tyre
from examples.car.manoeuvres import RUN_IN, manoeuvre
from examples.car.mujoco_car import MujocoCar

DESCRIPTION = read_car()


def floating() -> MujocoCar:
    """The car without weight."""
    model = MujocoCar(DESCRIPTION, 1e-3)
    model.model.opt.gravity[:] = 0.0
    return model


def test_degrees_of_freedom_are_those_of_exudyn():
    model = floating()
    data = model.data
    rows = data.efc_J.reshape(-1, model.model.nv)[: data.nefc]
    assert numpy.linalg.matrix_rank(rows) == len(rows)
    # Six of the chassis, travel and spin of each wheel, and the rack, whose motion is set.
    assert model.model.nv - len(rows) == 6 + 4 + 4 + 1


@pytest.mark.parametrize(("length", "rack"), [(0.186, 0.0), (0.197, 0.02), (0.160, -0.02)])
def test_positions_of_the_suspension_follow_from_lengths_alone(length, rack):
    model = floating()

    def hold(time: float) -> None:
        model.move_rack(min(1.0, 2.0 * time) * rack)
        for name in CORNERS:
            now, velocity = model.look(name)
            model.set_strut(name, 2e5 * (length - now) - 4e3 * velocity)

    # Without load the springs that close the loops do not deflect.
    model.run(1e-3, 1500, hold)
    turned, origin = model.rotation(model.chassis), model.nose()
    for name in CORNERS:
        wanted = position(DESCRIPTION.corners[name], model.look(name)[0], rack if name[0] == "f" else 0.0)
        carrier = model.carrier(name)
        numpy.testing.assert_allclose(turned.T @ (carrier.centre - origin), wanted.wheel_centre, rtol=0.0, atol=1e-6)
        numpy.testing.assert_allclose(turned.T @ carrier.axis, wanted.spin_axis, rtol=0.0, atol=1e-6)


def test_car_at_rest_carries_its_weight_and_struts_feel_theirs():
    model = MujocoCar(DESCRIPTION, 1e-3)
    rest = relax(model, read_tyre(DESCRIPTION), parameters_of(DESCRIPTION, "None", {}), 1e-3)
    assert sum(rest.loads.values()) == pytest.approx(9.81 * DESCRIPTION.mass, rel=1e-6)
    gravity = numpy.array([0.0, 0.0, -9.81])
    for name in CORNERS:
        eyes = [model.data.site(f"{name}.{eye}").xpos for eye in ("tube_eye", "rod_eye")]
        length = float(numpy.linalg.norm(eyes[1] - eyes[0]))
        a = (eyes[1] - eyes[0]) / length
        turning = [
            numpy.cross(model.data.body(f"{name}.{body}").xipos - eye, mass * gravity)
            for (body, mass), eye in zip((("tube", 0.45), ("rod", 0.30)), eyes, strict=True)
        ]
        # About the eye of the rod: the moment that the tube passes on, and the weight of the rod.
        about = sum(turning) - a * (a @ sum(turning))
        force, moment = model.reaction(name)
        m, n, _ = model.data.site(f"{name}.rod_eye").xmat.reshape(3, 3).T
        wanted = numpy.cross(about, a) / length
        assert force[:2] == pytest.approx([wanted @ m, wanted @ n], abs=1e-5)
        own = -turning[1]
        assert moment[:2] == pytest.approx([own @ m, own @ n], abs=1e-5)
        assert numpy.hypot(*force[:2]) > 0.4


def largest(run, column: str) -> float:
    """Largest deviation of a column from its start."""
    return float(numpy.abs(run[column] - run[column][0]).max())


def test_both_codes_compute_the_same_turn():
    course = manoeuvre("step-steer", duration=1.0, speed=15.0)
    runs = {code: car_ride.simulate(DESCRIPTION, course, "LuGre", code=code) for code in ("exudyn", "mujoco")}
    for column in ("roll", "yaw_rate", "yaw", "fl.load", "fr.load", "rl.load", "rr.load", "fl.length", "fl.friction"):
        one, other = (largest(run, column) for run in runs.values())
        assert one == pytest.approx(other, rel=0.02), column
    assert largest(runs["exudyn"], "roll") > 0.01


def test_both_codes_agree_on_the_lane_change_and_on_what_friction_changes():
    # As long as the car steers into the second lane and out of it.
    course = manoeuvre("lane-change", width=DESCRIPTION.width, duration=2.4)
    runs = {
        (code, law): car_ride.simulate(DESCRIPTION, course, law, code=code)
        for code in ("exudyn", "mujoco")
        for law in ("None", "LuGre")
    }
    for column in ("roll", "yaw_rate", "fl.load", "fr.load", "rl.load", "rr.load"):
        one, other = (largest(runs[code, "None"], column) for code in ("exudyn", "mujoco"))
        assert one == pytest.approx(other, rel=0.02), column
    for column in ("roll", "fl.length"):
        one, other = (
            largest(runs[code, "LuGre"], column) - largest(runs[code, "None"], column) for code in ("exudyn", "mujoco")
        )
        assert one == pytest.approx(other, rel=0.1), column
        assert abs(one) > 0.01 * largest(runs["exudyn", "None"], column)


def test_car_keeps_to_a_circle_while_its_speed_rises():
    course = manoeuvre("constant-radius", duration=4.0, acceleration=1.0)
    run = car_ride.simulate(DESCRIPTION, course, "None", code="mujoco")
    radius = numpy.hypot(run["front_x"] - course.speed * RUN_IN, run["front_y"] - course.radius)
    late = run["time"] > 3.0
    assert radius[late] == pytest.approx(course.radius, abs=0.3)
    # The drive is proportional: it lags by the torque that accelerates the car, over its gain.
    lag = DESCRIPTION.mass * course.acceleration * 0.2 / car_ride.CRUISE
    assert run["speed"][-1] == pytest.approx(course.speed + 2.0 - lag, abs=0.05)
    # The course, yaw and side slip together, turns at the speed over the radius, both those of the centre of mass.
    turning = run["yaw_rate"] + numpy.gradient(numpy.arctan2(run["lateral_velocity"], run["speed"]), run["time"])
    path = numpy.hypot(run["speed"], run["lateral_velocity"])
    centre = numpy.hypot(run["x"] - course.speed * RUN_IN, run["y"] - course.radius)
    assert (turning * centre)[late] == pytest.approx(path[late], rel=0.01)
    assert (numpy.diff(run["roll"][late][::200]) > 0.0).all()
