"""Laws of this project, as FMUs, in MuJoCo and exudyn: they hold a body that slides along one axis."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from pathlib import Path

import mujoco
import numpy
import stribeck

from examples.fmpy.coupling import FMUS, open_fmu, path_of
from examples.multibody.creep import closed_form, exudyn_friction, mujoco_friction
from examples.multibody.creep.slope import MASS, MU, STEP, Case, Slope
from examples.multibody.creep.table import OWN

# Laws by what they are expected to do, with the parameters that are not their start values. `mass` lets a law without
# memory find the force of the end of the step.
HOLDING = {
    "CoulombStiction": {"mu_k": MU, "mu_s": MU, "mass": MASS},
    "Karnopp": {"mu_k": MU, "mu_s": MU, "mass": MASS},
    "ElastoPlastic": {"mu_k": MU, "mu_s": MU},
    "LuGre": {"mu_k": MU, "mu_s": MU},
    "Dahl": {"mu_k": MU},
}
CREEPING = {
    "Threlfall": {"mu_k": MU, "mass": MASS},
    "Andersson": {"mu_k": MU, "mu_s": MU, "mass": MASS},
    "Specker": {"mu_k": MU, "mu_s": MU, "mass": MASS},
}
LAWS = {**HOLDING, **CREEPING}
# A law of a host that does not tell it the load.
UNTOLD = "CoulombStiction without external_force"

# Friction force over the next step for the velocity at its beginning.
Law = Callable[[float], float]


@contextmanager
def open_law(name: str, parameters: Mapping[str, object], slope: Slope, fmus: Path, told: bool = True) -> Iterator[Law]:
    """The law `name` under the weight across the slope; it is stepped before the body is. Unless `told` is false it
    gets the weight along the slope as well."""
    with open_fmu(path_of(name, fmus), {**parameters, "normal_force": slope.normal_force}) as fmu:
        slave = fmu.slave
        if told and "external_force" in fmu.names("input"):
            slave.setReal(fmu.references("external_force"), [slope.pull])
        velocity_reference, force_reference = fmu.references("velocity"), fmu.references("friction_force")
        steps = 0

        def force(velocity: float) -> float:
            nonlocal steps
            slave.setReal(velocity_reference, [velocity])
            slave.doStep(steps * STEP, STEP)
            steps += 1
            return slave.getReal(force_reference)[0]

        yield force


def in_mujoco(law: Law, slope: Slope, steps: int) -> numpy.ndarray:
    """A body on a slide joint: the force is held over the step."""
    gravity = " ".join(map(repr, slope.gravity))
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{STEP}" gravity="{gravity}"/><worldbody><body><joint type="slide" axis="1 0 0"/>'
        f'<geom type="box" size="0.2 0.2 0.05" mass="{MASS}" contype="0" conaffinity="0"/></body></worldbody></mujoco>'
    )
    data = mujoco.MjData(model)
    positions = numpy.zeros(steps + 1)
    for at in range(steps):
        data.qfrc_applied[0] = -law(float(data.qvel[0]))
        mujoco.mj_step(model, data)
        positions[at + 1] = data.qpos[0]
    return positions


def in_exudyn(law: Law, slope: Slope, steps: int) -> numpy.ndarray:
    """A mass with one coordinate: the force is set before each step and held over it."""
    sliding = exudyn_friction.Sliding(slope)
    # exudyn computes the first accelerations before the first step: the force of a body at rest is known there already.
    first = law(0.0)
    sliding.push(-first)
    forces = iter([first])

    def hold(system, _time: float) -> bool:
        force = next(forces, None)
        system.SetLoadParameter(sliding.applied, "load", -(law(sliding.velocity()) if force is None else force))
        return True

    sliding.system.SetPreStepUserFunction(hold)
    return sliding.run(steps)


def alone(name: str, parameters: Mapping[str, object], slope: Slope, steps: int) -> numpy.ndarray:
    """The law with the system `slope.toml` of the workbench, solved to a tolerance instead of stepped."""
    known = {key: value for key, value in parameters.items() if key != "mass"}
    solution = stribeck.solve(
        str(Path(__file__).with_name("slope.toml")),
        name,
        set={**known, "plane.angle": slope.angle, "plane.mass": MASS},
        tol=1e-10,
        until=steps * STEP,
        every=STEP,
        record=["plane.position"],
    )
    return solution["plane.position"]


def _stepped(host: Callable, name: str, fmus: Path, slope: Slope, steps: int, told: bool = True) -> numpy.ndarray:
    with open_law(name, LAWS[name], slope, fmus, told) as law:
        return host(law, slope, steps)


def version_of(simulator: str) -> str:
    """Version of a simulator that hosts the laws, or of the package."""
    versions = {"MuJoCo": mujoco_friction.VERSION, "exudyn": exudyn_friction.VERSION}
    return versions.get(simulator, stribeck.__version__)


def options_of(name: str) -> str:
    """The parameters of a law that differ from its start values."""
    return ", ".join(f"{key} = {value:g}" for key, value in LAWS[name].items())


def cases(fmus: Path = FMUS) -> list[Case]:
    """Every law in the workbench, in MuJoCo and in exudyn, and one that is not told the load."""
    hosts = {"MuJoCo": in_mujoco, "exudyn": in_exudyn}
    measures = {OWN: {name: partial(alone, name, LAWS[name]) for name in LAWS}}
    measures |= {host: {name: partial(_stepped, run, name, fmus) for name in LAWS} for host, run in hosts.items()}
    told = [
        Case(simulator, name, options_of(name), measure, closed_form.LAWS.get(name))
        for simulator, by_law in measures.items()
        for name, measure in by_law.items()
    ]
    law = "CoulombStiction"
    untold = [
        Case(host, UNTOLD, options_of(law), partial(_stepped, run, law, fmus, told=False), closed_form.untold)
        for host, run in hosts.items()
    ]
    return told + untold
