"""The Formula Student car: degrees of freedom, kinematics, statics and side loads by other roads; and nonsense."""

import copy
import math
import tomllib
from dataclasses import replace
from pathlib import Path

import exudyn
import numpy
import pytest
import stribeck
from car_kinematics import position
from command_line import run_example
from exudyn.utilities import RigidBodyInertia
from magic_formula import LateralTyre
from test_programs import is_drawn

from examples.car import car_ride
from examples.car.car_description import CAR, CORNERS, Car, CarError, car_of, read_car
from examples.car.car_design import DESIGNS
from examples.car.car_rest import settle
from examples.car.car_stand import SPRING, Stand
from examples.car.car_struts import PackageStrut, open_struts, parameters_of
from examples.car.car_study import (
    STUDIED,
    Case,
    courses_of,
    figures_of,
    laws_of,
    printed,
    run_case,
    scalar_laws,
    table_of,
)
from examples.car.car_tyres import read_tyre
from examples.car.exudyn_car import ExudynCar, steps_of
from examples.car.manoeuvres import manoeuvre
from examples.fmpy.coupling import FMUS, PROJECT
from examples.multibody.hosted_strut import Wrench

DESCRIPTION = read_car()
GRAVITY = 9.81


def entries() -> dict:
    """The description as it is in its file, to be changed."""
    return copy.deepcopy(tomllib.loads(CAR.read_text(encoding="utf-8")))


def test_bodies_joints_and_degrees_of_freedom():
    # Chassis and rack; eight bodies at each wheel. Locked by each joint: hinges 5, balls 3, links 1, telescope 4,
    # universal joints 4, the rack 6.
    bodies = 2 + 4 * 8
    per_wheel = 2 * (5 + 3) + 1 + 5 + (5 + 1) + (4 + 4 + 4) + (5 + 1)
    constraints = 6 + 4 * per_wheel
    # Six of the chassis, travel and spin of each wheel.
    assert 6 * bodies - constraints == 6 + 4 + 4
    assert ExudynCar(DESCRIPTION).mobility() == (bodies, constraints, 0)
    # Bolted down, with locked wheels.
    assert ExudynCar(DESCRIPTION, on_stand=True).mobility() == (bodies, constraints + 6 + 4, 0)


def test_positions_of_the_suspension_follow_from_lengths_alone():
    stand = Stand(DESCRIPTION)
    for length, rack in ((0.186, 0.0), (0.199, 0.02), (0.175, -0.03), (0.150, 0.01)):
        stand.place(length, rack)
        for name in CORNERS:
            real_length = stand.model.look(name)[0]
            wanted = position(DESCRIPTION.corners[name], real_length, rack if name[0] == "f" else 0.0)
            numpy.testing.assert_allclose(stand.model.wheel_centre(name), wanted.wheel_centre, rtol=0.0, atol=1e-9)
            _, _, camber, steer = stand.wheel(name)
            assert camber == pytest.approx(wanted.camber, abs=1e-9)
            assert steer == pytest.approx(wanted.steer, abs=1e-9)


def test_sweep_gives_the_motion_ratio_by_virtual_work():
    lengths = numpy.linspace(0.19, 0.17, 5)
    table = Stand(DESCRIPTION).sweep("rl", lengths)
    corner = DESCRIPTION.corners["rl"]
    heights = [position(corner, length).wheel_centre[2] for length in table["length"]]
    numpy.testing.assert_allclose(table["travel"], heights - corner["wheel_centre"][2], rtol=0.0, atol=1e-9)
    # The strut and the wheel move alike, within 3 %, and the wheel leans inwards when it rises.
    assert numpy.abs(table["motion_ratio"] - 1.0).max() < 0.03
    assert (numpy.diff(table["camber"]) > 0.0).all()
    assert numpy.abs(table["steer"]).max() < math.radians(0.01)


def resting(car=DESCRIPTION):
    """The car on its wheels."""
    model = ExudynCar(car)
    return model, settle(model, read_tyre(car), parameters_of(car, "None", {}))


def test_wheels_carry_the_weight_and_struts_the_springs():
    model, rest = resting()
    weight = GRAVITY * DESCRIPTION.mass
    assert sum(rest.loads.values()) == pytest.approx(weight, rel=1e-9)
    for axle in "fr":
        assert rest.loads[f"{axle}l"] == pytest.approx(rest.loads[f"{axle}r"], rel=1e-9)
    # Moments about the ground below the front axle, with all bodies where they are now.
    moment = DESCRIPTION.chassis.mass * model.place(model.chassis, DESCRIPTION.chassis.centre)[0]
    moment += DESCRIPTION.rack_mass * model.place(model.rack, model.centres[model.rack])[0]
    contacts = 0.0
    for name, made in model.corners.items():
        for body, number in made.bodies.items():
            given = made.corner.bodies[body]
            moment += given.mass * model.place(number, given.centre)[0]
        # The axles of these wheels are square to the car: each touches the road below its centre.
        contacts += rest.loads[name] * model.wheel_centre(name)[0]
    assert contacts == pytest.approx(GRAVITY * moment, rel=1e-6)
    for name, length in rest.lengths.items():
        strut = DESCRIPTION.corners[name].strut
        spring = strut["spring.preload"] + strut["spring.k"] * (strut["geom.length_extended"] - length)
        gas = stribeck.Model("GasSpring", **{"gas.p0": strut["gas.p0"], "compression": 0.2 - length})["force"]
        assert rest.forces[name] == pytest.approx(spring + gas, rel=1e-9)


