"""Runs a system of FMUs, which may have free inputs, in importers of different origin, in one exchange scheme: all FMUs
step, then all values are exchanged (Jacobi). Failures are reported as CouplingError, except by Ecos."""

import json
import os
import shutil
import subprocess
import sys
import zipfile
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import fmpy
import numpy
from fmu_manipulation_toolbox.assembly import Assembly
from fmu_manipulation_toolbox.checker import OperationGenericCheck, OperationSemanticCheck
from fmu_manipulation_toolbox.operations import FMU
from masters import Component, Record, Signals, System, columns, couple_jacobi, load_threads, split

from examples.fmpy.coupling import PROJECT, CouplingError, variables_of

C_MASTER = PROJECT / "examples" / "c" / "system_master.c"


START = "start"


def system(
    fmus: Mapping[str, Path], connections: Sequence[tuple[str, str]] = (), start: Mapping[str, float] | None = None
) -> System:
    """FMUs by the names of the components, with connections such as `("car.velocity", "strut.velocity")`, and with
    start values such as `{"strut.mass": 1.0}`."""
    values = {split(name): value for name, value in (start or {}).items()}
    components = [
        Component(part, path, {name: str(value) for (owner, name), value in values.items() if owner == part}, START)
        for part, path in fmus.items()
    ]
    return System(PROJECT, components, [(split(output), split(variable)) for output, variable in connections])


def start_values(parts: System) -> dict[tuple[str, str], float]:
    """Start values of all components."""
    return {(part.name, name): float(value) for part in parts.components for name, value in part.parameters.items()}


def in_ecos(parts: System, step: float, steps: int, watched: Sequence[str], signals: Signals) -> Record:
    """Ecos does not report that an FMU has failed, and continues to call it."""
    load_threads()
    from ecospy import EcosSimulation, EcosSimulationStructure

    with ExitStack() as stack:
        structure = stack.enter_context(EcosSimulationStructure())
        for part in parts.components:
            structure.add_model(part.name, str(part.fmu))
        for output, variable in parts.connections:
            structure.make_real_connection("::".join(output), "::".join(variable))
        structure.add_parameter_set(START, {"::".join(name): value for name, value in start_values(parts).items()})
        simulation = stack.enter_context(EcosSimulation(structure=structure, step_size=step))
        simulation.init(parameter_set=START)
        rows = []
        for number in range(steps):
            for name, values in signals.items():
                simulation.set_real("::".join(name), values[number])
            simulation.step()
            rows.append([simulation.get_real("::".join(split(name))) for name in watched])
        simulation.terminate()
        return columns(watched, rows)


