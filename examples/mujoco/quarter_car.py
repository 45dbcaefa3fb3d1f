#!/usr/bin/env python3
"""A quarter car in MuJoCo with the ShockAbsorber FMU as its strut.

    python examples/mujoco/quarter_car.py --set friction.scale=0.5 --step 5e-4

The car stands until it has come to rest, then the wheel runs over a bump of 5 cm. Every run is made with friction and
without it, unless --no-friction asks for the latter alone. Writes <out>.csv, <out>.png.

    --suspension double-wishbone   the strut is a force between body and lower arm (default)
                 telescope         the same; tube and rod have mass and hang in universal joints
                 macpherson        the tube is bolted to the upright: real side loads
                 guided            the wheel slides in a straight guide: the quarter car of textbooks

With --side-loads the reaction between tube and rod, as MuJoCo computes it, goes into the FMU: friction grows with it.
"""

import sys
from collections.abc import Mapping
from pathlib import Path

import mujoco
import numpy
from tqdm import tqdm

sys.path.append(str(Path(__file__).resolve().parents[1] / "fmpy"))
sys.path.append(str(Path(__file__).resolve().parents[1] / "multibody"))

import mjcf
from coupling import main
from report import Recorder, Run, cases_of, quarter_car_options, report_quarter_car
from hosted_strut import UNLOADED, Strut, Wrench, open_strut
from suspension import BUMP, DOUBLE_WISHBONE, GUIDED, MACPHERSON, TYRE, Bump, Tyre, strut_parameters

SUSPENSIONS = {
    "double-wishbone": (DOUBLE_WISHBONE, mjcf.double_wishbone),
    "telescope": (DOUBLE_WISHBONE, lambda name, s: mjcf.double_wishbone(name, s, telescopic=True)),
    "macpherson": (MACPHERSON, mjcf.macpherson),
    "guided": (GUIDED, mjcf.guided),
}


class QuarterCar:
    """The model, and what is read from it and written to it at each communication point."""

    def __init__(self, kind: str, step: float, tyre: Tyre):
        self.suspension, build = SUSPENSIONS[kind]
        parts = build("fl", self.suspension)
        self.model = mujoco.MjModel.from_xml_string(mjcf.quarter_car(self.suspension, parts, step))
        self.data = mujoco.MjData(self.model)
        self.tyre = tyre
        self.wheel = self.model.body("fl.upright").id
        self.centre = self.model.site("fl.wheel").id
        self.strut = self.model.tendon("fl.strut").id
        self.telescopic = bool(parts.sensors)

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
        """Reaction of the tube on the rod, which MuJoCo has computed in the step before."""
        if not self.telescopic:
            return UNLOADED
        # The sensors give what the outer body, here the tube, does to the inner one that carries them.
        return Wrench.in_rod_eye(self.data.sensor("fl.force").data, self.data.sensor("fl.torque").data, length)

    def move(self, force: float, road: tuple[float, float]) -> None:
        """Goes one step ahead with a force of the strut."""
        load = self.tyre.load(*self.wheel_motion(), *road)
        arm = self.data.site_xpos[self.centre] - self.data.xipos[self.wheel]
        self.data.xfrc_applied[self.wheel] = [0.0, 0.0, load, *numpy.cross(arm, (0.0, 0.0, load))]
        self.data.ctrl[0] = force
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
    bump: Bump = BUMP,
    tyre: Tyre = TYRE,
) -> Run:
    """Drives over the bump."""
    steps = round(time / step)
    car = QuarterCar(kind, step, tyre)
    recorder = Recorder()
    for at in tqdm(range(steps), desc=label, unit="step", leave=False, disable=None):
        length, velocity = car.look()
        road = bump.at(at * step)
        force = strut.advance(length, velocity, step, car.wrench(length) if side_loads else UNLOADED)
        normal_1, normal_2 = strut.contact_loads()
        recorder.add(
            time=at * step,
            road_height=road[0],
            body_height=car.body_height(),
            wheel_height=car.wheel_motion()[0] - car.suspension.wheel_centre[2],
            length=length,
            velocity=velocity,
            force=force,
            friction=strut.friction(),
            normal_1=normal_1,
            normal_2=normal_2,
        )
        car.move(force, road)
    return recorder.run(label, car.suspension.length())


def program() -> None:
    """Runs what the command line asks for."""
    parser = quarter_car_options(__doc__, out="out/mujoco_quarter_car")
    parser.add_argument("--suspension", choices=SUSPENSIONS, default="double-wishbone")
    parser.add_argument("--side-loads", action="store_true", help="feed the reaction between tube and rod to the strut")
    options = parser.parse_args()
    suspension = SUSPENSIONS[options.suspension][0]

    def case(label: str, parameters: Mapping[str, object]) -> Run:
        with open_strut(parameters, suspension.length(), options.native, options.fmus) as strut:
            return simulate(strut, label, options.suspension, options.step, options.time, options.side_loads)

    cases = cases_of(options, strut_parameters(suspension))
    runs = [case(label, parameters) for label, parameters in cases.items()]
    report_quarter_car(f"Quarter car in MuJoCo, {options.suspension}, {options.law}", runs, options.out)


if __name__ == "__main__":
    sys.exit(main(program))
