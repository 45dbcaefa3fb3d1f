"""The car in exudyn: spatial rigid bodies, joints without redundant constraints, and what acts between them.

All bodies have the axes of the car in the design position, so that every point of the description is a local position
less a centre of mass. Forces of tyres and struts are set from outside, and held over a step.
"""

import math
from collections.abc import Mapping

import exudyn
import numpy
from exudyn.utilities import RigidBodyInertia

from examples.car.car_description import CORNERS, Body, Car, CarError, Corner, Vector
from examples.car.car_tyres import Carrier, Contact, unit

# Which axes of a joint's frame are locked: three directions, then three rotations.
UNIVERSAL = [1, 1, 1, 0, 0, 1]
CYLINDRICAL = [1, 1, 0, 1, 1, 0]
REVOLUTE = [1, 1, 1, 1, 1, 0]
FIXED = [1, 1, 1, 1, 1, 1]

ENTRY, ROTATION = exudyn.OutputVariableType, exudyn.NodeType


class CornerBodies:
    """Numbers of the bodies, joints and loads of a corner in exudyn."""

    def __init__(self, corner: Corner):
        self.corner = corner
        self.bodies: dict[str, int] = {}
        self.telescope = self.strut = self.parking = -1
        self.patch = self.force = self.moment = self.shaft = self.caliper = -1
        # Friction torque about the axis of the strut, on tube and rod; force on the eye of the rod alone.
        self.twists: dict[str, int] = {}
        self.rod_push = -1


