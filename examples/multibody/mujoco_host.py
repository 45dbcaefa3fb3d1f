"""The quarter car in MuJoCo, and its coupling with a strut."""

import mujoco
import numpy
from tqdm import tqdm

from examples.multibody import mjcf
from examples.multibody.hosted_strut import UNLOADED, Strut, Wrench
from examples.multibody.report import Recorder, Run, steps_of
from examples.multibody.suspension import BUMP, SUSPENSIONS, TYRE, Suspension

BUILDERS = {
    "double-wishbone": mjcf.double_wishbone,
    "telescope": lambda name, s: mjcf.double_wishbone(name, s, telescopic=True),
    "macpherson": mjcf.macpherson,
    "guided": mjcf.guided,
}


class QuarterCar:
    """The model, and the values read from it and written to it at each communication point."""

    def __init__(self, suspension: Suspension, parts: mjcf.Parts, step: float):
        self.suspension = suspension
        self.model = mujoco.MjModel.from_xml_string(mjcf.quarter_car(suspension, parts, step))
        self.data = mujoco.MjData(self.model)
        self.wheel = self.model.body("fl.upright").id
        self.centre = self.model.site("fl.wheel").id
        self.strut = self.model.tendon("fl.strut").id

    def look(self) -> tuple[float, float]:
        """Length and velocity of the strut in the current position."""
        mujoco.mj_step1(self.model, self.data)
        return float(self.data.ten_length[self.strut]), float(self.data.ten_velocity[self.strut])

    def wheel_motion(self) -> tuple[float, float]:
        """Height and vertical velocity of the centre of the wheel."""
        motion = numpy.empty(6)
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_SITE, self.centre, motion, 0)
        return float(self.data.site_xpos[self.centre, 2]), float(motion[5])

    def wrench(self, length: float) -> Wrench:
        """Reaction of the tube on the rod, which MuJoCo computed in the previous step."""
        if self.model.nsensor == 0:
            return UNLOADED
        # The sensors give the action of the outer body, here the tube, on the inner one that carries them.
        return Wrench.in_rod_eye(self.data.sensor("fl.force").data, self.data.sensor("fl.torque").data, length)

    def push(self, force: float) -> None:
        """Sets the force of the strut."""
        self.data.ctrl[0] = force

    def move(self, time: float) -> None:
        """Makes one step, with the road below the wheel at a time."""
        load = TYRE.load(*self.wheel_motion(), *BUMP.at(time))
        arm = self.data.site_xpos[self.centre] - self.data.xipos[self.wheel]
        self.data.xfrc_applied[self.wheel] = [0.0, 0.0, load, *numpy.cross(arm, (0.0, 0.0, load))]
        mujoco.mj_step2(self.model, self.data)

    def body_height(self) -> float:
        """Deviation of the body from the design position."""
        return float(self.data.qpos[0])


def simulate(
    strut: Strut,
    label: str,
    kind: str = "double-wishbone",
    step: float = 1e-3,
    time: float = 4.0,
    side_loads: bool = False,
) -> Run:
    """Drives over the bump."""
    suspension = SUSPENSIONS[kind]
    car = QuarterCar(suspension, BUILDERS[kind]("fl", suspension), step)
    recorder = Recorder()
    for at in tqdm(steps_of(time, step), desc=label, unit="step", leave=False, disable=None):
        length, velocity = car.look()
        force = strut.advance(length, velocity, step, car.wrench(length) if side_loads else UNLOADED)
        recorder.add(
            strut,
            time=at * step,
            body_height=car.body_height(),
            wheel_height=car.wheel_motion()[0] - suspension.wheel_centre[2],
            length=length,
            velocity=velocity,
            force=force,
        )
        car.push(force)
        car.move(at * step)
    return recorder.run(label, suspension.length())
