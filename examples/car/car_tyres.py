"""Tyres of the car: contact with the road, relaxation, and the Magic Formula of the package; or the patch on a post."""

import math
from dataclasses import dataclass, field

import numpy
import stribeck

from examples.car.car_description import Car, CarError, Vector

# Part of the deflection by which the effective rolling radius is smaller than the one without load, for tyres whose
# file does not tell it (chosen).
ROLLING_DEFLECTION = 1.0 / 3.0
# Below this forward speed, in m/s, slip has no meaning.
SLOWEST = 1.0

# Half of the difference by which the slope of a load is found, in m.
NUDGE = 1e-5

UP = numpy.array([0.0, 0.0, 1.0])


def cross(a: Vector, b: Vector) -> Vector:
    """Cross product of two vectors in space: with that of numpy a run of the car takes a third longer."""
    (x, y, z), (u, v, w) = a.tolist(), b.tolist()
    return numpy.array([y * w - z * v, z * u - x * w, x * v - y * u])


def unit(vector: Vector) -> Vector:
    """A vector of the length 1 in the same direction."""
    return vector / math.sqrt(vector @ vector)


@dataclass
class Carrier:
    """Motion of the upright with its wheel: centre, velocity of the centre, angular velocity, axis of the wheel to the
    left, spin of the wheel about it."""

    centre: Vector
    velocity: Vector
    turning: Vector
    axis: Vector
    spin: float

    def ahead(self, before: "Carrier", lead: float, step: float) -> "Carrier":
        """The motion expected after `lead`, from the present one and that a step ago."""
        if lead == 0.0:
            return self
        share = lead / step
        velocity = self.velocity + share * (self.velocity - before.velocity)
        turning = self.turning + share * (self.turning - before.turning)
        axis = self.axis + lead * cross(0.5 * (self.turning + turning), self.axis)
        return Carrier(
            centre=self.centre + 0.5 * lead * (self.velocity + velocity),
            velocity=velocity,
            turning=turning,
            axis=unit(axis),
            spin=self.spin + share * (self.spin - before.spin),
        )


@dataclass
class Contact:
    """Where a tyre touches the road: directions ahead and to the left in the road, the contact point from the centre of
    the wheel, its velocity, the load, the deflection, the camber."""

    ahead: Vector
    left: Vector
    arm: Vector
    velocity: Vector
    load: float
    deflection: float
    camber: float


@dataclass
class Push:
    """Force of the road on the wheel, and its moment about the centre of the wheel."""

    force: Vector = field(default_factory=lambda: numpy.zeros(3))
    moment: Vector = field(default_factory=lambda: numpy.zeros(3))


class CarTyre:
    """The tyre of a car at its inflation pressure. The spring of version 5.2 of the formula is linear, that of versions
    6.1 and 6.2 follows the formula."""

    def __init__(self, tyre: stribeck.Tyre, pressure: float | None):
        self.formula, self.pressure = tyre, pressure
        self.radius, self.stiffness, self.damping = tyre.radius, tyre.stiffness, tyre.damping
        for key, value in (("VERTICAL_STIFFNESS", self.stiffness), ("VERTICAL_DAMPING", self.damping)):
            if value is None:
                raise CarError(f"tyre: its file gives no {key}")
        self.is_linear = tyre.pressure is None
        self.tells_radius = tyre.radii(0.0, pressure=pressure).effective_radius is not None

    def spring(self, reach: float, camber: float, spin: float, left: bool, forces: Vector) -> float:
        """Load without that of damping, for the distance of the centre from the road in the plane of the wheel."""
        if self.is_linear:
            return self.stiffness * (self.radius - reach)
        force_x, force_y = forces
        state = {"force_x": force_x, "force_y": force_y, "camber": camber, "spin": spin}
        return self.formula.load(reach, **state, pressure=self.pressure, left=left)

    def slope(self, contact: "Contact", left: bool) -> float:
        """Change of the load with the deflection, at rest."""
        if self.is_linear:
            return self.stiffness
        reach, still = self.radius - contact.deflection, numpy.zeros(2)
        deep, shallow = (self.spring(reach + end, contact.camber, 0.0, left, still) for end in (-NUDGE, NUDGE))
        return (deep - shallow) / (2.0 * NUDGE)

    def rolling_radius(self, load: float, deflection: float, speed: float) -> float:
        """Effective rolling radius."""
        if not self.tells_radius:
            return self.radius - ROLLING_DEFLECTION * max(0.0, deflection)
        try:
            return self.formula.radii(load, speed=speed, pressure=self.pressure).effective_radius
        except stribeck.Refused as refusal:
            raise CarError(f"tyre: {refusal}") from None

    def wrench(self, load: float, **state: float) -> stribeck.TyreWrench:
        """Forces and moments."""
        return self.formula.wrench(load, pressure=self.pressure, **state)


