"""Energy balance of a run: what is stored in bodies, height and anti-roll bars, and the work of everything held."""

import math
from dataclasses import dataclass, field

from examples.car.car_description import Body, Vector
from examples.car.car_struts import READINGS
from examples.car.car_tyres import Carrier, Push
from examples.car.exudyn_car import ENTRY, ExudynCar


@dataclass
class Works:
    """Work on the car, in J. Springs, gas and stops are what remains of the struts' work."""

    struts: float = 0.0
    friction: float = 0.0
    dampers: float = 0.0
    tyres: float = 0.0
    drive: float = 0.0
    brakes: float = 0.0
    rack: float = 0.0
    stored: float = 0.0

    @property
    def residual(self) -> float:
        """What the balance does not account for: errors, and on posts the parking brakes."""
        return self.struts + self.tyres + self.drive + self.brakes + self.rack - self.stored

    @property
    def dissipated(self) -> float:
        """Energy that friction and dampers have turned into heat."""
        return -self.friction - self.dampers


@dataclass(frozen=True)
class Acting:
    """What acts at a corner at a time: force of the strut and its readings; forces of the tyre, height of the road,
    push of the tyre, torques of drive and brake."""

    force: float
    strut: tuple[float, ...]
    tyre: tuple[float, float, float]
    road: float
    push: Push
    drive: Vector
    brake: Vector

    @property
    def friction(self) -> float:
        """Friction of both contacts along the axis."""
        return self._of("friction_1") + self._of("friction_2")

    @property
    def damper(self) -> float:
        """Force of the damper."""
        return self._of("force_damper")

    @property
    def twist(self) -> float:
        """Friction torque about the axis."""
        return self._of("friction_torque")

    @property
    def rod_force(self) -> float:
        """Part of the force that does not reach the eye of the rod."""
        return self._of("rod_force")

    @property
    def displacement(self) -> float:
        """Of the mount, by which the strut is longer than the distance of its eyes."""
        return self._of("mount.displacement")

    def _of(self, reading: str) -> float:
        return self.strut[READINGS.index(reading)]


@dataclass(frozen=True)
class _Booked:
    """What acted at a corner at the end of the last booked step, and where the corner was."""

    acting: Acting
    length: float
    spin: float
    eye: Vector
    rod_push: Vector
    centre: Vector
    wheel: Vector
    upright: Vector


@dataclass
class Ledger:
    """Sums the works of a run by the trapezoidal rule, which is that of the integrator: it takes loads as those at the
    ends of steps, and moves the car by the mean of both."""

    model: ExudynCar
    works: Works = field(default_factory=Works)
    _booked: dict[str, _Booked] = field(default_factory=dict)
    _chassis: tuple[Vector, Vector] | None = None
    _rack: tuple[float, float] | None = None
    _first: float | None = None

    def end_of_step(self, travel: float, step: float) -> None:
        """Books the step that has just ended for everything that belongs to the whole car, after its corners."""
        if self._first is None:
            self._first = stored_energy(self.model)
        shafts = -sum(booked.acting.drive for booked in self._booked.values())
        chassis = shafts, self.model.turning(self.model.chassis)
        rack = self.model.rack_force(), travel
        if self._chassis is not None:
            self.works.drive += 0.25 * step * float((shafts + self._chassis[0]) @ (chassis[1] + self._chassis[1]))
            self.works.rack += 0.5 * (rack[0] + self._rack[0]) * (rack[1] - self._rack[1])
        self._chassis, self._rack = chassis, rack

    def book(self, name: str, carrier: Carrier, length: float, spin: float, acting: Acting, step: float) -> None:
        """Books the step that has just ended for a corner."""
        wheel = carrier.turning + carrier.spin * carrier.axis
        eye, rod_push = self.model.rod_eye(name), -acting.rod_force * self.model.strut_axis(name)
        now = _Booked(acting, length, spin, eye, rod_push, carrier.centre, wheel, carrier.turning)
        last = self._booked.get(name)
        self._booked[name] = now
        if last is None:
            return
        extension, old = 0.5 * (length - last.length), last.acting
        twisted = 0.25 * step * (acting.twist + old.twist) * (spin + last.spin)
        self.works.struts += (acting.force + old.force) * extension - twisted
        self.works.struts += 0.5 * float((rod_push + last.rod_push) @ (eye - last.eye))
        # Behind a mount the strut extends by more than its eyes part.
        extension += 0.5 * (acting.displacement - old.displacement)
        self.works.friction -= (acting.friction + old.friction) * extension + twisted
        self.works.dampers += (acting.damper + old.damper) * extension
        turned, held = 0.25 * step * (wheel + last.wheel), 0.25 * step * (carrier.turning + last.upright)
        moved = 0.5 * (carrier.centre - last.centre)
        self.works.tyres += float((acting.push.force + old.push.force) @ moved)
        self.works.tyres += float((acting.push.moment + old.push.moment) @ turned)
        self.works.drive += float((acting.drive + old.drive) @ turned)
        self.works.brakes += float((acting.brake + old.brake) @ (turned - held))

    def close(self, step: float) -> Works:
        """Books the last step for the whole car; the works of the run."""
        self.end_of_step(self.model.travel, step)
        self.works.stored = stored_energy(self.model) - self._first
        return self.works


def stored_energy(model: ExudynCar) -> float:
    """Kinetic energy, energy of height and of the anti-roll bars."""
    energy = _body_energy(model, model.chassis, model.car.chassis) + _body_energy(model, model.rack, model.car.rack)
    for made in model.corners.values():
        for name, body in made.corner.bodies.items():
            energy += _body_energy(model, made.bodies[name], body)
    for axle, stiffness in model.car.bar_stiffness.items():
        left, right = (_bar_angle(model, f"{axle}{side}") for side in "lr")
        energy += 0.5 * stiffness * (left - right) ** 2
    return energy


def _body_energy(model: ExudynCar, number: int, body: Body) -> float:
    velocity = model.velocity(number, body.centre)
    turning = model.system.GetObjectOutputBody(number, ENTRY.AngularVelocityLocal, [0.0, 0.0, 0.0])
    moving = body.mass * float(velocity @ velocity) + float(turning @ model.inertia(number) @ turning)
    return 0.5 * moving - body.mass * float(model.gravity @ model.place(number, body.centre))


def _bar_angle(model: ExudynCar, name: str) -> float:
    """Angle of a lever of the bar about its axis in the chassis."""
    turned = model.rotation(model.chassis).T @ model.rotation(model.corners[name].bodies["bar"])
    return math.atan2(turned[0, 2], turned[0, 0])
