"""The struts of the car: the ShockAbsorber of the package, of its FMU or of the C library, with the same bits."""

import ctypes
import tempfile
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path

import fmpy
import stribeck

from examples.car.car_description import CORNERS, Car, CarError
from examples.fmpy.coupling import FMUS, Fmu, open_fmu, path_of
from examples.multibody.hosted_strut import UNLOADED, Wrench

INPUTS = (
    *("length", "velocity", "side_force_m", "side_force_n", "side_moment_m", "side_moment_n"),
    *("acceleration", "spin_rate"),
)
READINGS = (
    *("friction_1", "friction_2", "normal_1", "normal_2", "force_damper", "friction_torque"),
    *("rod_force", "mount.displacement"),
)
NOTHING_YET = (0.0,) * len(READINGS)

# No friction at the start, whatever the law: the car stands where the springs hold it.
AT_REST = {"init.friction_state": "Zero"}


def loads_of(wrench: Wrench) -> tuple[float, float, float, float]:
    """The four numbers of a side load."""
    return wrench.force_m, wrench.force_n, wrench.moment_m, wrench.moment_n


class PackageStrut:
    """The strut of the Python package."""

    def __init__(self, parameters: Mapping[str, object], length: float):
        try:
            self.model = stribeck.ShockAbsorber(**{**parameters, "length": length})
            # Levels that contradict each other are refused by a step only: here by one of another strut.
            stribeck.ShockAbsorber(**{**parameters, "length": length}).step(1e-6)
        except (stribeck.Refused, TypeError) as refusal:
            raise CarError(f"strut: {refusal}") from None
        self.seen = NOTHING_YET

    def advance(
        self,
        length: float,
        velocity: float,
        step: float,
        wrench: Wrench = UNLOADED,
        acceleration: float = 0.0,
        spin: float = 0.0,
    ) -> float:
        """Makes one step and returns the force."""
        model = self.model
        try:
            values = (length, velocity, *loads_of(wrench), acceleration, spin)
            model.set(**dict(zip(INPUTS, values, strict=True)))
            model.step(step)
            self.seen = tuple(model[name] for name in READINGS)
            return model["force"]
        except stribeck.Refused as refusal:
            load = "side load {:g}, {:g} N, {:g}, {:g} N.m".format(*loads_of(wrench))
            raise CarError(f"strut at {model.time:.4f} s: {refusal} (length {length:g} m, {load})") from None


class FmuStrut:
    """The strut of the FMU, through fmpy."""

    def __init__(self, fmu: Fmu):
        self.slave, self.time, self.seen = fmu.slave, 0.0, NOTHING_YET
        self.inputs, self.outputs = fmu.references(*INPUTS), fmu.references("force", *READINGS)

    def advance(
        self,
        length: float,
        velocity: float,
        step: float,
        wrench: Wrench = UNLOADED,
        acceleration: float = 0.0,
        spin: float = 0.0,
    ) -> float:
        """Makes one step and returns the force."""
        self.slave.setReal(self.inputs, [length, velocity, *loads_of(wrench), acceleration, spin])
        self.slave.doStep(self.time, step)
        self.time += step
        force, *seen = self.slave.getReal(self.outputs)
        self.seen = tuple(seen)
        return force


class CStrut:
    """The strut of the C library, whose functions every FMU contains."""

    def __init__(self, library: ctypes.CDLL, parameters: Mapping[str, object], length: float):
        self.library, self.handle = library, ctypes.c_void_p()
        library.stribeck_last_error.restype = ctypes.c_char_p
        self._call("create", b"ShockAbsorber", ctypes.byref(self.handle), of_model=False)
        # The C library takes the number of a choice, which the package knows.
        find = stribeck.model("ShockAbsorber").find
        for name, value in {**parameters, "length": length}.items():
            self._call("set_by_name", name.encode(), ctypes.c_double(find(name).number(value)))
        self.inputs = [self._reference(name) for name in INPUTS]
        self.outputs = [self._reference(name) for name in ("force", *READINGS)]
        self.seen = NOTHING_YET

    def advance(
        self,
        length: float,
        velocity: float,
        step: float,
        wrench: Wrench = UNLOADED,
        acceleration: float = 0.0,
        spin: float = 0.0,
    ) -> float:
        """Makes one step and returns the force."""
        values = (length, velocity, *loads_of(wrench), acceleration, spin)
        for reference, value in zip(self.inputs, values, strict=True):
            self._call("set", reference, ctypes.c_double(value))
        self._call("step", ctypes.c_double(step))
        force, *seen = (self._get(reference) for reference in self.outputs)
        self.seen = tuple(seen)
        return force

    def close(self) -> None:
        """Frees the model."""
        self.library.stribeck_free(self.handle)

    def _reference(self, name: str) -> ctypes.c_uint32:
        reference = ctypes.c_uint32()
        self._call("find", name.encode(), ctypes.byref(reference))
        return reference

    def _get(self, reference: ctypes.c_uint32) -> float:
        value = ctypes.c_double()
        self._call("get", reference, ctypes.byref(value))
        return value.value

    def _call(self, name: str, *arguments: object, of_model: bool = True) -> None:
        given = (self.handle, *arguments) if of_model else arguments
        if getattr(self.library, f"stribeck_{name}")(*given) != 0:
            raise CarError(f"strut: {self.library.stribeck_last_error(self.handle).decode()}")


@contextmanager
def _library_in(fmu: Path) -> Iterator[ctypes.CDLL]:
    """The library of an FMU for this machine."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder, zipfile.ZipFile(fmu) as archive:
        member = f"binaries/{fmpy.platform}/ShockAbsorber{fmpy.sharedLibraryExtension}"
        yield ctypes.CDLL(archive.extract(member, folder))


class RestingStrut:
    """Force and stiffness of a strut without friction that does not move."""

    def __init__(self, parameters: Mapping[str, object]):
        try:
            self.model = stribeck.ShockAbsorber(**{**parameters, "friction.model": "None"})
        except (stribeck.Refused, TypeError) as refusal:
            raise CarError(f"strut: {refusal}") from None
        overlap = self.model["overlap"] - self.model["compression"]
        if overlap <= 0.0:
            where = "overlap at full extension, geom.d_i + geom.d_j - geom.length_extended"
            raise CarError(f"strut: {where} = {overlap:g} m: must be positive")

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
) -> Iterator[dict[str, PackageStrut | FmuStrut | CStrut]]:
    """Four struts at rest: through the `package`, the `fmu` or `c`."""
    with ExitStack() as stack:
        struts = {}
        library = stack.enter_context(_library_in(path_of("ShockAbsorber", fmus))) if through == "c" else None
        for name in CORNERS:
            given = parameters[name], lengths[name]
            if through == "package":
                struts[name] = PackageStrut(*given)
            elif through == "c":
                struts[name] = CStrut(library, *given)
                stack.callback(struts[name].close)
            else:
                start = {**parameters[name], "length": lengths[name]}
                fmu = stack.enter_context(open_fmu(path_of("ShockAbsorber", fmus), start))
                struts[name] = FmuStrut(fmu)
        yield struts
