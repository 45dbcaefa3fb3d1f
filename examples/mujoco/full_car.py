#!/usr/bin/env python3
"""A car with four double wishbones in MuJoCo and four ShockAbsorber FMUs as its struts.

    python examples/mujoco/full_car.py --test four-post
    python examples/mujoco/full_car.py --test lane-change --law LuGre --set friction.scale=1.5

    --test four-post     the wheels stand on posts that move up and down, at the rear axle with a delay
           lane-change   at 72 km/h one lane to the left and back: a sine of the steering angle, a pause, its mirror

Each test is run with and without friction. Writes <out>_<test>.csv of each run, and <out>_<test>.png.

Tyres are forces: vertically a spring and damper that cannot pull; laterally springs and dampers on the posts, and the
Magic Formula with relaxation on the road; at the rear axle also a force that holds the speed. The wheels do not spin.
"""

import argparse
import math
import sys
from collections.abc import Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

import mujoco
import numpy
from tqdm import tqdm

sys.path.append(str(Path(__file__).resolve().parents[1] / "fmpy"))
sys.path.append(str(Path(__file__).resolve().parents[1] / "multibody"))

import mjcf
from coupling import main, positive, write_csv
from friction_pictures import Quantity, draw_runs
from hosted_strut import Strut, open_strut
from magic_formula import LateralTyre
from report import cases_of, steps_of, strut_options
from suspension import CORNERS, DOUBLE_WISHBONE, SPRUNG_MASS, TYRE, Body, strut_parameters

# Chosen: a medium-sized car whose corners carry the same mass as the quarter cars.
CAR = Body(4.0 * SPRUNG_MASS, (0.0, 0.0, 0.55), (480.0, 2100.0, 2300.0))
FRONT, REAR = 1.35, -1.35
SPEED = 20.0
LATERAL = LateralTyre()

# Contact patch on a post, chosen: stiff enough that the car does not drift.
PATCH_STIFFNESS, PATCH_DAMPING = 1.0e5, 1.0e3
# Force per deviation from the set speed, chosen.
CRUISE = 5.0e3

CAR_COLUMNS = {
    "time": "s",
    "position_x": "m",
    "position_y": "m",
    "heave": "m",
    "roll": "rad",
    "pitch": "rad",
    "yaw": "rad",
    "velocity_x": "m/s",
    "velocity_y": "m/s",
    "steering": "rad",
}
CORNER_COLUMNS = {"length": "m", "velocity": "m/s", "force": "N", "friction": "N", "tyre_load": "N"}

FRICTION = Quantity("fl.friction", "friction force, fl [N]")
FRONT_LEFT = [FRICTION, Quantity("fl.tyre_load", "tyre load, fl [kN]", 1e-3)]
DEGREES = 180.0 / math.pi
OVER_TIME = {
    "four-post": [Quantity("heave", "heave [mm]", 1e3), Quantity("pitch", "pitch [degrees]", DEGREES), *FRONT_LEFT],
    "lane-change": [Quantity("position_y", "path [m]"), Quantity("roll", "roll [degrees]", DEGREES), *FRONT_LEFT],
}
LOOPS = [
    (Quantity("fl.velocity", "velocity of the strut, fl [m/s]"), FRICTION),
    (Quantity("fl.length", "length of the strut, fl [mm]", 1e3), FRICTION),
]


@dataclass(frozen=True)
class FourPost:
    """Posts that move by (1 - cos)/2; the rear axle lags by an angle."""

    amplitude: float = 0.04
    frequency: float = 1.5
    lag: float = 0.5 * math.pi
    name = "four-post"

    def road(self, corner: str, time: float) -> tuple[float, float]:
        """Height and velocity of the post below a wheel."""
        omega = 2.0 * math.pi * self.frequency
        angle = omega * time - (self.lag if corner[0] == "r" else 0.0)
        if angle <= 0.0:
            return 0.0, 0.0
        return 0.5 * self.amplitude * (1.0 - math.cos(angle)), 0.5 * self.amplitude * omega * math.sin(angle)

    def steering(self, _time: float) -> float:
        """Angle of the front wheels."""
        return 0.0


@dataclass(frozen=True)
class LaneChange:
    """A sine of the steering, a pause, and the mirrored sine back."""

    angle: float = math.radians(2.2)
    frequency: float = 0.5
    start: float = 1.5
    pause: float = 0.5
    name = "lane-change"

    def road(self, _corner: str, _time: float) -> tuple[float, float]:
        """A flat road."""
        return 0.0, 0.0

    def steering(self, time: float) -> float:
        """Angle of the front wheels, positive to the left."""
        period = 1.0 / self.frequency
        for begin, sign in ((self.start, 1.0), (self.start + period + self.pause, -1.0)):
            if begin < time < begin + period:
                return sign * self.angle * math.sin(2.0 * math.pi * self.frequency * (time - begin))
        return 0.0


