"""The strut in multibody simulators: agreement with each other, with the quarter car, with statics and with C++."""

import functools
import sys

import mujoco
import numpy
import pytest
from command_line import run_example
from magic_formula import LateralTyre
from test_programs import is_drawn

from examples.fmpy.coupling import FMUS, CouplingError
from examples.fmpy.vehicle import QUARTER_CAR, Choice, Excitation, run_car
from examples.multibody import exudyn_host, mjcf, mujoco_host
from examples.multibody.hosted_strut import NativeStrut, Wrench, open_strut
from examples.multibody.suspension import (
    BUMP,
    DOUBLE_WISHBONE,
    GRAVITY,
    GUIDED,
    MACPHERSON,
    SPRUNG_MASS,
    SUSPENSIONS,
    TYRE,
    strut_parameters,
)

# Long enough for the largest stroke on the bump, which begins at 2 s.
AFTER_BUMP = 2.3

WITHOUT_FRICTION = {"friction.model": "None"}


@functools.cache
def cached(host: str, kind: str, step: float, time: float, native: bool, changes: tuple, how: tuple):
    """A run over the bump."""
    module = {"mujoco": mujoco_host, "exudyn": exudyn_host}[host]
    shape = SUSPENSIONS[kind]
    with open_strut({**strut_parameters(shape), **dict(changes)}, shape.length(), native, FMUS) as strut:
        return module.simulate(strut, host, kind=kind, step=step, time=time, **dict(how))


def drive(host, kind="double-wishbone", step=1e-3, time=AFTER_BUMP, native=False, changes=None, **how):
    """A run over the bump, computed once."""
    return cached(host, kind, step, time, native, tuple((changes or {}).items()), tuple(how.items()))


def differences(one, other) -> dict[str, float]:
    """Largest differences between two runs, by column."""
    names = ("body_height", "wheel_height", "length", "velocity", "force", "friction")
    return {name: float(numpy.abs(getattr(one, name) - getattr(other, name)).max()) for name in names}


def quarter_car(step: float, changes=None) -> tuple[float, float]:
    """Rest height and largest stroke of the QuarterCar FMU, with the masses of the guided suspension."""
    strut = strut_parameters(GUIDED) | (changes or {})
    weight = SPRUNG_MASS * GRAVITY
    settled = (GUIDED.spring_force - weight) / strut["spring.k"]
    car = {
        "body_mass": SPRUNG_MASS,
        "wheel_mass": GUIDED.unsprung_mass(),
        "motion_ratio": 1.0,
        "static_length": GUIDED.length() + settled,
        "tyre_stiffness": TYRE.stiffness,
        "tyre_damping": TYRE.damping,
        "body_height": -settled,
    }
    road = Excitation(("road_height", "road_velocity"), lambda time, _seen: list(BUMP.at(time)))
    run = run_car(QUARTER_CAR, road, Choice(FMUS, strut, car), AFTER_BUMP, step)
    rest = float(numpy.interp(BUMP.start, run.time, run["body_height"])) + settled
    return rest, GUIDED.length() - float(run["length"].min())


# Permitted error of an exchange once per step.
COUPLING_ERROR = {1e-3: 5e-3, 2e-4: 1e-3}


@pytest.mark.parametrize("step", COUPLING_ERROR)
@pytest.mark.parametrize("changes", [{}, WITHOUT_FRICTION], ids=["friction", "no friction"])
def test_mujoco_exudyn_and_quarter_car_agree(step, changes):
    runs = [
        drive("mujoco", "guided", step, changes=changes),
        drive("exudyn", "guided", step, changes=changes, coupling="implicit"),
        drive("exudyn", "guided", step, changes=changes, coupling="explicit"),
    ]
    rest, stroke = quarter_car(step, changes)
    for run in runs:
        assert run.largest_stroke() == pytest.approx(stroke, rel=COUPLING_ERROR[step])
        # A height of some millimetres: the error is relative to the stroke.
        assert run.rest_height() == pytest.approx(rest, abs=COUPLING_ERROR[step] * stroke)


@pytest.mark.parametrize("step", COUPLING_ERROR)
def test_double_wishbones_of_both_simulators_agree(step):
    one, other = drive("mujoco", step=step), drive("exudyn", step=step)
    assert one.largest_stroke() == pytest.approx(other.largest_stroke(), rel=COUPLING_ERROR[step])
    assert one.rest_height() == pytest.approx(other.rest_height(), rel=COUPLING_ERROR[step])


