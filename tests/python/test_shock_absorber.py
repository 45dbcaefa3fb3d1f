"""The ShockAbsorber FMU compared with the same equations in numpy, published points, and required properties.

Every golden number is checked for both, so the numpy model is tested as well.
"""

import math
from collections.abc import Mapping
from contextlib import contextmanager

import numpy
import pytest
from strut import DEFAULTS as STRUT_DEFAULTS
from strut import INPUTS, Strut, lumped_friction

from examples.fmpy.coupling import CouplingError, open_fmu, path_of

OUTPUTS = [
    "force",
    "force_spring",
    "force_gas",
    "force_bump",
    "force_rebound",
    "force_damper",
    "force_friction",
    "friction_1",
    "friction_2",
    "friction_torque",
    "normal_1",
    "normal_2",
    "compression",
    "overlap",
]
OTHERS = ["force_tension", "force_travel", "dforce_dlength", "dforce_dvelocity", "dissipated_energy"]

# The wrench of the worked example.
WRENCH = {"side_force_m": 80.0, "side_force_n": -30.0, "side_moment_m": 2.0, "side_moment_n": 6.0}
NO_FRICTION = {"friction.model": "None"}


def of_fmu(parameters: Mapping) -> dict[str, object]:
    """The parameters in the form of the FMU: tables as one variable per point."""
    single = {name: value for name, value in parameters.items() if not isinstance(value, tuple)}
    tables = {name: value for name, value in parameters.items() if isinstance(value, tuple)}
    points = {f"{name}[{at}]": y for name, ys in tables.items() for at, y in enumerate(ys, start=1)}
    return single | points | ({"damper.tab_n": len(parameters["damper.tab_v"])} if tables else {})


class Driven:
    """The FMU with its inputs and outputs by name."""

    def __init__(self, fmu):
        self.slave, self.fmu, self.time = fmu.slave, fmu, 0.0
        self.inputs = dict(zip(INPUTS, fmu.references(*INPUTS), strict=True))
        self.references = fmu.references(*OUTPUTS, *OTHERS)

    def set(self, **inputs: float) -> None:
        """Sets inputs."""
        self.slave.setReal([self.inputs[name] for name in inputs], list(inputs.values()))

    def outputs(self) -> dict[str, float]:
        """All outputs now."""
        return dict(zip(OUTPUTS + OTHERS, self.slave.getReal(self.references), strict=True))

    def step(self, step: float) -> dict[str, float]:
        """One step, and the outputs after it."""
        self.slave.doStep(self.time, step)
        self.time += step
        return self.outputs()

    def save(self) -> tuple:
        """The state of the FMU."""
        return self.slave.getFMUState(), self.time

    def restore(self, saved: tuple) -> None:
        """Restores that state."""
        self.slave.setFMUState(saved[0])
        self.time = saved[1]

    def drive(self, inputs: Mapping[str, float], step: float) -> dict[str, float]:
        """A step with held inputs."""
        self.set(**inputs)
        return self.step(step)


@contextmanager
def strut_fmu(**parameters):
    """The FMU with parameters by name, including dots."""
    with open_fmu(path_of("ShockAbsorber"), of_fmu(parameters)) as fmu:
        yield Driven(fmu)


def at(parameters: Mapping, **inputs: float) -> tuple[dict[str, float], dict[str, float]]:
    """Outputs of FMU and numpy model for inputs set at the start, friction in steady sliding."""
    with strut_fmu(**parameters) as fmu:
        fmu.set(**inputs)
        found = fmu.outputs()
    strut = Strut({name: value for name, value in parameters.items() if name in STRUT_DEFAULTS})
    strut.settle(inputs)
    return found, strut.outputs(inputs)


@pytest.mark.parametrize(
    ("length", "velocity", "mode", "force"),
    [
        (0.2000, 0.0, "Linear", 288.3403),
        (0.1775, 0.0, "Linear", 1325.2555),
        (0.1775, 0.2, "Linear", 865.2555),
        (0.1775, 0.2, "Table", 785.2555),
        (0.1775, -0.2, "Linear", 1625.2555),
        (0.1775, -0.2, "Table", 1681.9222),
        (0.1520, -0.1, "Linear", 3860.5289),
        (0.1520, -0.1, "Table", 3920.5289),
        (0.1450, 0.0, "Linear", 5088.5714),
        (0.2010, 0.0, "Linear", -757.6023),
    ],
)
def test_golden_points_without_friction(length, velocity, mode, force):
    parameters = lumped_friction(0.0) | {"damper.mode": mode, "friction.viscous_coefficient": 0.0}
    for found in at(parameters, length=length, velocity=velocity):
        assert found["force"] == pytest.approx(force, abs=1e-4)


