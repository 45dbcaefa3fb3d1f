"""The quarter car in exudyn, and its coupling with a strut."""

import exudyn
import numpy
from exudyn.utilities import RigidBodyInertia
from tqdm import tqdm

from examples.fmpy.coupling import CouplingError
from examples.multibody.hosted_strut import UNLOADED, Strut, Wrench
from examples.multibody.report import Recorder, Run, steps_of
from examples.multibody.suspension import BUMP, GRAVITY, SPRUNG_MASS, SUSPENSIONS, TYRE, Body, Suspension

# Which axes of the joint frame (m, n, a) a joint locks: three directions, then three rotations.
UNIVERSAL = [1, 1, 1, 0, 0, 1]
SLIDING = [1, 1, 0, 1, 1, 1]

Point = tuple[float, float, float]


class QuarterCar:
    """The bodies and joints. All points are given in the axes of the design position."""

    def __init__(self, kind: str):
        self.container = exudyn.SystemContainer()
        self.system = self.container.AddSystem()
        self.centres: dict[int, Point] = {}
        self.suspension = SUSPENSIONS[kind]
        self.ground = self.system.CreateGround(referencePosition=[0.0, 0.0, 0.0])
        self.centres[self.ground] = (0.0, 0.0, 0.0)
        self.car = self.body(Body(SPRUNG_MASS, (0.0, 0.0, 0.5), (50.0, 50.0, 50.0)))
        self.slide(self.ground, self.car, (0.0, 0.0, 0.5))
        # The bodies of the wheel and of both eyes of the strut; in a telescope, the joint between tube and rod.
        self.wheel = self.tube = self.rod = self.car
        self.telescope: int | None = None
        build = {
            "double-wishbone": self.double_wishbone,
            "telescope": self.telescopic_wishbone,
            "macpherson": self.macpherson,
            "guided": self.guided,
        }[kind]
        build(self.suspension)

    def body(self, body: Body) -> int:
        """A rigid body under gravity."""
        inertia = RigidBodyInertia(body.mass, numpy.diag(body.inertia))
        number = self.system.CreateRigidBody(
            referencePosition=list(body.centre), inertia=inertia, gravity=[0.0, 0.0, -GRAVITY]
        )
        self.centres[number] = body.centre
        return number

    def local(self, body: int, point: Point) -> list[float]:
        """A point in the axes of a body."""
        return list(numpy.subtract(point, self.centres[body]))

    def slide(self, outer: int, inner: int, point: Point) -> None:
        """A vertical guide."""
        self.system.CreatePrismaticJoint(itemNumbers=[outer, inner], position=list(point), axis=[0.0, 0.0, 1.0])

    def hinge(self, arm: int, front: Point, rear: Point) -> None:
        """The bearings of a wishbone on the car body."""
        middle, axis = 0.5 * numpy.add(front, rear), numpy.subtract(front, rear)
        axis /= numpy.linalg.norm(axis)
        self.system.CreateRevoluteJoint(itemNumbers=[self.car, arm], position=list(middle), axis=list(axis))

    def ball(self, first: int, second: int, point: Point) -> None:
        """A ball joint."""
        self.system.CreateSphericalJoint(itemNumbers=[first, second], position=list(point))

    def lower_arm(self, s: Suspension) -> int:
        """Adds the lower arm and the tie rod of a wheel; returns the arm."""
        arm = self.body(s.lower_arm)
        self.hinge(arm, s.lower_front, s.lower_rear)
        self.ball(arm, self.wheel, s.lower_ball)
        self.system.CreateDistanceConstraint(
            itemNumbers=[self.car, self.wheel],
            localPosition0=self.local(self.car, s.rack_end),
            localPosition1=self.local(self.wheel, s.tie_rod_end),
        )
        return arm

    def double_wishbone(self, s: Suspension) -> None:
        """A massless strut between body and lower arm."""
        self.wheel = self.body(s.upright)
        self.rod = self.lower_arm(s)
        upper = self.body(s.upper_arm)
        self.hinge(upper, s.upper_front, s.upper_rear)
        self.ball(upper, self.wheel, s.upper_ball)

    def telescopic_wishbone(self, s: Suspension) -> None:
        """The same with tube and rod, which hang in universal joints."""
        self.double_wishbone(s)
        arm, self.tube, self.rod = self.rod, self.body(s.tube), self.body(s.rod)
        self.strut_joint(self.car, self.tube, s.tube_eye, UNIVERSAL)
        self.telescope = self.strut_joint(self.tube, self.rod, s.rod_eye, SLIDING)
        self.ball(arm, self.rod, s.rod_eye)

    def macpherson(self, s: Suspension) -> None:
        """A strut whose tube is bolted to the upright and whose rod is attached to the car."""
        self.wheel = self.tube = self.body(s.upright)
        self.lower_arm(s)
        self.rod = self.body(s.rod)
        self.telescope = self.strut_joint(self.tube, self.rod, s.rod_eye, SLIDING)
        self.ball(self.car, self.rod, s.rod_eye)

    def guided(self, s: Suspension) -> None:
        """A wheel in a straight guide."""
        self.wheel = self.rod = self.body(Body(s.unsprung_mass(), s.upright.centre, s.upright.inertia))
        self.slide(self.ground, self.wheel, s.upright.centre)

    def strut_joint(self, outer: int, inner: int, point: Point, locked: list[int]) -> int:
        """A joint whose axes are those of the strut."""
        return self.system.CreateGenericJoint(
            itemNumbers=[outer, inner],
            position=list(point),
            rotationMatrixAxes=self.suspension.strut_axes(),
            constrainedAxes=locked,
        )

    def wrench(self, length: float) -> Wrench:
        """Reaction of the tube on the rod, as last computed by exudyn."""
        if self.telescope is None:
            return UNLOADED
        kinds = exudyn.OutputVariableType
        force = self.system.GetObjectOutput(self.telescope, kinds.ForceLocal)
        moment = self.system.GetObjectOutput(self.telescope, kinds.TorqueLocal)
        # The force is that of the rod on the tube. The moments are multipliers of the locked rotations: only the second
        # one turns like the moment of the tube on the rod. Found by statics.
        return Wrench.in_rod_eye(-force, [-moment[0], moment[1], 0.0], length)

    def tyre(self) -> None:
        """The vertical force of the road on the wheel; in exudyn, forces that pull two bodies together are positive."""

        def pull(_system, time, _item, displacement, velocity, _stiffness, _damping, _offset):
            return [0.0, 0.0, -TYRE.load(TYRE.radius + displacement[2], velocity[2], *BUMP.at(time))]

        centre = self.suspension.wheel_centre
        self.system.CreateCartesianSpringDamper(
            itemNumbers=[self.ground, self.wheel],
            localPosition0=self.local(self.ground, centre),
            localPosition1=self.local(self.wheel, centre),
            springForceUserFunction=pull,
        )

    def strut(self, tension: float = 0.0, pull=0) -> int:
        """The strut between its eyes, with a tension that is set externally or given by a function."""
        return self.system.CreateSpringDamper(
            itemNumbers=[self.tube, self.rod],
            localPosition0=self.local(self.tube, self.suspension.tube_eye),
            localPosition1=self.local(self.rod, self.suspension.rod_eye),
            referenceLength=self.suspension.length(),
            force=tension,
            springForceUserFunction=pull,
        )

    def look(self, strut: int) -> tuple[float, float]:
        """Length of the strut and its rate."""
        kinds = exudyn.OutputVariableType
        line = self.system.GetObjectOutput(strut, kinds.Displacement)
        length = self.system.GetObjectOutput(strut, kinds.Distance)
        return length, float(numpy.dot(line, self.system.GetObjectOutput(strut, kinds.Velocity))) / length

    def rise(self, body: int) -> float:
        """Height of a body above the design position."""
        return float(self.system.GetObjectOutputBody(body, exudyn.OutputVariableType.Displacement, [0.0, 0.0, 0.0])[2])