def weight_of_strut(model: ExudynCar, name: str, gravity: numpy.ndarray) -> list[float]:
    """The wrench of the joint from moments of tube and rod about their eyes, without any law of exudyn."""
    corner, bodies = model.corners[name].corner, model.corners[name].bodies
    tube_eye = model.place(bodies["tube"], corner["tube_eye"])
    rod_eye = model.place(bodies["rod"], corner["rod_eye"])
    length = float(numpy.linalg.norm(rod_eye - tube_eye))
    a = (rod_eye - tube_eye) / length
    turning = [
        numpy.cross(model.place(bodies[body], corner.bodies[body].centre) - eye, corner.bodies[body].mass * gravity)
        for body, eye in (("tube", tube_eye), ("rod", rod_eye))
    ]
    # The tube passes the moment of its weight on to the rod; about the rod's eye this, the rod's weight and the force
    # are in balance. Moments along the axis turn the rod in the tube.
    moment, about_rod_eye = (vector - a * (vector @ a) for vector in (turning[0], turning[0] + turning[1]))
    force = numpy.cross(about_rod_eye, a) / length
    m, n, _ = (model.rotation(bodies["tube"]) @ corner.strut_axes).T
    return [force @ m, force @ n, moment @ m, moment @ n]


@pytest.mark.parametrize("gravity", [(0.0, 0.0, -9.81), (9.81, 0.0, 0.0), (4.0, -3.0, -9.0)])
def test_side_load_is_the_weight_of_tube_and_rod(gravity):
    gravity = numpy.array(gravity)
    stand = Stand(DESCRIPTION, gravity)
    stand.place(0.178, 0.01)

    def compare():
        for name in CORNERS:
            wanted = weight_of_strut(stand.model, name, gravity)
            length, _ = stand.model.look(name)
            seen = Wrench.in_rod_eye(*stand.model.reaction(name), length)
            assert [seen.force_m, seen.force_n, seen.moment_m, seen.moment_n] == pytest.approx(wanted, abs=1e-6)
            assert math.hypot(*wanted[2:]) > 0.1

    compare()
    # The same from the integrator, which has multipliers of its own: nothing moves.
    done, _ = stand.model.integrate(steps_of(1e-3, 5))
    assert done
    compare()


def test_two_contacts_carry_the_side_load():
    """A side load alone, without the spring's: N1 + N2 = R, and their moment about the tube's eye is M."""
    parameters = parameters_of(DESCRIPTION, "LuGre", {"side.offset_m": 0.0})["fl"]
    strut = PackageStrut(parameters, 0.18)
    strut.advance(0.18, 0.0, 1e-3, Wrench(80.0, -30.0, 2.0, 6.0))
    normal = dict(zip(("normal_1", "normal_2"), strut.seen[2:4], strict=True))
    overlap, guide = strut.model["overlap"], strut.model["geom.d_i"]
    piston = guide - overlap
    spread = numpy.hypot(overlap, strut.model["geom.h_reg"])
    middle = 0.5 * (guide + piston)
    # (M x a) - middle R, in m and n, over the regularised overlap.
    couple = numpy.array([6.0 - middle * 80.0, -2.0 + middle * 30.0]) / spread
    for name, sign in (("normal_1", 1.0), ("normal_2", -1.0)):
        assert normal[name] == pytest.approx(
            float(numpy.hypot(*(numpy.array([40.0, -15.0]) + sign * couple))), rel=1e-9
        )


SHORT = {"duration": 0.4}


@pytest.fixture(scope="module")
def posts():
    """The car on its posts, with friction and without."""
    course = manoeuvre("four-post", **SHORT)
    return {law: car_ride.simulate(DESCRIPTION, course, law, step=2e-3) for law in ("LuGre", "None")}