@pytest.mark.parametrize("kind", ["double-wishbone", "telescope", "macpherson"])
def test_fmu_in_mujoco_is_the_native_law(kind):
    for changes, tolerance in ((WITHOUT_FRICTION, 0.0), ({}, 1e-9)):
        fmu, native = (drive("mujoco", kind, native=native, changes=changes) for native in (False, True))
        apart = differences(fmu, native)
        assert apart["body_height"] <= tolerance
        assert apart["force"] <= 1e4 * tolerance


def test_implicit_coupling_in_exudyn_is_the_native_law():
    for changes in (WITHOUT_FRICTION, {}):
        fmu, native = (drive("exudyn", native=native, changes=changes) for native in (False, True))
        apart = differences(fmu, native)
        assert apart["body_height"] < 1e-11, "ten digits of some centimetres"
        assert apart["force"] < 1e-5


def test_explicit_coupling_has_the_error_of_a_first_order_method():
    exact = drive("exudyn", step=2e-4, changes=WITHOUT_FRICTION, coupling="implicit")
    errors = []
    for step in (2e-3, 1e-3):
        run = drive("exudyn", step=step, changes=WITHOUT_FRICTION, coupling="explicit")
        errors.append(numpy.abs(run.length - numpy.interp(run.time, exact.time, exact.length)).max())
    assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.25)


@pytest.mark.parametrize("host", ["mujoco", "exudyn"])
@pytest.mark.parametrize("offset", [+300.0, -300.0])
def test_friction_holds_the_body_short_of_its_rest_height(host, offset):
    # Enough damping for the body to approach from one side.
    calm = {"damper.c_comp": 9000.0, "damper.c_reb": 9000.0}
    calm["spring.preload"] = SPRUNG_MASS * GRAVITY + offset - 60e3 * 0.06
    free = drive(host, "guided", time=1.95, changes=calm | WITHOUT_FRICTION)
    held = drive(host, "guided", time=1.95, changes=calm)
    assert free.body_height[-1] == pytest.approx(offset / 60e3, rel=1e-4)
    # With a stuck strut the body still oscillates a little on the tyre, which has hardly any damping.
    late = held.time > 1.55
    shift, friction = held.body_height[late].mean() - offset / 60e3, held.friction[late].mean()
    assert shift * offset < 0.0
    # The contacts carry the part that the spring lacks, up to their breakaway force.
    assert shift == pytest.approx(-friction / 60e3, rel=1e-2)
    assert 30.0 < abs(friction) <= 120.0


def cross(vector: numpy.ndarray) -> numpy.ndarray:
    """The matrix of a cross product."""
    x, y, z = vector
    return numpy.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def statics_of_macpherson(car: mujoco_host.QuarterCar) -> Wrench:
    """Reaction of tube on rod from the equilibrium of wheel, tube and rod, and of the arm, in their rest positions.

    The unknowns are the forces of ball joint, top mount and tie rod.
    """
    data, model = car.data, car.model
    point = {name: data.site(f"fl.{name}").xpos for name in ("rod_eye", "tube_eye", "wheel", "tie_rod", "rack")}
    ball, hinge = data.joint("fl.upright").xanchor, data.joint("fl.lower")
    tie = (point["rack"] - point["tie_rod"]) / numpy.linalg.norm(point["rack"] - point["tie_rod"])
    weights = {
        name: (data.body(f"fl.{name}").xipos, model.body(f"fl.{name}").mass[0]) for name in ("upright", "rod", "lower")
    }
    down = numpy.array([0.0, 0.0, -GRAVITY])
    load = numpy.array([0.0, 0.0, TYRE.load(*car.wheel_motion(), 0.0, 0.0)])
    acting = [(point["wheel"], load), *((at, mass * down) for at, mass in (weights["upright"], weights["rod"]))]
    equations, right = numpy.zeros((7, 7)), numpy.zeros(7)
    equations[:3] = numpy.column_stack([numpy.eye(3), numpy.eye(3), tie])
    equations[3:6] = numpy.column_stack([cross(ball), cross(point["rod_eye"]), numpy.cross(point["tie_rod"], tie)])
    right[:3] = -sum(force for _, force in acting)
    right[3:6] = -sum(numpy.cross(at, force) for at, force in acting)
    # The arm turns freely: no moment about its hinge from the ball joint's reaction and its weight.
    equations[6, :3] = -hinge.xaxis @ cross(ball - hinge.xanchor)
    right[6] = -hinge.xaxis @ numpy.cross(weights["lower"][0] - hinge.xanchor, weights["lower"][1] * down)
    top = numpy.linalg.solve(equations, right)[3:6]
    at, mass = weights["rod"]
    force = -(top + mass * down)
    moment = -numpy.cross(point["rod_eye"] - point["tube_eye"], top) - numpy.cross(at - point["tube_eye"], mass * down)
    m, n, _ = data.site("fl.rod_eye").xmat.reshape(3, 3).T
    return Wrench(force @ m, force @ n, moment @ m, moment @ n)


