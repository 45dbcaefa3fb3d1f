"""What the car is made to do: the road below each wheel, the steering, the speed. All numbers can be set."""

import math
from dataclasses import dataclass

from car_description import CarError

# Of a straight run before a manoeuvre begins, in s: the tyres find their rolling state.
RUN_IN = 0.5


@dataclass(frozen=True)
class Pose:
    """What a driver sees: time, position of the middle of the front axle, yaw, speed, yaw rate."""

    time: float
    x: float
    y: float
    yaw: float
    speed: float
    yaw_rate: float


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
    duration: float = 4.0
    name = "four-post"

    def road(self, corner: str, time: float, x: float) -> tuple[float, float]:  # noqa: ARG002
        omega = 2.0 * math.pi * self.frequency
        angle = omega * time - (self.lag if corner[0] == "r" else 0.0)
        if angle <= 0.0:
            return 0.0, 0.0
        return 0.5 * self.stroke * (1.0 - math.cos(angle)), 0.5 * self.stroke * omega * math.sin(angle)


@dataclass(frozen=True)
class StepSteer(Manoeuvre):
    """A turn of the steering wheel to an angle, in a quarter of a cosine."""

    speed: float = 15.0
    angle: float = math.radians(25.0)
    rise: float = 0.2
    duration: float = 4.0
    name = "step-steer"

    def steer(self, pose: Pose) -> float:
        passed = min(1.0, max(0.0, (pose.time - RUN_IN) / self.rise))
        return 0.5 * self.angle * (1.0 - math.cos(math.pi * passed))


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


MANOEUVRES = {kind.name: kind for kind in (FourPost, StepSteer, Kerb)}


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