def test_friction_on_the_posts_takes_energy_and_follows_the_contacts(posts):
    rubbing, free = posts["LuGre"], posts["None"]
    for name in CORNERS:
        friction, normal = rubbing[f"{name}.friction"], rubbing[f"{name}.normal_1"]
        travel = numpy.diff(rubbing[f"{name}.length"])
        assert (friction[1:-1] * travel[1:]).sum() > 0.2
        assert not free[f"{name}.friction"].any()
        # Sliding, without the Stribeck part: seals and both contacts.
        sliding = numpy.abs(rubbing[f"{name}.velocity"]) > 0.03
        strut = DESCRIPTION.corners[name].strut
        level = strut["c1.preload_k"] + strut["c2.preload_k"]
        level = level + strut["c1.mu_k"] * normal + strut["c2.mu_k"] * rubbing[f"{name}.normal_2"]
        assert numpy.abs(friction)[sliding] == pytest.approx(level[sliding], rel=0.1)
    # 40 mm of the posts lift the body; left and right are alike.
    assert numpy.ptp(free["heave"]) > 0.03
    assert numpy.abs(free["roll"]).max() < 1e-9
    assert numpy.ptp(rubbing["pitch"]) < numpy.ptp(free["pitch"])


def test_struts_of_package_fmu_and_c_library_agree_to_the_last_bit():
    course = manoeuvre("four-post", duration=0.1)
    runs = [
        car_ride.simulate(DESCRIPTION, course, "Leuven", step=2e-3, through=through, fmus=FMUS)
        for through in ("package", "fmu", "c")
    ]
    for name, column in runs[0].columns.items():
        assert numpy.array_equal(column, runs[1][name]), name
        assert numpy.array_equal(column, runs[2][name]), name


def test_car_turns_where_it_is_steered():
    course = manoeuvre("step-steer", duration=1.2, speed=12.0)
    run = car_ride.simulate(DESCRIPTION, course, "LuGre")
    force = sum(run[f"{name}.force_y"] for name in CORNERS)
    # To the left: the yaw rate is positive, the left side rises, the right wheels carry more.
    assert run["yaw_rate"][-1] > 0.3
    assert run["roll"][-1] > math.radians(0.3)
    assert run["fr.load"][-1] > run["fl.load"][-1] + 200.0
    # Newton's law across the car, at the middle of the chassis; tyres and body differ by the roll motion only.
    acceleration = numpy.gradient(run["lateral_velocity"], run["time"]) + run["speed"] * run["yaw_rate"]
    late = slice(-200, -20)
    assert force[late].mean() == pytest.approx(DESCRIPTION.mass * acceleration[late].mean(), rel=0.03)
    loads = sum(run[f"{name}.load"] for name in CORNERS)
    assert loads[late].mean() == pytest.approx(GRAVITY * DESCRIPTION.mass, rel=5e-3)
    # The drive holds the speed within the torque it needs for that.
    assert run["speed"][-1] == pytest.approx(12.0, abs=0.3)


def test_exudyn_takes_a_load_as_that_at_the_end_of_a_step():
    """1 kg under a force that is equal to the time: after 1 s it moves at 0.5 m/s."""

    def error(step: float, lead: float) -> float:
        container = exudyn.SystemContainer()
        system = container.AddSystem()
        mass = system.CreateMassPoint(referencePosition=[0.0] * 3, mass=1.0)
        load = system.CreateForce(itemNumber=mass, loadVector=[0.0] * 3)

        def push(_system, end: float) -> bool:
            system.SetLoadParameter(load, "loadVector", [end - step + lead, 0.0, 0.0])
            return True

        system.SetPreStepUserFunction(push)
        system.Assemble()
        assert exudyn.MainSolverImplicitSecondOrder().SolveSystem(system, steps_of(step, round(1.0 / step)))
        node = system.GetObjectParameter(mass, "nodeNumber")
        return system.GetNodeOutput(node, exudyn.OutputVariableType.Velocity)[0] - 0.5

    for step in (0.02, 0.01):
        # The force of the beginning lags by a whole step, that of the end does not.
        assert error(step, 0.0) == pytest.approx(-step, rel=0.02)
        assert abs(error(step, step)) < 0.05 * step**2


def test_exudyn_turns_a_wheel_right_in_the_group_of_rotations_only():
    """A torque of 20 N m on 0.15 kg m^2 that turn at 100 rad/s, for 0.3 s."""

    def error(rotation: exudyn.NodeType) -> float:
        container = exudyn.SystemContainer()
        system = container.AddSystem()
        wheel = system.CreateRigidBody(
            inertia=RigidBodyInertia(7.0, numpy.diag([0.09, 0.15, 0.09])),
            initialAngularVelocity=[0.0, 100.0, 0.0],
            nodeType=rotation,
        )
        system.CreateTorque(itemNumber=wheel, loadVector=[0.0, 20.0, 0.0])
        system.Assemble()
        assert exudyn.MainSolverImplicitSecondOrder().SolveSystem(system, steps_of(1e-3, 300))
        spin = system.GetObjectOutputBody(wheel, exudyn.OutputVariableType.AngularVelocity, [0.0] * 3)[1]
        return spin - (100.0 + 20.0 / 0.15 * 0.3)

    gained = 20.0 / 0.15 * 0.3
    assert error(exudyn.NodeType.RotationEulerParameters) / gained == pytest.approx(-3e-3, rel=0.2)
    assert abs(error(exudyn.NodeType.RotationRotationVector)) < 1e-9


