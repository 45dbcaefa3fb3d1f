"""Energy balance of a run: what is stored in bodies, height and anti-roll bars, and the work of everything held."""

import math
from dataclasses import dataclass, field

from car_description import CORNERS, Body, Vector
from car_tyres import Carrier
from exudyn_car import ENTRY, ExudynCar


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


@dataclass
class _Held:
    """What acts at a corner over a step, and where the corner was at its beginning."""

    force: float
    friction: float
    damper: float
    length: float
    push: Vector
    moment: Vector
    torque: Vector
    brake: Vector
    centre: Vector
    turning: Vector
    upright: Vector


@dataclass
class Ledger:
    """Sums the works of a run. Held forces do their work exactly along the motion; moments and the force that moves the
    rack, which are not constant, by the trapezoidal rule."""

    model: ExudynCar
    works: Works = field(default_factory=Works)
    _held: dict[str, _Held] = field(default_factory=dict)
    _chassis: Vector | None = None
    _rack: tuple[float, float] | None = None
    _first: float | None = None

    def begin_step(self, step: float) -> None:
        """Books the step that has just ended for everything that belongs to the whole car."""
        if self._first is None:
            self._first = stored_energy(self.model)
        turning = self.model.turning(self.model.chassis)
        if self._chassis is not None:
            shafts = -sum(held.torque for held in self._held.values())
            self.works.drive += 0.5 * step * float(shafts @ (self._chassis + turning))
        self._chassis = turning
        rack = self.model.rack_force(), self.model.travel
        if self._rack is not None:
            self.works.rack += 0.5 * (rack[0] + self._rack[0]) * (rack[1] - self._rack[1])
        self._rack = rack

    def book(self, name: str, carrier: Carrier, length: float, step: float) -> None:
        """Books the step that has just ended for a corner."""
        held = self._held.get(name)
        if held is None:
            return
        extension = length - held.length
        self.works.struts += held.force * extension
        self.works.friction -= held.friction * extension
        self.works.dampers += held.damper * extension
        turned = 0.5 * step * (held.turning + _wheel_turning(carrier))
        self.works.tyres += float(held.push @ (carrier.centre - held.centre) + held.moment @ turned)
        self.works.drive += float(held.torque @ turned)
        self.works.brakes += float(held.brake @ (turned - 0.5 * step * (held.upright + carrier.turning)))

    def hold(self, name: str, carrier: Carrier, length: float, strut: tuple, tyre: tuple) -> None:
        """Notes what acts at a corner over the step that begins now: force, friction and damper of the strut; force and
        moment of the tyre, torques of drive and brake."""
        places = carrier.centre, _wheel_turning(carrier), carrier.turning
        self._held[name] = _Held(*strut, length, *tyre, *places)

    def close(self, step: float) -> Works:
        """Books the last step; the works of the run."""
        self.begin_step(step)
        for name in CORNERS:
            self.book(name, self.model.carrier(name), self.model.look(name)[0], step)
        self.works.stored = stored_energy(self.model) - self._first
        return self.works


def _wheel_turning(carrier: Carrier) -> Vector:
    return carrier.turning + carrier.spin * carrier.axis


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
