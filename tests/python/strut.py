"""A second implementation of the shock absorber, in numpy, from its equations: the reference for the tests of the FMU.

Parameters and inputs have the names of the FMU, so one dictionary serves both. SI units; friction is LuGre with a
state of two components per contact (along the axis and around it). Axes of the joint: a along the strut from the tube's
eye to the rod's, m and n across it, m x n = a.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from math import pi

import numpy
from scipy.interpolate import PchipInterpolator

# The set FS-ref: the defaults of the FMU.
DEFAULTS = {
    "geom.length_extended": 0.200,
    "geom.d_i": 0.125,
    "geom.d_j": 0.105,
    "geom.r_1": 0.007,
    "geom.r_2": 0.0125,
    "geom.h_reg": 0.002,
    "spring.k": 45000.0,
    "spring.preload": 150.0,
    "gas.enabled": True,
    "gas.p0": 1e6,
    "gas.V0": 3e-5,
    "gas.n": 1.2,
    "gas.rod_diameter": 0.014,
    "gas.p_ambient": 101325.0,
    "bump.gap": 0.040,
    "bump.mode": "Linear",
    "bump.k": 1.5e5,
    "bump.n": 2.2,
    "bump.x_ref": 0.010,
    "bump.F_ref": 1500.0,
    "bump.k2": 0.0,
    "bump.k3": 0.0,
    "bump.c": 0.0,
    "rebound.gap": 0.0,
    "rebound.k": 1e6,
    "rebound.c": 0.0,
    "damper.mode": "Linear",
    "damper.c_comp": 1500.0,
    "damper.c_reb": 2300.0,
    "damper.degr_comp": 0.0,
    "damper.degr_reb": 0.0,
    "damper.tab_v": (-1.0, -0.5, -0.25, -0.1, -0.05, 0.0, 0.05, 0.1, 0.25, 0.5, 1.0),
    "damper.tab_f": (-1150.0, -700.0, -430.0, -210.0, -110.0, 0.0, 180.0, 340.0, 640.0, 950.0, 1500.0),
    "damper.interpolation": "Linear",
    "damper.scale": 1.0,
    "friction.asymmetry": 0.0,
    "friction.scale": 1.0,
    "friction.sigma_0": 1e5,
    "friction.sigma_1": 316.227_766_016_837_94,
    "friction.viscous_coefficient": 0.1,
    "friction.stribeck_velocity": 1e-3,
    "friction.stribeck_exponent": 2.0,
    "c1.mu_s": 0.15,
    "c1.mu_k": 0.10,
    "c1.preload_s": 10.0,
    "c1.preload_k": 8.0,
    "c2.mu_s": 0.10,
    "c2.mu_k": 0.08,
    "c2.preload_s": 8.0,
    "c2.preload_k": 6.0,
    "side.mode": "Sum",
    "side.convention": "WrenchOnRod",
    "side.normal_sum": "TwoPoint",
    "side.offset_m": 0.003,
    "side.offset_n": 0.0,
    "side.force_ratio": 0.0,
    "side.c_geo": 1.0,
}

INPUTS = {
    "length": 0.1775,
    "velocity": 0.0,
    "side_force_m": 0.0,
    "side_force_n": 0.0,
    "side_moment_m": 0.0,
    "side_moment_n": 0.0,
    "spin_rate": 0.0,
}


def lumped_friction(level: float, ratio: float = 1.3) -> dict[str, float]:
    """Parameters of a friction level independent of the side load: the static level is `ratio` times the kinetic
    one."""
    contacts = {f"c{k}.{name}": 0.0 for k in (1, 2) for name in ("mu_s", "mu_k", "preload_s", "preload_k")}
    return contacts | {"c1.preload_k": level, "c1.preload_s": ratio * level}


def spring_force(p: Mapping, compression: float) -> float:
    """Spring with preload."""
    return p["spring.preload"] + p["spring.k"] * compression


def gas_force(p: Mapping, compression: float) -> float:
    """Gas compressed by the rod, against the ambient pressure."""
    if not p["gas.enabled"]:
        return 0.0
    area = pi / 4.0 * p["gas.rod_diameter"] ** 2
    pressure = p["gas.p0"] * (p["gas.V0"] / (p["gas.V0"] - area * compression)) ** p["gas.n"]
    return (pressure - p["gas.p_ambient"]) * area


def _stop(elastic: float, damping: float) -> float:
    """A stop whose damping neither pulls nor more than doubles it."""
    return elastic + min(max(damping, -elastic), elastic)


def bump_force(p: Mapping, compression: float, velocity: float) -> float:
    """Bump stop."""
    x = compression - p["bump.gap"]
    if x <= 0.0:
        return 0.0
    shapes = {
        "Linear": lambda: p["bump.k"] * x,
        "Power": lambda: p["bump.F_ref"] * (x / p["bump.x_ref"]) ** p["bump.n"],
        "Cubic": lambda: p["bump.k"] * x + p["bump.k2"] * x**2 + p["bump.k3"] * x**3,
    }
    return _stop(shapes[p["bump.mode"]](), -p["bump.c"] * velocity)


def rebound_force(p: Mapping, compression: float, velocity: float) -> float:
    """Top-out: pulls the eyes together."""
    x = p["rebound.gap"] - compression
    return -_stop(p["rebound.k"] * x, p["rebound.c"] * velocity) if x > 0.0 else 0.0


def damper_resistance(p: Mapping, velocity: float) -> float:
    """Force against the motion, with the sign of the velocity."""
    side = "reb" if velocity > 0.0 else "comp"
    shapes = {
        "Linear": lambda: p[f"damper.c_{side}"] * velocity,
        "Degressive": lambda: p[f"damper.c_{side}"] * velocity / (1.0 + p[f"damper.degr_{side}"] * abs(velocity)),
        "Table": lambda: _CURVES[p["damper.interpolation"]](p["damper.tab_v"], p["damper.tab_f"], velocity),
    }
    return p["damper.scale"] * shapes[p["damper.mode"]]()


def _line(xs, ys, x: float) -> float:
    """Straight lines between the points, extended beyond the outer ones."""
    at = min(max(int(numpy.searchsorted(xs, x)), 1), len(xs) - 1)
    return ys[at - 1] + (ys[at] - ys[at - 1]) / (xs[at] - xs[at - 1]) * (x - xs[at - 1])


def _monotone(xs, ys, x: float) -> float:
    """Monotone cubics between the points, tangents beyond the outer ones."""
    curve = PchipInterpolator(xs, ys)
    inside = min(max(x, xs[0]), xs[-1])
    return float(curve(inside) + curve(inside, 1) * (x - inside))


_CURVES = {"Linear": _line, "Cubic": _monotone}


def side_load(p: Mapping, inputs: Mapping) -> tuple[numpy.ndarray, numpy.ndarray]:
    """Force and moment (m, n) of the tube on the rod at the tube's eye: from the host and from the spring."""
    force = numpy.array([inputs["side_force_m"], inputs["side_force_n"]])
    moment = numpy.array([inputs["side_moment_m"], inputs["side_moment_n"]])
    if p["side.convention"] == "Lambda":
        force, moment = -force, numpy.array([-moment[1], moment[0]])
    spring = spring_force(p, p["geom.length_extended"] - inputs["length"])
    of_host, of_spring = p["side.mode"] != "Internal", (p["side.mode"] != "Inputs") * spring
    return (
        of_host * force + of_spring * numpy.array([p["side.force_ratio"], 0.0]),
        of_host * moment + of_spring * numpy.array([-p["side.offset_n"], p["side.offset_m"]]),
    )


