"""Friction of MuJoCo: of contacts, and of a joint."""

from functools import partial

import mujoco
import numpy

from examples.multibody.creep.closed_form import mujoco_joint
from examples.multibody.creep.slope import CENTRE, FEET, FOOT, INERTIA, MASS, MU, STEP, Case, Slope

VERSION = mujoco.__version__

CONTACT_OPTIONS = {
    'cone="pyramidal" impratio="1" (default)': ("", ""),
    'cone="pyramidal", noslip_iterations="10"': ('noslip_iterations="10"', ""),
    'cone="elliptic" impratio="1"': ('cone="elliptic"', ""),
    'cone="elliptic" impratio="100"': ('cone="elliptic" impratio="100"', ""),
    'cone="elliptic" impratio="1" noslip_iterations="10"': ('cone="elliptic" noslip_iterations="10"', ""),
    'cone="elliptic" impratio="1", solref="0.002 1"': ('cone="elliptic"', 'solref="0.002 1"'),
    'cone="elliptic" impratio="1", solimp="0.99 0.99 0.001"': ('cone="elliptic"', 'solimp="0.99 0.99 0.001"'),
}
# With the time constant in s and the impedances, at rest and beyond the width.
JOINT_OPTIONS = {
    'solreffriction="0.02 1" solimpfriction="0.9 0.95 0.001" (default)': ("", 0.02, 0.9, 0.95),
    'solreffriction="0.002 1"': ('solreffriction="0.002 1"', 0.002, 0.9, 0.95),
    'solimpfriction="0.9999 0.9999 0.001"': ('solimpfriction="0.9999 0.9999 0.001"', 0.02, 0.9999, 0.9999),
}


def run(option: str, contact: str, body: str, slope: Slope, steps: int) -> numpy.ndarray:
    """Positions of a body on the plane z = 0; everything that is not named is MuJoCo's default. Both sides of a contact
    have the same options: MuJoCo averages them."""
    gravity = " ".join(map(repr, slope.gravity))
    model = mujoco.MjModel.from_xml_string(
        f'<mujoco><option timestep="{STEP}" gravity="{gravity}" {option}/>'
        f'<default><geom friction="{MU} 0 0" {contact}/></default>'
        f'<worldbody><geom type="plane" size="5 5 1"/>{body}</worldbody></mujoco>'
    )
    data = mujoco.MjData(model)
    positions = numpy.zeros(steps + 1)
    for at in range(steps):
        mujoco.mj_step(model, data)
        positions[at + 1] = data.qpos[0]
    return positions


def mass_at(height: float) -> str:
    """Mass and moments of inertia of the block."""
    moments = " ".join(map(repr, INERTIA))
    return f'<inertial pos="0 0 {height}" mass="{MASS}" diaginertia="{moments}"/>'


def on_feet(option: str, contact: str, slope: Slope, steps: int) -> numpy.ndarray:
    """The free block on its feet."""
    feet = "".join(f'<geom type="sphere" size="{FOOT}" pos="{x} {y} {z}"/>' for x, y, z in FEET)
    return run(option, contact, f"<body><freejoint/>{mass_at(CENTRE)}{feet}</body>", slope, steps)


def on_joint(joint: str, slope: Slope, steps: int) -> numpy.ndarray:
    """A body on a slide joint with a friction loss of the level of the block."""
    slide = f'<joint type="slide" axis="1 0 0" frictionloss="{slope.level!r}" {joint}/>'
    return run("", "", f"<body>{slide}{mass_at(0.0)}</body>", slope, steps)


def cases() -> list[Case]:
    """The options that change creep, one after the other."""
    contacts = [
        Case("MuJoCo", "contacts", text, partial(on_feet, option, contact))
        for text, (option, contact) in CONTACT_OPTIONS.items()
    ]
    joints = [
        Case("MuJoCo", "`frictionloss` of a joint", text, partial(on_joint, joint), partial(mujoco_joint, *numbers))
        for text, (joint, *numbers) in JOINT_OPTIONS.items()
    ]
    return contacts + joints
