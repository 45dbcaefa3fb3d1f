"""The car that all multibody examples share: hardpoints, bodies, tyre, road and the parameters of the strut.

Axes as in ISO 8855: x forward, y left, z up, origin on the ground below the middle of the axle. All points are those of
the left corner in the design position; the right corner is its mirror image. The numbers are chosen: a medium-sized
road car, one corner of which carries 350 kg.
"""

import math
from dataclasses import dataclass

import numpy

GRAVITY = 9.81


@dataclass(frozen=True)
class Body:
    """A rigid body: mass in kg, centre of mass in m, principal moments of inertia about it in kg m^2."""

    mass: float
    centre: tuple[float, float, float]
    inertia: tuple[float, float, float]


@dataclass(frozen=True)
class Suspension:
    """One corner. The strut's tube ends in the eye `tube_eye`, its rod in `rod_eye`."""

    lower_front: tuple[float, float, float] = (0.15, 0.35, 0.20)
    lower_rear: tuple[float, float, float] = (-0.15, 0.35, 0.20)
    lower_ball: tuple[float, float, float] = (0.0, 0.70, 0.18)
    upper_front: tuple[float, float, float] = (0.11, 0.42, 0.46)
    upper_rear: tuple[float, float, float] = (-0.13, 0.42, 0.45)
    upper_ball: tuple[float, float, float] = (-0.02, 0.66, 0.48)
    rack_end: tuple[float, float, float] = (-0.12, 0.355, 0.25)
    tie_rod_end: tuple[float, float, float] = (-0.12, 0.69, 0.235)
    wheel_centre: tuple[float, float, float] = (0.0, 0.75, 0.31)
    tube_eye: tuple[float, float, float] = (0.0, 0.57, 0.62)
    rod_eye: tuple[float, float, float] = (0.0, 0.65, 0.19)
    lower_arm: Body = Body(4.0, (0.0, 0.52, 0.19), (0.06, 0.03, 0.08))
    upper_arm: Body = Body(2.0, (-0.01, 0.55, 0.465), (0.02, 0.01, 0.03))
    upright: Body = Body(35.0, (0.0, 0.74, 0.31), (0.9, 1.5, 0.9))
    tube: Body = Body(2.0, (0.0, 0.585, 0.54), (0.015, 0.015, 0.001))
    rod: Body = Body(1.0, (0.0, 0.632, 0.29), (0.010, 0.010, 0.0005))
    # Spring force in the design position.
    spring_force: float = 4700.0

    def axis(self) -> numpy.ndarray:
        """Unit vector along the strut from the eye of the tube to the eye of the rod."""
        return _unit(numpy.subtract(self.rod_eye, self.tube_eye))

    def transverse(self) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Unit vectors m and n across the strut; (m, n, axis) is right-handed."""
        m = _unit(numpy.cross((1.0, 0.0, 0.0), self.axis()))
        return m, numpy.cross(self.axis(), m)

    def strut_axes(self) -> numpy.ndarray:
        """The axes of the strut as columns: m, n and the axis itself."""
        return numpy.column_stack([*self.transverse(), self.axis()])

    def length(self) -> float:
        """Distance between the eyes in the design position."""
        return math.dist(self.rod_eye, self.tube_eye)

    def unsprung_mass(self) -> float:
        """Mass of wheel, upright and arms."""
        return self.upright.mass + self.lower_arm.mass + self.upper_arm.mass


# Tube bolted to the upright, rod attached to the body: the strut guides the wheel, so the load bends it.
MACPHERSON = Suspension(
    tube_eye=(-0.01, 0.62, 0.30),
    rod_eye=(-0.03, 0.56, 0.74),
    upright=Body(37.0, (0.0, 0.735, 0.32), (0.9, 1.5, 0.9)),
    tube=Body(2.0, (-0.015, 0.60, 0.41), (0.015, 0.015, 0.001)),
    rod=Body(1.0, (-0.025, 0.58, 0.62), (0.010, 0.010, 0.0005)),
    spring_force=3900.0,
)

DOUBLE_WISHBONE = Suspension()

# Straight up and down: with this guide a multibody code computes the quarter car of textbooks.
GUIDED = Suspension(tube_eye=(0.0, 0.75, 0.75), rod_eye=(0.0, 0.75, 0.31), spring_force=3800.0)


SUSPENSIONS = {
    "double-wishbone": DOUBLE_WISHBONE,
    "telescope": DOUBLE_WISHBONE,
    "macpherson": MACPHERSON,
    "guided": GUIDED,
}

# Mass that one corner carries.
SPRUNG_MASS = 350.0


@dataclass(frozen=True)
class Tyre:
    """A vertical spring and damper between wheel centre and road that cannot pull.

    In the design position, with the wheel centre `radius` above the road, it carries `static_load`.
    """

    radius: float = 0.31
    static_load: float = (SPRUNG_MASS + 41.0) * GRAVITY
    stiffness: float = 2.0e5
    damping: float = 300.0

    def load(self, wheel_height: float, wheel_velocity: float, road_height: float, road_velocity: float) -> float:
        """Vertical force on the wheel."""
        deflection = self.radius + road_height - wheel_height
        force = self.static_load + self.stiffness * deflection + self.damping * (road_velocity - wheel_velocity)
        return max(0.0, force)


@dataclass(frozen=True)
class Bump:
    """A bump with the shape of one period of a cosine."""

    height: float = 0.05
    start: float = 2.0
    duration: float = 0.15

    def at(self, time: float) -> tuple[float, float]:
        """Height and vertical velocity of the road below the wheel."""
        passed = (time - self.start) / self.duration
        if not 0.0 < passed < 1.0:
            return 0.0, 0.0
        phase = 2.0 * math.pi * passed
        rate = math.pi * self.height / self.duration
        return 0.5 * self.height * (1.0 - math.cos(phase)), rate * math.sin(phase)


TYRE = Tyre()
BUMP = Bump()


def strut_parameters(suspension: Suspension) -> dict[str, object]:
    """Parameters of the ShockAbsorber for a suspension, by their names in its FMU.

    60 kN/m, friction 60 N, static friction 120 N, half at each contact; side loads add to it.
    """
    length = suspension.length()
    return {
        "geom.length_extended": length + 0.06,
        "geom.stroke": 0.16,
        "geom.d_i": 0.65 * length,
        "geom.d_j": 0.65 * length,
        "geom.r_1": 0.011,
        "geom.r_2": 0.016,
        "spring.k": 60.0e3,
        "spring.preload": suspension.spring_force - 60.0e3 * 0.06,
        "gas.enabled": False,
        "bump.gap": 0.14,
        "damper.mode": "Linear",
        "damper.c_comp": 2000.0,
        "damper.c_reb": 4000.0,
        "friction.model": "LuGre",
        "friction.sigma_0": 2.0e5,
        "friction.sigma_1": 450.0,
        "friction.viscous_coefficient": 0.0,
        "friction.stribeck_velocity": 1.0e-3,
        "c1.preload_k": 30.0,
        "c1.preload_s": 60.0,
        "c2.preload_k": 30.0,
        "c2.preload_s": 60.0,
        "side.offset_m": 0.0,
        # At rest at the start: a host that iterates requests the first force at a non-zero velocity.
        "init.friction_state": "Zero",
    }


def _unit(vector: numpy.ndarray) -> numpy.ndarray:
    return vector / numpy.linalg.norm(vector)
