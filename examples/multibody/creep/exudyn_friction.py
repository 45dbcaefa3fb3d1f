"""Friction of exudyn: of spheres on triangles (GeneralContact), and of a connector of two coordinates."""

from functools import partial

import exudyn
import numpy
from exudyn import itemInterface
from exudyn.utilities import RigidBodyInertia

from examples.fmpy.coupling import CouplingError
from examples.multibody.creep.closed_form import exudyn_zone
from examples.multibody.creep.slope import CENTRE, FEET, FOOT, INERTIA, MASS, MU, STEP, Case, Slope

VERSION = exudyn.__version__
CONTACT_STIFFNESS, CONTACT_DAMPING = 1e5, 100.0  # N/m, N.s/m (chosen: exudyn has no defaults)
STICKING_STIFFNESS, STICKING_DAMPING = 1e5, 1e5**0.5  # N/m, N.s/m: those of LuGre here


def solve(system: exudyn.MainSystem, steps: int) -> None:
    """Runs a system with exudyn's default integrator, generalised alpha, at a fixed step."""
    settings = exudyn.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = STEP * steps
    settings.timeIntegration.adaptiveStep = False
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    try:
        system.SolveDynamic(settings)
    except exudyn.SolverError as error:
        raise CouplingError("exudyn's Newton iterations did not converge") from error


class Sliding:
    """A mass with one coordinate down the slope, with room for friction."""

    def __init__(self, slope: Slope):
        self.container = exudyn.SystemContainer()
        self.system = self.container.AddSystem()
        self.node = self.system.AddNode(itemInterface.Node1D(referenceCoordinates=[0.0]))
        self.system.AddObject(itemInterface.Mass1D(mass=MASS, nodeNumber=self.node))
        ground = self.system.AddNode(itemInterface.NodePointGround())
        self.ends = [
            self.system.AddMarker(itemInterface.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
            for node in (ground, self.node)
        ]
        self.system.AddLoad(itemInterface.LoadCoordinate(markerNumber=self.ends[1], load=slope.pull))
        self.applied = self.system.AddLoad(itemInterface.LoadCoordinate(markerNumber=self.ends[1], load=0.0))

    def push(self, force: float) -> None:
        """Sets the second force on the mass."""
        self.system.SetLoadParameter(self.applied, "load", force)

    def velocity(self) -> float:
        """Velocity down the slope."""
        return float(self.system.GetNodeOutput(self.node, exudyn.OutputVariableType.Coordinates_t))

    def run(self, steps: int) -> numpy.ndarray:
        """Positions after each step."""
        positions = [0.0]

        def record(system, _time: float) -> bool:
            positions.append(float(system.GetNodeOutput(self.node, exudyn.OutputVariableType.Coordinates)))
            return True

        self.system.SetPostStepUserFunction(record)
        self.system.Assemble()
        solve(self.system, steps)
        # exudyn may add a step of 1e-13 s to reach the end.
        return numpy.array(positions[: steps + 1])


def on_connector(zone: float, damping: float, slope: Slope, steps: int) -> numpy.ndarray:
    """CoordinateSpringDamperExt: regularised in a zone of velocity, or with bristles if that is 0."""
    sliding = Sliding(slope)
    bristles = {}
    if zone == 0.0:
        state = itemInterface.NodeGenericData(initialCoordinates=[0.0] * 3, numberOfDataCoordinates=3)
        bristles = {"nodeNumber": sliding.system.AddNode(state)}
        bristles |= {"stickingStiffness": STICKING_STIFFNESS, "stickingDamping": damping}
    sliding.system.AddObject(
        itemInterface.CoordinateSpringDamperExt(
            markerNumbers=sliding.ends, dynamicFrictionForce=slope.level, frictionProportionalZone=zone, **bristles
        )
    )
    return sliding.run(steps)


def on_feet(zone: float, slope: Slope, steps: int) -> numpy.ndarray:
    """The free block on its feet, which begins with the penetration of a block at rest on a level plane."""
    container = exudyn.SystemContainer()
    system = container.AddSystem()
    ground = system.CreateGround()
    sunk = slope.normal_force / len(FEET) / (0.5 * CONTACT_STIFFNESS)
    block = system.CreateRigidBody(
        referencePosition=[0.0, 0.0, CENTRE - sunk],
        inertia=RigidBodyInertia(MASS, numpy.diag(INERTIA)),
        gravity=slope.gravity,
    )
    contact = system.AddGeneralContact()
    contact.SetFrictionPairings(MU * numpy.eye(1))
    contact.SetFrictionProportionalZone(zone)
    contact.SetSearchTreeCellSize([4, 4, 4])
    contact.SetSearchTreeBox(pMin=numpy.array([-2.0, -2.0, -1.0]), pMax=numpy.array([2.0, 2.0, 1.0]))
    plane = system.AddMarker(itemInterface.MarkerBodyRigid(bodyNumber=ground))
    corners = [[-2.0, -2.0, 0.0], [2.0, -2.0, 0.0], [2.0, 2.0, 0.0], [-2.0, 2.0, 0.0]]
    stiff = (CONTACT_STIFFNESS, CONTACT_DAMPING, 0)
    contact.AddTrianglesRigidBodyBased(plane, *stiff, corners, [[0, 1, 2], [0, 2, 3]])
    for x, y, z in FEET:
        foot = system.AddMarker(itemInterface.MarkerBodyRigid(bodyNumber=block, localPosition=[x, y, z - CENTRE]))
        contact.AddSphereWithMarker(foot, FOOT, *stiff)
    positions = [0.0]

    def record(system, _time: float) -> bool:
        seen = system.GetObjectOutputBody(block, exudyn.OutputVariableType.Displacement, [0.0, 0.0, 0.0])
        positions.append(float(seen[0]))
        return True

    system.SetPostStepUserFunction(record)
    system.Assemble()
    solve(system, steps)
    return numpy.array(positions[: steps + 1])


def cases() -> list[Case]:
    """Both kinds of friction, with several widths of the zone and dampings of the bristles."""
    connector = "`CoordinateSpringDamperExt`"
    sticking = f"bristles, stickingStiffness = {STICKING_STIFFNESS:g} N/m, stickingDamping"
    zones = [
        ("`GeneralContact`", "0.001 m/s (default)", 1e-3, partial(on_feet, 1e-3)),
        ("`GeneralContact`", "0.01 m/s", 1e-2, partial(on_feet, 1e-2)),
        *((connector, f"{zone:g} m/s", zone, partial(on_connector, zone, 0.0)) for zone in (1e-3, 1e-4)),
    ]
    return [
        *(
            Case("exudyn", friction, f"frictionProportionalZone = {text}", measure, partial(exudyn_zone, zone))
            for friction, text, zone, measure in zones
        ),
        Case("exudyn", connector, f"{sticking} = 0 (default)", partial(on_connector, 0.0, 0.0)),
        Case("exudyn", connector, f"{sticking} = 316 N.s/m", partial(on_connector, 0.0, STICKING_DAMPING)),
    ]