LANE_CHANGE = manoeuvre("lane-change", width=DESCRIPTION.width, duration=4.0)


@pytest.fixture(scope="module")
def lane_changes():
    """The lane change with LuGre friction, at two steps."""
    return {step: car_ride.simulate(DESCRIPTION, LANE_CHANGE, "LuGre", step=step) for step in (1e-3, 5e-4)}


def test_car_changes_lanes_between_the_cones(lane_changes):
    course, run = LANE_CHANGE, lane_changes[1e-3]
    assert course.speed == pytest.approx(72.0 / 3.6)
    # By the corners of a rectangle over both axles, as wide as the car; all three lanes are behind the car at the end.
    assert run["front_x"][-1] - DESCRIPTION.wheelbase > course.lanes[-1].end
    for ahead, side in ((0.0, 1.0), (0.0, -1.0), (-DESCRIPTION.wheelbase, 1.0), (-DESCRIPTION.wheelbase, -1.0)):
        across = 0.5 * side * DESCRIPTION.width
        x = run["front_x"] + ahead * numpy.cos(run["yaw"]) - across * numpy.sin(run["yaw"])
        y = run["front_y"] + ahead * numpy.sin(run["yaw"]) + across * numpy.cos(run["yaw"])
        for lane in course.lanes:
            within = (x > lane.begin) & (x < lane.end)
            assert (y[within] > lane.right).all()
            assert (y[within] < lane.left).all()
    assert figures_of(run, course)["clearance"] > 0.03
    # No tyre leaves the road, and each lateral force stays within what its load admits.
    for name in CORNERS:
        assert run[f"{name}.load"].min() > 100.0
        assert (numpy.abs(run[f"{name}.force_y"]) < 1.4 * run[f"{name}.load"]).all()


def test_energy_of_the_lane_change_is_accounted_for(lane_changes):
    """What tyres, friction and dampers have taken is missing in the motion. With 0.5 ms the rest is below a thousandth
    of what friction and dampers have taken, though the tyres have taken 400 times as much; and it falls with the square
    of the step."""
    coarse, fine = (run.works for run in lane_changes.values())
    assert fine.dissipated > 10.0
    assert abs(fine.residual) < 1e-3 * fine.dissipated
    assert coarse.residual == pytest.approx(4.0 * fine.residual, rel=0.1)
    # Friction and dampers apart: both steps agree, and so does force times velocity from the table.
    for run in lane_changes.values():
        for column, booked in (("friction", -fine.friction), ("force_damper", fine.dampers)):
            power = sum(run[f"{name}.{column}"] * run[f"{name}.velocity"] for name in CORNERS)
            assert numpy.trapezoid(power, run["time"]) == pytest.approx(booked, rel=1e-3), column
    assert coarse.friction == pytest.approx(fine.friction, rel=1e-3)
    assert coarse.dampers == pytest.approx(fine.dampers, rel=1e-3)


def test_figures_hold_when_the_step_is_halved(lane_changes):
    coarse, fine = lane_changes.values()
    for column in ("roll", "yaw_rate", "fl.load", "fr.load", "rl.load", "rr.load", "fl.length"):
        one, other = (float(numpy.abs(run[column] - run[column][0]).max()) for run in (coarse, fine))
        assert one == pytest.approx(other, rel=1e-3), column


def test_friction_torque_of_a_strut_does_the_work_of_its_spin():
    """In a strut that spins, a torque moves the suspension as virtual work says. In this car none does: the struts lie
    in the planes of their rockers."""
    assert Stand(DESCRIPTION).model.rod_spin("fl") == 0.0
    top = entries()
    top["front"]["rocker_axis"] = [1.0, 0.3, 0.0]
    stand = Stand(car_of(top))
    model, bodies = stand.model, stand.model.corners["fl"].bodies

    def angle() -> float:
        turned = model.rotation(bodies["tube"]).T @ model.rotation(bodies["rod"])
        axes = model.corners["fl"].corner.strut_axes
        return float(axes[:, 1] @ turned @ axes[:, 0])

    lengths, angles = [], []
    for length in (0.1801, 0.1799):
        stand.place(length, 0.0)
        lengths.append(model.look("fl")[0])
        angles.append(angle())
    spin = (angles[0] - angles[1]) / (lengths[0] - lengths[1])
    assert abs(spin) > 0.1
    stand.place(0.18, 0.0)
    seen = []
    for torque in (5.0, -5.0):
        model.twist_strut("fl", torque)
        model.settle("a twisted strut")
        seen.append(model.look("fl")[0])
    # The torque is on the tube, and reversed on the rod: it takes torque times spin.
    assert (seen[0] - seen[1]) * SPRING == pytest.approx(-10.0 * spin, rel=1e-3)


