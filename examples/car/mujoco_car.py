"""The car in MuJoCo: a second opinion on the one in exudyn, from the same description.

Loops are closed, and links and tie rods held, by stiff springs that deflect by some micrometres. The strut is
guided by a universal joint and a slide, and ends in a ball joint at the rocker: its rod does not turn in the tube, and
everything else moves as in exudyn.
"""

import math
from collections.abc import Callable, Mapping

import mujoco
import numpy

from examples.car.car_description import CORNERS, Body, Car, CarError, Corner, Vector
from examples.car.car_tyres import Carrier
from examples.multibody import mjcf
from examples.multibody.mjcf import joint, site, text

# Inertia of the rack's joint, in kg.
RACK_INERTIA = 1e5


def _body(name: str, given: Body, *inside: str, axes: Vector | None = None) -> str:
    """A rigid body whose principal moments may have other axes than the car."""
    tensor = numpy.diag(given.inertia)
    if axes is not None:
        tensor = axes @ tensor @ axes.T
    full = [*numpy.diag(tensor), tensor[0, 1], tensor[0, 2], tensor[1, 2]]
    inertial = f'<inertial pos="{text(given.centre)}" mass="{given.mass}" fullinertia="{text(full)}"/>'
    return "\n".join([f'<body name="{name}">', inertial, *inside, "</body>"])


def _corner(name: str, corner: Corner, parts: mjcf.Parts) -> None:
    """Bodies and joints of a corner, as children of the chassis."""
    p, bodies = corner.points, corner.bodies
    axis = corner.spin_axis
    across = numpy.cross(axis, [0.0, 0.0, 1.0])
    across /= numpy.linalg.norm(across)
    spinning = numpy.column_stack([across, axis, numpy.cross(across, axis)])
    wheel = _body(
        f"{name}.wheel", bodies["wheel"], joint(f"{name}.spin", "hinge", p["wheel_centre"], axis), axes=spinning
    )
    upright = _body(
        f"{name}.upright",
        bodies["upright"],
        joint(f"{name}.upright", "ball", p["lower_ball"]),
        site(f"{name}.centre", p["wheel_centre"]),
        site(f"{name}.outer_tie", p["outer_tie"]),
        wheel,
    )
    lower = joint(f"{name}.lower", "hinge", p["lower_front"], p["lower_front"] - p["lower_rear"])
    arm_end = site(f"{name}.push_rod_arm", p["push_rod_arm"])
    parts.bodies.append(_body(f"{name}.lower_arm", bodies["lower_arm"], lower, arm_end, upright))
    upper = joint(f"{name}.upper", "hinge", p["upper_front"], p["upper_front"] - p["upper_rear"])
    parts.bodies.append(_body(f"{name}.upper_arm", bodies["upper_arm"], upper))
    parts.connect(f"{name}.upper_arm", f"{name}.upright", p["upper_ball"])
    parts.rod(f"{name}.tie_rod", f"{name}.inner_tie", f"{name}.outer_tie")
    _rocker_and_bar(name, corner, parts)
    _strut(name, corner, parts)


def _rocker_and_bar(name: str, corner: Corner, parts: mjcf.Parts) -> None:
    p, bodies = corner.points, corner.bodies
    ends = [site(f"{name}.{point}", p[point]) for point in ("push_rod_rocker", "bar_rocker")]
    turning = joint(f"{name}.rocker", "hinge", p["rocker_pivot"], corner.rocker_axis)
    parts.bodies.append(_body(f"{name}.rocker", bodies["rocker"], turning, *ends))
    parts.rod(f"{name}.push_rod", f"{name}.push_rod_arm", f"{name}.push_rod_rocker")
    lever = joint(f"{name}.bar", "hinge", p["bar_pivot"], (0.0, 1.0, 0.0))
    parts.bodies.append(_body(f"{name}.bar", bodies["bar"], lever, site(f"{name}.bar_lever", p["bar_lever"])))
    parts.rod(f"{name}.bar_link", f"{name}.bar_rocker", f"{name}.bar_lever")


def _strut(name: str, corner: Corner, parts: mjcf.Parts) -> None:
    p, bodies = corner.points, corner.bodies
    m, n, a = corner.strut_axes.T
    eye = f'<site name="{name}.rod_eye" pos="{text(p["rod_eye"])}" xyaxes="{text(m)} {text(n)}"/>'
    rod = _body(f"{name}.rod", bodies["rod"], joint(f"{name}.slide", "slide", p["rod_eye"], a), eye)
    cross = [joint(f"{name}.eye_{at}", "hinge", p["tube_eye"], axis) for at, axis in (("m", m), ("n", n))]
    parts.bodies.append(_body(f"{name}.tube", bodies["tube"], *cross, rod))
    parts.sites.append(site(f"{name}.tube_eye", p["tube_eye"]))
    parts.connect(f"{name}.rod", f"{name}.rocker", p["rod_eye"])
    mjcf.side_load_sensors(name, parts)
    mjcf.strut(name, parts)