class ExudynCar:
    """Bodies and joints of the car. With `on_stand` the chassis is bolted to the ground and the wheels do not spin;
    `gravity` may point elsewhere than down."""

    # The generalised-alpha method takes a load that is set before a step as that at its end.
    TAKES_LOADS_AT_THE_END = True

    def __init__(self, car: Car, on_stand: bool = False, gravity: Vector | None = None):
        self.car = car
        self.gravity = numpy.array([0.0, 0.0, -car.gravity]) if gravity is None else gravity
        self.container = exudyn.SystemContainer()
        self.system = self.container.AddSystem()
        self.centres: dict[int, Vector] = {}
        self.tensors: dict[int, Vector] = {}
        self.travel = 0.0
        # Whether the present reactions are those of a dynamic solution.
        self.is_moving = False
        self.ground = self.system.CreateGround(referencePosition=[0.0, 0.0, 0.0])
        self.centres[self.ground] = numpy.zeros(3)
        self.chassis = self._body(car.chassis)
        if on_stand:
            self._joint(self.ground, self.chassis, car.chassis.centre, numpy.eye(3), FIXED)
        self.rack = self._rack()
        self.corners = {name: self._corner(car.corners[name], on_stand) for name in CORNERS}
        for left, right in (("fl", "fr"), ("rl", "rr")):
            self._anti_roll_bar(self.corners[left], self.corners[right])
        self.system.Assemble()

    # Bodies and joints.

    def _body(self, body: Body, axes: Vector | None = None, spins: bool = False) -> int:
        """A rigid body under gravity; `axes` are those of its principal moments. One that spins is integrated in the
        group of rotations: in Euler parameters, at 100 rad/s and with 1 ms, a torque would change its spin by 0.3 % too
        little."""
        tensor = numpy.diag(body.inertia)
        if axes is not None:
            tensor = axes @ tensor @ axes.T
        number = self.system.CreateRigidBody(
            referencePosition=list(body.centre),
            inertia=RigidBodyInertia(body.mass, tensor),
            gravity=list(self.gravity),
            nodeType=ROTATION.RotationRotationVector if spins else ROTATION.RotationEulerParameters,
        )
        self.centres[number], self.tensors[number] = body.centre, tensor
        return number

    def _local(self, body: int, point: Vector) -> list[float]:
        return list(point - self.centres[body])

    def _joint(self, first: int, second: int, point: Vector, axes: Vector, locked: list[int]) -> int:
        """A joint at a point; the columns of `axes` are its x, y and z."""
        return self.system.CreateGenericJoint(
            itemNumbers=[first, second], position=list(point), rotationMatrixAxes=axes, constrainedAxes=locked
        )

    def _hinge(self, first: int, second: int, point: Vector, axis: Vector) -> None:
        self._joint(first, second, point, frame_about(axis), REVOLUTE)

    def _ball(self, first: int, second: int, point: Vector) -> None:
        self.system.CreateSphericalJoint(itemNumbers=[first, second], position=list(point))

    def _link(self, first: int, second: int, ends: tuple[Vector, Vector]) -> None:
        """A rod without mass between two ball joints."""
        self.system.CreateDistanceConstraint(
            itemNumbers=[first, second],
            localPosition0=self._local(first, ends[0]),
            localPosition1=self._local(second, ends[1]),
        )

    def _rack(self) -> int:
        """The steering rack. Its travel to the left is prescribed by moving the place at which it is held."""
        given = self.car.rack
        rack = self._body(given)
        self.rack_joint = joint = self._joint(self.chassis, rack, given.centre, numpy.eye(3), FIXED)
        self.rack_place = self._local(self.chassis, given.centre)
        self.rack_marker = self.system.GetObjectParameter(joint, "markerNumbers")[0]
        return rack

    def _corner(self, corner: Corner, on_stand: bool) -> CornerBodies:
        made = CornerBodies(corner)
        spin = frame_about(corner.spin_axis)
        # The wheel's moments are given about x, the axle and z: the frame has the axle last.
        wheel_axes = spin[:, [0, 2, 1]]
        for name, body in corner.bodies.items():
            made.bodies[name] = self._body(body, *((wheel_axes, True) if name == "wheel" else ()))
        b, p = made.bodies, corner.points
        for arm, front, rear, ball in (
            ("lower_arm", "lower_front", "lower_rear", "lower_ball"),
            ("upper_arm", "upper_front", "upper_rear", "upper_ball"),
        ):
            self._hinge(self.chassis, b[arm], 0.5 * (p[front] + p[rear]), p[front] - p[rear])
            self._ball(b[arm], b["upright"], p[ball])
        steered = self.rack if corner.is_front else self.chassis
        self._link(steered, b["upright"], (p["inner_tie"], p["outer_tie"]))
        self._joint(b["upright"], b["wheel"], p["wheel_centre"], spin, FIXED if on_stand else REVOLUTE)
        self._hinge(self.chassis, b["rocker"], p["rocker_pivot"], corner.rocker_axis)
        self._link(b["lower_arm"], b["rocker"], (p["push_rod_arm"], p["push_rod_rocker"]))
        axes = corner.strut_axes
        self._joint(self.chassis, b["tube"], p["tube_eye"], axes, UNIVERSAL)
        made.telescope = self._joint(b["tube"], b["rod"], p["rod_eye"], axes, CYLINDRICAL)
        self._joint(b["rod"], b["rocker"], p["rod_eye"], axes, UNIVERSAL)
        self._hinge(self.chassis, b["bar"], p["bar_pivot"], numpy.array([0.0, 1.0, 0.0]))
        self._link(b["rocker"], b["bar"], (p["bar_rocker"], p["bar_lever"]))
        self._connect(made)
        return made

    # Springs and loads.

    def _connect(self, made: CornerBodies) -> None:
        """The strut between its eyes; the tyre as springs to the ground for rest, and as a force and a moment for
        motion; a parking brake."""
        b, p = made.bodies, made.corner.points
        made.strut = self.system.CreateSpringDamper(
            itemNumbers=[b["tube"], b["rod"]],
            localPosition0=self._local(b["tube"], p["tube_eye"]),
            localPosition1=self._local(b["rod"], p["rod_eye"]),
            referenceLength=made.corner.strut_length,
        )
        made.patch = self.system.CreateCartesianSpringDamper(
            itemNumbers=[self.ground, b["wheel"]],
            localPosition0=list(p["wheel_centre"]),
            localPosition1=self._local(b["wheel"], p["wheel_centre"]),
        )
        made.parking = self.system.CreateTorsionalSpringDamper(
            itemNumbers=[b["upright"], b["wheel"]],
            position=list(p["wheel_centre"]),
            axis=list(made.corner.spin_axis),
        )
        centre = self._local(b["wheel"], p["wheel_centre"])
        made.force = self.system.CreateForce(itemNumber=b["wheel"], loadVector=[0.0] * 3, localPosition=centre)
        made.moment = self.system.CreateTorque(itemNumber=b["wheel"], loadVector=[0.0] * 3)
        made.caliper = self.system.CreateTorque(itemNumber=b["upright"], loadVector=[0.0] * 3)
        made.shaft = self.system.CreateTorque(itemNumber=self.chassis, loadVector=[0.0] * 3)
        made.twists = {
            part: self.system.CreateTorque(itemNumber=b[part], loadVector=[0.0] * 3) for part in ("tube", "rod")
        }
        eye = self._local(b["rod"], p["rod_eye"])
        made.rod_push = self.system.CreateForce(itemNumber=b["rod"], loadVector=[0.0] * 3, localPosition=eye)

    def _anti_roll_bar(self, left: CornerBodies, right: CornerBodies) -> None:
        pivot = 0.5 * (left.corner["bar_pivot"] + right.corner["bar_pivot"])
        self.system.CreateTorsionalSpringDamper(
            itemNumbers=[left.bodies["bar"], right.bodies["bar"]],
            position=list(pivot),
            axis=[0.0, 1.0, 0.0],
            stiffness=self.car.bar_stiffness[left.corner.name[0]],
        )

    # Measurements.

    def look(self, name: str) -> tuple[float, float]:
        """Length of a strut and its rate."""
        strut = self.corners[name].strut
        line = self.system.GetObjectOutput(strut, ENTRY.Displacement)
        length = self.system.GetObjectOutput(strut, ENTRY.Distance)
        return length, float(line @ self.system.GetObjectOutput(strut, ENTRY.Velocity)) / length

    def strut_axis(self, name: str) -> Vector:
        """Present axis of a strut, from the eye of the tube to that of the rod."""
        return unit(self.system.GetObjectOutput(self.corners[name].strut, ENTRY.Displacement))

    def rod_eye(self, name: str) -> Vector:
        """Present position of the eye of a rod."""
        made = self.corners[name]
        return self.place(made.bodies["rod"], made.corner["rod_eye"])

    def rod_spin(self, name: str) -> float:
        """Spin of the rod in the tube about the axis of the strut."""
        bodies = self.corners[name].bodies
        return float((self.turning(bodies["rod"]) - self.turning(bodies["tube"])) @ self.strut_axis(name))

    def reaction(self, name: str) -> tuple[Vector, Vector]:
        """Force and moment of the tube on the rod at the present eye of the rod, in the axes m, n and a."""
        telescope = self.corners[name].telescope
        force = self.system.GetObjectOutput(telescope, ENTRY.ForceLocal)
        # If two rotations are locked, the moments are the multipliers of x.a = 0 and of y.a = 0, in this order. All
        # signs change from a static to a dynamic solution. Manuals do not say so: statics does, in the tests.
        about_n, about_m, _ = self.system.GetObjectOutput(telescope, ENTRY.TorqueLocal)
        sense = -1.0 if self.is_moving else 1.0
        return sense * force, sense * numpy.array([about_m, -about_n, 0.0])

    def place(self, body: int, point: Vector) -> Vector:
        """Present position of a point that is given by its place in the design position."""
        return self.system.GetObjectOutputBody(body, ENTRY.Position, self._local(body, point))

    def rotation(self, body: int) -> Vector:
        """Rotation of a body from the design position."""
        return self.system.GetObjectOutputBody(body, ENTRY.RotationMatrix, [0.0, 0.0, 0.0]).reshape(3, 3)

    def velocity(self, body: int, point: Vector) -> Vector:
        """Velocity of a point that is given by its place in the design position."""
        return self.system.GetObjectOutputBody(body, ENTRY.Velocity, self._local(body, point))

    def turning(self, body: int) -> Vector:
        """Angular velocity of a body."""
        return self.system.GetObjectOutputBody(body, ENTRY.AngularVelocity, [0.0, 0.0, 0.0])

    def inertia(self, body: int) -> Vector:
        """Inertia of a body about its centre of mass, in its own axes."""
        return self.tensors[body]

    def rack_force(self) -> float:
        """Force of the chassis on the rack, to the left."""
        sense = -1.0 if self.is_moving else 1.0
        return sense * float(self.system.GetObjectOutput(self.rack_joint, ENTRY.ForceLocal)[1])

    def spin_axis(self, name: str) -> Vector:
        """Present axis of a wheel, to the left: it belongs to the upright, which does not spin."""
        made = self.corners[name]
        return self.rotation(made.bodies["upright"]) @ made.corner.spin_axis

    def wheel_centre(self, name: str) -> Vector:
        """Present position of the centre of a wheel."""
        made = self.corners[name]
        return self.place(made.bodies["upright"], made.corner["wheel_centre"])

    def carrier(self, name: str) -> Carrier:
        """Present motion of a wheel and of the upright that carries it."""
        made = self.corners[name]
        upright, wheel = made.bodies["upright"], made.bodies["wheel"]
        axis = self.rotation(upright) @ made.corner.spin_axis
        turning = self.turning(upright)
        spin = self.turning(wheel) - turning
        centre = made.corner["wheel_centre"]
        return Carrier(self.place(upright, centre), self.velocity(upright, centre), turning, axis, float(spin @ axis))

    def mobility(self) -> tuple[int, int, int]:
        """Number of bodies, of independent constraints and of redundant ones, by the rank of the constraints."""
        found = self.system.ComputeSystemDegreeOfFreedom()
        bodies = len(self.centres) - 1
        return bodies, 6 * bodies - found["degreeOfFreedom"], found["redundantConstraints"]

    # Forces.

    def set_strut(self, name: str, force: float, stiffness: float = 0.0, length: float = 0.0) -> None:
        """Sets the force of a strut, which falls with a stiffness from a length on; positive pushes the eyes apart."""
        strut = self.corners[name].strut
        self.system.SetObjectParameter(strut, "force", -force)
        self.system.SetObjectParameter(strut, "stiffness", stiffness)
        if stiffness > 0.0:
            self.system.SetObjectParameter(strut, "referenceLength", length)

    def push_rod(self, name: str, rod_force: float) -> None:
        """Sets the part of a strut's force that does not reach the eye of its rod."""
        push = -rod_force * self.strut_axis(name)
        self.system.SetLoadParameter(self.corners[name].rod_push, "loadVector", list(push))

    def twist_strut(self, name: str, torque: float) -> None:
        """Sets the friction torque about the axis of a strut: on the tube, and reversed on the rod."""
        moment = torque * self.strut_axis(name)
        twists = self.corners[name].twists
        self.system.SetLoadParameter(twists["tube"], "loadVector", list(moment))
        self.system.SetLoadParameter(twists["rod"], "loadVector", list(-moment))

    def push(self, name: str, force: Vector, moment: Vector) -> None:
        """Sets force and moment of the road, at the centre of a wheel."""
        made = self.corners[name]
        self.system.SetLoadParameter(made.force, "loadVector", list(force))
        self.system.SetLoadParameter(made.moment, "loadVector", list(moment))

    def react(self, name: str, moment: Vector) -> None:
        """Sets the moment of a driven wheel's shaft on the chassis."""
        self.system.SetLoadParameter(self.corners[name].shaft, "loadVector", list(moment))

    def brake(self, name: str, moment: Vector) -> None:
        """Sets the moment of a wheel's brake on its upright."""
        self.system.SetLoadParameter(self.corners[name].caliper, "loadVector", list(moment))

    def park(self, name: str, stiffness: float) -> None:
        """Pulls the parking brake of a wheel: a stiff spring, well damped."""
        parking = self.corners[name].parking
        inertia = float(self.corners[name].corner.bodies["wheel"].inertia[1])
        self.system.SetObjectParameter(parking, "stiffness", stiffness)
        self.system.SetObjectParameter(parking, "damping", math.sqrt(stiffness * inertia))

    def move_rack(self, travel: float) -> None:
        """Moves the rack to a travel, which it has at the end of the step."""
        self.travel = travel
        x, y, z = self.rack_place
        self.system.SetMarkerParameter(self.rack_marker, "localPosition", [x, y + travel, z])

    def set_in_motion(self, speed: float, radii: Mapping[str, float]) -> None:
        """Gives all bodies a forward speed, and the wheels the spin of rolling on these radii."""
        rates = self.system.systemData.GetODE2Coordinates_t(exudyn.ConfigurationType.Initial)
        spins = {self.corners[name].bodies["wheel"]: speed / radius for name, radius in radii.items()}
        for body in self.centres:
            if body == self.ground:
                continue
            node = self.system.GetObjectParameter(body, "nodeNumber")
            at = self.system.GetNodeODE2Index(node)
            rates[at : at + 3] = [speed, 0.0, 0.0]
            rates[at + 3 : at + (6 if body in spins else 7)] = 0.0
            if body in spins:
                name = next(name for name in radii if self.corners[name].bodies["wheel"] == body)
                # The rates of rotation in the group are the angular velocity in the axes of the body.
                rates[at + 3 : at + 6] = self.rotation(body).T @ (spins[body] * self.spin_axis(name))
        self.system.systemData.SetODE2Coordinates_t(rates, exudyn.ConfigurationType.Initial)
        self.system.systemData.SetODE2Coordinates_t(rates, exudyn.ConfigurationType.Current)

    # Motion of the chassis.

    def pose(self) -> tuple[float, float, float, float, float, float]:
        """Position of its centre of mass, heave from the design position, and roll (left side up), pitch (nose down)
        and yaw (to the left)."""
        turned = self.rotation(self.chassis)
        centre = self.place(self.chassis, self.car.chassis.centre)
        roll = math.atan2(turned[2, 1], turned[2, 2])
        pitch = math.asin(-turned[2, 0])
        yaw = math.atan2(turned[1, 0], turned[0, 0])
        return centre[0], centre[1], centre[2] - self.car.chassis.centre[2], roll, pitch, yaw

    def nose(self) -> Vector:
        """The middle of the front axle."""
        return self.place(self.chassis, numpy.zeros(3))

    def motion(self) -> tuple[float, float, float]:
        """Forward and lateral velocity of its centre of mass, and yaw rate."""
        ahead = unit(self.rotation(self.chassis)[:2, 0])
        velocity = self.velocity(self.chassis, self.car.chassis.centre)
        turning = self.turning(self.chassis)
        across = -ahead[1] * velocity[0] + ahead[0] * velocity[1]
        return float(velocity[:2] @ ahead), float(across), float(turning[2])

    # Positions at rest.

    def stand(self, name: str, carrier: Carrier, contact: Contact, slope: float, holding: float, parking: float):
        """Holds a wheel by the tangent of its tyre's force, and softly where it is in the plane of the road."""
        made = self.corners[name]
        shift = carrier.centre - made.corner["wheel_centre"]
        shift[2] += contact.load / slope
        self.system.SetObjectParameter(made.patch, "stiffness", [holding, holding, slope])
        self.system.SetObjectParameter(made.patch, "offset", list(shift))
        self.system.SetObjectParameter(made.parking, "stiffness", parking)
        up = numpy.array([0.0, 0.0, contact.load])
        self.push(name, numpy.zeros(3), numpy.cross(contact.arm, up))

    def release(self, name: str) -> None:
        """Removes what held a wheel at rest; the tyre's force takes its place."""
        made = self.corners[name]
        self.system.SetObjectParameter(made.patch, "stiffness", [0.0] * 3)
        self.system.SetObjectParameter(made.parking, "stiffness", 0.0)

    def settle(self, what: str) -> None:
        """Solves for the position in which all forces balance, and starts there the next time."""
        settings = exudyn.SimulationSettings()
        settings.staticSolver.newton.relativeTolerance = 1e-12
        settings.staticSolver.newton.absoluteTolerance = 1e-12
        settings.staticSolver.verboseMode = 0
        settings.solution.file.write = False
        if not self.system.SolveStatic(settings, updateInitialValues=True):
            raise CarError(f"no position of the car found: {what}")
        self.is_moving = False

    def integrate(self, settings: exudyn.SimulationSettings) -> tuple[bool, int]:
        """Moves the car on from where it is; whether that succeeded, and the number of Newton iterations."""
        self.is_moving = True
        solver = exudyn.MainSolverImplicitSecondOrder()
        done = solver.SolveSystem(self.system, settings)
        return done, solver.it.newtonStepsCount