def read_tyre(car: Car) -> CarTyre:
    """The tyre in the file that the description names."""
    try:
        return CarTyre(stribeck.Tyre(car.tyre.file), car.tyre.pressure)
    except stribeck.Refused as refusal:
        raise CarError(f"tyre: {refusal}") from None


def touch(
    tyre: CarTyre, carrier: Carrier, height: float, rise: float, left: bool, forces: Vector | None = None
) -> Contact:
    """The contact with a level road at a height that rises; its load cannot pull. The forces along the road, which
    soften some tyres, are those of the last step."""
    ahead = unit(cross(carrier.axis, UP))
    # In the plane of the wheel, from the road to the centre.
    radial = cross(ahead, carrier.axis)
    reach = (carrier.centre[2] - height) / radial[2]
    arm = -reach * radial
    deflection = tyre.radius - reach
    closing = (rise - carrier.velocity[2]) / radial[2]
    camber = math.asin(carrier.axis[2])
    spring = tyre.spring(reach, camber, carrier.spin, left, numpy.zeros(2) if forces is None else forces)
    load = max(0.0, spring + tyre.damping * closing) if spring > 0.0 else 0.0
    velocity = carrier.velocity + cross(carrier.turning, arm)
    return Contact(ahead, cross(UP, ahead), arm, velocity, load, deflection, camber)


class RollingTyre:
    """A tyre on the road. Both slips lag behind by the relaxation length."""

    def __init__(self, tyre: CarTyre, car: Car, left: bool):
        self.tyre, self.is_left, self.relaxation = tyre, left, car.tyre.relaxation_length
        # Slip and side slip, and what they would be without relaxation.
        self.slips = numpy.zeros(2)
        self.steady: Vector | None = None
        self.forces = (0.0, 0.0, 0.0)

    def push(self, contact: Contact, carrier: Carrier, step: float) -> Push:
        """Advances the slips by a step, to the time of the contact; the force then."""
        forward = float(carrier.velocity @ contact.ahead)
        if abs(forward) < SLOWEST:
            raise CarError(f"a wheel rolls at {forward:.3g} m/s: its slip has a meaning above {SLOWEST:g} m/s only")
        radius = self.tyre.rolling_radius(contact.load, contact.deflection, forward)
        slip = (radius * carrier.spin - forward) / abs(forward)
        steady = numpy.array([slip, math.atan2(float(contact.velocity @ contact.left), abs(forward))])
        last, self.steady = steady if self.steady is None else self.steady, steady
        mean = 0.5 * (last + steady)
        self.slips = mean + (self.slips - mean) * math.exp(-abs(forward) * step / self.relaxation)
        wrench = self.tyre.wrench(
            contact.load,
            longitudinal_slip=float(self.slips[0]),
            side_slip=float(self.slips[1]),
            camber=contact.camber,
            speed=forward,
            left=self.is_left,
        )
        self.forces = (wrench.force_x, wrench.force_y, contact.load)
        force = wrench.force_x * contact.ahead + wrench.force_y * contact.left + contact.load * UP
        moment = wrench.moment_x * contact.ahead + wrench.moment_y * contact.left + wrench.moment_z * UP
        return Push(force, cross(contact.arm, force) + moment)


class StandingTyre:
    """A tyre on a post: three springs and dampers, of which the two in the plane of the post hold the contact point
    where it was at the start."""

    def __init__(self, tyre: CarTyre, car: Car, wheel_mass: float):
        self.tyre, self.stiffness = tyre, car.tyre.patch_stiffness
        self.damping = 2.0 * car.tyre.patch_damping * math.sqrt(self.stiffness * wheel_mass)
        self.home: Vector | None = None
        self.forces = (0.0, 0.0, 0.0)

    def push(self, contact: Contact, carrier: Carrier, _step: float) -> Push:
        """The force of the present deflections."""
        point = carrier.centre + contact.arm
        if self.home is None:
            self.home = point
        force = contact.load * UP
        if contact.load > 0.0:
            along = -self.stiffness * (point - self.home) - self.damping * contact.velocity
            force = numpy.array([along[0], along[1], contact.load])
        self.forces = (float(force[0]), float(force[1]), contact.load)
        return Push(force, cross(contact.arm, force))