def components(wrench: Wrench) -> list[float]:
    """A wrench as numbers."""
    return [wrench.force_m, wrench.force_n, wrench.moment_m, wrench.moment_n]


def resting(kind: str) -> tuple[mujoco_host.QuarterCar, exudyn_host.QuarterCar, float]:
    """The same suspension at rest in both simulators, and the length of its strut."""
    shape, build = SUSPENSIONS[kind], mujoco_host.BUILDERS[kind]
    calm = strut_parameters(shape) | WITHOUT_FRICTION | {"damper.c_comp": 6000.0, "damper.c_reb": 6000.0}
    one = mujoco_host.QuarterCar(shape, build("fl", shape), 1e-3)
    strut = NativeStrut(calm)
    for _ in range(3000):
        length, velocity = one.look()
        one.push(strut.advance(length, velocity, 1e-3))
        one.move(0.0)
    length, _ = one.look()
    other = exudyn_host.QuarterCar(kind)
    other.tyre()
    connection = exudyn_host.Coupling(other, NativeStrut(calm), 1e-3, False, exudyn_host.tqdm(disable=True))
    connection.implicitly()
    other.system.Assemble()
    assert other.system.SolveDynamic(exudyn_host.settings(1e-3, 1900))
    return one, other, length


def test_side_loads_are_those_of_statics():
    one, other, length = resting("macpherson")
    expected = statics_of_macpherson(one)
    assert abs(expected.force_m) > 500.0
    assert components(one.wrench(length)) == pytest.approx(components(expected), rel=1e-6)
    # This one has less time to come to rest before its bump.
    assert components(other.wrench(length)) == pytest.approx(components(expected), rel=2e-5, abs=1e-3)


def test_a_strut_between_two_joints_carries_only_its_own_weight():
    one, other, length = resting("telescope")
    weight = GRAVITY * (DOUBLE_WISHBONE.tube.mass + DOUBLE_WISHBONE.rod.mass)
    for wrench in (one.wrench(length), other.wrench(length)):
        assert 0.0 < numpy.hypot(wrench.force_m, wrench.force_n) < weight
    assert components(one.wrench(length)) == pytest.approx(components(other.wrench(length)), rel=1e-3, abs=1e-9)


@pytest.mark.parametrize("host", ["mujoco", "exudyn"])
def test_friction_rises_with_the_side_load(host):
    alone = drive(host, "macpherson", side_loads=False)
    loaded = drive(host, "macpherson", side_loads=True)
    assert numpy.abs(loaded.friction).max() > 3.0 * numpy.abs(alone.friction).max()
    # Where the strut has slid for 6 mm, friction is preload and coefficient times load of each contact.
    travel = loaded.length - numpy.roll(loaded.length, 20)
    sliding = (numpy.abs(travel) > 6e-3) & (numpy.abs(loaded.velocity) > 0.2)
    sliding &= numpy.sign(loaded.velocity) == numpy.sign(numpy.roll(loaded.velocity, 20))
    assert sliding.sum() > 50
    expected = 60.0 + 0.10 * loaded.normal_1[sliding] + 0.08 * loaded.normal_2[sliding]
    assert numpy.abs(loaded.friction[sliding]) == pytest.approx(expected, rel=0.05), (
        "bristles lag a load that changes fast"
    )
    # Two universal joints leave the strut almost without side load.
    telescope = drive(host, "telescope", side_loads=True)
    assert numpy.abs(telescope.friction).max() < 1.2 * numpy.abs(alone.friction).max()


def test_the_native_law_rejects_unknown_parameters():
    strut = NativeStrut(strut_parameters(MACPHERSON))
    with pytest.raises(CouplingError, match="has no side loads"):
        strut.advance(0.44, 0.0, 1e-3, Wrench(force_m=1.0))
    for changes, reason in (
        ({"friction.model": "Dahl"}, r"friction.model = Dahl: .* LuGre or None"),
        ({"damper.mode": "Degressive"}, r"damper.mode = Degressive: .* must be Linear"),
        ({"friction.scale": 2.0}, r"friction.scale = 2.0: .* it has geom.length_extended, spring.k"),
    ):
        with pytest.raises(CouplingError, match=reason):
            NativeStrut(strut_parameters(MACPHERSON) | changes)


plugin_only = pytest.mark.skipif(sys.platform == "win32", reason="the plugin's script supports only Linux and macOS")


@pytest.fixture(scope="module")
def plugin():
    """The script of the plugin, with the plugin built and loaded."""
    from examples.multibody.plugin import run_plugin

    run_plugin.load_plugin()
    return run_plugin


