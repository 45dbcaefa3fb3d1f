"""Machines that run the packed libraries here: this machine's processor, wine and qemu."""

import os
import shlex
import subprocess
import zipfile
from dataclasses import dataclass
from pathlib import Path

from mach_o import processors, write_assembly

from examples.fmpy.coupling import PROJECT

OUT = PROJECT / "out" / "platforms"
FMUS = OUT / "fmus"
COPY = OUT / "copy"
FMUS_OF_COPY = OUT / "fmus-of-copy"
ARM = "aarch64-linux"
MAC_ARM = "darwin64 on Apple's processors"
WINE = Path("/usr/lib/wine/wine64")  # the only place in Debian's package
WINE_FILES = OUT / "wine"


def run(command: list[str | Path], environment: dict[str, str] | None = None) -> str:
    """Runs a command that must succeed without error output, and returns its output."""
    words = [str(word) for word in command]
    settings = {**os.environ, **(environment or {})}
    done = subprocess.run(words, capture_output=True, text=True, timeout=300, env=settings)
    assert done.returncode == 0, f"{shlex.join(words)}\nexit code {done.returncode}\n{done.stdout}{done.stderr}"
    assert not done.stderr, f"{shlex.join(words)}\n{done.stderr}"
    return done.stdout


@dataclass(frozen=True)
class Machine:
    """A platform whose programs run here."""

    platform: str
    compiler: list[str]
    runner: list[str]
    library: Path
    environment: dict[str, str]

    def compile(self, source: Path, *arguments: str | Path) -> Path:
        """Compiles a C program, next to the library."""
        program = self.library.parent / f"{source.stem}.exe"
        run([*self.compiler, "-std=c99", "-O2", f"-I{PROJECT / 'include'}", source, "-o", program, *arguments])
        return program

    def run(self, program: Path, *arguments: str | Path) -> str:
        """The output of the program, with plain line ends."""
        output = run([*self.runner, program, *arguments], self.environment)
        return output.replace("\r\n", "\n")


def for_linux(library: Path, processor: str, compiler: list[str]) -> Path:
    """The code of the library for macOS as a library for Linux on the same processor."""
    folder = library.parent / processor
    folder.mkdir()
    source = write_assembly(processors(library)[processor], folder)
    converted = folder / "libstribeck.so"
    shims = Path(__file__).with_name("macos.c")
    flags = ["-shared", "-fPIC", "-O2", "-Wl,-z,defs", "-Wl,--no-warn-rwx-segments"]
    run([*compiler, *flags, source, shims, "-o", converted, "-lm", "-lgcc_s"])
    return converted


def library_of(fmu: Path, platform: str, suffix: str, folder: Path) -> Path:
    """The library of an FMU as a file with the name under which programs search for it."""
    library = folder / platform / ("stribeck.dll" if suffix == ".dll" else f"libstribeck{suffix}")
    library.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(fmu) as archive:
        library.write_bytes(archive.read(f"binaries/{platform}/{fmu.stem}{suffix}"))
    return library
