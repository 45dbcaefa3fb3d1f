"""The car in motion: once per step, struts and tyres are evaluated for the time for which the simulator takes a load.

MuJoCo takes a load as that at the beginning of a step. The generalised-alpha method of exudyn takes it as that at the
end: there struts and tyres are evaluated for the motion predicted from position, velocity and acceleration. A load of
the beginning would lag by a whole step.
"""

import math
import time
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import exudyn
import numpy

from examples.car.car_description import CORNERS, Car, CarError, is_left
from examples.car.car_energy import Acting, Ledger, Works
from examples.car.car_rest import Rest, relax, settle
from examples.car.car_struts import READINGS, open_struts, parameters_of
from examples.car.car_tyres import Carrier, RollingTyre, StandingTyre, read_tyre, touch
from examples.car.exudyn_car import ExudynCar, steps_of
from examples.car.manoeuvres import Manoeuvre, Pose
from examples.car.mujoco_car import MujocoCar
from examples.fmpy.coupling import FMUS
from examples.multibody.hosted_strut import Wrench

CAR_COLUMNS = {
    "time": "s",
    "x": "m",
    "y": "m",
    "heave": "m",
    "roll": "rad",
    "pitch": "rad",
    "yaw": "rad",
    "speed": "m/s",
    "lateral_velocity": "m/s",
    "yaw_rate": "rad/s",
    "front_x": "m",
    "front_y": "m",
    "steering_wheel": "rad",
    "rack": "m",
}
CORNER_COLUMNS = {
    "length": "m",
    "velocity": "m/s",
    "force": "N",
    "friction": "N",
    "friction_1": "N",
    "friction_2": "N",
    "normal_1": "N",
    "normal_2": "N",
    "force_damper": "N",
    "friction_torque": "N.m",
    "rod_force": "N",
    "mount": "m",
    "force_x": "N",
    "force_y": "N",
    "load": "N",
    "road": "m",
}
COLUMNS = [*CAR_COLUMNS, *(f"{name}.{column}" for name in CORNERS for column in CORNER_COLUMNS)]

EXUDYN, MUJOCO = "exudyn", "mujoco"

# Torque of the drive per deviation from the wanted speed, on both rear wheels together, in N m s/m (chosen).
CRUISE = 300.0
# Fastest turn of the steering wheel, in rad/s, and time constant of the arms of the driver in s (chosen).
FASTEST_TURN = math.radians(1000.0)
ARMS = 0.04
# Longest step on the road in s: slip and spin of a wheel exchange their energy at up to 170 rad/s, and the tyre's force
# is held over a step. With 2 ms it rocks itself up.
LONGEST_STEP = 1.25e-3
# Side load beyond which a run is given up, in N or N m: 35 times the weight of the car.
LARGEST_SIDE_LOAD = 1e5
# Stiffness of the parking brake on posts, in N m/rad.
PARKED = 2.0e3


@dataclass(frozen=True)
class Run:
    """A computed motion: columns by name, one entry per step."""

    label: str
    columns: Mapping[str, numpy.ndarray]
    rest: Rest
    works: Works | None
    iterations: int
    seconds: float
    strut_seconds: float
    step: float

    def __getitem__(self, column: str) -> numpy.ndarray:
        return self.columns[column]


def columns_with_units(run: Run) -> dict[str, numpy.ndarray]:
    """The columns of a CSV file."""
    units = {**CAR_COLUMNS, **{f"{name}.{column}": unit for name in CORNERS for column, unit in CORNER_COLUMNS.items()}}
    return {f"{name} [{units[name]}]": values for name, values in run.columns.items()}


def side_load(name: str, now: float, wrench: Wrench) -> Wrench:
    """A wrench that a joint of this car can have: beyond, strut and car have rocked each other up."""
    largest = max(map(abs, (wrench.force_m, wrench.force_n, wrench.moment_m, wrench.moment_n)))
    if not largest <= LARGEST_SIDE_LOAD:
        seen = f"side load of {largest:g} N or N.m: must be at most {LARGEST_SIDE_LOAD:.0f} N; try a smaller step"
        raise CarError(f"{name} at {now:.4f} s: {seen}")
    return wrench


@dataclass(frozen=True)
class Seen:
    """Motion of a corner at the beginning of a step: length of the strut and its rate, wheel, spin of the rod in the
    tube."""

    length: float
    velocity: float
    carrier: Carrier
    spin: float


def at_rest(readings: tuple[float, ...]) -> tuple[float, ...]:
    """Readings of a strut before its first step, from those after it: contacts and mount carry their load, nothing
    rubs."""
    kept = ("normal_1", "normal_2", "mount.displacement")
    return tuple(value if name in kept else 0.0 for name, value in zip(READINGS, readings, strict=True))