def normal_forces(p: Mapping, inputs: Mapping) -> numpy.ndarray:
    """Normal forces at rod guide and piston."""
    force, moment = side_load(p, inputs)
    overlap = p["geom.d_i"] + p["geom.d_j"] - inputs["length"]
    middle = p["geom.d_i"] - 0.5 * overlap
    couple = (numpy.array([moment[1], -moment[0]]) - middle * force) / numpy.hypot(overlap, p["geom.h_reg"])
    if p["side.normal_sum"] == "Adams":
        pair = numpy.full(2, 0.5 * (numpy.linalg.norm(force) + numpy.linalg.norm(couple)))
    else:
        pair = numpy.linalg.norm([0.5 * force + couple, 0.5 * force - couple], axis=1)
    return p["side.c_geo"] * pair


@dataclass
class Strut:
    """A shock absorber in time; `parameters` replaces defaults."""

    parameters: Mapping = field(default_factory=dict)
    deflection: numpy.ndarray = field(default_factory=lambda: numpy.zeros((2, 2)))

    def __post_init__(self):
        unknown = set(self.parameters) - set(DEFAULTS)
        assert not unknown, f"unknown parameters {unknown}"
        self.parameters = DEFAULTS | dict(self.parameters)

    def elastic(self, length: float, velocity: float) -> dict[str, float]:
        """Everything but friction."""
        p, compression = self.parameters, self.parameters["geom.length_extended"] - length
        return {
            "force_spring": spring_force(p, compression),
            "force_gas": gas_force(p, compression),
            "force_bump": bump_force(p, compression, velocity),
            "force_rebound": rebound_force(p, compression, velocity),
            "force_damper": -damper_resistance(p, velocity),
        }

    def slip(self, inputs: Mapping) -> numpy.ndarray:
        """Sliding velocity at each contact, along and around the axis."""
        radii = (self.parameters["geom.r_1"], self.parameters["geom.r_2"])
        return numpy.array([(inputs["velocity"], radius * inputs["spin_rate"]) for radius in radii])

    def levels(self, inputs: Mapping) -> tuple[numpy.ndarray, numpy.ndarray, numpy.ndarray]:
        """Normal forces, the level g(v) and the capacity of the bristles, of each contact."""
        p, normal = self.parameters, normal_forces(self.parameters, inputs)
        kinetic, static = (
            p["friction.scale"]
            * (
                numpy.array([p[f"c1.preload_{kind}"], p[f"c2.preload_{kind}"]])
                + numpy.array([p[f"c1.mu_{kind}"], p[f"c2.mu_{kind}"]]) * normal
            )
            for kind in ("k", "s")
        )
        speed = numpy.linalg.norm(self.slip(inputs), axis=1)
        ratio = (speed / p["friction.stribeck_velocity"]) ** p["friction.stribeck_exponent"]
        level = kinetic + (static - kinetic) * numpy.exp(-ratio)
        asymmetry = p["friction.asymmetry"]
        return normal, (1.0 - numpy.sign(inputs["velocity"]) * asymmetry) * level, (1.0 + abs(asymmetry)) * static

    def settle(self, inputs: Mapping) -> None:
        """Puts the bristles into steady sliding."""
        _, level, _ = self.levels(INPUTS | dict(inputs))
        slip = self.slip(INPUTS | dict(inputs))
        speed = numpy.linalg.norm(slip, axis=1, keepdims=True)
        direction = numpy.divide(slip, speed, out=numpy.zeros_like(slip), where=speed > 0.0)
        self.deflection = level[:, None] / self.parameters["friction.sigma_0"] * direction

    def rate(self, inputs: Mapping, deflection: numpy.ndarray) -> numpy.ndarray:
        """Time derivative of the deflections."""
        _, level, _ = self.levels(inputs)
        slip = self.slip(inputs)
        pull = self.parameters["friction.sigma_0"] * numpy.linalg.norm(slip, axis=1)
        share = numpy.divide(pull, level, out=numpy.zeros_like(pull), where=level > 0.0)
        return numpy.where(level[:, None] > 0.0, slip - share[:, None] * deflection, 0.0)

    def step(self, inputs: Mapping, step: float) -> None:
        """The exact solution of the bristles' equation for held inputs."""
        inputs, stiffness = INPUTS | dict(inputs), self.parameters["friction.sigma_0"]
        _, level, _ = self.levels(inputs)
        slip = self.slip(inputs)
        self.deflection = self.carried(inputs)
        for contact in (0, 1):
            speed = numpy.hypot(*slip[contact])
            if level[contact] > 0.0 and speed > 0.0:
                steady = level[contact] / stiffness * slip[contact] / speed
                fade = numpy.exp(-stiffness * speed * step / level[contact])
                self.deflection[contact] = steady + (self.deflection[contact] - steady) * fade

    def carried(self, inputs: Mapping) -> numpy.ndarray:
        """Deflections as far as the load allows: bristles that carried more slip down to their capacity."""
        _, _, most = self.levels(inputs)
        length, longest = numpy.linalg.norm(self.deflection, axis=1), most / self.parameters["friction.sigma_0"]
        shrink = numpy.divide(longest, length, out=numpy.ones(2), where=length > longest)
        return shrink[:, None] * self.deflection

    def outputs(self, inputs: Mapping) -> dict[str, float]:
        """The outputs of the FMU for these inputs and the present deflections."""
        p, inputs = self.parameters, INPUTS | dict(inputs)
        deflection, slip = self.carried(inputs), self.slip(inputs)
        bristles = (
            p["friction.sigma_0"] * deflection
            + p["friction.sigma_1"] * self.rate(inputs, deflection)
            + p["friction.viscous_coefficient"] * slip
        )
        terms = self.elastic(inputs["length"], inputs["velocity"])
        terms["force_friction"] = -float(bristles[:, 0].sum())
        normal, _, _ = self.levels(inputs)
        return terms | {
            "force": sum(terms.values()),
            "friction_1": bristles[0, 0],
            "friction_2": bristles[1, 0],
            "friction_torque": p["geom.r_1"] * bristles[0, 1] + p["geom.r_2"] * bristles[1, 1],
            "normal_1": normal[0],
            "normal_2": normal[1],
            "compression": p["geom.length_extended"] - inputs["length"],
            "overlap": p["geom.d_i"] + p["geom.d_j"] - inputs["length"],
        }

    def drive(self, inputs: Mapping, step: float) -> dict[str, float]:
        """A step with held inputs, and the outputs after it."""
        self.step(inputs, step)
        return self.outputs(inputs)