def test_golden_point_of_the_progressive_bump_stop():
    parameters = lumped_friction(0.0) | {"bump.mode": "Power"}
    for found in at(parameters, length=0.152):
        assert found["force_bump"] == pytest.approx(918.0984, abs=1e-4)


@pytest.mark.parametrize(
    ("velocity", "spin", "friction", "torque"),
    [(0.2, 0.0, 21.485700, 0.0), (-0.2, 0.0, -21.485700, 0.0), (0.2, 3.0, 21.216811, 0.036127)],
)
def test_worked_example_of_the_joint(velocity, spin, friction, torque):
    parameters = {"side.offset_m": 0.0, "geom.h_reg": 0.0, "friction.model": "Coulomb", "side.mode": "Inputs"}
    sliding = {"length": 0.18, "velocity": velocity, "spin_rate": spin} | WRENCH
    with strut_fmu(**parameters) as fmu:
        fmu.set(**sliding)
        found = fmu.outputs()
    strut = Strut({"side.mode": "Inputs", "geom.h_reg": 0.0, "friction.viscous_coefficient": 0.0})
    strut.settle(sliding)
    for one in (found, strut.outputs(sliding)):
        assert one["normal_1"] == pytest.approx(5.0, abs=1e-6)
        assert one["normal_2"] == pytest.approx(87.321246, abs=1e-6)
        assert one["force_friction"] == pytest.approx(-friction, abs=1e-6)
        assert one["friction_torque"] == pytest.approx(torque, abs=1e-6)


# k: normal forces, friction of both contacts, force.
GOLDEN_TRACE = {
    0: (70.294625, 34.726770, 15.044542, 8.793221, 859.824878),
    10: (66.088897, 37.067987, 14.570122, 9.000644, 792.940535),
    125: (30.368135, 68.080712, 11.079758, 11.409332, 748.929674),
    250: (70.294625, 34.726770, -15.096360, -8.776724, 1633.630076),
    500: (70.294625, 34.726770, 14.993054, 8.809113, 859.860475),
}


@pytest.mark.parametrize("h_max", [1e-4, 3e-4, 1e-2])
def test_golden_trace_of_the_default_shock_absorber(h_max):
    motion = [
        (0.1775 + 0.012 * math.sin(t), 0.012 * 4.0 * math.pi * math.cos(t)) for t in 0.004 * math.pi * numpy.r_[:501]
    ]
    inputs = [{"length": length, "velocity": velocity} | WRENCH for length, velocity in motion]
    strut = Strut({"damper.mode": "Table"})
    strut.settle(inputs[0])
    with strut_fmu(**{"damper.mode": "Table", "num.h_max": h_max}) as fmu:
        for drive in (fmu.drive, strut.drive):
            trace = [drive(given, 1e-3) for given in inputs]
            for k, golden in GOLDEN_TRACE.items():
                names = ("normal_1", "normal_2", "friction_1", "friction_2", "force")
                assert [trace[k][name] for name in names] == pytest.approx(golden, abs=1e-6)
            friction = numpy.array([found["friction_1"] + found["friction_2"] for found in trace])
            velocity = numpy.array([given["velocity"] for given in inputs])
            assert 1e-3 * friction @ velocity == pytest.approx(1.150427, abs=1e-6)


def test_golden_trace_of_lugre():
    golden = {1: 1.10999993, 2: 2.35400725, 5: 5.73064391, 10: 6.90855681, 20: -3.32047907, 30: 5.74107226}
    parameters = lumped_friction(20.0, 1.5)
    strut = Strut(parameters)
    with strut_fmu(**parameters) as fmu:
        for k in range(41):
            given = {"velocity": 0.01 * math.sin(2.0 * math.pi * k / 23.0)}
            found, expected = fmu.drive(given, 1e-3), strut.drive(given, 1e-3)
            if k in golden:
                # The other contact, without load, still has viscous drag.
                assert found["friction_1"] == pytest.approx(golden[k], abs=2e-8)
                assert expected["friction_1"] == pytest.approx(golden[k], abs=2e-8)
    assert strut.deflection[0, 0] == pytest.approx(4.0779333550e-6, rel=1e-9)