class Ride:
    """One run: the model of the car, its struts and tyres."""

    def __init__(self, car: Car, manoeuvre: Manoeuvre, step: float, code: str = EXUDYN, balance: bool = True):
        self.car, self.manoeuvre, self.step = car, manoeuvre, step
        self.model = ExudynCar(car) if code == EXUDYN else MujocoCar(car, step)
        self.tyre = read_tyre(car)
        self.struts: Mapping[str, object] = {}
        # The balance needs the force that moves the rack, which MuJoCo does not tell.
        self.ledger = Ledger(self.model) if balance and code == EXUDYN else None
        self.rows: list[list[float]] = []
        self.failure: CarError | None = None
        self.wheel = self.torque = self.brake = self.strut_seconds = 0.0
        self.is_moving = manoeuvre.speed > 0.0
        self.tyres = {name: self._tyre(name) for name in CORNERS}
        # What was seen at the beginning of the last step, and what acts now.
        self.before: dict[str, Seen] = {}
        self.pose: Pose | None = None
        self.acting: dict[str, Acting] = {}

    def _tyre(self, name: str) -> RollingTyre | StandingTyre:
        if self.is_moving:
            return RollingTyre(self.tyre, self.car, is_left(name))
        return StandingTyre(self.tyre, self.car, self.car.corners[name].bodies["wheel"].mass)

    def start(self, parameters: Mapping[str, Mapping[str, object]]) -> Rest:
        """Finds the rest position, and gives the car its speed or parks it on its posts."""
        if isinstance(self.model, ExudynCar):
            rest = settle(self.model, self.tyre, parameters)
        else:
            rest = relax(self.model, self.tyre, parameters, self.step)
        if self.is_moving:
            speed, loads = self.manoeuvre.speed, rest.loads
            deflections = {name: load / self.tyre.stiffness for name, load in loads.items()}
            radii = {name: self.tyre.rolling_radius(loads[name], deflections[name], speed) for name in CORNERS}
            self.model.set_in_motion(speed, radii)
        else:
            for name in CORNERS:
                self.model.park(name, PARKED)
        for name in CORNERS:
            self.model.set_strut(name, rest.forces[name])
            wheel = self._push_tyre(name, self.model.carrier(name), 0.0, 0.0)
            self.acting[name] = Acting(rest.forces[name], (0.0,) * len(READINGS), *wheel)
        return rest

    def _push_tyre(self, name: str, carrier: Carrier, at: float, step: float) -> tuple:
        """Sets the force of a tyre at a time, the torque of the drive, whose reaction acts on the chassis, and that of
        the brake, whose reaction acts on the upright; returns the tyre's forces, the height of the road, the push of
        the tyre and the torques."""
        height, rise = self.manoeuvre.road(name, at, carrier.centre[0])
        contact = touch(self.tyre, carrier, height, rise, is_left(name), self.tyres[name].forces[:2])
        push = self.tyres[name].push(contact, carrier, step)
        share = self.car.front_brakes if name[0] == "f" else 1.0 - self.car.front_brakes
        drive = (0.5 * self.torque if name[0] == "r" else 0.0) * carrier.axis
        brake = -0.5 * share * math.copysign(self.brake, carrier.spin) * carrier.axis
        self.model.push(name, push.force, push.moment + drive + brake)
        self.model.react(name, -drive)
        self.model.brake(name, -brake)
        return self.tyres[name].forces, height, push, drive, brake

    def hold(self, _system, end: float) -> bool:
        """Before a step: sets all forces, and writes a row. exudyn gives the time at the end of the step."""
        try:
            self._hold(end - self.step)
        except CarError as error:
            # exudyn would put it into a text of its own.
            self.failure = error
            return False
        return True

    def integrate(self, steps: int) -> int:
        """Moves the car on; returns the number of iterations, of which MuJoCo needs none."""
        if isinstance(self.model, MujocoCar):
            self.model.run(self.step, steps, self._hold)
            return 0
        self.model.system.SetPreStepUserFunction(self.hold)
        try:
            done, iterations = self.model.integrate(steps_of(self.step, steps))
        except exudyn.ModelError:
            if self.failure is None:
                raise
            raise self.failure from None
        if not done:
            raise CarError(f"exudyn stops at {len(self.rows) * self.step:.4f} s: try a smaller step")
        return iterations

    def close(self) -> Works | None:
        """Books the last step; the works of the run."""
        if not self.ledger:
            return None
        for name in CORNERS:
            seen = self._look(name)
            self.ledger.book(name, seen.carrier, seen.length, seen.spin, self.acting[name], self.step)
        return self.ledger.close(self.step)

    def _look(self, name: str) -> Seen:
        length, velocity = self.model.look(name)
        return Seen(length, velocity, self.model.carrier(name), self.model.rod_spin(name))

    def _hold(self, begin: float) -> None:
        travel = self.model.travel
        row = self._steer(begin)
        for name in CORNERS:
            seen = self._look(name)
            before = self.before.get(name, seen)
            self.before[name] = seen
            if self.model.TAKES_LOADS_AT_THE_END:
                # This acts at the beginning of the step; what is set now acts at the end.
                acting = self.acting[name]
                self.acting[name] = self._act(name, seen, before, begin, self.step)
                if not self.rows:
                    acting = replace(acting, strut=at_rest(self.acting[name].strut))
            else:
                acting = self.acting[name] = self._act(name, seen, before, begin, 0.0)
            if self.ledger:
                self.ledger.book(name, seen.carrier, seen.length, seen.spin, acting, self.step)
            row += [seen.length, seen.velocity, acting.force, acting.friction, *acting.strut]
            row += [*acting.tyre, acting.road]
        if self.ledger:
            self.ledger.end_of_step(travel, self.step)
        self.rows.append(row)

    def _act(self, name: str, seen: Seen, before: Seen, now: float, lead: float) -> Acting:
        """Sets what acts on a corner at `lead` after a time, for the motion that is expected then."""
        strut, model = self.struts[name], self.model
        wrench = side_load(name, now, Wrench.in_rod_eye(*model.reaction(name), seen.length))
        acceleration = (seen.velocity - before.velocity) / self.step
        began = time.process_time()
        force = strut.advance(seen.length, seen.velocity, self.step, wrench, acceleration, seen.spin)
        self.strut_seconds += time.process_time() - began
        model.set_strut(name, force)
        model.push_rod(name, strut.seen[READINGS.index("rod_force")])
        model.twist_strut(name, strut.seen[READINGS.index("friction_torque")])
        carrier = seen.carrier.ahead(before.carrier, lead, self.step)
        return Acting(force, tuple(strut.seen), *self._push_tyre(name, carrier, now + lead, self.step))

    def _steer(self, now: float) -> list[float]:
        """Moves the rack; returns the part of the row that belongs to the whole car."""
        model = self.model
        x, y, heave, roll, pitch, yaw = model.pose()
        nose = model.nose()
        speed, lateral, yaw_rate = model.motion()
        pose = Pose(now, float(nose[0]), float(nose[1]), yaw, speed, yaw_rate)
        # The driver turns the wheel throughout the step: as he sees the road in its middle.
        seen = pose.ahead(self.pose or pose, 0.5 * self.step, self.step)
        self.pose = pose
        wanted = self.manoeuvre.steer(seen)
        cruise = self.manoeuvre.wanted_speed(seen)
        self.brake = self.manoeuvre.brake(seen)
        self.torque = 0.0 if cruise is None else CRUISE * (cruise - seen.speed)
        turn = (wanted - self.wheel) * (1.0 - math.exp(-self.step / ARMS))
        turn = min(max(turn, -FASTEST_TURN * self.step), FASTEST_TURN * self.step)
        row = [now, x, y, heave, roll, pitch, yaw, speed, lateral, yaw_rate, pose.x, pose.y, self.wheel, model.travel]
        self.wheel += turn
        # The rack is ahead of the axle: it moves to the left to steer to the left.
        model.move_rack(self.wheel * self.car.travel_per_turn / (2.0 * math.pi))
        return row


