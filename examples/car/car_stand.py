"""The suspension on a stand: chassis bolted down, struts set to lengths, rack to travels."""

import math

import numpy

from examples.car.car_description import CORNERS, Car, CarError
from examples.car.exudyn_car import ExudynCar

# A spring in place of the strut, in N/m: the length it leaves is measured, so that its stiffness does not matter.
SPRING = 1.0e7
COLUMNS = {"length": "m", "rack": "m", "travel": "m", "camber": "rad", "steer": "rad", "motion_ratio": "1"}


class Stand:
    """The car on a stand."""

    def __init__(self, car: Car, gravity: numpy.ndarray | None = None):
        self.car, self.model = car, ExudynCar(car, True, gravity)

    def place(self, length: float, rack: float) -> None:
        """Sets all struts to a length, and the rack to a travel."""
        for name in CORNERS:
            self.model.set_strut(name, 0.0, SPRING, length)
        self.model.move_rack(rack)
        self.model.settle(f"struts of {length:g} m, rack at {rack:g} m")

    def wheel(self, name: str) -> tuple[float, float, float, float]:
        """Length of a strut, rise of its wheel, camber (positive if the top leans to the right), steer (positive to the
        left)."""
        axis = self.model.spin_axis(name)
        rise = self.model.wheel_centre(name)[2] - self.car.corners[name]["wheel_centre"][2]
        steer = math.atan2(-axis[0], axis[1])
        return self.model.look(name)[0], float(rise), math.asin(axis[2]), steer

    def sweep(self, name: str, lengths: numpy.ndarray, rack: float = 0.0) -> dict[str, numpy.ndarray]:
        """The wheel of a corner at lengths of its strut; columns by name."""
        if len(lengths) < 2:
            raise CarError(f"lengths = {list(lengths)}: must be at least two")
        rows = []
        for length in lengths:
            self.place(float(length), rack)
            seen = self.wheel(name)
            rows.append([seen[0], rack, *seen[1:]])
        table = numpy.array(rows).T
        ratio = -numpy.gradient(table[0], table[2], edge_order=min(2, len(lengths) - 1))
        return dict(zip(COLUMNS, [*table, ratio], strict=True))