def test_kerb_lifts_the_left_side():
    run = car_ride.simulate(DESCRIPTION, manoeuvre("kerb", start=1.0, duration=0.4), "None")
    over = run["fl.road"] > 0.0
    assert over.sum() == pytest.approx(50, abs=2)
    assert run["fl.road"].max() == pytest.approx(0.03, rel=1e-2)
    assert not run["fr.road"].any()
    assert run["fl.load"][over].max() > run["fl.load"][0] + 300.0
    # The body follows: its left side rises.
    assert run["roll"].max() > math.radians(0.1)


def test_brakes_stop_the_car_and_lower_its_nose():
    course = manoeuvre("braking", duration=1.2)
    run = car_ride.simulate(DESCRIPTION, course, "None")
    late = slice(-300, -20)
    force = sum(run[f"{name}.force_x"] for name in CORNERS)[late].mean()
    slowing = numpy.gradient(run["speed"], run["time"])[late].mean()
    assert force == pytest.approx(DESCRIPTION.mass * slowing, rel=0.01)
    # The brakes act on the wheels, whose spin slows down too; the arm of the force is the loaded radius.
    radius = 0.2 - GRAVITY * DESCRIPTION.mass / 4.0 / 87563.5
    spinning = 4.0 * DESCRIPTION.corners["fl"].bodies["wheel"].inertia[1] * slowing / radius
    assert -force * radius == pytest.approx(course.torque + spinning, rel=0.02)
    # Load moves forward by m a h / l, and the nose goes down.
    moved = run["fl.load"][late].mean() - run["fl.load"][0]
    height = 0.286 + run["heave"][late].mean()
    assert moved == pytest.approx(-DESCRIPTION.mass * slowing * height / DESCRIPTION.wheelbase / 2.0, rel=0.05)
    assert run["pitch"][-1] > math.radians(0.1)
    works = run.works
    assert abs(works.residual) < 1e-3 * -works.brakes


def test_a_tyre_of_version_6_follows_its_pressure(tmp_path):
    """With C = 1, E = 0 and a steep slope the force is nearly friction times load, mu = pdy1 (1 + ppy3 dp)."""
    file = tmp_path / "six.tir"
    keys = "FITTYP = 61\nUNLOADED_RADIUS = 0.2\nFNOMIN = 800\nINFLPRES = 1E5\nNOMPRES = 1E5\nPDXP1 = 0.4\nNEW = 1\n"
    file.write_text(keys + "PCY1 = 1\nPDY1 = 1.5\nPKY1 = -1E9\nPKY2 = 1.6\nPPY3 = -0.2\n")
    tyre = stribeck.Tyre(file)
    assert (tyre.pressure, tyre.stiffness, tyre.damping) == (1e5, None, None)
    assert (tyre.unused, tyre.ignored) == (["unknown: NEW"], ["turn slip: PDXP1"])
    assert any(note.startswith("FITTYP = 61") for note in tyre.notes)
    for pressure, friction in ((None, 1.5), (1e5, 1.5), (1.5e5, 1.35), (5e4, 1.65)):
        force = tyre.wrench(800.0, side_slip=0.1, pressure=pressure).force_y
        assert force == pytest.approx(-800.0 * friction, rel=1e-9), pressure
    for pressure in (0.0, math.nan):
        with pytest.raises(stribeck.Refused, match="pressure = "):
            tyre.wrench(800.0, pressure=pressure)
    other = stribeck.Tyre(PROJECT / "examples" / "tyres" / "formula_student.tir")
    assert other.pressure is None
    with pytest.raises(stribeck.Refused, match="Magic Formula 5.2"):
        other.wrench(800.0, pressure=1e5)


def test_tyre_of_the_package_gives_the_published_points():
    file = PROJECT / "examples" / "tyres" / "formula_student.tir"
    tyre, other = stribeck.Tyre(file), LateralTyre(fnomin=700.0)
    assert (tyre.radius, tyre.stiffness, tyre.damping) == (0.2, 87563.5, 95.8)
    for side_slip in (0.02, 0.05, 0.1, 0.15):
        left, right = (
            tyre.wrench(700.0, side_slip=slip, left=at).force_y for slip, at in ((side_slip, True), (-side_slip, False))
        )
        assert left == -right
        # The other one is symmetric: it lies between both turns of this one.
        both = sorted((left, -tyre.wrench(700.0, side_slip=-side_slip).force_y))
        assert both[0] <= other.force(side_slip, 700.0) <= both[1]
    assert tyre.wrench(0.0, side_slip=0.1) == (0.0,) * 5
    assert tyre.wrench(700.0, longitudinal_slip=0.05).force_x > 500.0
    with pytest.raises(stribeck.Refused, match="side_slip = NaN: must be finite"):
        tyre.wrench(700.0, side_slip=math.nan)
    with pytest.raises(stribeck.Refused, match="nowhere.tir"):
        stribeck.Tyre("nowhere.tir")