POINTS = {f"damper.tab_{name}[{at}]": value * at for name, value in (("v", 0.2), ("f", 150.0)) for at in (1, 2, 3)}
TABLE = {"damper.mode": "Table", "damper.tab_n": 3} | POINTS


@plugin_only
@pytest.mark.parametrize("changes", [{}, WITHOUT_FRICTION, TABLE], ids=["friction", "no friction", "table"])
def test_plugin_is_the_fmu(plugin, changes):
    run = plugin.simulate_plugin(strut_parameters(DOUBLE_WISHBONE) | changes, "plugin", time=AFTER_BUMP)
    fmu = drive("mujoco", changes=changes)
    assert numpy.abs(run["body_height"] - fmu.body_height).max() < 1e-12
    assert numpy.abs(run["force"] - fmu.force).max() < 1e-8


@plugin_only
def test_plugin_keeps_its_state_in_the_simulation(plugin):
    parts = plugin.parts(strut_parameters(DOUBLE_WISHBONE))
    car = mujoco_host.QuarterCar(DOUBLE_WISHBONE, parts, 1e-3)
    mujoco.mj_step(car.model, car.data, 300)
    copy = mujoco.MjData(car.model)
    mujoco.mj_copyData(copy, car.model, car.data)
    # Reading does not change it.
    for _ in range(5):
        mujoco.mj_forward(car.model, car.data)
    mujoco.mj_step(car.model, car.data, 200)
    mujoco.mj_step(car.model, copy, 200)
    assert numpy.array_equal(car.data.qpos, copy.qpos)
    assert numpy.array_equal(car.data.plugin_state, copy.plugin_state)
    first = copy.qpos.copy()
    mujoco.mj_resetData(car.model, copy)
    mujoco.mj_step(car.model, copy, 500)
    assert numpy.array_equal(copy.qpos, first)


@plugin_only
def test_plugin_rejects_what_it_cannot_do(plugin):
    parts = plugin.parts(strut_parameters(DOUBLE_WISHBONE))
    text = mjcf.quarter_car(DOUBLE_WISHBONE, parts, 1e-3)
    for wrong, reason in (
        (text.replace("<option ", '<option integrator="RK4" '), "choose Euler or implicitfast"),
        (text.replace('key="spring.k" value="60000.0"', 'key="spring.k" value="-1"'), "spring.k = -1"),
        (text.replace('key="spring.k" value="60000.0"', 'key="spring.k" value="stiff"'), "must be a number"),
        (text.replace('key="spring.k" value="60000.0"', 'key="spring.k" value="1 2"'), "spring.k: must have at most 1"),
    ):
        assert wrong != text
        with pytest.raises(ValueError, match=reason):
            mujoco.MjData(mujoco.MjModel.from_xml_string(wrong))


def test_magic_formula_gives_the_published_points():
    """Points of the same coefficients, scaled to a tyre for 700 N, computed elsewhere."""
    tyre = LateralTyre(fnomin=700.0)
    forces = [tyre.force(slip, 700.0) for slip in (0.02, 0.05, 0.10, 0.15)]
    assert forces == pytest.approx([-400.079, -730.387, -839.639, -822.635], abs=1e-3)
    assert tyre.force(-0.05, 700.0) == pytest.approx(-forces[1])
    assert tyre.force(0.05, 0.0) == 0.0


@pytest.mark.parametrize(
    "options",
    [
        ["mujoco", "--suspension", "macpherson", "--side-loads", "--law", "Dahl"],
        ["mujoco", "--native"],
        ["exudyn", "--coupling", "explicit", "--set", "friction.scale=2"],
    ],
)
def test_the_program_writes_tables_and_a_picture(options, tmp_path):
    done = run_example("multibody.quarter_car", "--time", "1", *options, "--out", "a/run", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    tables, pictures = sorted((tmp_path / "a").glob("*.csv")), list((tmp_path / "a").glob("*.png"))
    assert len(tables) == 2
    for table in tables:
        assert numpy.isfinite(numpy.loadtxt(table, delimiter=",", skiprows=1)).all()
    assert is_drawn(pictures[0])


def test_programs_report_errors(tmp_path):
    for options, reason in (
        (["--law", "Nonsense"], "friction.model = 'Nonsense': must be one of None,"),
        (["--step", "1"], "time = 0.1 s: must be at least one step of 1.0 s"),
        (["--native", "--suspension", "macpherson", "--side-loads"], "has no side loads"),
    ):
        done = run_example("multibody.quarter_car", "mujoco", "--time", "0.1", *options, folder=tmp_path)
        assert done.returncode == 1
        assert reason in done.stderr
