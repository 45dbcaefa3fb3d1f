"""Friction of Bullet: of contacts, and of a joint held by a motor."""

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from importlib.metadata import version

import numpy
import pybullet

from examples.multibody.creep.slope import CENTRE, FEET, FOOT, INERTIA, MASS, MU, STEP, Case, Slope

VERSION = version("pybullet")

# Options of the solver and of the block.
OPTIONS = {
    "numSolverIterations = 50, solverResidualThreshold = 1e-7 (default)": ({}, {}),
    "numSolverIterations = 500": ({"numSolverIterations": 500}, {}),
    "frictionAnchor = 1": ({}, {"frictionAnchor": 1}),
    "solverResidualThreshold = 0": ({"solverResidualThreshold": 0.0}, {}),
    "solverResidualThreshold = 0, numSolverIterations = 500": (
        {"solverResidualThreshold": 0.0, "numSolverIterations": 500},
        {},
    ),
}


@contextmanager
def world(slope: Slope, options: dict[str, float]) -> Iterator[int]:
    """A world of its own."""
    client = pybullet.connect(pybullet.DIRECT)
    try:
        pybullet.setTimeStep(STEP, physicsClientId=client)
        pybullet.setPhysicsEngineParameter(physicsClientId=client, **options)
        pybullet.setGravity(*slope.gravity, physicsClientId=client)
        yield client
    finally:
        pybullet.disconnect(client)


def on_feet(options: dict[str, float], feet: dict[str, float], slope: Slope, steps: int) -> numpy.ndarray:
    """The free block on its feet. Bullet multiplies the coefficients of both bodies: that of the plane is 1."""
    with world(slope, options) as client:
        of = {"physicsClientId": client}
        plane = pybullet.createMultiBody(0.0, pybullet.createCollisionShape(pybullet.GEOM_PLANE, **of), **of)
        shape = pybullet.createCollisionShapeArray(
            [pybullet.GEOM_SPHERE] * len(FEET), radii=[FOOT] * len(FEET), collisionFramePositions=FEET, **of
        )
        block = pybullet.createMultiBody(MASS, shape, baseInertialFramePosition=[0.0, 0.0, CENTRE], **of)
        pybullet.changeDynamics(plane, -1, lateralFriction=1.0, **of)
        body = {"lateralFriction": MU, "localInertiaDiagonal": INERTIA, "linearDamping": 0.0, "angularDamping": 0.0}
        pybullet.changeDynamics(block, -1, **body, **feet, **of)

        def position() -> float:
            return pybullet.getBasePositionAndOrientation(block, **of)[0][0]

        return _stepped(client, position, steps)


def on_joint(slope: Slope, steps: int) -> numpy.ndarray:
    """A body on a prismatic joint whose motor keeps it at rest with at most the level of the block."""
    with world(slope, {}) as client:
        of = {"physicsClientId": client}
        link = {
            "linkMasses": [MASS],
            "linkCollisionShapeIndices": [-1],
            "linkVisualShapeIndices": [-1],
            "linkPositions": [[0.0] * 3],
            "linkOrientations": [[0.0, 0.0, 0.0, 1.0]],
            "linkInertialFramePositions": [[0.0] * 3],
            "linkInertialFrameOrientations": [[0.0, 0.0, 0.0, 1.0]],
            "linkParentIndices": [0],
            "linkJointTypes": [pybullet.JOINT_PRISMATIC],
            "linkJointAxis": [[1.0, 0.0, 0.0]],
        }
        body = pybullet.createMultiBody(0.0, **link, **of)
        still = {"linearDamping": 0.0, "angularDamping": 0.0, "jointDamping": 0.0}
        pybullet.changeDynamics(body, 0, localInertiaDiagonal=INERTIA, **still, **of)
        motor = {"targetVelocity": 0.0, "force": slope.level}
        pybullet.setJointMotorControl2(body, 0, pybullet.VELOCITY_CONTROL, **motor, **of)
        return _stepped(client, lambda: pybullet.getJointState(body, 0, **of)[0], steps)


def _stepped(client: int, position, steps: int) -> numpy.ndarray:
    positions = numpy.empty(steps + 1)
    positions[0] = position()
    for at in range(steps):
        pybullet.stepSimulation(physicsClientId=client)
        positions[at + 1] = position()
    return positions


def cases() -> list[Case]:
    """Contacts with options that change creep, and a joint."""
    contacts = [
        Case("Bullet", "contacts", text, partial(on_feet, options, feet)) for text, (options, feet) in OPTIONS.items()
    ]
    return [*contacts, Case("Bullet", "motor of a joint", "targetVelocity = 0, force = level", on_joint)]
