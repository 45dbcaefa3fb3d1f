"""Runs a system of FMUs from an SSP package in four masters.

    jacobi     a plain script: all FMUs step, then all values are exchanged (Jacobi)
    ecos       Ecos, which exchanges in the same order
    libcosim   libcosim, in the same order as well
    fmpy       the SSP runner of FMPy, started with the start values of the FMUs instead of zeros

A variant is another description in the package: `firm` means firm.ssd and its parameter sets. Ecos and libcosim are
available as Python packages for Linux on x86-64.
"""

import ctypes
import shutil
import sys
import tempfile
import zipfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from unittest import mock
from xml.etree import ElementTree

import numpy
from fmpy.ssp import simulation as fmpy_runner
from fmpy.ssp.ssd import Parameter, ParameterSet

from examples.fmpy.coupling import CouplingError, open_fmu

MAIN = "SystemStructure"
SPACES = {
    "ssd": "http://ssp-standard.org/SSP1/SystemStructureDescription",
    "ssv": "http://ssp-standard.org/SSP1/SystemStructureParameterValues",
}


@dataclass(frozen=True)
class Component:
    """A component of a system: its FMU, and the values and the name of its parameter set."""

    name: str
    fmu: Path
    parameters: dict[str, str]
    parameter_set: str | None


@dataclass(frozen=True)
class System:
    """A parsed description. Connections lead from an output to an input, as (component, variable)."""

    folder: Path
    components: list[Component]
    connections: list[tuple[tuple[str, str], tuple[str, str]]]

    def parameter_set(self) -> str | None:
        """Common name of the parameter sets of all components."""
        names = {component.parameter_set for component in self.components} - {None}
        if len(names) > 1:
            raise CouplingError(f"the parameter sets have different names: {', '.join(sorted(names))}")
        return names.pop() if names else None


def variants(package: Path) -> list[str]:
    """Names of the descriptions in a package."""
    with zipfile.ZipFile(package) as archive:
        return sorted(Path(name).stem for name in archive.namelist() if name.endswith(".ssd"))


@contextmanager
def unpacked(package: Path, variant: str = MAIN) -> Iterator[System]:
    """Unpacks a package temporarily, with the description of the variant as the main one, which every tool finds."""
    if variant not in variants(package):
        raise CouplingError(f"{package} has no variant '{variant}'; there are {', '.join(variants(package))}")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        with zipfile.ZipFile(package) as archive:
            archive.extractall(folder)
        if variant != MAIN:
            shutil.copyfile(folder / f"{variant}.ssd", folder / f"{MAIN}.ssd")
        yield read_system(folder)


def read_system(folder: Path) -> System:
    """Reads the main description in a folder."""
    root = ElementTree.parse(folder / f"{MAIN}.ssd").getroot()
    components = []
    for element in root.iterfind(".//ssd:Component", SPACES):
        binding = element.find(".//ssd:ParameterBinding", SPACES)
        parameters, name = ({}, None) if binding is None else read_parameters(folder / binding.get("source"))
        components.append(Component(element.get("name"), folder / element.get("source"), parameters, name))
    connections = [
        (
            (element.get("startElement"), element.get("startConnector")),
            (element.get("endElement"), element.get("endConnector")),
        )
        for element in root.iterfind(".//ssd:Connection", SPACES)
    ]
    return System(folder, components, connections)


def read_parameters(path: Path) -> tuple[dict[str, str], str]:
    """Values of a parameter set by the names of the variables, and the name of the set."""
    root = ElementTree.parse(path).getroot()
    values = {element.get("name"): element[0].get("value") for element in root.iterfind(".//ssv:Parameter", SPACES)}
    return values, root.get("name")


Record = dict[str, numpy.ndarray]
# Values of inputs that are not connected, one per step.
Signals = Mapping[tuple[str, str], Sequence[float]]
NONE: Signals = {}


def run_jacobi(package: Path, variant: str, step: float, steps: int, watched: Sequence[str]) -> Record:
    """All FMUs step with the values of the last communication point; then outputs become inputs."""
    with unpacked(package, variant) as system:
        return couple_jacobi(system, step, steps, watched)


