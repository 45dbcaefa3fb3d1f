"""Tyres of the car: contact with the road, relaxation, and the Magic Formula of the package; or the patch on a post."""

import math
from dataclasses import dataclass, field

import numpy
import stribeck

from examples.car.car_description import Car, CarError, Vector

# Part of the deflection by which the effective rolling radius is smaller than the one without load (chosen).
ROLLING_DEFLECTION = 1.0 / 3.0
# Below this forward speed, in m/s, slip has no meaning.
SLOWEST = 1.0

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


def read_tyre(car: Car) -> stribeck.Tyre:
    """The tyre in the file that the description names."""
    try:
        return stribeck.Tyre(car.tyre.file)
    except stribeck.Refused as refusal:
        raise CarError(f"tyre: {refusal}") from None


def touch(tyre: stribeck.Tyre, carrier: Carrier, height: float, rise: float) -> Contact:
    """The contact with a level road at a height that rises; its load cannot pull."""
    ahead = unit(cross(carrier.axis, UP))
    # In the plane of the wheel, from the road to the centre.
    radial = cross(ahead, carrier.axis)
    reach = (carrier.centre[2] - height) / radial[2]
    arm = -reach * radial
    deflection = tyre.radius - reach
    closing = (rise - carrier.velocity[2]) / radial[2]
    load = max(0.0, tyre.stiffness * deflection + tyre.damping * closing) if deflection > 0.0 else 0.0
    velocity = carrier.velocity + cross(carrier.turning, arm)
    return Contact(ahead, cross(UP, ahead), arm, velocity, load, deflection, math.asin(carrier.axis[2]))


class RollingTyre:
    """A tyre on the road. Both slips lag behind by the relaxation length."""

    def __init__(self, tyre: stribeck.Tyre, car: Car, left: bool):
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
        radius = self.tyre.radius - ROLLING_DEFLECTION * max(0.0, contact.deflection)
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

    def __init__(self, tyre: stribeck.Tyre, car: Car, wheel_mass: float):
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
