"""Checks of the packed libraries that do not run them, and proof that the checks of the packer can fail."""

import os
import shutil
import struct
import subprocess
import zipfile
from pathlib import Path

import pytest
from lief import ELF, PE, MachO
from mach_o import PAGE, pages_that_differ, part_of, processors
from machines import ARM, FMUS, library_of

from examples.fmpy.coupling import PROJECT, models_in

SUFFIXES = {"linux64": ".so", "win64": ".dll", "darwin64": ".dylib", ARM: ".so"}
OLDEST_MACOS = [11, 0, 0]
# Of a segment, which may have one of the two only.
WRITE_AND_EXECUTE = 2 | 4


@pytest.fixture(scope="module")
def libraries(tmp_path_factory) -> dict[str, Path]:
    """The packed library of each platform."""
    folder = tmp_path_factory.mktemp("packed")
    model = models_in(FMUS)[0]
    return {
        platform: library_of((FMUS / ARM if platform == ARM else FMUS) / f"{model}.fmu", platform, suffix, folder)
        for platform, suffix in SUFFIXES.items()
    }


@pytest.fixture(scope="module")
def packer() -> Path:
    """The program that packs."""
    subprocess.run(["cargo", "build", "--package", "fmu-build"], cwd=PROJECT, check=True)
    return PROJECT / "target" / "debug" / "fmu-build"


def inspect(packer: Path, library: Path, platform: str) -> str | None:
    """The complaint of the packer about a library."""
    command = [packer, "inspect", library, "--platform", platform]
    done = subprocess.run(command, cwd=PROJECT, capture_output=True, text=True)
    return None if done.returncode == 0 else done.stderr


def load_command(number: int, *words: int) -> bytes:
    """The beginning of a load command of Mach-O."""
    return struct.pack(f"<{1 + len(words)}I", number, *words)


# For each library: the replaced bytes, their replacement, and the expected message.
# In the tree of names of Mach-O `fmi2DoStep` is cut into pieces.
NAME = (b"oStep\0", b"oStap\0", "exports")
PATH = (b"", os.fsencode(PROJECT / "src"), "contains the path")
MISTAKES = {
    "linux64": [
        NAME,
        PATH,
        (b"GLIBC_2.14", b"GLIBC_2.34", "newer than glibc 2.17"),
        (b"libc.so.6", b"libq.so.6", "needs"),
    ],
    "win64": [NAME, PATH, (b"KERNEL32.dll", b"KERNEL33.dll", "needs KERNEL33.dll")],
    "darwin64": [
        NAME,
        PATH,
        (b"/usr/lib/libSystem.B.dylib", b"/usr/lib/libSystem.C.dylib", "needs /usr/lib/libSystem.C.dylib"),
        (b"@rpath/libstribeck.dylib", b"/build/libstribeck.dylib", "is called /build/libstribeck.dylib"),
        # Build version: macOS, 11.0; UUID; code signature.
        (load_command(0x32, 32, 1, 11 << 16), load_command(0x32, 32, 1, 15 << 16), "for macOS 15.0"),
        (load_command(0x1B, 24), load_command(0x7F, 24), "has no UUID"),
        (load_command(0x1D, 16), load_command(0x1E, 16), "is not signed"),
    ],
    ARM: [NAME, PATH, (b"GLIBC_2.17", b"GLIBC_2.34", "newer than glibc 2.17"), (b"libc.so.6", b"libq.so.6", "needs")],
}


@pytest.mark.parametrize("platform", SUFFIXES)
def test_the_packer_accepts_its_library_and_rejects_a_doctored_one(packer, libraries, platform, tmp_path):
    assert inspect(packer, libraries[platform], platform) is None
    good = libraries[platform].read_bytes()
    for old, new, complaint in MISTAKES[platform]:
        assert old in good
        doctored = tmp_path / "doctored"
        doctored.write_bytes(good.replace(old, new) if old else good + new)
        said = inspect(packer, doctored, platform)
        assert said is not None, complaint
        assert complaint in said
        assert str(doctored) in said
    print(f"figure: {platform}: {len(MISTAKES[platform])} doctored libraries rejected")


# Format and processor of a library, as the packer names them.
MACHINES = {
    "linux64": "Elf for X86_64",
    "win64": "Pe for X86_64",
    "darwin64": "MachO for X86_64 and MachO for Aarch64",
    ARM: "Elf for Aarch64",
}


@pytest.mark.parametrize("platform", SUFFIXES)
def test_a_library_of_another_platform_is_rejected(packer, libraries, platform):
    for other in SUFFIXES.keys() - {platform}:
        said = inspect(packer, libraries[other], platform)
        assert said is not None, other
        assert f"{platform}: is {MACHINES[other]}, not {MACHINES[platform]}\n" in said


