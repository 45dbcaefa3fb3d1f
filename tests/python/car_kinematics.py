"""Suspension kinematics from lengths alone: points, and the distances that arms and links keep between them.

No body, rotation or joint occurs here, so that this is another road than that of a multibody code.
"""

import math
from dataclasses import dataclass

import numpy

# Points that move, and the pairs of points whose distance is constant; `rack` is the inner end of the tie rod.
MOVING = (
    *("lower_ball", "upper_ball", "outer_tie", "wheel_centre", "spin_point"),
    *("push_rod_arm", "push_rod_rocker", "rod_eye"),
)
LINKS = (
    ("lower_ball", "lower_front"),
    ("lower_ball", "lower_rear"),
    ("upper_ball", "upper_front"),
    ("upper_ball", "upper_rear"),
    ("lower_ball", "upper_ball"),
    ("outer_tie", "lower_ball"),
    ("outer_tie", "upper_ball"),
    ("outer_tie", "inner_tie"),
    ("wheel_centre", "lower_ball"),
    ("wheel_centre", "upper_ball"),
    ("wheel_centre", "outer_tie"),
    ("spin_point", "lower_ball"),
    ("spin_point", "upper_ball"),
    ("spin_point", "outer_tie"),
    ("push_rod_arm", "lower_front"),
    ("push_rod_arm", "lower_rear"),
    ("push_rod_arm", "lower_ball"),
    ("push_rod_arm", "push_rod_rocker"),
    ("push_rod_rocker", "rocker_pivot"),
    ("push_rod_rocker", "axis_point"),
    ("rod_eye", "rocker_pivot"),
    ("rod_eye", "axis_point"),
    ("rod_eye", "push_rod_rocker"),
)


@dataclass(frozen=True)
class Position:
    """A corner at a length of the strut and a travel of the rack; angles in rad, at a left wheel positive for a top
    that leans to the right and for a turn to the left."""

    wheel_centre: numpy.ndarray
    spin_axis: numpy.ndarray
    points: dict

    @property
    def camber(self) -> float:
        return math.asin(self.spin_axis[2])

    @property
    def steer(self) -> float:
        return math.atan2(-self.spin_axis[0], self.spin_axis[1])


def position(corner, length: float, rack: float = 0.0) -> Position:
    """Solves the distances by Newton's method from the design position."""
    fixed = dict(corner.points) | {
        "spin_point": corner["wheel_centre"] + 0.1 * corner.spin_axis,
        "axis_point": corner["rocker_pivot"] + 0.1 * corner.rocker_axis,
    }
    pairs = [*LINKS, ("rod_eye", "tube_eye")]
    wanted = numpy.array([numpy.linalg.norm(fixed[a] - fixed[b]) for a, b in pairs])
    wanted[-1] = length
    fixed["inner_tie"] = fixed["inner_tie"] + [0.0, rack, 0.0]
    place = {name: 3 * at for at, name in enumerate(MOVING)}
    q = numpy.concatenate([fixed[name] for name in MOVING])
    for _ in range(50):
        here = fixed | {name: q[at : at + 3] for name, at in place.items()}
        residual, jacobian = numpy.empty(len(pairs)), numpy.zeros((len(pairs), len(q)))
        for row, (a, b) in enumerate(pairs):
            line = here[a] - here[b]
            residual[row] = line @ line - wanted[row] ** 2
            for name, sign in ((a, 2.0), (b, -2.0)):
                if name in place:
                    jacobian[row, place[name] : place[name] + 3] += sign * line
        change = numpy.linalg.solve(jacobian, residual)
        q = q - change
        if numpy.abs(change).max() < 1e-13:
            break
    else:
        raise AssertionError(f"no position of {corner.name} at a strut of {length} m")
    axis = (here["spin_point"] - here["wheel_centre"]) / 0.1
    return Position(here["wheel_centre"], axis / numpy.linalg.norm(axis), here)