def couple_jacobi(system: System, step: float, steps: int, watched: Sequence[str], signals: Signals = NONE) -> Record:
    """The plain script; signals are set before each step."""
    with ExitStack() as stack:
        fmus = {part.name: stack.enter_context(open_fmu(part.fmu, part.parameters)) for part in system.components}
        links = [
            (fmus[a].slave, fmus[a].references(output), fmus[b].slave, fmus[b].references(variable))
            for (a, output), (b, variable) in system.connections
        ]
        drives = [(fmus[part].slave, fmus[part].references(name), signals[part, name]) for part, name in signals]

        def exchange() -> None:
            values = [source.getReal(output) for source, output, _, _ in links]
            for (_, _, target, variable), value in zip(links, values, strict=True):
                target.setReal(variable, value)

        eyes = [(fmus[part].slave, fmus[part].references(name)) for part, name in map(split, watched)]
        # At the start, values propagate through all components.
        for _ in fmus:
            exchange()
        rows = []
        for number in range(steps):
            for slave, variable, values in drives:
                slave.setReal(variable, [values[number]])
            for fmu in fmus.values():
                fmu.slave.doStep(number * step, step)
            rows.append([slave.getReal(reference)[0] for slave, reference in eyes])
            exchange()
        return columns(watched, rows)


def run_ecos(package: Path, variant: str, step: float, steps: int, watched: Sequence[str]) -> Record:
    """Ecos selects parameter sets only by their name."""
    load_threads()
    from ecospy import EcosSimulation

    with (
        unpacked(package, variant) as system,
        EcosSimulation(ssp_path=str(system.folder), step_size=step) as simulation,
    ):
        simulation.init(parameter_set=system.parameter_set())
        rows = []
        for _ in range(steps):
            simulation.step()
            rows.append([simulation.get_real("::".join(split(name))) for name in watched])
        simulation.terminate()
        return columns(watched, rows)


def run_libcosim(package: Path, variant: str, step: float, steps: int, watched: Sequence[str]) -> Record:
    """libcosim counts time in nanoseconds. Failures are reported by its calls; its log shows errors for valid
    descriptions."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimObserver import CosimObserver

    log_output_level(CosimLogLevel.FATAL)
    with unpacked(package, variant) as system:
        execution = CosimExecution.from_ssp_file(str(system.folder), round(step * 1e9))
        observer = CosimObserver.create_last_value()
        execution.add_observer(observer)
        eyes = []
        for part, name in map(split, watched):
            slave = execution.slave_index_from_instance_name(part)
            known = {variable.name.decode(): variable.reference for variable in execution.slave_variables(slave)}
            eyes.append((slave, [known[name]]))
        rows = []
        for number in range(steps):
            if not execution.step():
                raise CouplingError(f"libcosim: step {number + 1} failed")
            rows.append([observer.last_real_values(slave, reference)[0] for slave, reference in eyes])
        return columns(watched, rows)


def run_fmpy(package: Path, variant: str, step: float, steps: int, watched: Sequence[str]) -> Record:
    """FMPy's runner ignores parameter bindings, and sets every input to 0 in the first step.

    The package runs like that as well, but with strut lengths of 0 in that step and with the default car; both are
    corrected here.
    """
    with unpacked(package, variant) as system:
        main = Path(shutil.make_archive(str(system.folder / "main"), "zip", system.folder))
        values = [
            Parameter(name=f"{part.name}.{name}", value=value)
            for part in system.components
            for name, value in part.parameters.items()
        ]
        instantiate = fmpy_runner.instantiate_fmu

        def instantiate_with_start_values(component, *rest) -> None:
            instantiate(component, *rest)
            for connector in component.connectors:
                connector.value = fmpy_runner.get_value(component, connector.name)

        with mock.patch.object(fmpy_runner, "instantiate_fmu", instantiate_with_start_values):
            result = fmpy_runner.simulate_ssp(
                str(main),
                # Half a step less, because sums of steps are not exact.
                stop_time=(steps - 0.5) * step,
                step_size=step,
                parameter_set=ParameterSet(parameters=values),
            )
        return {name: result[name] for name in watched}


MASTERS: dict[str, Callable[..., Record]] = {
    "jacobi": run_jacobi,
    "ecos": run_ecos,
    "libcosim": run_libcosim,
    "fmpy": run_fmpy,
}


def split(name: str) -> tuple[str, str]:
    """Component and variable of `car.fl.length`."""
    component, _, variable = name.partition(".")
    return component, variable


def columns(names: Sequence[str], rows: list[list[float]]) -> Record:
    """Rows of values as one array per name."""
    return dict(zip(names, numpy.array(rows).T, strict=True))


def load_threads() -> None:
    """Loads the thread library that Ecos needs, from the Python package `tbb` or from the system."""
    name = "libtbb.so.12"
    if sys.platform != "linux":
        return
    try:
        files = [file.locate() for file in metadata.files("tbb") or [] if file.name == name]
    except metadata.PackageNotFoundError:
        files = []
    try:
        ctypes.CDLL(str(files[0].resolve()) if files else name, mode=ctypes.RTLD_GLOBAL)
    except OSError as error:
        cure = "pip install tbb, or apt install libtbb12 (Debian, Ubuntu)"
        raise CouplingError(f"Ecos needs {name}: {cure} ({error})") from error