def random_parameters(random: numpy.random.Generator) -> dict[str, object]:
    """A strut with other numbers and modes than the default."""

    def about(name: str) -> float:
        return STRUT_DEFAULTS[name] * random.uniform(0.6, 1.4)

    scaled = ["spring.k", "spring.preload", "gas.p0", "bump.k", "bump.F_ref", "rebound.k", "damper.c_comp"]
    scaled += ["damper.c_reb", "friction.sigma_0", "friction.sigma_1", "friction.stribeck_velocity", "side.offset_m"]
    widths = numpy.cumsum(random.uniform(0.05, 0.3, 5))
    heights = numpy.cumsum(random.uniform(50.0, 400.0, 5))
    levels = {}
    for contact in ("c1", "c2"):
        levels |= {f"{contact}.{name}_k": about(f"{contact}.{name}_k") for name in ("mu", "preload")}
        levels |= {
            f"{contact}.{name}_s": levels[f"{contact}.{name}_k"] * random.uniform(1.0, 2.0)
            for name in ("mu", "preload")
        }
    return (
        {name: about(name) for name in scaled}
        | levels
        | {
            "gas.enabled": bool(random.integers(2)),
            "bump.gap": random.uniform(0.02, 0.04),
            "bump.mode": random.choice(["Linear", "Power", "Cubic"]),
            "bump.k2": random.uniform(0.0, 1e7),
            "bump.k3": random.uniform(0.0, 1e9),
            "bump.c": random.uniform(0.0, 3000.0),
            "rebound.gap": random.uniform(0.0, 0.01),
            "rebound.c": random.uniform(0.0, 3000.0),
            "damper.mode": random.choice(["Linear", "Table", "Degressive"]),
            "damper.interpolation": random.choice(["Linear", "Cubic"]),
            "damper.degr_comp": random.uniform(0.0, 5.0),
            "damper.degr_reb": random.uniform(0.0, 5.0),
            "damper.scale": random.uniform(0.5, 1.5),
            "damper.tab_v": (*(-widths[::-1]).tolist(), 0.0, *widths.tolist()),
            "damper.tab_f": (*(-0.7 * heights[::-1]).tolist(), 0.0, *heights.tolist()),
            "friction.asymmetry": random.uniform(-0.4, 0.4),
            "friction.scale": random.uniform(0.5, 2.0),
            "side.mode": random.choice(["Inputs", "Internal", "Sum"]),
            "side.convention": random.choice(["WrenchOnRod", "Lambda"]),
            "side.normal_sum": random.choice(["TwoPoint", "Adams"]),
            "side.offset_n": random.uniform(-0.003, 0.003),
            "side.force_ratio": random.uniform(-0.05, 0.05),
            "side.c_geo": random.uniform(1.0, 4.0 / math.pi),
        }
    )


@pytest.mark.parametrize("seed", range(40))
def test_equals_the_numpy_model_over_random_parameters_and_motions(seed):
    random = numpy.random.default_rng(seed)
    parameters = random_parameters(random)
    strut = Strut(parameters)
    moving, loads = random.uniform(0.5, 30.0, 3), {name: random.normal(0.0, 40.0, 60) for name in list(WRENCH)[:2]}
    loads |= {name: random.normal(0.0, 4.0, 60) for name in list(WRENCH)[2:]}
    with strut_fmu(**parameters) as fmu:
        for k in range(60):
            time = 0.01 * k
            given = {
                "length": 0.1775 + 0.026 * math.sin(moving[0] * time + moving[1]),
                # Not the derivative of the length: each law is tested, from creeping to fast.
                "velocity": math.sin(moving[2] * time) * 10.0 ** random.uniform(-5.0, 0.0),
            } | {name: values[k] for name, values in loads.items()}
            step = 10.0 ** random.uniform(-5.0, -1.5)
            if k == 0:
                strut.settle(given)
            found, expected = fmu.drive(given, step), strut.drive(given, step)
            for name in OUTPUTS:
                assert found[name] == pytest.approx(expected[name], rel=1e-9, abs=1e-7), (k, name)


@pytest.mark.parametrize("seed", range(5))
def test_friction_and_torque_of_a_rod_that_slides_and_spins(seed):
    """In steady sliding, where a law along the path and a law in two directions must agree."""
    random = numpy.random.default_rng(seed)
    given = {"velocity": random.normal(0.0, 0.3), "spin_rate": random.normal(0.0, 20.0)} | WRENCH
    found, expected = at({}, **given)
    for name in OUTPUTS:
        assert found[name] == pytest.approx(expected[name], rel=1e-9, abs=1e-9), name