@pytest.mark.parametrize("processor", ["Intel", "Apple"])
def test_half_a_library_for_macos_is_rejected(packer, libraries, processor, tmp_path):
    half = tmp_path / "half"
    half.write_bytes(part_of(libraries["darwin64"], processors(libraries["darwin64"])[processor]))
    found = {"Intel": "MachO for X86_64", "Apple": "MachO for Aarch64"}[processor]
    assert f"darwin64: is {found}, not {MACHINES['darwin64']}\n" in inspect(packer, half, "darwin64")


def test_a_library_is_not_for_all_platforms(packer, libraries):
    assert "--platform all: a library is for one platform" in inspect(packer, libraries["linux64"], "all")


@pytest.mark.parametrize("folder", [FMUS, FMUS / ARM], ids=["linux64", ARM])
def test_functions_that_glibc_has_in_no_shared_library_bring_its_licence(folder):
    with zipfile.ZipFile(folder / f"{models_in(folder)[0]}.fmu") as archive:
        library = next(name for name in archive.namelist() if name.startswith("binaries/linux64/"))
        # glibc 2.17 has another function in its place: the one of that name is linked in.
        assert b"__fxstat64\0" in archive.read(library)
        assert b"GNU Lesser General Public" in archive.read("documentation/licenses/glibc.txt")
        assert b'"LGPL-2.1-or-later WITH GCC-exception-2.0-note"' in archive.read("documentation/sbom.cdx.json")


def test_imports_of_the_linux_library(libraries):
    library = ELF.parse(str(libraries["linux64"]))
    versions = {
        tuple(map(int, version.name.removeprefix("GLIBC_").split(".")))
        for needed in library.symbols_version_requirement
        for version in needed.get_auxiliary_symbols()
    }
    newest = ".".join(map(str, max(versions)))
    print(f"figure: linux64 imports: glibc {newest}, {', '.join(sorted(library.libraries))}")
    assert "libgcc_s.so.1" not in library.libraries


def test_imports_of_the_windows_library(libraries):
    library = PE.parse(str(libraries["win64"]))
    names = sorted(needed.name for needed in library.imports)
    print(f"figure: win64 imports: {', '.join(names)}")
    assert "libgcc_s_seh-1.dll" not in names


@pytest.mark.parametrize("options", [[], ["--strict"]], ids=["", "strict"])
def test_a_missing_linker_is_reported_with_the_command_that_installs_it(packer, tmp_path, options):
    """On a search path with only Rust."""
    for program in ("cargo", "rustc"):
        (tmp_path / program).symlink_to(shutil.which(program))
    command = [packer, "pack", *options, "--platform", "win64", "--out", tmp_path / "dist"]
    settings = {**os.environ, "PATH": str(tmp_path)}
    done = subprocess.run(command, cwd=PROJECT, env=settings, capture_output=True, text=True)
    cure = "win64, which lacks the linker for Windows: apt-get install gcc-mingw-w64-x86-64-win32\n"
    assert done.returncode == 1
    assert cure in (done.stderr if options else done.stdout)
    assert not (tmp_path / "dist").exists()


@pytest.mark.parametrize("processor", ["Intel", "Apple"])
def test_macos_finds_what_its_loader_requires(libraries, processor):
    parts = processors(libraries["darwin64"])
    assert set(parts) == {"Intel", "Apple"}
    part = parts[processor]
    page = PAGE if processor == "Apple" else 4096
    assert part.header.file_type == MachO.Header.FILE_TYPE.DYLIB
    assert part.build_version.platform == MachO.BuildVersion.PLATFORMS.MACOS
    assert part.build_version.minos == OLDEST_MACOS
    assert {library.name for library in part.libraries} == {"/usr/lib/libSystem.B.dylib", "@rpath/libstribeck.dylib"}
    assert list(part.rpaths) == []
    assert part.fat_offset % page == 0
    for segment in part.segments:
        assert segment.virtual_address % page == segment.file_offset % page == 0
        assert segment.init_protection & WRITE_AND_EXECUTE != WRITE_AND_EXECUTE
    counts = f"{len(part.exported_symbols)} functions, {len(list(part.bindings))} pointers into libSystem"
    print(f"figure: macOS on the processor of {processor}: {counts}")


def test_the_signature_for_apples_processors_is_that_of_its_pages(libraries):
    parts = processors(libraries["darwin64"])
    assert not parts["Intel"].has_code_signature
    signature = bytes(parts["Apple"].code_signature.content)
    code = bytearray(part_of(libraries["darwin64"], parts["Apple"]))
    different, pages = pages_that_differ(code, signature)
    assert different == 0 < pages
    code[len(code) // 2] ^= 1
    assert pages_that_differ(code, signature)[0] == 1
    print(f"figure: signature for Apple's processors: {pages} pages, {different} differ")
