"""Cars on their struts as plain differential equations, solved by scipy: an independent reference for the hosts.

There are no steps or exchanges: body, wheels, tyres and the bristles of a lumped LuGre friction are one system of
equations, integrated at tight tolerances. Heights are deviations from rest. Axes of ISO 8855: pitch nose down, roll
right side down, corner height z - X pitch + Y roll.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy
from scipy.integrate import solve_ivp
from strut import DEFAULTS, Strut, lumped_friction

GRAVITY = 9.81
REST_LENGTH = 0.1775


@dataclass(frozen=True)
class Car:
    """A body on corners with a strut, a wheel and a tyre each; the defaults that differ per corner are arrays.

    The height of corner k is row k of `corners` times the body's coordinates, whose inertias are `inertia`.
    """

    corners: numpy.ndarray
    inertia: numpy.ndarray
    motion_ratio: numpy.ndarray
    struts: list[Strut]
    tyre_load: numpy.ndarray
    wheel_mass: float = 16.36
    tyre_stiffness: float = 87563.5
    tyre_damping: float = 95.8

    def strut_forces(self, travel: numpy.ndarray, rate: numpy.ndarray) -> numpy.ndarray:
        """Additional strut forces compared with rest, without friction; travel of the body above the wheels."""
        lengths, velocities = REST_LENGTH + self.motion_ratio * travel, self.motion_ratio * rate
        pairs = zip(self.struts, lengths, velocities, strict=True)
        moving = [sum(strut.elastic(length, velocity).values()) for strut, length, velocity in pairs]
        return numpy.array(moving) - [sum(strut.elastic(REST_LENGTH, 0.0).values()) for strut in self.struts]

    def tyre_forces(self, gap: numpy.ndarray, gap_rate: numpy.ndarray) -> numpy.ndarray:
        """Tyre loads for a road that is `gap` closer to the wheels."""
        return numpy.maximum(0.0, self.tyre_load + self.tyre_stiffness * gap + self.tyre_damping * gap_rate)


def friction(level: float, velocity: numpy.ndarray, deflection: numpy.ndarray) -> tuple[numpy.ndarray, numpy.ndarray]:
    """LuGre friction of a kinetic level, with a static one 1.3 times as high, and the rate of its bristles."""
    if level == 0.0:
        return numpy.zeros_like(velocity), numpy.zeros_like(velocity)
    p = DEFAULTS
    yielding = level * (1.0 + 0.3 * numpy.exp(-((velocity / p["friction.stribeck_velocity"]) ** 2)))
    rate = velocity - p["friction.sigma_0"] * abs(velocity) * deflection / yielding
    viscous = p["friction.viscous_coefficient"] * velocity
    return p["friction.sigma_0"] * deflection + p["friction.sigma_1"] * rate + viscous, rate


@dataclass(frozen=True)
class Solution:
    """Sampled motion; one column per coordinate or corner."""

    time: numpy.ndarray
    body: numpy.ndarray
    wheels: numpy.ndarray
    travel: numpy.ndarray
    velocity: numpy.ndarray
    friction: numpy.ndarray
    tyre_load: numpy.ndarray
    extra: numpy.ndarray = field(default_factory=lambda: numpy.empty((0, 0)))


# Heights and their rates at all corners.
Road = Callable[[float], tuple[numpy.ndarray, numpy.ndarray]]


def _pieces(car: Car, state: numpy.ndarray) -> list[numpy.ndarray]:
    """Parts of a state: body, its rates, wheels, their rates, bristles, states of a lateral model."""
    body, wheels = len(car.inertia), len(car.motion_ratio)
    return numpy.split(state, numpy.cumsum([body, body, wheels, wheels, wheels]))


def solve(car: Car, road: Road, level: float, times: numpy.ndarray, plane=None, longest: float = 2e-3) -> Solution:
    """Solves the motion from rest; `plane` is the motion of the car in the plane of the road."""

    def forces(time, state):
        body, body_rate, wheels, wheel_rate, bristles, _ = _pieces(car, state)
        height, height_rate = road(time)
        travel, rate = car.corners @ body - wheels, car.corners @ body_rate - wheel_rate
        resistance, bristle_rate = friction(level, car.motion_ratio * rate, bristles)
        push = car.motion_ratio * (car.strut_forces(travel, rate) - resistance)
        loads = car.tyre_forces(height - wheels, height_rate - wheel_rate)
        return travel, rate, resistance, bristle_rate, push, loads

    def rates(time, state):
        body, body_rate, _, wheel_rate, _, rest = _pieces(car, state)
        _, _, _, bristle_rate, push, loads = forces(time, state)
        moments, lifts, rest_rate = plane.act(time, body, rest, loads) if plane else (0.0, 0.0, rest)
        body_acceleration = (car.corners.T @ push + moments) / car.inertia
        wheel_acceleration = (loads - car.tyre_load - push + lifts) / car.wheel_mass
        return numpy.concatenate(
            (body_rate, body_acceleration, wheel_rate, wheel_acceleration, bristle_rate, rest_rate)
        )

    start = numpy.zeros(2 * len(car.inertia) + 3 * len(car.motion_ratio))
    start = numpy.concatenate((start, numpy.zeros(8) if plane else []))
    solved = solve_ivp(rates, (0.0, times[-1]), start, "LSODA", times, rtol=1e-7, atol=1e-9, max_step=longest)
    assert solved.success, solved.message
    states = solved.y.T
    pieces = [_pieces(car, state) for state in states]
    seen = [forces(time, state) for time, state in zip(times, states, strict=True)]
    travel, rate, resistance, _, _, loads = (numpy.array(column) for column in zip(*seen, strict=True))
    return Solution(
        time=times,
        body=numpy.array([piece[0] for piece in pieces]),
        wheels=numpy.array([piece[2] for piece in pieces]),
        travel=travel,
        velocity=car.motion_ratio * rate,
        friction=resistance,
        tyre_load=loads,
        extra=numpy.array([piece[5] for piece in pieces]),
    )


def quarter_car(**strut) -> Car:
    """The front corner of the set FS-ref."""
    return Car(
        corners=numpy.ones((1, 1)),
        inertia=numpy.array([52.91]),
        motion_ratio=numpy.array([1.011]),
        struts=[Strut(lumped_friction(0.0) | strut)],
        tyre_load=numpy.array([GRAVITY * (52.91 + 16.36)]),
    )


# Positions of the corners fl, fr, rl, rr before and left of the body's centre of mass: wheelbase 1.528 m, tracks 1.22
# and 1.20 m; the body's mass is the load of the axles less the wheels, 2 x 52.91 kg in front and 2 x 58.69 kg behind.
FRONT_MASS, REAR_MASS, WHEELBASE = 2 * 52.91, 2 * 58.69, 1.528
X = WHEELBASE * numpy.array([REAR_MASS, REAR_MASS, -FRONT_MASS, -FRONT_MASS]) / (FRONT_MASS + REAR_MASS)
Y = numpy.array([0.61, -0.61, 0.60, -0.60])
CAR_FRONT = (FRONT_MASS + 2 * 16.36) / (FRONT_MASS + REAR_MASS + 4 * 16.36)


def four_post_car(**strut) -> Car:
    """The whole car of the set FS-ref: coordinates heave, pitch, roll."""
    parameters = lumped_friction(0.0) | strut
    front, rear = Strut(parameters | {"spring.k": 45000.0}), Strut(parameters | {"spring.k": 35000.0})
    return Car(
        corners=numpy.column_stack((numpy.ones(4), -X, Y)),
        inertia=numpy.array([FRONT_MASS + REAR_MASS, 126.29, 26.46]),
        motion_ratio=numpy.array([1.011, 1.011, 1.004, 1.004]),
        struts=[front, front, rear, rear],
        tyre_load=GRAVITY * (numpy.repeat([FRONT_MASS, REAR_MASS], 2) / 2.0 + 16.36),
    )


NO_ROAD = (numpy.zeros(4), numpy.zeros(4))


def magic_formula(side_slip: numpy.ndarray, load: numpy.ndarray) -> numpy.ndarray:
    """Lateral force of the tyres fl, fr, rl, rr: the open set for a nominal load of 700 N, without its shifts."""
    nominal, shape = 700.0, 1.5
    change = load / nominal - 1.0
    friction_peak = (1.2 - 0.09 * change) * load
    stiffness = -75.5 * nominal * numpy.sin(2.0 * numpy.arctan(load / (4.65 * nominal)))
    # The set was measured on a left tyre; the right ones are its mirror image.
    lean = 0.05 * numpy.array([1.0, -1.0, 1.0, -1.0]) * numpy.sign(side_slip)
    curvature = numpy.minimum(1.0, (0.1 - 1.2 * change) * (1.0 - lean))
    slip = stiffness / (shape * numpy.maximum(friction_peak, 1e-9)) * side_slip
    return friction_peak * numpy.sin(shape * numpy.arctan(slip - curvature * (slip - numpy.arctan(slip))))


@dataclass(frozen=True)
class Plane:
    """A steered car at constant speed; its state is y, yaw, lateral velocity, yaw rate and four side slips.

    The lateral force of an axle acts on the body at the roll centre, and its remaining moment tilts the axle.
    """

    steering: Callable[[float], float]
    speed: float = 20.0

    def act(self, time: float, body: numpy.ndarray, state: numpy.ndarray, loads: numpy.ndarray):
        """Moments on the body, forces on the wheels, and the rates of the state."""
        mass, wheel_mass, yaw_inertia, relaxation = FRONT_MASS + REAR_MASS + 4 * 16.36, 16.36, 142.92, 0.2
        # From the centre of mass of the whole car, wheels included, which carries 48 % on the front axle.
        ahead = WHEELBASE * numpy.repeat([1.0 - CAR_FRONT, -CAR_FRONT], 2)
        _, yaw, lateral_velocity, yaw_rate = state[:4]
        steered = self.steering(time) * numpy.array([1.0, 1.0, 0.0, 0.0])
        wanted = numpy.arctan((lateral_velocity + ahead * yaw_rate) / self.speed) - steered
        forces = magic_formula(state[4:], loads)
        acceleration, turning = forces.sum() / mass, ahead @ forces / yaw_inertia
        inertial = 2.0 * wheel_mass * (acceleration + ahead[[0, 2]] * turning)
        on_body = forces.reshape(2, 2).sum(axis=1) - inertial
        body_height, centres, wheel_height = 0.3203, numpy.array([0.035, 0.050]), 0.2
        axis = centres[0] + (centres[1] - centres[0]) * X[0] / WHEELBASE
        gravity = (FRONT_MASS + REAR_MASS) * GRAVITY * (body_height - axis) * body[2]
        roll_moment = on_body @ (body_height - centres) + gravity
        tilting = (on_body * centres + inertial * wheel_height) / (2.0 * Y[[0, 2]])
        rates = [
            self.speed * numpy.sin(yaw) + lateral_velocity * numpy.cos(yaw),
            yaw_rate,
            acceleration - self.speed * yaw_rate,
            turning,
            *(self.speed / relaxation * (wanted - state[4:])),
        ]
        return numpy.array([0.0, 0.0, roll_moment]), numpy.repeat(tilting, 2) * [1, -1, 1, -1], rates


def sine_road(frequency: float, amplitude: float) -> Road:
    """A road that rises and falls under one wheel."""
    angular = 2.0 * numpy.pi * frequency
    return lambda time: (
        numpy.array([amplitude * numpy.sin(angular * time)]),
        numpy.array([amplitude * angular * numpy.cos(angular * time)]),
    )


def posts(frequency: float, stroke: float, delay: float) -> Road:
    """Four posts that rise by `stroke` and return; the rear ones delayed by the angle `delay`."""
    angular, phases = 2.0 * numpy.pi * frequency, numpy.array([0.0, 0.0, delay, delay])
    return lambda time: (
        0.5 * stroke * (1.0 - numpy.cos(angular * time - phases)),
        0.5 * stroke * angular * numpy.sin(angular * time - phases),
    )


def fundamental(time: numpy.ndarray, signal: numpy.ndarray, frequency: float) -> float:
    """Amplitude of the first harmonic over whole periods of equally spaced samples, without the last one."""
    return 2.0 * abs(numpy.mean((signal * numpy.exp(-2j * numpy.pi * frequency * time))[:-1]))
