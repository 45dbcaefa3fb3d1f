"""The packed libraries on the platforms that this machine can run: Linux, Windows under wine, ARM under qemu."""

import os
import signal
import subprocess
import sys
import zipfile
from contextlib import suppress
from pathlib import Path

import fmpy
import numpy
import pytest
from fmpy.util import add_remoting
from machines import ARM, COPY, FMUS, FMUS_OF_COPY, MAC_ARM

from examples.fmpy.coupling import PROJECT, models_in

MODELS = models_in(FMUS)
PLATFORMS = ["linux64", "win64", ARM]
# On Apple's processors a logger gets its arguments differently than on Linux, so only programs without log messages run
# there.
MAC = ["darwin64", MAC_ARM]
EXAMPLES = PROJECT / "examples" / "c"
PROGRAMS = PROJECT / "tests" / "c"
FMI_3_HEADERS = Path(fmpy.__file__).with_name("c-code")

# First bytes of a file, and the number of its processor in it (System V ABI, PE format, mach-o/loader.h).
ELF, INTEL_ELF, ARM_ELF = b"\x7fELF", b"\x3e\x00", b"\xb7\x00"
UNIVERSAL = b"\xca\xfe\xba\xbe\x00\x00\x00\x02"


def linked(machine, source):
    """A program that finds the library beside it."""
    beside = [] if machine.platform == "win64" else ["-Wl,-rpath,$ORIGIN", "-lm"]
    return machine.compile(source, machine.library, *beside)


def results_of_all_models(machine):
    """Results of the program catalogue.c by model and variable."""
    lines = machine.run(linked(machine, PROGRAMS / "catalogue.c")).splitlines()
    return {(model, name): float(value) for model, name, value in (line.split(" ") for line in lines)}


@pytest.mark.parametrize("model", MODELS)
def test_one_file_holds_the_libraries_of_three_systems_and_arm_has_its_own(model):
    def head(archive, path):
        return archive.read(f"binaries/{path}")[:20]

    with zipfile.ZipFile(FMUS / f"{model}.fmu") as archive:
        folders = {name.split("/")[1] for name in archive.namelist() if name.startswith("binaries/")}
        assert folders == {"linux64", "win64", "darwin64"}
        linux = head(archive, f"linux64/{model}.so")
        assert linux.startswith(ELF)
        assert linux.endswith(INTEL_ELF)
        assert head(archive, f"win64/{model}.dll").startswith(b"MZ")
        assert head(archive, f"darwin64/{model}.dylib").startswith(UNIVERSAL)
    with zipfile.ZipFile(FMUS / ARM / f"{model}.fmu") as archive:
        # Importers on ARM look in one of the two.
        for folder in ("linux64", ARM):
            arm = head(archive, f"{folder}/{model}.so")
            assert arm.startswith(ELF)
            assert arm.endswith(ARM_ELF)


def test_a_copy_of_the_project_in_another_folder_gives_the_same_bytes():
    names = [path.relative_to(FMUS) for path in sorted(FMUS.rglob("*.fmu"))]
    assert names == [path.relative_to(FMUS_OF_COPY) for path in sorted(FMUS_OF_COPY.rglob("*.fmu"))]
    # FMI 2.0, its files for ARM, and FMI 3.0.
    assert len(names) == 3 * len(MODELS)
    built_there = [path.name for path in (COPY / "target" / "fmu").glob("*/release/*stribeck.*") if path.suffix != ".d"]
    assert {"libstribeck.so", "libstribeck.dylib", "stribeck.dll"} <= set(built_there)
    different = [str(name) for name in names if (FMUS / name).read_bytes() != (FMUS_OF_COPY / name).read_bytes()]
    print(f"figure: {len(names)} files packed twice, {len(different)} differ")
    assert different == []


@pytest.mark.parametrize("program", ["fmi_test.c", "fmi3_test.c"])
@pytest.mark.parametrize("platform", [*PLATFORMS, "darwin64"])
def test_a_host_loads_the_library_and_reaches_every_function(machines, platform, program):
    machine = machines[platform]
    loads = [] if platform == "win64" else ["-lm", "-ldl"]
    program = machine.compile(PROGRAMS / program, "-isystem", FMI_3_HEADERS, *loads)
    assert " 0 failed" in machine.run(program, machine.library)


@pytest.mark.parametrize("platform", [*PLATFORMS, *MAC])
def test_the_master_in_c_prints_the_same_everywhere(machines, platform):
    source = EXAMPLES / "fmu_master.c"
    output = {name: machines[name].run(linked(machines[name], source)) for name in {"linux64", platform}}
    assert "slips 5 times, first at 7.35" in output[platform]
    assert output[platform] == output["linux64"]


@pytest.mark.parametrize("platform", [*PLATFORMS, *MAC])
def test_all_models_have_the_results_of_linux(machines, platform):
    expected, found = results_of_all_models(machines["linux64"]), results_of_all_models(machines[platform])
    assert {model for model, _ in found} == set(MODELS)
    assert found.keys() == expected.keys()
    equal = sum(found[key] == value for key, value in expected.items())
    print(f"figure: {platform}: {equal} of {len(expected)} results of {len(MODELS)} models are equal to the last bit")
    assert {key: value for key, value in expected.items() if found[key] != value} == {}


def simulate(fmu, file, environment):
    """Outputs of a run in fmpy. The process and its children end with it, or after a minute."""
    script = Path(__file__).with_name("remote.py")
    python_path = os.pathsep.join([str(PROJECT), os.environ.get("PYTHONPATH", "")])
    settings = {**os.environ, **environment, "PYTHONPATH": python_path}
    log = file.with_suffix(".log")
    with log.open("w") as output:
        process = subprocess.Popen(
            [sys.executable, script, fmu, file], stdout=output, stderr=output, env=settings, start_new_session=True
        )
        try:
            status = process.wait(timeout=60)
        finally:
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
    assert status == 0, log.read_text()
    return numpy.load(file)


@pytest.mark.parametrize("model", MODELS)
def test_fmpy_runs_the_windows_library_as_the_linux_one(model, wine, tmp_path):
    fmu = FMUS / f"{model}.fmu"
    remote = tmp_path / fmu.name
    with zipfile.ZipFile(fmu) as packed, zipfile.ZipFile(remote, "w") as archive:
        for name in packed.namelist():
            if not name.startswith("binaries/linux64/"):
                archive.writestr(name, packed.read(name))
    add_remoting(remote, "linux64", "win64")
    here, there = simulate(fmu, tmp_path / "here.npy", {}), simulate(remote, tmp_path / "there.npy", wine)
    assert len(here) == len(there) == 101
    for name in here.dtype.names:
        numpy.testing.assert_array_equal(there[name], here[name], err_msg=name)
