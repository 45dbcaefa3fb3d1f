"""MuJoCo models of the suspensions in suspension.py, as MJCF text.

The frames of all bodies are at the origin in the design position, so that every point is written as in the table. Loops
are closed by `connect` (a ball joint), tie rods by the length of a tendon. MuJoCo enforces both with stiff springs,
which here deflect by some micrometres.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy

from examples.multibody.suspension import GRAVITY, SPRUNG_MASS, Body, Suspension

STIFF = 'solref="0.002 1" solimp="0.999 0.9999 0.0001"'


@dataclass
class Parts:
    """Pieces of a model, by the section of the file they belong to."""

    extensions: list[str] = field(default_factory=list)
    bodies: list[str] = field(default_factory=list)
    sites: list[str] = field(default_factory=list)
    equalities: list[str] = field(default_factory=list)
    tendons: list[str] = field(default_factory=list)
    actuators: list[str] = field(default_factory=list)
    sensors: list[str] = field(default_factory=list)

    def connect(self, first: str, second: str, point: Iterable[float]) -> None:
        """A ball joint between two bodies."""
        self.equalities.append(f'<connect body1="{first}" body2="{second}" anchor="{text(point)}" {STIFF}/>')

    def rod(self, name: str, first: str, second: str) -> None:
        """A massless rod of constant length between two sites."""
        self.line(name, first, second)
        self.equalities.append(f'<tendon tendon1="{name}" {STIFF}/>')

    def line(self, name: str, first: str, second: str) -> None:
        """A straight line between two sites, whose length is measured."""
        self.tendons.append(f'<spatial name="{name}"><site site="{first}"/><site site="{second}"/></spatial>')


def text(numbers: Iterable[float]) -> str:
    """Numbers with all their digits."""
    return " ".join(repr(float(number)) for number in numbers)


def site(name: str, point: Iterable[float]) -> str:
    """A named point of a body."""
    return f'<site name="{name}" pos="{text(point)}"/>'


def joint(name: str, kind: str, point: Iterable[float], axis: Iterable[float] = (0.0, 0.0, 1.0)) -> str:
    """A joint of a body to the one around it."""
    return f'<joint name="{name}" type="{kind}" pos="{text(point)}" axis="{text(axis)}"/>'


def body(name: str, inertia: Body, *inside: str) -> str:
    """A rigid body with its joints, sites and child bodies."""
    pose = f'<inertial pos="{text(inertia.centre)}" mass="{inertia.mass}" diaginertia="{text(inertia.inertia)}"/>'
    return "\n".join([f'<body name="{name}">', pose, *inside, "</body>"])


def wishbone(name: str, front: Iterable[float], rear: Iterable[float], inertia: Body, *inside: str) -> str:
    """An arm that turns about the line through its two bearings."""
    return body(name, inertia, joint(name, "hinge", front, numpy.subtract(front, rear)), *inside)


def strut(name: str, parts: Parts) -> None:
    """The force of the strut, along the line between its eyes."""
    parts.line(f"{name}.strut", f"{name}.tube_eye", f"{name}.rod_eye")
    parts.actuators.append(f'<motor name="{name}.strut" tendon="{name}.strut"/>')


def side_load_sensors(name: str, parts: Parts) -> None:
    """Force and moment between tube and rod at the eye of the rod, in the axes (m, n, a) of its site."""
    for kind in ("force", "torque"):
        parts.sensors.append(f'<{kind} name="{name}.{kind}" site="{name}.rod_eye"/>')


def telescope(name: str, s: Suspension) -> str:
    """The rod that slides in the tube around it. Its eye carries the axes (m, n, a)."""
    m, n = s.transverse()
    eye = f'<site name="{name}.rod_eye" pos="{text(s.rod_eye)}" xyaxes="{text(m)} {text(n)}"/>'
    return body(f"{name}.rod", s.rod, joint(f"{name}.slide", "slide", s.rod_eye, s.axis()), eye)


def upright(name: str, s: Suspension, *parts: str) -> str:
    """The upright on its lower ball joint, with the sites of wheel and tie rod."""
    sites = site(f"{name}.wheel", s.wheel_centre), site(f"{name}.tie_rod", s.tie_rod_end)
    return body(f"{name}.upright", s.upright, joint(f"{name}.upright", "ball", s.lower_ball), *sites, *parts)


def double_wishbone(name: str, s: Suspension, telescopic: bool = False) -> Parts:
    """A double wishbone. The strut between body and lower arm is a force, or a telescope with mass and side loads.

    The body of the car must have a body or site `<name>.rack` for the tie rod.
    """
    parts = Parts()
    wheel = upright(name, s)
    eye = [] if telescopic else [site(f"{name}.rod_eye", s.rod_eye)]
    parts.bodies.append(wishbone(f"{name}.lower", s.lower_front, s.lower_rear, s.lower_arm, *eye, wheel))
    parts.bodies.append(wishbone(f"{name}.upper", s.upper_front, s.upper_rear, s.upper_arm))
    parts.connect(f"{name}.upper", f"{name}.upright", s.upper_ball)
    parts.rod(f"{name}.tie_rod", f"{name}.rack", f"{name}.tie_rod")
    parts.sites.append(site(f"{name}.tube_eye", s.tube_eye))
    if telescopic:
        m, n = s.transverse()
        cross = [joint(f"{name}.eye_m", "hinge", s.tube_eye, m), joint(f"{name}.eye_n", "hinge", s.tube_eye, n)]
        parts.bodies.append(body(f"{name}.tube", s.tube, *cross, telescope(name, s)))
        parts.connect(f"{name}.rod", f"{name}.lower", s.rod_eye)
        side_load_sensors(name, parts)
    strut(name, parts)
    return parts


def macpherson(name: str, s: Suspension) -> Parts:
    """A strut whose tube is bolted to the upright and whose rod is attached to the body `car`: it guides the wheel."""
    parts = Parts()
    wheel = upright(name, s, site(f"{name}.tube_eye", s.tube_eye), telescope(name, s))
    parts.bodies.append(wishbone(f"{name}.lower", s.lower_front, s.lower_rear, s.lower_arm, wheel))
    parts.rod(f"{name}.tie_rod", f"{name}.rack", f"{name}.tie_rod")
    parts.connect(f"{name}.rod", "car", s.rod_eye)
    side_load_sensors(name, parts)
    strut(name, parts)
    return parts


def guided(name: str, s: Suspension) -> Parts:
    """A wheel on a straight vertical guide with the strut above it: the quarter car of textbooks."""
    parts = Parts()
    unsprung = Body(s.unsprung_mass(), s.upright.centre, s.upright.inertia)
    wheel = [joint(f"{name}.guide", "slide", s.wheel_centre), site(f"{name}.wheel", s.wheel_centre)]
    parts.bodies.append(body(f"{name}.upright", unsprung, *wheel, site(f"{name}.rod_eye", s.rod_eye)))
    parts.sites.append(site(f"{name}.tube_eye", s.tube_eye))
    strut(name, parts)
    return parts


def quarter_car(s: Suspension, parts: Parts, step: float) -> str:
    """A body that can only rise and fall, on one suspension named `fl`."""
    car = Body(SPRUNG_MASS, (0.0, 0.0, 0.5), (50.0, 50.0, 50.0))
    rack = site("fl.rack", s.rack_end)
    return model(
        body("car", car, joint("heave", "slide", (0.0, 0.0, 0.5)), rack, *parts.sites, *parts.bodies), parts, step
    )


def model(car: str, parts: Parts, step: float) -> str:
    """The whole file."""
    sections = {
        "extension": parts.extensions,
        "worldbody": [car],
        "tendon": parts.tendons,
        "equality": parts.equalities,
        "actuator": parts.actuators,
        "sensor": parts.sensors,
    }
    inside = "\n".join(f"<{name}>\n" + "\n".join(lines) + f"\n</{name}>" for name, lines in sections.items())
    options = f'<option timestep="{step!r}" gravity="0 0 {-GRAVITY}" tolerance="1e-12" iterations="100"/>'
    return f'<mujoco>\n<compiler autolimits="true"/>\n{options}\n{inside}\n</mujoco>'
