"""What the car is made to do: the road below each wheel, the steering, the speed. All numbers can be set."""

import math
from dataclasses import astuple, dataclass, replace
from functools import cached_property

from examples.car.car_description import CarError
from examples.fmpy.lane_change import Lane, lanes, way

# Of a straight run before a manoeuvre begins, in s: the tyres find their rolling state.
RUN_IN = 0.5
# Later than any run ends, in s.
NEVER = 1e9


@dataclass(frozen=True)
class Pose:
    """What a driver sees: time, position of the middle of the front axle, yaw, speed, yaw rate."""

    time: float
    x: float
    y: float
    yaw: float
    speed: float
    yaw_rate: float

    def ahead(self, before: "Pose", lead: float, step: float) -> "Pose":
        """What is expected after `lead`, from the present and from what was a step ago."""
        share = lead / step
        now, last = astuple(self), astuple(before)
        moved = (new + share * (new - old) for new, old in zip(now, last, strict=True))
        return replace(Pose(*moved), time=self.time + lead)


@dataclass(frozen=True)
class Manoeuvre:
    """A level road and a car that drives straight on; speed in m/s, 0 on posts."""

    speed: float = 0.0
    duration: float = 1.0
    name = "straight"

    def road(self, corner: str, time: float, x: float) -> tuple[float, float]:  # noqa: ARG002
        """Height of the road below a wheel at `x`, and how fast it rises there."""
        return 0.0, 0.0

    def steer(self, pose: Pose) -> float:  # noqa: ARG002
        """Angle of the steering wheel in rad, positive to the left."""
        return 0.0

    def brake(self, pose: Pose) -> float:  # noqa: ARG002
        """Torque of all brakes together in N m."""
        return 0.0

    def wanted_speed(self, pose: Pose) -> float | None:  # noqa: ARG002
        """Speed that the drive holds; None for a released accelerator, or none."""
        return self.speed or None


@dataclass(frozen=True)
class FourPost(Manoeuvre):
    """Posts that rise by `stroke` and return; those of the rear axle lag by an angle. The thesis has 40 mm; its lag is
    not known here."""

    stroke: float = 0.04
    frequency: float = 2.0
    lag: float = 0.5 * math.pi
    duration: float = 3.0
    name = "four-post"

    def road(self, corner: str, time: float, x: float) -> tuple[float, float]:  # noqa: ARG002
        omega = 2.0 * math.pi * self.frequency
        angle = omega * time - (self.lag if corner[0] == "r" else 0.0)
        if angle <= 0.0:
            return 0.0, 0.0
        return 0.5 * self.stroke * (1.0 - math.cos(angle)), 0.5 * self.stroke * omega * math.sin(angle)


def eased(time: float, rise: float) -> float:
    """0 before the time 0, 1 after the rise, half a period of a cosine between them."""
    passed = min(1.0, max(0.0, time / rise))
    return 0.5 * (1.0 - math.cos(math.pi * passed))


@dataclass(frozen=True)
class StepSteer(Manoeuvre):
    """A turn of the steering wheel to an angle, along half a period of a cosine."""

    speed: float = 15.0
    angle: float = math.radians(25.0)
    rise: float = 0.2
    duration: float = 4.0
    name = "step-steer"

    def steer(self, pose: Pose) -> float:
        return self.angle * eased(pose.time - RUN_IN, self.rise)


@dataclass(frozen=True)
class SineSteer(Manoeuvre):
    """Two periods of a sine of the steering wheel, the second one mirrored, with a pause between them: a lane change
    without a driver. Then the wheel is held straight. Angle, frequency and pause are those of the double-track car in
    examples/fmpy/lane_change.py, at the wheels."""

    speed: float = 20.0
    angle: float = math.radians(20.0)
    frequency: float = 0.9
    pause: float = 0.35
    duration: float = 6.0
    name = "sine-steer"

    def steer(self, pose: Pose) -> float:
        period = 1.0 / self.frequency
        for begin, sign in ((RUN_IN, 1.0), (RUN_IN + period + self.pause, -1.0)):
            passed = pose.time - begin
            if 0.0 < passed < period:
                return sign * self.angle * math.sin(2.0 * math.pi * self.frequency * passed)
        return 0.0


@dataclass(frozen=True)
class Braking(Manoeuvre):
    """Straight-line braking with a torque of all brakes together, which rises along half a period of a cosine."""

    speed: float = 20.0
    torque: float = 350.0
    rise: float = 0.1
    duration: float = 2.5
    name = "braking"

    def brake(self, pose: Pose) -> float:
        return self.torque * eased(pose.time - RUN_IN, self.rise)

    def wanted_speed(self, pose: Pose) -> float | None:
        return self.speed if pose.time < RUN_IN else None


