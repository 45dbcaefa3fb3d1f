"""Friction of Drake's MultibodyPlant, in point contact."""

from functools import partial
from importlib.metadata import version

import numpy
from pydrake.geometry import HalfSpace, Sphere
from pydrake.math import RigidTransform
from pydrake.multibody.plant import AddMultibodyPlant, CoulombFriction, MultibodyPlantConfig
from pydrake.multibody.tree import RotationalInertia, SpatialInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

from examples.multibody.creep.closed_form import drake_lagged, drake_tamsi
from examples.multibody.creep.slope import CENTRE, FEET, FOOT, INERTIA, MASS, MU, STEP, Case, Slope

VERSION = version("drake")

# With the speed of creep, where there is a formula.
OPTIONS = {
    'discrete_contact_approximation = "lagged", stiction_tolerance = 1e-4 m/s (default)': (
        {},
        partial(drake_lagged, 1e-4),
    ),
    '"lagged", stiction_tolerance = 1e-3 m/s': ({"stiction_tolerance": 1e-3}, partial(drake_lagged, 1e-3)),
    # So small that something else is left, see the page.
    '"lagged", stiction_tolerance = 1e-6 m/s': ({"stiction_tolerance": 1e-6}, None),
    '"similar", stiction_tolerance = 1e-4 m/s': (
        {"discrete_contact_approximation": "similar"},
        partial(drake_lagged, 1e-4),
    ),
    '"tamsi", stiction_tolerance = 1e-4 m/s': (
        {"discrete_contact_approximation": "tamsi"},
        partial(drake_tamsi, 1e-4),
    ),
    '"sap"': ({"discrete_contact_approximation": "sap"}, None),
}


def on_feet(options: dict[str, object], slope: Slope, steps: int) -> numpy.ndarray:
    """The free block on its feet, on a half-space."""
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlant(MultibodyPlantConfig(time_step=STEP, **options), builder)
    plant.mutable_gravity_field().set_gravity_vector(slope.gravity)
    inertia = SpatialInertia.MakeFromCentralInertia(MASS, numpy.array([0.0, 0.0, CENTRE]), RotationalInertia(*INERTIA))
    block = plant.AddRigidBody("block", inertia)
    friction = CoulombFriction(MU, MU)
    plant.RegisterCollisionGeometry(plant.world_body(), RigidTransform(), HalfSpace(), "plane", friction)
    for at, foot in enumerate(FEET):
        plant.RegisterCollisionGeometry(block, RigidTransform(foot), Sphere(FOOT), f"foot {at}", friction)
    plant.Finalize()
    simulator = Simulator(builder.Build())
    simulator.Initialize()
    state = plant.GetMyContextFromRoot(simulator.get_context())
    positions = numpy.zeros(steps + 1)
    for at in range(steps):
        simulator.AdvanceTo((at + 1) * STEP)
        positions[at + 1] = plant.EvalBodyPoseInWorld(state, block).translation()[0]
    return positions


def cases() -> list[Case]:
    """The approximations of contact that Drake offers, and its tolerance."""
    return [
        Case("Drake", "contacts", text, partial(on_feet, options), speed) for text, (options, speed) in OPTIONS.items()
    ]
