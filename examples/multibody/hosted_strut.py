"""The strut of the multibody examples: the ShockAbsorber FMU, or the same law written here to check the coupling.

Both have the same two interfaces. A host with an explicit solver calls `advance` once per step. A host that iterates
over the step calls `attempt` as often as it needs, always from the last accepted point, and `accept` at the end.
"""

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from ctypes import byref, c_void_p
from dataclasses import dataclass
from pathlib import Path

from examples.fmpy.coupling import FMUS, CouplingError, Fmu, open_fmu, path_of


@dataclass(frozen=True)
class Wrench:
    """Transverse force and moment of the tube on the rod, reduced to the eye of the tube: the bending load of the
    strut."""

    force_m: float = 0.0
    force_n: float = 0.0
    moment_m: float = 0.0
    moment_n: float = 0.0

    @classmethod
    def in_rod_eye(cls, force: Sequence[float], moment: Sequence[float], length: float) -> "Wrench":
        """From force and moment at the eye of the rod, in the axes m, n and a, where a points from the tube to the
        rod."""
        return cls(force[0], force[1], moment[0] - length * force[1], moment[1] + length * force[0])


UNLOADED = Wrench()


class Strut(ABC):
    """A force law between two eyes. Forces push the eyes apart, velocities are positive when they move apart."""

    def advance(self, length: float, velocity: float, step: float, wrench: Wrench = UNLOADED) -> float:
        """Makes one step with held inputs and returns the force."""
        force = self.attempt(length, velocity, step, wrench)
        self.accept()
        return force

    @abstractmethod
    def attempt(self, length: float, velocity: float, step: float, wrench: Wrench = UNLOADED) -> float:
        """The force at the end of a step from the last accepted point."""

    @abstractmethod
    def accept(self) -> None:
        """Makes the end of the last attempt the starting point of the next one."""

    @abstractmethod
    def friction(self) -> float:
        """Sum of the friction forces of both contacts in the last attempt; has the sign of the velocity."""

    @abstractmethod
    def contact_loads(self) -> tuple[float, float]:
        """Normal forces at the rod guide and at the piston in the last attempt."""


class FmuStrut(Strut):
    """The ShockAbsorber FMU. Saved and restored only if the host iterates, because copying its state takes time."""

    def __init__(self, fmu: Fmu):
        self.slave = fmu.slave
        self.inputs = fmu.references(
            "length", "velocity", "side_force_m", "side_force_n", "side_moment_m", "side_moment_n"
        )
        self.outputs = fmu.references("force", "friction_1", "friction_2", "normal_1", "normal_2", "force_damper")
        self.time = 0.0
        self.attempted = 0.0
        self.saved = c_void_p()
        self.seen = self.slave.getReal(self.outputs)

    def advance(self, length: float, velocity: float, step: float, wrench: Wrench = UNLOADED) -> float:
        force = self._step(length, velocity, step, wrench)
        self.time = self.attempted
        return force

    def attempt(self, length: float, velocity: float, step: float, wrench: Wrench = UNLOADED) -> float:
        if self.saved:
            self.slave.setFMUState(self.saved)
        else:
            self._save()
        return self._step(length, velocity, step, wrench)

    def accept(self) -> None:
        self.time = self.attempted
        self._save()

    def friction(self) -> float:
        return self.seen[1] + self.seen[2]

    def contact_loads(self) -> tuple[float, float]:
        return self.seen[3], self.seen[4]

    def close(self) -> None:
        """Frees the saved state."""
        if self.saved:
            self.slave.freeFMUState(self.saved)

    def _save(self) -> None:
        # An FMU overwrites a given state: nothing is allocated from the second time on.
        self.slave.fmi2GetFMUstate(self.slave.component, byref(self.saved))

    def _step(self, length: float, velocity: float, step: float, wrench: Wrench) -> float:
        loads = [wrench.force_m, wrench.force_n, wrench.moment_m, wrench.moment_n]
        self.slave.setReal(self.inputs, [length, velocity, *loads])
        if step > 0.0:
            self.slave.doStep(self.time, step)
        self.attempted = self.time + step
        self.seen = self.slave.getReal(self.outputs)
        return self.seen[0]