class Wheel:
    """One corner: the tyre's forces on the wheel and the measurements of the strut."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, name: str):
        self.model, self.data, self.name = model, data, name
        self.body = model.body(f"{name}.upright").id
        self.centre = model.site(f"{name}.wheel").id
        self.strut = model.tendon(f"{name}.strut").id
        self.actuator = model.actuator(f"{name}.strut").id
        x = FRONT if name[0] == "f" else REAR
        self.home = numpy.array(DOUBLE_WISHBONE.placed(x, 1.0 if name[1] == "l" else -1.0).wheel_centre)
        self.slip = 0.0
        self.load = 0.0

    def look(self) -> tuple[float, float]:
        """Length and velocity of the strut."""
        return float(self.data.ten_length[self.strut]), float(self.data.ten_velocity[self.strut])

    def roll_on(self, manoeuvre: FourPost | LaneChange, time: float, step: float) -> None:
        """Applies the forces of the tyre."""
        centre, velocity = self.data.site_xpos[self.centre], self.velocity()
        road = manoeuvre.road(self.name, time)
        self.load = TYRE.load(centre[2], velocity[2], *road)
        held = isinstance(manoeuvre, FourPost)
        along = self.held(centre, velocity) if held else self.rolling(velocity, step)
        force = numpy.array([*along, self.load])
        patch = numpy.array([centre[0], centre[1], road[0]])
        self.data.xfrc_applied[self.body, :3] = force
        self.data.xfrc_applied[self.body, 3:] = numpy.cross(patch - self.data.xipos[self.body], force)

    def velocity(self) -> numpy.ndarray:
        """Velocity of the centre of the wheel."""
        motion = numpy.empty(6)
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_SITE, self.centre, motion, 0)
        return motion[3:]

    def held(self, centre: numpy.ndarray, velocity: numpy.ndarray) -> numpy.ndarray:
        """Horizontal force on a wheel that stands on its post."""
        force = -PATCH_STIFFNESS * (centre - self.home) - PATCH_DAMPING * velocity
        return force[:2] if self.load > 0.0 else numpy.zeros(2)

    def rolling(self, velocity: numpy.ndarray, step: float) -> numpy.ndarray:
        """Horizontal force on a wheel that rolls."""
        ahead = self.data.xmat[self.body].reshape(3, 3)[:2, 0]
        ahead = ahead / numpy.linalg.norm(ahead)
        left = numpy.array([-ahead[1], ahead[0]])
        forward, sideways = float(velocity[:2] @ ahead), float(velocity[:2] @ left)
        self.slip = LATERAL.relaxed(self.slip, math.atan2(sideways, abs(forward)), abs(forward) * step)
        drive = 0.5 * CRUISE * (SPEED - forward) if self.name[0] == "r" and self.load > 0.0 else 0.0
        return LATERAL.force(self.slip, self.load) * left + drive * ahead


class FullCar:
    """The model with its four wheels."""

    def __init__(self, step: float, manoeuvre: FourPost | LaneChange):
        text = mjcf.full_car(CAR, FRONT, REAR, DOUBLE_WISHBONE, step)
        self.model = mujoco.MjModel.from_xml_string(text)
        self.data = mujoco.MjData(self.model)
        self.step, self.manoeuvre = step, manoeuvre
        self.wheels = [Wheel(self.model, self.data, name) for name in CORNERS]
        self.car = self.model.body("car").id
        self.rack = self.model.equality("rack").id
        # Distance of the tie rod from the steering axis, which passes through both ball joints.
        s = DOUBLE_WISHBONE
        share = (s.tie_rod_end[2] - s.lower_ball[2]) / (s.upper_ball[2] - s.lower_ball[2])
        self.steering_arm = s.lower_ball[0] + share * (s.upper_ball[0] - s.lower_ball[0]) - s.tie_rod_end[0]
        if isinstance(manoeuvre, LaneChange):
            self.data.qvel[0] = SPEED

    def advance(self, struts: list[Strut], time: float) -> list[float]:
        """One step; returns the values for the columns of the table at its beginning."""
        mujoco.mj_step1(self.model, self.data)
        angle = self.manoeuvre.steering(time)
        # The rack is behind the axle: moving it to the right steers to the left.
        self.model.eq_data[self.rack, 0] = -self.steering_arm * angle
        row = [time, *self.pose(), angle]
        for wheel, strut in zip(self.wheels, struts, strict=True):
            length, velocity = wheel.look()
            force = strut.advance(length, velocity, self.step)
            self.data.ctrl[wheel.actuator] = force
            wheel.roll_on(self.manoeuvre, time, self.step)
            row += [length, velocity, force, strut.friction(), wheel.load]
        mujoco.mj_step2(self.model, self.data)
        return row

    def pose(self) -> list[float]:
        """Position, angles and velocity of the body: positive roll lifts the left side, positive pitch lowers the
        nose."""
        turned = self.data.xmat[self.car].reshape(3, 3)
        x, y, z = self.data.xipos[self.car]
        roll = math.atan2(turned[2, 1], turned[2, 2])
        pitch = math.asin(-turned[2, 0])
        yaw = math.atan2(turned[1, 0], turned[0, 0])
        return [x, y, z - CAR.centre[2], roll, pitch, yaw, *self.data.qvel[:2]]


def columns() -> list[str]:
    """Headings of the table, with units."""
    corners = [f"{name}.{quantity} [{unit}]" for name in CORNERS for quantity, unit in CORNER_COLUMNS.items()]
    return [f"{name} [{unit}]" for name, unit in CAR_COLUMNS.items()] + corners


def simulate(
    parameters: Mapping[str, object], label: str, manoeuvre: FourPost | LaneChange, step: float, time: float, **where
) -> dict[str, numpy.ndarray]:
    """One run with four struts; the columns of its table by name."""
    car = FullCar(step, manoeuvre)
    with ExitStack() as stack:
        struts = [stack.enter_context(open_strut(parameters, DOUBLE_WISHBONE.length(), **where)) for _ in CORNERS]
        steps = tqdm(steps_of(time, step), desc=label, unit="step", leave=False, disable=None)
        rows = [car.advance(struts, at * step) for at in steps]
    return dict(zip([heading.split()[0] for heading in columns()], numpy.array(rows).T, strict=True))


def lateral_acceleration(run: Mapping[str, numpy.ndarray]) -> numpy.ndarray:
    """Acceleration of the body to its left."""
    rates = [numpy.gradient(run[name], run["time"]) for name in ("velocity_x", "velocity_y")]
    return rates[1] * numpy.cos(run["yaw"]) - rates[0] * numpy.sin(run["yaw"])


def summary(run: Mapping[str, numpy.ndarray], manoeuvre: FourPost | LaneChange) -> str:
    """The figures of a run."""
    if isinstance(manoeuvre, FourPost):
        settled = run["time"] > run["time"][-1] - 2.0 / manoeuvre.frequency
        heave, pitch = (numpy.ptp(run[name][settled]) for name in ("heave", "pitch"))
        return f"heave {1e3 * heave:.2f} mm, pitch {math.degrees(pitch):.3f} degrees, peak to peak"
    before = run["roll"][run["time"] < manoeuvre.start][-1]
    roll = numpy.degrees(run["roll"] - before)
    return (
        f"largest roll {numpy.abs(roll).max():.3f} degrees, at the end {roll[-1]:.4f} degrees, "
        f"lane {run['position_y'].max():.2f} m, "
        f"lateral acceleration {numpy.abs(lateral_acceleration(run)).max():.2f} m/s^2"
    )


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = strut_options(__doc__, out="out/mujoco")
    parser.add_argument("--test", choices=("four-post", "lane-change"), default="four-post")
    parser.add_argument("--time", type=positive, help="simulated time in s (default: 5 on the posts, 8 on the road)")
    return parser.parse_args()


def program() -> None:
    """Runs the simulations selected on the command line."""
    options = arguments()
    manoeuvre, time = {"four-post": (FourPost(), 5.0), "lane-change": (LaneChange(), 8.0)}[options.test]
    runs = {}
    for label, parameters in cases_of(options, strut_parameters(DOUBLE_WISHBONE)).items():
        where = {"native": options.native, "fmus": options.fmus}
        run = simulate(parameters, label, manoeuvre, options.step, options.time or time, **where)
        table = Path(f"{options.out}_{options.test}_{label.replace(' ', '_')}.csv")
        write_csv(table, dict(zip(columns(), run.values(), strict=True)))
        print(f"{label}: {summary(run, manoeuvre)}\n{table}")
        runs[label] = run
    picture = Path(f"{options.out}_{options.test}.png")
    title = f"Full car in MuJoCo, {options.test}, {options.law}"
    draw_runs(title, runs, OVER_TIME[options.test], LOOPS, picture)
    print(picture)


if __name__ == "__main__":
    sys.exit(main(program))
