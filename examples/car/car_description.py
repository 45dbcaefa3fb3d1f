"""A Formula Student car, read from its file: hardpoints, bodies, springs, tyres. Nothing here knows a simulator."""

import difflib
import math
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy

from examples.fmpy.coupling import CouplingError

CAR = Path(__file__).resolve().parent / "stribeck_fs.toml"

CORNERS = ("fl", "fr", "rl", "rr")
AXLES = {"f": "front", "r": "rear"}
BODIES = ("lower_arm", "upper_arm", "upright", "wheel", "rocker", "tube", "rod", "bar")

# Two hardpoints that a link or an axis connects cannot be closer than this, in m.
SHORTEST = 1e-3

Vector = numpy.ndarray


class CarError(CouplingError):
    """A description that makes no sense; the text names the entry, its value and the limit."""


def is_left(corner: str) -> bool:
    """Whether a corner is on the left."""
    return corner[1] == "l"


@dataclass(frozen=True)
class Body:
    """A rigid body: mass, centre of mass in the axes of the car, principal moments of inertia about it."""

    mass: float
    centre: Vector
    inertia: Vector


@dataclass(frozen=True)
class Corner:
    """One wheel with its suspension in the design position; the points are in the axes of the car."""

    name: str
    points: Mapping[str, Vector]
    bodies: Mapping[str, Body]
    rocker_axis: Vector
    camber: float
    toe: float
    strut: Mapping[str, object]

    def __getitem__(self, point: str) -> Vector:
        return self.points[point]

    @property
    def is_front(self) -> bool:
        """Whether the rack steers the wheel."""
        return self.name[0] == "f"

    @property
    def side(self) -> float:
        """1 on the left, -1 on the right."""
        return 1.0 if is_left(self.name) else -1.0

    def distance(self, first: str, second: str) -> float:
        """Distance of two points in the design position."""
        return float(numpy.linalg.norm(self[second] - self[first]))

    @property
    def strut_length(self) -> float:
        """Distance of the eyes of the strut in the design position."""
        return self.distance("tube_eye", "rod_eye")

    @cached_property
    def spin_axis(self) -> Vector:
        """Axis of the wheel in the design position, to the left."""
        camber, toe = math.radians(self.camber), math.radians(self.toe)
        # Camber is negative if the top leans inwards; toe-in turns a left wheel to the right.
        lean, turn = -self.side * camber, -self.side * toe
        axis = numpy.array([-math.sin(turn) * math.cos(lean), math.cos(turn) * math.cos(lean), math.sin(lean)])
        return axis / numpy.linalg.norm(axis)

    @cached_property
    def strut_axes(self) -> Vector:
        """The axes of the strut as columns: m, n, and a from the eye of the tube to that of the rod. m lies along the
        axis of the rocker as far as it can."""
        a = _unit(self["rod_eye"] - self["tube_eye"])
        n = _unit(numpy.cross(a, self.rocker_axis))
        return numpy.column_stack([numpy.cross(n, a), n, a])


@dataclass(frozen=True)
class Tyre:
    """What the file of the tyre does not say. The inflation pressure, in Pa, is that of the file unless it is given."""

    file: Path
    relaxation_length: float
    patch_stiffness: float
    patch_damping: float
    pressure: float | None = None


@dataclass(frozen=True)
class Car:
    """The whole car."""

    name: str
    gravity: float
    wheelbase: float
    width: float
    chassis: Body
    rack_mass: float
    travel_per_turn: float
    tyre: Tyre
    front_brakes: float
    corners: Mapping[str, Corner]
    bar_stiffness: Mapping[str, float]

    @property
    def rack(self) -> Body:
        """The steering rack: a slender rod between the inner ends of the tie rods."""
        left, right = (self.corners[name]["inner_tie"] for name in ("fl", "fr"))
        moment = self.rack_mass * float((left - right) @ (left - right)) / 12.0
        return Body(self.rack_mass, 0.5 * (left + right), numpy.array([moment, 1e-3 * moment, moment]))

    @property
    def mass(self) -> float:
        """Mass of all bodies."""
        parts = [body.mass for corner in self.corners.values() for body in corner.bodies.values()]
        return self.chassis.mass + self.rack_mass + sum(parts)