# Parameters of the law inside the host, required values of others, and parameters that it ignores.
NATIVE = (
    "geom.length_extended",
    "spring.k",
    "spring.preload",
    "damper.c_comp",
    "damper.c_reb",
    "friction.sigma_0",
    "friction.sigma_1",
    "friction.viscous_coefficient",
    "friction.stribeck_velocity",
    "c1.preload_k",
    "c1.preload_s",
    "c2.preload_k",
    "c2.preload_s",
)
CHOICES = {
    "friction.model": ["LuGre", "None"],
    "damper.mode": ["Linear"],
    "gas.enabled": [False],
    "init.friction_state": ["Zero"],
}
WITHOUT_EFFECT = ("geom.", "bump.gap", "side.offset_m")


class NativeStrut(Strut):
    """Spring, damper with two slopes and LuGre friction at two contacts, as a user would program them in the host.

    It has no side loads, gas or stops. The LuGre state is advanced exactly for a held velocity, as in

        z(t + h) = z_ss + (z(t) - z_ss) exp(-sigma_0 |v| h / g),   z_ss = g sgn(v) / sigma_0
        g = F_C + (F_S - F_C) exp(-(v / v_S)^2)
    """

    def __init__(self, parameters: Mapping[str, object]):
        _refuse_unknown(parameters)
        law = parameters["friction.model"]
        number = {name: _number(name, parameters[name]) for name in NATIVE}
        self.extended = number["geom.length_extended"]
        self.stiffness, self.preload = number["spring.k"], number["spring.preload"]
        self.compression_damping, self.rebound_damping = number["damper.c_comp"], number["damper.c_reb"]
        self.sigma_0, self.sigma_1 = number["friction.sigma_0"], number["friction.sigma_1"]
        self.sigma_2 = number["friction.viscous_coefficient"]
        self.stribeck_velocity = number["friction.stribeck_velocity"]
        # Coulomb and breakaway level of each contact.
        self.levels = (
            [] if law == "None" else [(number[f"{c}.preload_k"], number[f"{c}.preload_s"]) for c in ("c1", "c2")]
        )
        self.deflections = [0.0 for _ in self.levels]
        self.attempted = list(self.deflections)
        self.forces = [0.0 for _ in self.levels]

    def attempt(self, length: float, velocity: float, step: float, wrench: Wrench = UNLOADED) -> float:
        if wrench != UNLOADED:
            raise CouplingError("the law inside the host has no side loads: use the FMU")
        for at, levels in enumerate(self.levels):
            self.attempted[at], self.forces[at] = self._bristles(self.deflections[at], *levels, velocity, step)
        damping = self.compression_damping if velocity < 0.0 else self.rebound_damping
        spring = self.preload + self.stiffness * (self.extended - length)
        return spring - damping * velocity - sum(self.forces)

    def accept(self) -> None:
        self.deflections = list(self.attempted)

    def friction(self) -> float:
        return sum(self.forces)

    def contact_loads(self) -> tuple[float, float]:
        return 0.0, 0.0

    def _bristles(self, z: float, kinetic: float, static: float, v: float, step: float) -> tuple[float, float]:
        """Deflection after a step, and friction force."""
        g = kinetic + (static - kinetic) * math.exp(-((v / self.stribeck_velocity) ** 2))
        steady = math.copysign(g / self.sigma_0, v)
        rate = self.sigma_0 * abs(v) / g
        z = steady + (z - steady) * math.exp(-rate * step)
        return z, self.sigma_0 * z + self.sigma_1 * (v - rate * z) + self.sigma_2 * v


@contextmanager
def open_strut(
    parameters: Mapping[str, object], length: float, native: bool = False, fmus: Path = FMUS
) -> Iterator[Strut]:
    """A strut at rest at a length."""
    if native:
        yield NativeStrut(parameters)
        return
    with open_fmu(path_of("ShockAbsorber", fmus), {**parameters, "length": length}) as fmu:
        strut = FmuStrut(fmu)
        try:
            yield strut
        finally:
            strut.close()


def _number(name: str, value: object) -> float:
    try:
        return float(value)
    except ValueError:
        raise CouplingError(f"{name} = '{value}': must be a number") from None


def _refuse_unknown(parameters: Mapping[str, object]) -> None:
    for name, value in parameters.items():
        choices = CHOICES.get(name, [value] if name in NATIVE or name.startswith(WITHOUT_EFFECT) else [])
        if value not in choices:
            wanted = f"must be {' or '.join(map(str, choices))}" if choices else f"it has {', '.join(NATIVE)}"
            raise CouplingError(f"{name} = {value}: not in the law inside the host; {wanted}")