def test_contact_forces_reproduce_200_wrenches():
    """Resultant and moment in vectors; the overlap goes from 85 mm to nothing."""
    random = numpy.random.default_rng(1)
    a = numpy.array([0.0, 0.0, 1.0])
    with open_fmu(path_of("TelescopicJoint"), {"geom.h_reg": 0.0}) as joint:
        inputs = joint.references("length", *WRENCH)
        outputs = joint.references("force_1_m", "force_1_n", "force_2_m", "force_2_n")
        for length in numpy.linspace(0.145, 0.2299, 200):
            force, moment = random.normal(0.0, 100.0, 2), random.normal(0.0, 10.0, 2)
            joint.slave.setReal(inputs, [length, *force, *moment])
            guide, piston = numpy.zeros(3), numpy.zeros(3)
            guide[0], guide[1], piston[0], piston[1] = joint.slave.getReal(outputs)
            size = max(1.0, abs(guide).max())
            assert (guide + piston)[:2] == pytest.approx(force, abs=1e-10 * size)
            found = numpy.cross(0.125 * a, guide) + numpy.cross((length - 0.105) * a, piston)
            assert found[:2] == pytest.approx(moment, abs=1e-10 * size)


def test_contacts_that_coincide_stay_finite_and_keep_the_resultant():
    with open_fmu(path_of("TelescopicJoint")) as joint:
        inputs = joint.references("length", *WRENCH)
        outputs = joint.references("force_1_m", "force_1_n", "force_2_m", "force_2_n", "normal_1", "normal_2")
        for length in (0.229, 0.23, 0.2300001, 0.24):
            joint.slave.setReal(inputs, [length, *WRENCH.values()])
            found = joint.slave.getReal(outputs)
            assert all(math.isfinite(value) for value in found)
            assert (found[0] + found[2], found[1] + found[3]) == pytest.approx((80.0, -30.0), abs=1e-10)
        joint.slave.setReal(inputs, [0.23, *WRENCH.values()])
        assert joint.slave.getReal(outputs)[4:] == pytest.approx([2140.4, 2225.7], abs=0.05)


def test_slow_cycling_gives_a_rectangle_of_friction_over_displacement():
    """Area 4 F_C A of a stroke from -A to A and back, apart from the bristles that reverse at its ends."""
    level, amplitude, speed, step = 15.0, 0.02, 0.01, 1e-3
    with strut_fmu(**lumped_friction(level)) as fmu:
        position, areas = -amplitude, []
        for direction in (1, -1, 1, -1, 1):
            areas.append(0.0)
            for _ in range(round(2.0 * amplitude / (speed * step))):
                found = fmu.drive({"length": 0.1775 + position, "velocity": direction * speed}, step)
                position += direction * speed * step
                areas[-1] += found["friction_1"] * direction * speed * step
    assert areas[-1] + areas[-2] == pytest.approx(4.0 * level * amplitude, rel=0.01)


# Only friction.
BARE = {"spring.k": 0.0, "spring.preload": 0.0, "gas.enabled": False, "rebound.k": 0.0, "bump.k": 0.0}
BARE |= {"damper.c_comp": 0.0, "damper.c_reb": 0.0}


class Block:
    """A mass on the friction of a strut alone, pushed by a force; explicit steps, the strut first."""

    def __init__(self, fmu: Driven, mass: float = 16.36):
        self.fmu, self.mass, self.position, self.velocity = fmu, mass, 0.0, 0.0

    def push(self, force: float, step: float) -> float:
        """One step under a force; returns that of the strut."""
        strut = self.fmu.drive({"length": 0.1775 + self.position, "velocity": self.velocity}, step)["force"]
        self.velocity += step * (force + strut) / self.mass
        self.position += step * self.velocity
        return strut


def test_a_rising_load_breaks_the_contact_away_at_the_static_level():
    """The load rises so slowly that the bristles creep at a tenth of the Stribeck velocity when 98 % are reached."""
    level, step, stribeck_velocity = 52.0, 1e-3, 0.01
    parameters = BARE | lumped_friction(40.0) | {"friction.stribeck_velocity": stribeck_velocity}
    with strut_fmu(**parameters) as fmu:
        block, load = Block(fmu), 0.0
        while block.velocity < stribeck_velocity:
            load += step * (20.0 if load < 0.8 * level else 2.0)
            block.push(load, step)
            assert load < 2.0 * level, "it never moves"
    assert load == pytest.approx(level, rel=0.02)


