"""The struts of the car: the ShockAbsorber of the package, or its FMU; both give the same forces to the last bit."""

from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path

import stribeck
from car_description import CORNERS, Car, CarError
from coupling import FMUS
from hosted_strut import UNLOADED, Wrench, open_strut

READINGS = ("friction_1", "friction_2", "normal_1", "normal_2", "force_damper")

# No friction at the start, whatever the law: the car stands where the springs hold it.
AT_REST = {"init.friction_state": "Zero"}


class PackageStrut:
    """The strut of the Python package."""

    def __init__(self, parameters: Mapping[str, object], length: float):
        try:
            self.model = stribeck.ShockAbsorber(**{**parameters, "length": length})
            # Levels that contradict each other are refused by a step only: here by one of another strut.
            stribeck.ShockAbsorber(**{**parameters, "length": length}).step(1e-6)
        except (stribeck.Refused, TypeError) as refusal:
            raise CarError(f"strut: {refusal}") from None
        self.seen = (0.0, 0.0, 0.0, 0.0, 0.0)

    def advance(self, length: float, velocity: float, step: float, wrench: Wrench = UNLOADED) -> float:
        """Makes one step with held inputs and returns the force."""
        model = self.model
        try:
            model.set(
                length=length,
                velocity=velocity,
                side_force_m=wrench.force_m,
                side_force_n=wrench.force_n,
                side_moment_m=wrench.moment_m,
                side_moment_n=wrench.moment_n,
            )
            model.step(step)
            self.seen = tuple(model[name] for name in READINGS)
            return model["force"]
        except stribeck.Refused as refusal:
            load = f"side load {wrench.force_m:g}, {wrench.force_n:g} N, {wrench.moment_m:g}, {wrench.moment_n:g} N.m"
            raise CarError(f"strut at {model.time:.4f} s: {refusal} (length {length:g} m, {load})") from None


class FmuStrut:
    """The strut of the FMU, through fmpy."""

    def __init__(self, strut):
        self.strut, self.seen = strut, (0.0, 0.0, 0.0, 0.0, 0.0)

    def advance(self, length: float, velocity: float, step: float, wrench: Wrench = UNLOADED) -> float:
        """Makes one step with held inputs and returns the force."""
        force = self.strut.advance(length, velocity, step, wrench)
        self.seen = tuple(self.strut.seen[1:])
        return force


class RestingStrut:
    """Force and stiffness of a strut without friction that does not move."""

    def __init__(self, parameters: Mapping[str, object]):
        try:
            self.model = stribeck.ShockAbsorber(**{**parameters, "friction.model": "None"})
        except (stribeck.Refused, TypeError) as refusal:
            raise CarError(f"strut: {refusal}") from None

    def at(self, length: float) -> tuple[float, float]:
        """Force, and by how much it falls per length."""
        self.model.set(length=length, velocity=0.0)
        return self.model["force"], -self.model["dforce_dlength"]


def parameters_of(car: Car, law: str, changes: Mapping[str, object]) -> dict[str, dict[str, object]]:
    """Parameters of the struts of a car, by corner."""
    given = {name: _plain(value) for name, value in changes.items()}
    return {name: {**corner.strut, **AT_REST, "friction.model": law, **given} for name, corner in car.corners.items()}


def _plain(value: object) -> object:
    """A value from the command line: a number, true or false, or the name of a choice."""
    if value in ("true", "false"):
        return value == "true"
    try:
        return float(value)
    except (TypeError, ValueError):
        return value


@contextmanager
def open_struts(
    parameters: Mapping[str, Mapping[str, object]],
    lengths: Mapping[str, float],
    through: str = "package",
    fmus: Path = FMUS,
) -> Iterator[dict[str, PackageStrut | FmuStrut]]:
    """Four struts at rest."""
    with ExitStack() as stack:
        struts = {}
        for name in CORNERS:
            if through == "package":
                struts[name] = PackageStrut(parameters[name], lengths[name])
            else:
                struts[name] = FmuStrut(
                    stack.enter_context(open_strut(parameters[name], lengths[name], native=False, fmus=fmus))
                )
        yield struts