SIX = PROJECT / "examples" / "tyres" / "formula_student_61.tir"


def test_a_tyre_tells_its_radii_at_any_pressure():
    """F = F_0 (1 + 0.7 dp) (1 - (0.1 F_y / F_0)^2) (q r + 15 r^2) with q^2 = (C R / F_0)^2 - 60, solved for r."""
    tyre = stribeck.Tyre(SIX)
    assert tyre.unused == tyre.ignored == []
    assert tyre.pressure == 90e3
    for pressure in (None, 80e3, 100e3):
        rise = 1.0 + 0.7 * ((pressure or 90e3) / 90e3 - 1.0)
        for load, side_slip in ((200.0, 0.0), (700.0, 0.05), (1500.0, -0.1)):
            force_y = tyre.wrench(load, side_slip=side_slip, pressure=pressure).force_y
            softened = 1.0 - (0.1 * force_y / 700.0) ** 2
            linear = math.sqrt((87563.5 * 0.2 / 700.0) ** 2 - 60.0)
            root = (math.sqrt(linear**2 + 60.0 * load / (700.0 * rise * softened)) - linear) / 30.0
            radii = tyre.radii(load, side_slip=side_slip, pressure=pressure)
            assert radii.deflection == pytest.approx(0.2 * root, rel=1e-12)
            assert radii.loaded_radius == pytest.approx(0.2 * (1.0 - root), rel=1e-12)
            ratio = load / 700.0
            fall = 700.0 / (87563.5 * rise) * (0.25 * math.atan(8.0 * ratio) + 0.07 * ratio)
            assert (radii.free_radius, radii.effective_radius) == (0.2, pytest.approx(0.2 - fall, rel=1e-12))
            state = {"force_y": force_y, "pressure": pressure}
            assert tyre.load(radii.loaded_radius, **state) == pytest.approx(load, rel=1e-12)
    rolling = tyre.radii(700.0, speed=20.0)
    growth = 5e-4 * (20.0 / rolling.effective_radius * 0.2 / 16.7) ** 2
    assert rolling.free_radius == pytest.approx(0.2 * (1.0 + growth), rel=1e-12)
    assert tyre.load(0.21) == 0.0
    assert tyre.radii(0.0).deflection == 0.0


def test_radii_that_a_tyre_cannot_have_are_refused(tmp_path):
    tyre = stribeck.Tyre(SIX)
    with pytest.raises(stribeck.Refused, match=r"load = 200000: no deflection carries it: .* from 0\.0 to 137000\.0 N"):
        tyre.radii(2e5)
    with pytest.raises(stribeck.Refused, match="camber = NaN: must be finite"):
        tyre.radii(700.0, camber=math.nan)
    with pytest.raises(stribeck.Refused, match="spin = inf: must be finite"):
        tyre.load(0.19, spin=math.inf)
    with pytest.raises(stribeck.Refused, match="pressure = -1: must be > 0"):
        tyre.load(0.19, pressure=-1.0)
    file = tmp_path / "soft.tir"
    text = SIX.read_text(encoding="utf-8")
    file.write_text("".join(line for line in text.splitlines(True) if "VERTICAL_STIFFNESS" not in line))
    soft = stribeck.Tyre(file)
    assert soft.stiffness is None
    for ask in (lambda: soft.radii(700.0), lambda: soft.load(0.19)):
        with pytest.raises(stribeck.Refused, match="gives no VERTICAL_STIFFNESS"):
            ask()
    # Version 5.2, linear: no coefficient tells its rolling radius.
    radii = stribeck.Tyre(DESCRIPTION.tyre.file).radii(700.0)
    assert radii.effective_radius is None
    assert (radii.free_radius, radii.loaded_radius) == (0.2, pytest.approx(0.2 - 700.0 / 87563.5, rel=1e-12))


def at_pressure(pressure: float | None, file: Path = SIX) -> Car:
    """The car on other tyres."""
    return replace(DESCRIPTION, tyre=replace(DESCRIPTION.tyre, file=file, pressure=pressure))