def test_a_contact_holds_a_load_below_breakaway_for_a_minute():
    load, step = 30.0, 1e-3
    with strut_fmu(**BARE, **lumped_friction(40.0)) as fmu:
        block, positions = Block(fmu), []
        for k in range(60_000):
            block.push(min(load, 20.0 * step * k), step)
            positions.append(block.position)
    bristles = load / STRUT_DEFAULTS["friction.sigma_0"]
    assert abs(positions[-1] - positions[5_000]) < 0.01 * bristles
    assert positions[-1] < 2.0 * bristles


@pytest.mark.parametrize("model", ["None", "LuGre", "BrownMcPhee", "Dahl", "MaxwellSlip", "ElastoPlastic"])
def test_closed_cycles_dissipate_the_work_of_the_force(model):
    """Ten cycles of a motion of two frequencies, the last nine measured: the work done on the strut stays in it."""
    step = 1e-4
    with strut_fmu(**{"friction.model": model, "side.offset_m": 0.01}) as fmu:
        work, begin, found = 0.0, 0.0, {}
        for k in range(20_000):
            time = step * k
            if k == 2_000:
                work, begin = 0.0, found["dissipated_energy"]
            phases = [2.0 * math.pi * f * time for f in (5.0, 15.0)]
            length = 0.1775 + 0.01 * math.sin(phases[0]) + 0.001 * math.sin(phases[1])
            velocity = 2.0 * math.pi * (0.05 * math.cos(phases[0]) + 0.015 * math.cos(phases[1]))
            found = fmu.drive({"length": length, "velocity": velocity}, step)
            work -= found["force"] * velocity * step
        dissipated = found["dissipated_energy"] - begin
        assert dissipated > 0.0
        assert dissipated == pytest.approx(work, rel=2e-3)


@pytest.mark.parametrize("model", ["None", "LuGre", "BrownMcPhee", "Dahl"])
def test_tangents_are_slopes_of_the_force(model):
    """Forward differences of the force after a step from one state, over length and over velocity."""
    given = {"length": 0.175, "velocity": 0.03} | WRENCH
    step, change = 1e-3, 1e-6
    with strut_fmu(**{"friction.model": model}) as fmu:
        for _ in range(5):
            fmu.drive(given, step)
        saved = fmu.save()

        def force(**changes: float) -> float:
            fmu.restore(saved)
            return fmu.drive(given | changes, step)["force"]

        middle = force()
        tangents = fmu.outputs()
        slope = (force(velocity=given["velocity"] + change) - middle) / change
        assert tangents["dforce_dvelocity"] == pytest.approx(slope, rel=1e-2)
        fmu.restore(saved)
        fmu.set(**given)
        tangent = fmu.outputs()["dforce_dlength"]
        fmu.set(length=given["length"] + change)
        below = fmu.outputs()["force"]
        fmu.set(**given)
        assert tangent == pytest.approx((below - fmu.outputs()["force"]) / change, rel=1e-3)
        fmu.slave.freeFMUState(saved[0])


# A host's definition of travel: adapter, travel at the length 0.1775 m, and travel per metre of extension.
ADAPTERS = {
    "Chrono, CarMaker: length in m": ({}, 0.1775, 1.0),
    "CarSim: compression in mm": ({"adapter.length_offset": 0.2, "adapter.length_gain": -1e-3}, 22.5, -1000.0),
    "wheel travel, motion ratio 0.8": ({"adapter.length_offset": 0.1775, "adapter.length_gain": -0.8}, 0.0, -1.25),
}


@pytest.mark.parametrize("host", ADAPTERS)
def test_signs_of_hosts(host):
    """Compressing raises the force that pushes the eyes apart, damping acts against the motion, and work is
    conserved."""
    adapter, travel, per_extension = ADAPTERS[host]
    with strut_fmu(**NO_FRICTION, **adapter) as fmu:

        def seen(extension: float, velocity: float) -> dict[str, float]:
            fmu.set(length=travel + per_extension * extension, velocity=per_extension * velocity)
            return fmu.outputs()

        rest = seen(0.0, 0.0)
        assert rest["force"] == pytest.approx(1325.2555, abs=1e-4)
        assert seen(-0.01, 0.0)["force"] > rest["force"] + 400.0
        assert seen(0.0, -0.1)["force"] == pytest.approx(rest["force"] + 150.0, abs=1e-9)
        assert seen(0.0, 0.1)["force"] == pytest.approx(rest["force"] - 230.0, abs=1e-9)
        # In Modelica tension is positive.
        assert rest["force_tension"] == -rest["force"]
        # Virtual work: the same power for any definition of travel.
        assert rest["force_travel"] * per_extension == pytest.approx(rest["force"], rel=1e-12)


