"""C sources of a law on other processors, under qemu: the same bits as the library here; laws in registers of ARM."""

import os
import subprocess
import sys

import pytest
from machines import FMUS, library_of

from examples.fmpy.coupling import PROJECT

sys.path.append(str(PROJECT / "tests" / "python"))
import c_sources

MODEL = "LuGre"
# All models at -O2, or one at each level, and one of those in whose motions GCC's sums for ARM round wrongly.
ALL = os.environ.get("STRIBECK_THOROUGH") == "1"
FEW = [*((MODEL, f"-O{level}") for level in (0, 2, 3)), ("Threlfall", "-O2")]
CASES = [(name, "-O2") for name in c_sources.with_sources()] if ALL else FEW
CORTEX = PROJECT / "tests" / "sources" / "cortex_m"
# No operating system: a start of its own, and files of the host by semihosting.
BARE = ["--specs=rdimon.specs", f"-T{CORTEX / 'memory.ld'}", str(CORTEX / "start.c")]
SEMIHOSTING = ["-display", "none", "-serial", "none", "-monitor", "none", "-semihosting", "-kernel"]
# Compiler, and what runs its programs. PowerPC is big-endian; Cortex-M4 computes double without its registers.
PROCESSORS = {
    "ARM with 64 bits": (["aarch64-linux-gnu-gcc", "-static"], ["qemu-aarch64-static"]),
    "PowerPC": (["powerpc-linux-gnu-gcc", "-static"], ["qemu-ppc-static"]),
    "Cortex-M4F": (
        ["arm-none-eabi-gcc", "-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16", *BARE],
        ["qemu-system-arm", "-M", "mps2-an386", *SEMIHOSTING],
    ),
    "Cortex-M7": (
        ["arm-none-eabi-gcc", "-mcpu=cortex-m7", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv5-d16", *BARE],
        ["qemu-system-arm", "-M", "mps2-an500", *SEMIHOSTING],
    ),
}


@pytest.fixture(scope="module")
def library(tmp_path_factory):
    return library_of(FMUS / f"{MODEL}.fmu", "linux64", ".so", tmp_path_factory.mktemp("library"))


@pytest.fixture(scope="module")
def header(tmp_path_factory):
    """The header of the sources of a model, which are made when they are needed."""
    folder = tmp_path_factory.mktemp("sources")

    def of(model):
        if model not in c_sources.headers(folder):
            c_sources.make("sources", model, "--out", folder)
        return c_sources.headers(folder)[model]

    return of


@pytest.mark.parametrize(("model", "optimised"), CASES)
@pytest.mark.parametrize("processor", PROCESSORS)
def test_sources_have_the_bits_of_the_library_on(processor, model, optimised, header, library):
    compiler, machine = PROCESSORS[processor]
    rows = c_sources.motion(model, 1000)
    words = [*compiler, *c_sources.WARNINGS, optimised]
    program = c_sources.compiled(header(model), words, f"_{processor}{optimised}".replace(" ", "_"))
    answer = c_sources.answer([*machine, str(program)], c_sources.question(model, rows))
    assert answer == c_sources.of_library(model, rows, library)


def test_laws_side_by_side_in_the_registers_of_arm():
    target = "aarch64-unknown-linux-gnu"
    variable = "CARGO_TARGET_" + target.upper().replace("-", "_")
    linker, runner = "aarch64-linux-gnu-gcc", "qemu-aarch64-static -L /usr/aarch64-linux-gnu"
    settings = {**os.environ, f"{variable}_LINKER": linker, f"{variable}_RUNNER": runner}
    command = ["cargo", "test", "--package", "stribeck", "--test", "batch", "--target", target]
    subprocess.run(command, cwd=PROJECT, env=settings, check=True)