@dataclass(frozen=True)
class ConstantRadius(Manoeuvre):
    """A circle to the left, entered along its tangent, with a speed that rises slowly; the driver steers in proportion
    to the distance from the circle ahead."""

    speed: float = 8.0
    radius: float = 25.0
    acceleration: float = 0.5
    duration: float = 12.0
    # Preview in s, and turn of the steering wheel per distance, in rad/m.
    preview: float = 0.3
    gain: float = 1.0
    name = "constant-radius"

    def steer(self, pose: Pose) -> float:
        ahead = self.preview * pose.speed
        # From the centre of the circle, to the left of where the run-in ends.
        x = pose.x + ahead * math.cos(pose.yaw) - self.speed * RUN_IN
        y = pose.y + ahead * math.sin(pose.yaw) - self.radius
        # Before its end the car keeps to the tangent.
        if x < 0.0 and y < 0.0 and pose.x < self.speed * RUN_IN:
            return -self.gain * (y + self.radius)
        return self.gain * (math.hypot(x, y) - self.radius)

    def wanted_speed(self, pose: Pose) -> float | None:
        return self.speed + self.acceleration * max(0.0, pose.time - 4.0 * RUN_IN)


@dataclass(frozen=True)
class Kerb(Manoeuvre):
    """A kerb below the left wheels: a bump of one period of a cosine."""

    speed: float = 10.0
    height: float = 0.03
    length: float = 0.5
    start: float = 10.0
    duration: float = 3.0
    name = "kerb"

    def road(self, corner: str, time: float, x: float) -> tuple[float, float]:  # noqa: ARG002
        passed = (x - self.start) / self.length
        if corner[1] != "l" or not 0.0 < passed < 1.0:
            return 0.0, 0.0
        phase = 2.0 * math.pi * passed
        slope = math.pi * self.height / self.length * math.sin(phase)
        return 0.5 * self.height * (1.0 - math.cos(phase)), slope * self.speed


@dataclass(frozen=True)
class LaneChange(Manoeuvre):
    """The obstacle avoidance of ISO 3888-2 with the track of its second edition (2011), driven by a driver who follows
    a path through the cones. The accelerator is released 2 m into the first lane; until then the drive holds the speed.
    """

    speed: float = 20.0
    width: float = 1.41
    duration: float = 5.0
    # Distance from the middle of the front axle to the first cones.
    approach: float = 12.0
    # The driver: preview in s, and turn of the steering wheel per distance from the path there, in rad/m.
    preview: float = 0.19
    gain: float = 1.4
    # Steering against the rate of yaw, in rad per rad/s.
    calm: float = 0.05
    # Where the path leaves a lane, in m before its end, and reaches the next one, in m after its beginning.
    leaving: float = 2.8
    arriving: float = 4.8
    # When the driver turns the wheel straight and holds it there, in s.
    release: float = NEVER
    name = "lane-change"

    @cached_property
    def lanes(self) -> list[Lane]:
        """The three lanes between cones."""
        return lanes(self.width, self.approach)

    def path(self, x: float) -> float:
        """Lateral position of the path."""
        return way(self.lanes, x, self.leaving, self.arriving)

    def steer(self, pose: Pose) -> float:
        if pose.time >= self.release:
            return 0.0
        distance = self.preview * pose.speed
        expected = pose.y + distance * math.sin(pose.yaw)
        aim = self.path(pose.x + distance * math.cos(pose.yaw))
        return self.gain * (aim - expected) - self.calm * pose.yaw_rate

    def wanted_speed(self, pose: Pose) -> float | None:
        return self.speed if pose.x < self.approach + 2.0 else None


MANOEUVRES = {kind.name: kind for kind in (FourPost, LaneChange, StepSteer, SineSteer, ConstantRadius, Braking, Kerb)}


def manoeuvre(name: str, **changes: float) -> Manoeuvre:
    """A manoeuvre by its name, with some of its numbers changed."""
    kind = MANOEUVRES[name]
    known = list(kind.__dataclass_fields__)
    for field, value in changes.items():
        if field not in known:
            raise CarError(f"{name} has no {field}; there are {', '.join(known)}")
        if not math.isfinite(value):
            raise CarError(f"{field} = {value}: must be finite")
    return kind(**changes)