def frame_about(axis: Vector) -> Vector:
    """A right-handed frame, as columns, whose z is along an axis."""
    z = axis / numpy.linalg.norm(axis)
    x = numpy.cross([0.0, 0.0, 1.0] if abs(z[2]) < 0.9 else [1.0, 0.0, 0.0], z)
    x /= numpy.linalg.norm(x)
    return numpy.column_stack([x, numpy.cross(z, x), z])


def steps_of(step: float, count: int, spectral_radius: float = 0.7) -> exudyn.SimulationSettings:
    """An implicit integrator with a fixed step; nothing is written."""
    chosen = exudyn.SimulationSettings()
    chosen.timeIntegration.numberOfSteps = count
    chosen.timeIntegration.endTime = step * count
    chosen.timeIntegration.adaptiveStep = False
    chosen.timeIntegration.verboseMode = 0
    chosen.timeIntegration.generalizedAlpha.spectralRadius = spectral_radius
    chosen.timeIntegration.newton.relativeTolerance = 1e-8
    chosen.timeIntegration.newton.absoluteTolerance = 1e-10
    chosen.timeIntegration.newton.useModifiedNewton = True
    chosen.linearSolver.solverType = exudyn.LinearSolverType.EigenSparse
    chosen.solution.file.write = False
    return chosen