def test_both_tyres_of_the_examples_have_the_same_forces_at_the_nominal_pressure():
    """But for the tangent of the side slip in place of the angle, and the sine of the camber."""
    five, six = stribeck.Tyre(DESCRIPTION.tyre.file), stribeck.Tyre(SIX)
    for load in (300.0, 700.0, 1400.0):
        for side_slip in (-0.05, 0.0, 0.02):
            state = {"longitudinal_slip": 0.01, "side_slip": side_slip, "camber": -0.02, "speed": 20.0}
            assert six.wrench(load, **state) == pytest.approx(five.wrench(load, **state), rel=0.01, abs=1.0)


def test_the_car_sinks_on_softer_tyres():
    """At rest the wheels carry the weight; the tyres are as deep as radii without forces say."""
    heights = {}
    for pressure in (80e3, 100e3):
        car = at_pressure(pressure)
        tyre, model = read_tyre(car), ExudynCar(car)
        rest = settle(model, tyre, parameters_of(car, "None", {}))
        assert sum(rest.loads.values()) == pytest.approx(car.mass * car.gravity, rel=1e-9)
        for name in CORNERS:
            camber = math.asin(model.carrier(name).axis[2])
            radii = tyre.formula.radii(rest.loads[name], pressure=pressure)
            assert model.carrier(name).centre[2] == pytest.approx(radii.loaded_radius * math.cos(camber), abs=1e-9)
        heights[pressure] = model.pose()[2]
    assert 0.5e-3 < heights[100e3] - heights[80e3] < 3e-3


def test_tyres_without_pressure_or_stiffness_are_refused_by_the_car(tmp_path):
    with pytest.raises(CarError, match="Magic Formula 5.2, which has none"):
        read_tyre(at_pressure(80e3, DESCRIPTION.tyre.file))
    file = tmp_path / "soft.tir"
    file.write_text(SIX.read_text(encoding="utf-8").replace("VERTICAL_DAMPING", "VERTICAL_DAMPER"))
    with pytest.raises(CarError, match="its file gives no VERTICAL_DAMPING"):
        read_tyre(at_pressure(80e3, file))
    with pytest.raises(CarError, match="tyre.pressure = -1: must be positive"):
        car_of(changed("tyre/pressure", -1.0))


def changed(path: str, value: object) -> dict:
    """The description with one entry changed, or removed with None."""
    table = top = entries()
    *folders, name = path.split("/")
    for folder in folders:
        table = table[folder]
    if value is None:
        del table[name]
    else:
        table[name] = value
    return top


@pytest.mark.parametrize(
    ("path", "value", "text"),
    [
        ("chassis/mass", -1.0, "chassis.mass = -1: must be positive"),
        ("wheelbase", "long", "wheelbase = 'long': must be a finite number"),
        ("front/camber", None, "no entry front.camber"),
        ("rear/lower_bal", [0.0, 0.0, 0.0], "rear.lower_bal: unknown; did you mean lower_ball?"),
        ("front/upper_ball", [0.0, 1.0], "front.upper_ball = [0.0, 1.0]: must be three numbers"),
        ("front/tube_eye", [0.0, 0.252, 0.587], "front.tube_eye and rod_eye: 0 m apart, must be at least 0.001 m"),
        ("front/tube_eye", [0.0, 0.100, 0.587], "front.tube_eye and rod_eye: 0.152 m apart, must be between 0.145 and"),
        ("front/bodies/rod/inertia", [1.0, 0.1, 0.1], "front.bodies.rod.inertia = [1.0, 0.1, 0.1]: must be positive"),
        ("rear/bodies", 3, "rear.bodies = 3: must be a table"),
        ("brakes/front_share", 1.5, "brakes.front_share = 1.5: must be between 0 and 1"),
        ("tyre/width", 0.2, "tyre.width: unknown; there are file"),
    ],
)
def test_nonsense_in_the_description_is_named(path, value, text):
    if "tube_eye" in path and value[1] == 0.1:
        top = changed(path, value)
        top["strut"]["geom.length_extended"] = 0.2
        top["strut"]["geom.stroke"] = 0.040
        text = text.replace("0.145", "0.16")
    else:
        top = changed(path, value)
    with pytest.raises(CarError) as caught:
        car_of(top)
    assert text in str(caught.value)