def steps_in(manoeuvre: Manoeuvre, step: float) -> int:
    """How many steps a manoeuvre takes; rejects steps that are too long for it."""
    if manoeuvre.speed > 0.0 and step > LONGEST_STEP:
        raise CarError(f"step = {step:g} s: must be at most {LONGEST_STEP:g} s on the road, where the wheels spin")
    steps = round(manoeuvre.duration / step)
    if steps < 1:
        raise CarError(f"duration = {manoeuvre.duration:g} s: must be at least one step of {step:g} s")
    return steps


def simulate(
    car: Car,
    manoeuvre: Manoeuvre,
    law: str = "LuGre",
    changes: Mapping[str, object] | None = None,
    step: float = 1e-3,
    through: str = "package",
    fmus: Path = FMUS,
    label: str = "",
    code: str = EXUDYN,
    balance: bool = True,
) -> Run:
    """Computes a manoeuvre with a friction law in all four struts, in exudyn or in MuJoCo; with the balance of energy,
    which takes some time, if the code is exudyn."""
    parameters = parameters_of(car, law, changes or {})
    if code == EXUDYN:
        # The strut itself moves on with velocity and acceleration, to where the load is needed.
        parameters = {name: {"num.input_mode": "Linear", **given} for name, given in parameters.items()}
    steps = steps_in(manoeuvre, step)
    ride = Ride(car, manoeuvre, step, code, balance)
    began = time.perf_counter()
    rest = ride.start(parameters)
    with open_struts(parameters, rest.lengths, through, fmus) as struts:
        ride.struts = struts
        iterations = ride.integrate(steps)
    columns = dict(zip(COLUMNS, numpy.array(ride.rows).T, strict=True))
    works = ride.close()
    seconds = time.perf_counter() - began
    return Run(label or law, columns, rest, works, iterations, seconds, ride.strut_seconds, step)