def mjcf_of(car: Car, step: float) -> str:
    """The model as MJCF text."""
    parts, ends = mjcf.Parts(), []
    for name, corner in car.corners.items():
        _corner(name, corner, parts)
        (ends if corner.is_front else parts.sites).append(site(f"{name}.inner_tie", corner["inner_tie"]))
    for axle, stiffness in car.bar_stiffness.items():
        both = f'<joint joint="{axle}l.bar" coef="1"/><joint joint="{axle}r.bar" coef="-1"/>'
        # The torsion of the bar, as the spring of a fixed tendon.
        parts.tendons.append(f'<fixed name="{axle}.torsion" stiffness="{stiffness}" springlength="0">{both}</fixed>')
    # The rack slides at a velocity that is set; with this inertia no tie rod changes it within a step. Held by a spring
    # as the tie rods are, it would lag by 4 ms.
    sliding = f'<joint name="rack" type="slide" axis="0 1 0" armature="{RACK_INERTIA}"/>'
    rack = _body("rack", car.rack, sliding, *ends)
    chassis = _body("chassis", car.chassis, '<freejoint name="chassis"/>', *parts.sites, rack, *parts.bodies)
    return mjcf.model(chassis, parts, step)


class MujocoCar:
    """The car, with the interface of the one in exudyn as far as a ride needs it."""

    # A load acts on the motion at the beginning of a step.
    TAKES_LOADS_AT_THE_END = False

    def __init__(self, car: Car, step: float):
        self.car, self.travel = car, 0.0
        self.model = mujoco.MjModel.from_xml_string(mjcf_of(car, step))
        self.model.opt.gravity[:] = [0.0, 0.0, -car.gravity]
        self.data = mujoco.MjData(self.model)
        rack = self.model.joint("rack")
        self.rack, self.rack_rate = int(rack.qposadr[0]), int(rack.dofadr[0])
        self.step = step
        self.chassis = self.model.body("chassis").id
        self.shafts = {name: numpy.zeros(3) for name in CORNERS}
        self.names = {
            name: (
                self.model.body(f"{name}.upright").id,
                self.model.body(f"{name}.wheel").id,
                self.model.site(f"{name}.centre").id,
                self.model.tendon(f"{name}.strut").id,
                self.model.actuator(f"{name}.strut").id,
            )
            for name in CORNERS
        }
        self.struts = {
            name: (
                self.model.body(f"{name}.rod").id,
                self.model.site(f"{name}.tube_eye").id,
                self.model.site(f"{name}.rod_eye").id,
            )
            for name in CORNERS
        }
        mujoco.mj_forward(self.model, self.data)

    # Measurements.

    def look(self, name: str) -> tuple[float, float]:
        """Length of a strut and its rate."""
        strut = self.names[name][3]
        return float(self.data.ten_length[strut]), float(self.data.ten_velocity[strut])

    def reaction(self, name: str) -> tuple[Vector, Vector]:
        """Force and moment of the tube on the rod at the present eye of the rod, in the axes m, n and a."""
        return self.data.sensor(f"{name}.force").data, self.data.sensor(f"{name}.torque").data

    def rod_spin(self, _name: str) -> float:
        """Spin of the rod in the tube: none, it is guided by a slide."""
        return 0.0

    def turning(self, body: int) -> Vector:
        """Angular velocity of a body."""
        return self._motion(mujoco.mjtObj.mjOBJ_BODY, body)[:3]

    def _motion(self, kind: mujoco.mjtObj, number: int) -> Vector:
        motion = numpy.empty(6)
        mujoco.mj_objectVelocity(self.model, self.data, kind, number, motion, 0)
        return motion

    def carrier(self, name: str) -> Carrier:
        """Present motion of a wheel and of the upright that carries it."""
        upright, wheel, centre, _, _ = self.names[name]
        axis = self.data.xmat[upright].reshape(3, 3) @ self.car.corners[name].spin_axis
        turning = self.turning(upright)
        spin = float((self.turning(wheel) - turning) @ axis)
        velocity = self._motion(mujoco.mjtObj.mjOBJ_SITE, centre)[3:]
        return Carrier(self.data.site_xpos[centre].copy(), velocity, turning, axis, spin)

    def rotation(self, body: int) -> Vector:
        """Rotation of a body from the design position."""
        return self.data.xmat[body].reshape(3, 3)

    def pose(self) -> tuple[float, float, float, float, float, float]:
        """Position, heave, roll (left side up), pitch (nose down) and yaw (to the left) of the chassis."""
        turned = self.rotation(self.chassis)
        x, y, z = self.data.xipos[self.chassis]
        roll, pitch = math.atan2(turned[2, 1], turned[2, 2]), math.asin(-turned[2, 0])
        return x, y, z - self.car.chassis.centre[2], roll, pitch, math.atan2(turned[1, 0], turned[0, 0])

    def nose(self) -> Vector:
        """The middle of the front axle: the origin of the design position."""
        return self.data.xpos[self.chassis]

    def motion(self) -> tuple[float, float, float]:
        """Forward and lateral velocity of the chassis' centre of mass, and yaw rate."""
        ahead = self.rotation(self.chassis)[:2, 0]
        ahead = ahead / numpy.linalg.norm(ahead)
        seen = self._motion(mujoco.mjtObj.mjOBJ_BODY, self.chassis)
        velocity = seen[3:]
        across = -ahead[1] * velocity[0] + ahead[0] * velocity[1]
        return float(velocity[:2] @ ahead), float(across), float(seen[2])

    # Forces.

    def set_strut(self, name: str, force: float) -> None:
        """Sets the force of a strut; positive pushes the eyes apart."""
        self.data.ctrl[self.names[name][4]] = force

    def push_rod(self, name: str, rod_force: float) -> None:
        """Sets the part of a strut's force that does not reach the eye of its rod."""
        rod, tube_eye, rod_eye = self.struts[name]
        places = self.data.site_xpos
        line = places[rod_eye] - places[tube_eye]
        push = -rod_force * line / numpy.linalg.norm(line)
        arm = places[rod_eye] - self.data.xipos[rod]
        self.data.xfrc_applied[rod] = [*push, *numpy.cross(arm, push)]

    def twist_strut(self, _name: str, torque: float) -> None:
        """Would set the friction torque about the axis of a strut, which is 0 for a rod that does not spin."""
        assert torque == 0.0

    def push(self, name: str, force: Vector, moment: Vector) -> None:
        """Sets force and moment of the road, at the centre of a wheel, which is its centre of mass."""
        self.data.xfrc_applied[self.names[name][1]] = [*force, *moment]

    def react(self, name: str, moment: Vector) -> None:
        """Sets the moment of a driven wheel's shaft on the chassis."""
        self.shafts[name] = moment
        self.data.xfrc_applied[self.chassis, 3:] = sum(self.shafts.values())

    def brake(self, name: str, moment: Vector) -> None:
        """Sets the moment of a wheel's brake on its upright."""
        self.data.xfrc_applied[self.names[name][0], 3:] = moment

    def move_rack(self, travel: float) -> None:
        """Moves the rack to a travel, which it has at the end of the step."""
        self.travel = travel
        self.data.qvel[self.rack_rate] = (travel - self.data.qpos[self.rack]) / self.step

    def park(self, name: str, stiffness: float) -> None:
        """Pulls the parking brake of a wheel: a stiff spring, well damped."""
        spin = self.model.joint(f"{name}.spin")
        inertia = float(self.car.corners[name].bodies["wheel"].inertia[1])
        self.model.jnt_stiffness[spin.id] = stiffness
        self.model.dof_damping[spin.dofadr[0]] = math.sqrt(stiffness * inertia)

    def set_in_motion(self, speed: float, radii: Mapping[str, float]) -> None:
        """Gives the car a forward speed, and the wheels the spin of rolling on these radii."""
        self.data.qvel[0] = speed
        for name, radius in radii.items():
            self.data.qvel[self.model.joint(f"{name}.spin").dofadr[0]] = speed / radius
        mujoco.mj_forward(self.model, self.data)

    def stop(self) -> None:
        """Takes all velocity out of the car."""
        self.data.qvel[:] = 0.0
        mujoco.mj_forward(self.model, self.data)

    def run(self, step: float, count: int, hold: Callable[[float], None]) -> None:
        """Steps, each after `hold` has set the forces for the present position."""
        for at in range(count):
            mujoco.mj_step1(self.model, self.data)
            hold(at * step)
            mujoco.mj_step2(self.model, self.data)
            if not numpy.isfinite(self.data.qvel).all():
                raise CarError(f"MuJoCo diverges at {at * step:.4f} s: try a smaller step")