def test_nonsense_in_struts_and_manoeuvres_is_named():
    lengths = dict.fromkeys(CORNERS, 0.186)

    def opened(law, changes):
        with open_struts(parameters_of(DESCRIPTION, law, changes), lengths):
            pass

    with pytest.raises(CarError, match="Nonsense"):
        opened("Nonsense", {})
    with pytest.raises(CarError, match="frictoin.scale"):
        opened("LuGre", {"frictoin.scale": 2.0})
    with pytest.raises(CarError, match="c1.mu_s"):
        opened("LuGre", {"c1.mu_s": 0.01})
    strut = PackageStrut(parameters_of(DESCRIPTION, "LuGre", {})["fl"], 0.186)
    with pytest.raises(CarError, match=r"strut at 0\.0000 s: .*side_force_m.*inf"):
        strut.advance(0.186, 0.0, 1e-3, Wrench(math.inf, 0.0, 0.0, 0.0))
    with (
        pytest.raises(CarError, match="c1.mu_s"),
        open_struts(parameters_of(DESCRIPTION, "LuGre", {"c1.mu_s": -0.1}), lengths, "c", FMUS),
    ):
        pass
    for changes in DESIGNS.values():
        opened("LuGre", changes)
    short = parameters_of(DESCRIPTION, "LuGre", {"geom.d_i": 0.09})
    with pytest.raises(CarError, match=r"overlap at full extension, .* = -0\.005 m: must be positive"):
        settle(ExudynCar(DESCRIPTION), read_tyre(DESCRIPTION), short)
    with pytest.raises(CarError, match=r"fl at 0\.0000 s: side load of 200000 N or N.m: must be at most 100000 N"):
        car_ride.side_load("fl", 0.0, Wrench(2e5, 0.0, 0.0, 0.0))
    with pytest.raises(CarError, match="four-post has no angle; there are speed, duration, stroke, frequency, lag"):
        manoeuvre("four-post", angle=1.0)
    with pytest.raises(CarError, match=r"step = 0\.002 s: must be at most 0\.00125 s on the road"):
        car_ride.simulate(DESCRIPTION, manoeuvre("step-steer"), step=2e-3)
    with pytest.raises(CarError, match="a wheel rolls at"):
        car_ride.simulate(DESCRIPTION, manoeuvre("step-steer", speed=0.5, duration=0.1))


@pytest.mark.parametrize(
    ("options", "printed"),
    [
        (["rest"], "34 bodies, 190 independent constraints, 0 redundant; 14 free"),
        (["kinematics", "--points", "3", "--corner", "fr", "--rack", "-0.02", "0.02"], "motion ratio"),
        (["drive", "--law", "Dahl", "--with", "duration=0.1", "--step", "2e-3"], "largest roll"),
        (["accuracy", "--test", "four-post", "--with", "duration=0.1", "--steps", "2e-3", "1e-3"], "codes differ"),
        (
            ["pressure", "--pressures", "8e4", "9e4", "1e5", "--with", "duration=0.1", "--with", "speed=16"],
            "90 kPa",
        ),
        (
            ["study", "--laws", "Dahl,Karnopp", "--test", "four-post", "--with", "duration=0.2", "--strut", "rr"],
            "Karnopp",
        ),
    ],
)
def test_program(options, printed, tmp_path):
    done = run_example("car.car", *options, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert printed in done.stdout
    if options[0] == "kinematics":
        table = numpy.loadtxt(tmp_path / "out" / "car_kinematics.csv", delimiter=",", skiprows=1)
        assert table[:, 1] == pytest.approx([-0.02] * 3 + [0.02] * 3)
        # Steered to the right, then to the left.
        assert (numpy.sign(table[:, 4]) == [-1.0] * 3 + [1.0] * 3).all()
        assert is_drawn(tmp_path / "out" / "car_kinematics.png")
    if options[0] == "study":
        page = (tmp_path / "out" / "car_study" / "report.html").read_text(encoding="utf-8")
        assert page.count("data:image/png;base64,") == 5
        assert all(f"<td>{law}</td>" in page for law in ("None", "Dahl", "Karnopp"))
        assert '<td>piston</td><td class="number">0.1</td><td class="number">0.08</td>' in page
    for table in tmp_path.rglob("*.csv"):
        assert numpy.isfinite(numpy.loadtxt(table, delimiter=",", skiprows=1)).all()


def test_study_knows_its_laws_and_numbers(tmp_path):
    assert len(scalar_laws()) >= 30
    assert laws_of("LuGre,None,Dahl,LuGre") == ["None", "LuGre", "Dahl"]
    assert laws_of(None) == ["None", *scalar_laws()]
    with pytest.raises(CarError, match="Dhal is not a law of the struts; these are: Coulomb,"):
        laws_of("Dhal")
    courses = courses_of(STUDIED, DESCRIPTION, {"stroke": 0.03, "duration": 0.1})
    assert (courses["four-post"].stroke, courses["lane-change"].duration) == (0.03, 0.1)
    assert courses["lane-change"].width == DESCRIPTION.width
    with pytest.raises(CarError, match="lane-change and four-post: no height; there are approach,"):
        courses_of(STUDIED, DESCRIPTION, {"height": 1.0})
    # A run that fails is told, and the others go on.
    case = Case(CAR, courses["four-post"], "LuGre", {"c1.mu_k": "0.9"}, 1e-3, tmp_path / "none.csv")
    outcome = run_case(case)
    assert "c1.mu_s = 0.15: must be >= c1.mu_k = 0.9" in outcome.failure
    assert "failed" in printed(table_of([outcome], "four-post"))