@pytest.mark.parametrize("law", ["LuGre", "Dahl"])
def test_force_does_not_depend_on_the_communication_step(law):
    """12 mm at 2 Hz with the derivatives of the inputs; at every 5 ms after the first the forces agree within 0.5 N."""

    def forces(step: float) -> list[float]:
        parameters = {"friction.model": law, "num.input_mode": "Linear", "init.friction_state": "Steady"}
        with strut_fmu(**parameters) as fmu:
            references, found = list(fmu.inputs.values())[:2], []
            for k in range(round(0.6 / step)):
                phase = 4.0 * math.pi * k * step
                velocity = 0.012 * 4.0 * math.pi * math.cos(phase)
                fmu.set(length=0.1775 + 0.012 * math.sin(phase), velocity=velocity)
                if k % round(5e-3 / step) == 0:
                    found.append(fmu.outputs()["force"])
                acceleration = -0.012 * (4.0 * math.pi) ** 2 * math.sin(phase)
                fmu.slave.setRealInputDerivatives(references[1:], [1], [acceleration])
                fmu.step(step)
            return found

    fine = forces(1e-4)
    for step in (1e-3, 5e-3):
        assert forces(step) == pytest.approx(fine, abs=0.5)


@pytest.mark.parametrize("law", ["LuGre", "Dahl", "ElastoPlastic", "MaxwellSlip", "BrownMcPhee", "Bristle", "Leuven"])
def test_a_run_that_is_saved_and_restored_while_sticking_continues_bit_by_bit(law):
    def ride(fmu: Driven, begin: int, end: int) -> list[dict[str, float]]:
        return [fmu.drive({"velocity": 2e-4 * math.sin(0.3 * k)} | WRENCH, 1e-3) for k in range(begin, end)]

    with strut_fmu(**{"friction.model": law}) as fmu:
        ride(fmu, 0, 25)
        saved = fmu.save()
        once = ride(fmu, 25, 80)
        fmu.restore(saved)
        assert ride(fmu, 25, 80) == once
        fmu.slave.freeFMUState(saved[0])


# A switch, and parameters that must have the same effect.
SWITCHES = [
    ({"friction.switch": "Off"}, {"friction.model": "None"}),
    ({"friction.switch": "Off"}, lumped_friction(0.0) | {"friction.viscous_coefficient": 0.0}),
    ({"friction.switch": "ViscousOnly"}, lumped_friction(0.0)),
    (
        {"friction.switch": "NoStiction"},
        {"c1.mu_s": 0.10, "c1.preload_s": 8.0, "c2.mu_s": 0.08, "c2.preload_s": 6.0},
    ),
    ({"gas.enabled": False}, {"gas.p0": 101325.0, "gas.n": 0.0}),
    ({"side.mode": "Inputs"}, {"side.offset_m": 0.0}),
]


@pytest.mark.parametrize(("switch", "parameters"), SWITCHES)
def test_a_switch_has_the_effect_of_its_parameters_at_zero(switch, parameters):
    with strut_fmu(**switch) as switched, strut_fmu(**parameters) as zeroed:
        for k in range(100):
            motion = {"length": 0.1775 + 0.01 * math.sin(0.1 * k), "velocity": 0.1 * math.cos(0.1 * k)} | WRENCH
            found, expected = switched.drive(motion, 1e-3), zeroed.drive(motion, 1e-3)
            for name in ("force", "force_friction", "force_gas", "friction_1", "friction_2"):
                assert found[name] == pytest.approx(expected[name], rel=1e-12, abs=1e-9), (k, name)


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ({"c1.mu_s": 0.05}, "c1.mu_s = 0.05: must be >= c1.mu_k = 0.1"),
        ({"adapter.length_gain": 0.0}, "adapter.length_gain = 0"),
        ({"gas.V0": 5e-6}, "gas.V0"),
        ({"friction.model": "Lugre"}, "friction.model = 'Lugre': must be one of None, Coulomb"),
        ({"damper.tab_v[3]": 0.3, "damper.mode": "Table"}, "damper.tab_v"),
    ],
)
def test_impossible_values_are_rejected_by_name(parameters, message):
    with pytest.raises(CouplingError, match=message):
        with strut_fmu(**parameters) as fmu:
            fmu.drive({"length": 0.1775}, 1e-3)