def read_car(path: Path = CAR) -> Car:
    """Reads and checks a description."""
    try:
        entries = tomllib.loads(Path(path).read_text(encoding="utf-8"))
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise CarError(f"{path}: {error}") from error
    return car_of(entries, Path(path).parent)


def _tyre(table: "_Table", folder: Path) -> Tyre:
    file = folder / str(table.take("file"))
    numbers = ("relaxation_length", "patch_stiffness", "patch_damping")
    pressure = table.positive("pressure") if "pressure" in table.entries else None
    return Tyre(file=file, pressure=pressure, **{name: table.positive(name) for name in numbers})


def car_of(entries: Mapping[str, object], folder: Path = CAR.parent) -> Car:
    """A car from the entries of a file; `folder` is where the file of the tyre is looked for."""
    top = _Table(entries, "")
    wheelbase = top.positive("wheelbase")
    gravity = top.positive("gravity")
    shared = top.table("strut").rest()
    axles = {letter: top.table(axle) for letter, axle in AXLES.items()}
    corners = {name: _corner(name, axles[name[0]], wheelbase, shared) for name in CORNERS}
    bars = {letter: axles[letter].table("anti_roll_bar") for letter in AXLES}
    tyre, steering, brakes = (top.table(name) for name in ("tyre", "steering", "brakes"))
    car = Car(
        name=str(top.take("name")),
        gravity=gravity,
        wheelbase=wheelbase,
        width=top.positive("width"),
        chassis=top.table("chassis").body(),
        rack_mass=steering.positive("mass"),
        travel_per_turn=steering.positive("travel_per_turn"),
        tyre=_tyre(tyre, folder),
        front_brakes=brakes.share("front_share"),
        corners=corners,
        bar_stiffness={letter: bars[letter].positive("stiffness") for letter in AXLES},
    )
    for table in (*bars.values(), *axles.values(), tyre, steering, brakes, top):
        table.finish()
    return car


# Points of an axle, and pairs of them that a link or an axis connects.
POINTS = (
    *("lower_front", "lower_rear", "lower_ball", "upper_front", "upper_rear", "upper_ball", "inner_tie", "outer_tie"),
    *("wheel_centre", "push_rod_arm", "push_rod_rocker", "rocker_pivot", "rod_eye", "tube_eye"),
    *("bar_rocker", "bar_lever", "bar_pivot"),
)
APART = (
    ("lower_front", "lower_rear"),
    ("upper_front", "upper_rear"),
    ("lower_ball", "upper_ball"),
    ("inner_tie", "outer_tie"),
    ("push_rod_arm", "push_rod_rocker"),
    ("rocker_pivot", "push_rod_rocker"),
    ("rocker_pivot", "rod_eye"),
    ("tube_eye", "rod_eye"),
    ("bar_rocker", "bar_lever"),
    ("bar_lever", "bar_pivot"),
)


def _corner(name: str, axle: "_Table", wheelbase: float, shared: Mapping[str, object]) -> Corner:
    """One corner: the left one is in the file, the right one is its mirror image."""
    mirror = numpy.array([1.0, 1.0 if name[1] == "l" else -1.0, 1.0])
    offset = numpy.array([0.0 if name[0] == "f" else -wheelbase, 0.0, 0.0])
    points = {point: mirror * axle.vector(point) + offset for point in POINTS}
    for first, second in APART:
        distance = float(numpy.linalg.norm(points[first] - points[second]))
        if distance < SHORTEST:
            raise CarError(f"{axle.path}{first} and {second}: {distance:g} m apart, must be at least {SHORTEST:g} m")
    bodies = axle.table("bodies")
    placed = {}
    for body in BODIES:
        read = bodies.table(body).body()
        placed[body] = Body(read.mass, mirror * read.centre + offset, read.inertia)
    bodies.finish()
    corner = Corner(
        name=name,
        points=points,
        bodies=placed,
        # An axis is mirrored like a moment, so that both rockers turn by the same angle.
        rocker_axis=_unit(mirror[1] * mirror * axle.vector("rocker_axis")),
        camber=axle.number("camber"),
        toe=axle.number("toe"),
        strut={**shared, **axle.table("strut").rest()},
    )
    _check_strut(axle.path, corner)
    return corner