class Coupling:
    """Connects a strut with the car; records one row per step."""

    def __init__(self, car: QuarterCar, strut: Strut, step: float, side_loads: bool, progress: tqdm):
        self.car, self.strut, self.step, self.progress = car, strut, step, progress
        self.side_loads, self.wrench = side_loads, UNLOADED
        self.recorder = Recorder()
        self.accepted = 0.0
        self.connector = -1

    def explicitly(self) -> None:
        """The force is computed at the beginning of a step and held."""
        # exudyn computes the first accelerations before the first step.
        first = self.strut.attempt(self.car.suspension.length(), 0.0, 0.0)
        self.connector = self.car.strut(tension=-first)
        self.car.system.SetPreStepUserFunction(self.hold)

    def hold(self, system, time: float) -> bool:
        """Before a step. exudyn gives the time at the end of the step."""
        length, velocity = self.car.look(self.connector)
        self.weigh(length)
        force = self.strut.advance(length, velocity, self.step, self.wrench)
        system.SetObjectParameter(self.connector, "force", -force)
        self.record(time - self.step, length, velocity, force)
        return True

    def implicitly(self) -> None:
        """The force is recomputed in each iteration."""
        self.connector = self.car.strut(pull=self.iterate)
        self.car.system.SetPostStepUserFunction(self.accept)

    def iterate(self, _system, time: float, _item, extension: float, velocity: float, *_linear: float) -> float:
        """The tension of the strut at the end of the step, for the values of the current iteration."""
        length = self.car.suspension.length() + extension
        return -self.strut.attempt(length, velocity, time - self.accepted, self.wrench)

    def accept(self, _system, time: float) -> bool:
        """After a step. The last iteration may have used perturbed values, for the Jacobian."""
        length, velocity = self.car.look(self.connector)
        force = self.strut.attempt(length, velocity, time - self.accepted, self.wrench)
        self.strut.accept()
        self.accepted = time
        self.weigh(length)
        self.record(time, length, velocity, force)
        return True

    def weigh(self, length: float) -> None:
        """Reads the side loads for the next step."""
        if self.side_loads:
            self.wrench = self.car.wrench(length)

    def record(self, time: float, length: float, velocity: float, force: float) -> None:
        """Writes a row."""
        self.recorder.add(
            self.strut,
            time=time,
            body_height=self.car.rise(self.car.car),
            wheel_height=self.car.rise(self.car.wheel),
            length=length,
            velocity=velocity,
            force=force,
        )
        self.progress.update()


