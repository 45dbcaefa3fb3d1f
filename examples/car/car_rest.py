"""The car at rest on its wheels: springs and tyres in balance, without friction."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy

from examples.car.car_description import CORNERS, Car, CarError, is_left
from examples.car.car_struts import RestingStrut, parameters_of
from examples.car.car_tyres import UP, CarTyre, Contact, read_tyre, touch
from examples.car.exudyn_car import ExudynCar
from examples.car.mujoco_car import MujocoCar

# Springs that hold a wheel in the road and against spinning while the balance is computed; no force remains in them.
HOLDING = 1.0e4
PARKING = 1.0e5

# The balance is found when no load changes by more than this, in N.
CHANGE = 1e-9


@dataclass(frozen=True)
class Rest:
    """Loads of the tyres, and lengths and forces of the struts at rest, by corner."""

    loads: dict[str, float]
    lengths: dict[str, float]
    forces: dict[str, float]


def settle(model: ExudynCar, tyre: CarTyre, parameters: Mapping[str, Mapping[str, object]]) -> Rest:
    """Finds the balance: forces of struts and tyres are replaced by their tangents until nothing changes."""
    struts = {name: RestingStrut(parameters[name]) for name in CORNERS}
    seen: dict[str, Contact] = {}
    for _ in range(20):
        before = {name: contact.load for name, contact in seen.items()}
        for name in CORNERS:
            length, _ = model.look(name)
            model.set_strut(name, *struts[name].at(length), length)
            carrier = model.carrier(name)
            contact = touch(tyre, carrier, 0.0, 0.0, is_left(name))
            slope = tyre.slope(contact, is_left(name)) / numpy.cross(contact.ahead, carrier.axis)[2]
            model.stand(name, carrier, contact, slope, HOLDING, PARKING)
        model.settle("the springs do not carry the car")
        seen = {name: touch(tyre, model.carrier(name), 0.0, 0.0, is_left(name)) for name in CORNERS}
        if before and max(abs(seen[name].load - before[name]) for name in CORNERS) < CHANGE:
            return _rest(model, struts, seen)
    raise CarError("the car finds no rest on its springs within 20 iterations")


# Damping of the struts, in N s/m, and time in s, until a car that cannot be solved for its rest has come to it.
CALMING, CALM = 4000.0, 2.0


def relax(model: MujocoCar, tyre: CarTyre, parameters: Mapping[str, Mapping[str, object]], step: float) -> Rest:
    """Lets the car come to rest on parked wheels, without friction and with much damping."""
    struts = {name: RestingStrut(parameters[name]) for name in CORNERS}
    lengths, loads = {}, {}

    def hold(_time: float) -> None:
        for name in CORNERS:
            lengths[name], velocity = model.look(name)
            model.set_strut(name, struts[name].at(lengths[name])[0] - CALMING * velocity)
            contact = touch(tyre, model.carrier(name), 0.0, 0.0, is_left(name))
            loads[name] = contact.load
            up = contact.load * UP
            model.push(name, up, numpy.cross(contact.arm, up))

    model.run(step, round(CALM / step), hold)
    model.stop()
    return Rest(loads, lengths, {name: struts[name].at(lengths[name])[0] for name in CORNERS})


def _rest(model: ExudynCar, struts: Mapping[str, RestingStrut], seen: Mapping[str, Contact]) -> Rest:
    for name, contact in seen.items():
        if contact.load <= 0.0:
            raise CarError(f"at rest the wheel {name} carries no load")
    lengths = {name: model.look(name)[0] for name in CORNERS}
    for name in CORNERS:
        model.release(name)
    return Rest(
        loads={name: contact.load for name, contact in seen.items()},
        lengths=lengths,
        forces={name: struts[name].at(lengths[name])[0] for name in CORNERS},
    )


def on_rubber(car: Car, changes: Mapping[str, object]) -> Car:
    """The car with a rubber mount in each strut, which carries the strut at rest without being displaced: the car
    stands as it does without. Friction stops the mass of the rod then, which the strut knows, and no other."""
    forces = settle(ExudynCar(car), read_tyre(car), parameters_of(car, "None", changes)).forces
    corners = {
        name: replace(
            corner, strut={**corner.strut, "mount.enabled": True, "mount.preload": forces[name], "friction.mass": 0.0}
        )
        for name, corner in car.corners.items()
    }
    return replace(car, corners=corners)


def imbalance(car: Car, rest: Rest) -> float:
    """Weight of the car less the loads of its tyres, in N."""
    return car.mass * car.gravity - sum(rest.loads.values())