def in_libcosim(parts: System, step: float, steps: int, watched: Sequence[str], signals: Signals) -> Record:
    """libcosim counts time in nanoseconds, so its steps differ in the last digits."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimManipulator import CosimManipulator
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    log_output_level(CosimLogLevel.FATAL)
    execution = CosimExecution.from_step_size(round(step * 1e9))
    slaves = {part.name: CosimLocalSlave(str(part.fmu), part.name) for part in parts.components}
    indices = {name: execution.add_local_slave(slave) for name, slave in slaves.items()}
    references = references_of(parts)
    for (source, output), (target, variable) in parts.connections:
        execution.connect_real_variables(
            indices[source], references[source, output], indices[target], references[target, variable]
        )
    for name, value in start_values(parts).items():
        execution.real_initial_value(indices[name[0]], references[name], value)
    observer, manipulator = CosimObserver.create_last_value(), CosimManipulator.create_override()
    execution.add_observer(observer)
    execution.add_manipulator(manipulator)
    rows = []
    for number in range(steps):
        for name, values in signals.items():
            manipulator.slave_real_values(indices[name[0]], [references[name]], [float(values[number])])
        if not execution.step():
            raise CouplingError(f"libcosim: step {number + 1} failed")
        eyes = [(indices[split(name)[0]], [references[split(name)]]) for name in watched]
        rows.append([observer.last_real_values(slave, reference)[0] for slave, reference in eyes])
    return columns(watched, rows)


def in_container(parts: System, step: float, steps: int, watched: Sequence[str], signals: Signals) -> Record:
    """A container FMU of fmu-manipulation-toolbox imports the FMUs; the container itself runs in fmpy."""
    watched_ports = [split(name) for name in watched]
    with TemporaryDirectory() as folder:
        for part in parts.components:
            shutil.copyfile(part.fmu, Path(folder) / f"{part.name}.fmu")
        plan = {
            "name": "container.fmu",
            "step_size": step,
            "auto_link": False,
            "auto_input": False,
            "auto_output": False,
            "fmu": [f"{part.name}.fmu" for part in parts.components],
            "input": [[port_name(port), f"{port[0]}.fmu", port[1]] for port in signals],
            "output": [[f"{port[0]}.fmu", port[1], port_name(port)] for port in watched_ports],
            "start": [[f"{part}.fmu", name, value] for (part, name), value in start_values(parts).items()],
            "link": [[f"{a}.fmu", output, f"{b}.fmu", variable] for (a, output), (b, variable) in parts.connections],
        }
        (Path(folder) / "container.json").write_text(json.dumps(plan), encoding="utf-8")
        Assembly("container.json", fmu_directory=Path(folder)).make_fmu()
        container = system({"container": Path(folder) / "container.fmu"})
        record = couple_jacobi(
            container,
            step,
            steps,
            [f"container.{port_name(port)}" for port in watched_ports],
            {("container", port_name(port)): values for port, values in signals.items()},
        )
    return dict(zip(watched, record.values(), strict=True))


def port_name(port: tuple[str, str]) -> str:
    """Name of a port of the container."""
    return "__".join(port).replace(".", "_")


def in_c(parts: System, step: float, steps: int, watched: Sequence[str], signals: Signals) -> Record:
    """The master in plain C of the examples; it needs the unpacked binaries."""
    with TemporaryDirectory() as folder:
        binaries = [binary_of(part, Path(folder)) for part in parts.components]
        return run_plan([c_master()], parts, binaries, step, steps, watched, signals)


def in_rust(crate: str) -> Callable[..., Record]:
    """The master of tests/importers with one of its importers."""

    def run(parts: System, step: float, steps: int, watched: Sequence[str], signals: Signals) -> Record:
        files = [part.fmu for part in parts.components]
        return run_plan([rust_master(), "run", crate], parts, files, step, steps, watched, signals)

    return run


def in_fmpy(parts: System, step: float, steps: int, watched: Sequence[str], signals: Signals) -> Record:
    """The plain script on fmpy."""
    return couple_jacobi(parts, step, steps, watched, signals)


IMPORTERS: dict[str, Callable[..., Record]] = {
    "fmpy": in_fmpy,
    "ecos": in_ecos,
    "libcosim": in_libcosim,
    "fmi": in_rust("fmi"),
    "fmi-rs": in_rust("fmi-rs"),
    "container": in_container,
    "c": in_c,
}


def references_of(parts: System) -> dict[tuple[str, str], int]:
    """Value reference of each variable of each component."""
    return {
        (part.name, name): variable.valueReference
        for part in parts.components
        for name, variable in variables_of(part.fmu).items()
    }


def binary_of(part: Component, folder: Path) -> Path:
    """Unpacks the binary of an FMU for this machine."""
    description = fmpy.read_model_description(str(part.fmu))
    name = f"binaries/{fmpy.platform}/{description.coSimulation.modelIdentifier}{fmpy.sharedLibraryExtension}"
    with zipfile.ZipFile(part.fmu) as archive:
        return Path(archive.extract(name, folder / part.name))


def run_plan(
    command: Sequence[str | Path],
    parts: System,
    files: Sequence[Path],
    step: float,
    steps: int,
    watched: Sequence[str],
    signals: Signals,
) -> Record:
    """Runs a master that reads the system from a text file, and reads its table."""
    references, numbers = references_of(parts), {part.name: str(at) for at, part in enumerate(parts.components)}

    def port(name: tuple[str, str]) -> str:
        return f"{numbers[name[0]]} {references[name]}"

    lines = [f"step {step!r}", f"steps {steps}"]
    for part, file in zip(parts.components, files, strict=True):
        lines.append(f"fmu {fmpy.read_model_description(str(part.fmu)).guid} {file}")
    lines += [f"start {port(name)} {value!r}" for name, value in start_values(parts).items()]
    lines += [f"link {port(output)} {port(variable)}" for output, variable in parts.connections]
    lines += [f"signal {port(name)} {' '.join(repr(float(v)) for v in values)}" for name, values in signals.items()]
    lines += [f"watch {port(split(name))}" for name in watched]
    with TemporaryDirectory() as folder:
        plan = Path(folder) / "system.txt"
        plan.write_text("\n".join(lines) + "\n", encoding="utf-8")
        done = subprocess.run([*command, plan], capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        raise CouplingError(f"exit code {done.returncode}: {done.stderr}")
    return columns(watched, [[float(value) for value in row.split()] for row in done.stdout.splitlines()])


@cache
def c_master() -> Path:
    """Compiles the C example as a user would."""
    compiler = os.environ.get("CC", "cc")
    if shutil.which(compiler) is None:
        raise CouplingError(f"no C compiler {compiler}: install one, or set CC")
    program = PROJECT / "out" / "system_master"
    program.parent.mkdir(exist_ok=True)
    build([compiler, "-std=c99", f"-I{PROJECT / 'include'}", C_MASTER, "-o", program, "-ldl"])
    return program


@cache
def rust_master() -> Path:
    """Builds tests/importers."""
    script = PROJECT / "tests" / "importers" / "cargo.py"
    text = build([sys.executable, script, "build", "--message-format", "json"])
    built = [json.loads(line) for line in text.splitlines()]
    return Path(next(item["executable"] for item in built if item.get("executable")))


def build(command: Sequence[str | Path]) -> str:
    """Runs a compiler; its error message becomes the text of the exception."""
    done = subprocess.run([str(word) for word in command], cwd=PROJECT, capture_output=True, text=True)
    if done.returncode != 0:
        raise CouplingError(f"{command[0]} failed\n{done.stderr}")
    return done.stdout


def fmutool_errors(path: Path, version: str) -> list[str]:
    """Findings of the checks of `fmutool` for an FMU: those against the schema, and those of the text of the
    standard."""
    schema, rules = OperationGenericCheck(), OperationSemanticCheck()
    fmu = FMU(str(path))
    for check in (schema, rules):
        fmu.apply_operation(check)
    return rules.errors + ([] if schema.compliant_with_version == version else [f"breaks the schema of FMI {version}"])


def difference(record: Record, reference: Record) -> float:
    """Largest difference, over the largest value of the variable or over 1 if that is larger."""
    return max(
        numpy.abs(record[name] - values).max() / max(1.0, numpy.abs(values).max()) for name, values in reference.items()
    )