def settings(step: float, steps: int) -> exudyn.SimulationSettings:
    """An implicit integrator with a fixed step; nothing is written."""
    chosen = exudyn.SimulationSettings()
    chosen.timeIntegration.numberOfSteps = steps
    chosen.timeIntegration.endTime = step * steps
    chosen.timeIntegration.adaptiveStep = False
    chosen.timeIntegration.verboseMode = 0
    chosen.timeIntegration.generalizedAlpha.spectralRadius = 0.8
    chosen.timeIntegration.newton.relativeTolerance = 1e-9
    chosen.timeIntegration.newton.absoluteTolerance = 1e-12
    chosen.solution.file.write = False
    return chosen


def simulate(
    strut: Strut,
    label: str,
    kind: str = "double-wishbone",
    step: float = 1e-3,
    time: float = 4.0,
    side_loads: bool = False,
    coupling: str = "implicit",
) -> Run:
    """Drives over the bump."""
    steps = len(steps_of(time, step))
    car = QuarterCar(kind)
    car.tyre()
    with tqdm(total=steps, desc=label, unit="step", leave=False, disable=None) as progress:
        connection = Coupling(car, strut, step, side_loads, progress)
        {"explicit": connection.explicitly, "implicit": connection.implicitly}[coupling]()
        car.system.Assemble()
        if not car.system.SolveDynamic(settings(step, steps)):
            raise CouplingError(f"exudyn failed at {connection.accepted:.4f} s: try a smaller --step")
    return connection.recorder.run(label, car.suspension.length())