def _check_strut(path: str, corner: Corner) -> None:
    """The design position must be within the stroke; the rest is checked by the strut itself."""
    try:
        extended, stroke = (float(corner.strut[f"geom.{name}"]) for name in ("length_extended", "stroke"))
    except KeyError as error:
        raise CarError(f"strut: no entry {error}") from None
    length = corner.strut_length
    if not extended - stroke < length < extended:
        limits = f"between {extended - stroke:g} and {extended:g} m, geom.length_extended less geom.stroke"
        raise CarError(f"{path}tube_eye and rod_eye: {length:g} m apart, must be {limits}")


class _Table:
    """A table of the file; what is taken is checked, and what is left over at the end is unknown."""

    def __init__(self, entries: object, path: str):
        if not isinstance(entries, Mapping):
            raise CarError(f"{path.rstrip('.')} = {entries!r}: must be a table")
        self.entries, self.path, self.used = entries, path, set()

    def take(self, name: str) -> object:
        """An entry, which must be there."""
        if name not in self.entries:
            near = difflib.get_close_matches(name, self.entries, 1)
            hint = f"; there is {self.path}{near[0]}" if near else ""
            raise CarError(f"no entry {self.path}{name}{hint}")
        self.used.add(name)
        return self.entries[name]

    def table(self, name: str) -> "_Table":
        return _Table(self.take(name), f"{self.path}{name}.")

    def rest(self) -> dict[str, object]:
        """All entries, under names that someone else checks."""
        self.used.update(self.entries)
        return dict(self.entries)

    def number(self, name: str) -> float:
        return _number(f"{self.path}{name}", self.take(name))

    def positive(self, name: str) -> float:
        value = self.number(name)
        if value <= 0.0:
            raise CarError(f"{self.path}{name} = {value:g}: must be positive")
        return value

    def share(self, name: str) -> float:
        value = self.number(name)
        if not 0.0 <= value <= 1.0:
            raise CarError(f"{self.path}{name} = {value:g}: must be between 0 and 1")
        return value

    def vector(self, name: str) -> Vector:
        value = self.take(name)
        if not isinstance(value, list) or len(value) != 3:
            raise CarError(f"{self.path}{name} = {value!r}: must be three numbers")
        return numpy.array([_number(f"{self.path}{name}", item) for item in value])

    def body(self) -> Body:
        body = Body(self.positive("mass"), self.vector("centre"), self.vector("inertia"))
        largest = float(body.inertia.max())
        # No distribution of mass has a moment of inertia above the sum of the other two.
        if body.inertia.min() <= 0.0 or largest > body.inertia.sum() - largest + 1e-12:
            limit = "must be positive, and none above the sum of the other two"
            raise CarError(f"{self.path}inertia = {body.inertia.tolist()}: {limit}")
        self.finish()
        return body

    def finish(self) -> None:
        """Refuses entries that nobody has asked for."""
        known = sorted(self.used)
        for name in self.entries:
            if name not in self.used:
                near = difflib.get_close_matches(name, known, 1)
                hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(known)}"
                raise CarError(f"{self.path}{name}: unknown; {hint}")


def _number(name: str, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
        raise CarError(f"{name} = {value!r}: must be a finite number")
    return float(value)


def _unit(vector: Vector) -> Vector:
    length = numpy.linalg.norm(vector)
    if length == 0.0:
        raise CarError("an axis of the length 0 has no direction")
    return vector / length
