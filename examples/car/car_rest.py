"""The car at rest on its wheels: springs and tyres in balance, without friction."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy
from car_description import CORNERS, Car, CarError
from car_struts import RestingStrut
from car_tyres import Contact, touch
from exudyn_car import ExudynCar
from stribeck import Tyre

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


def settle(model: ExudynCar, tyre: Tyre, parameters: Mapping[str, Mapping[str, object]]) -> Rest:
    """Finds the balance: forces of struts and tyres are replaced by their tangents until nothing changes."""
    struts = {name: RestingStrut(parameters[name]) for name in CORNERS}
    seen: dict[str, Contact] = {}
    for _ in range(20):
        before = {name: contact.load for name, contact in seen.items()}
        for name in CORNERS:
            length, _ = model.look(name)
            model.set_strut(name, *struts[name].at(length), length)
            carrier = model.carrier(name)
            contact = touch(tyre, carrier, 0.0, 0.0)
            slope = tyre.stiffness / numpy.cross(contact.ahead, carrier.axis)[2]
            model.stand(name, carrier, contact, slope, HOLDING, PARKING)
        model.settle("the springs do not carry the car")
        seen = {name: touch(tyre, model.carrier(name), 0.0, 0.0) for name in CORNERS}
        if before and max(abs(seen[name].load - before[name]) for name in CORNERS) < CHANGE:
            return _rest(model, struts, seen)
    raise CarError("the car finds no rest on its springs within 20 iterations")


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


def imbalance(car: Car, rest: Rest) -> float:
    """Weight of the car less the loads of its tyres, in N."""
    return car.mass * car.gravity - sum(rest.loads.values())
