"""The wheels for all platforms, built on this machine: their headers and imports, and results where they run here."""

import platform
import subprocess
import sys
import zipfile
from pathlib import Path

import arm
import pytest
from lief import ELF, PE, MachO

PROJECT = Path(__file__).resolve().parents[2]
WHEELS = PROJECT / "dist" / "wheels"
OUT = PROJECT / "out" / "wheels"
LARGEST = 6_000_000
NUMPY = "numpy==2.4.6"

# The last tag of each wheel, and the folder of its FMUs.
KINDS = {
    "manylinux_2_17_x86_64": "linux64",
    "manylinux_2_17_aarch64": "aarch64-linux/aarch64-linux",
    "win_amd64": "win64",
    "macosx_11_0_arm64": "darwin64",
    "macosx_11_0_x86_64": "darwin64",
}
# What every system has, in lower case.
OF_LINUX = {"libc.so.6", "libm.so.6", "libdl.so.2", "libpthread.so.0", "librt.so.1"}
LOADERS = {"ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
OF_WINDOWS = {"kernel32.dll", "ntdll.dll", "msvcrt.dll", "bcryptprimitives.dll", "userenv.dll", "ws2_32.dll"}
SYNCHRONISATION = "api-ms-win-core-synch-l1-2-0.dll"
OF_MACOS = {"/usr/lib/libSystem.B.dylib", "/usr/lib/libiconv.2.dylib", "/usr/lib/libcharset.1.dylib"}
OLDEST_GLIBC = (2, 17)
OLDEST_MACOS = [11, 0, 0]

# Results of many runs of all laws, of a system and of a fit, as one number.
CODE = """
import hashlib, numpy, stribeck
draw = numpy.random.default_rng(3)
found = hashlib.sha256()
for law in stribeck.laws():
    inputs = {name: 5e-3 * draw.normal(size=(5, 40)) for name in law.inputs}
    for name in inputs:
        if name.startswith("normal_"):
            inputs[name] = numpy.abs(1e3 * inputs[name])
    for held in (True, False):
        result = stribeck.simulate(law, dt=1e-3, held=held, **inputs)
        for name in result.columns:
            found.update(result[name].tobytes())
    if "velocity" in law.inputs and law.name != "Bristle":
        found.update(stribeck.force(law, numpy.linspace(-0.01, 0.01, 20), 10.0).tobytes())
for law in ("LuGre", "CoulombStiction", "BrownMcPhee"):
    motion = stribeck.solve("belt", law, until=12.0)
    found.update(repr(motion.events).encode())
    for name in motion:
        found.update(motion[name].tobytes())
print(found.hexdigest())
"""


@pytest.fixture(params=KINDS)
def kind(request):
    return request.param


def wheel_of(kind):
    (one,) = WHEELS.glob(f"stribeck-*{kind}.whl")
    return one


def module_of(kind):
    """The extension module."""
    with zipfile.ZipFile(wheel_of(kind)) as wheel:
        (name,) = (name for name in wheel.namelist() if name.startswith("stribeck/_stribeck.") and "pyi" not in name)
        return wheel.read(name)


def test_a_wheel_is_small_and_holds_this_python(kind):
    with zipfile.ZipFile(wheel_of(kind)) as wheel:
        found = {name: wheel.read(name) for name in wheel.namelist() if name.endswith((".py", ".pyi"))}
    folder = PROJECT / "python"
    here = [path for path in (folder / "stribeck").rglob("*.py*") if path.suffix in (".py", ".pyi")]
    assert found == {path.relative_to(folder).as_posix(): path.read_bytes() for path in here}
    size = wheel_of(kind).stat().st_size
    print(f"figure: wheel for {kind}: {size / 1e6:.2f} MB")
    assert size <= LARGEST


def test_a_wheel_holds_the_fmus_of_its_platform(kind):
    packed = OUT / KINDS[kind]
    with zipfile.ZipFile(wheel_of(kind)) as wheel:
        read = {name.rpartition("/")[2]: wheel.read(name) for name in wheel.namelist() if "/fmus/" in name}
    shared = read["order"].decode().split()
    fmus = sorted(packed.glob("*.fmu"))
    assert len(fmus) == sum(name.endswith(".0") for name in read) > 50
    for fmu in fmus:
        content = read[f"{fmu.stem}.0"]
        for number, name in enumerate(shared, 1):
            content += read[name] + read[f"{fmu.stem}.{number}"]
        assert content == fmu.read_bytes(), fmu.stem


def test_the_module_keeps_to_the_stable_interface(kind):
    done = subprocess.run(
        [sys.executable, "-m", "abi3audit", "--strict", wheel_of(kind)], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    assert "-cp310-abi3-" in wheel_of(kind).name


def test_no_path_of_this_machine_is_in_the_module(kind):
    module = module_of(kind)
    for path in (PROJECT, Path.home() / ".cargo"):
        assert str(path).encode() not in module


@pytest.mark.parametrize(("kind", "machine"), [("x86_64", ELF.ARCH.X86_64), ("aarch64", ELF.ARCH.AARCH64)])
def test_linux_finds_what_the_module_needs(kind, machine):
    module = ELF.parse(list(module_of(f"manylinux_2_17_{kind}")))
    assert module.header.machine_type == machine
    assert {name.lower() for name in module.libraries} <= OF_LINUX | LOADERS
    versions = [
        tuple(map(int, version.name.removeprefix("GLIBC_").split(".")))
        for needed in module.symbols_version_requirement
        for version in needed.get_auxiliary_symbols()
    ]
    print(f"figure: wheel for Linux on {kind}: glibc {'.'.join(map(str, max(versions)))}")
    assert max(versions) <= OLDEST_GLIBC
    assert any(symbol.name == "PyInit__stribeck" for symbol in module.exported_symbols)


def test_windows_finds_what_the_module_needs():
    module = PE.parse(list(module_of("win_amd64")))
    assert module.header.machine == PE.Header.MACHINE_TYPES.AMD64
    names = {needed.name.lower() for needed in module.imports}
    print(f"figure: wheel for Windows: {', '.join(sorted(names))}")
    assert "python3.dll" in names, "the library of the stable interface, which every Python has"
    assert names <= OF_WINDOWS | {"python3.dll", SYNCHRONISATION}
    assert [entry.name for entry in module.get_export().entries] == ["PyInit__stribeck"]


@pytest.mark.parametrize(
    ("kind", "machine"), [("arm64", MachO.Header.CPU_TYPE.ARM64), ("x86_64", MachO.Header.CPU_TYPE.X86_64)]
)
def test_macos_finds_what_the_module_needs(kind, machine, tmp_path):
    file = tmp_path / "_stribeck.abi3.so"
    file.write_bytes(module_of(f"macosx_11_0_{kind}"))
    module = MachO.parse(str(file)).take(machine)
    assert module is not None
    assert module.build_version.platform == MachO.BuildVersion.PLATFORMS.MACOS
    assert module.build_version.minos == OLDEST_MACOS
    needed = {library.name for library in module.libraries if "_stribeck" not in library.name}
    print(f"figure: wheel for macOS on {kind}: {', '.join(sorted(needed))}")
    assert needed <= OF_MACOS
    # Names without a library are looked for in the program, which is Python.
    loose = {one.symbol.name for one in module.bindings if not one.has_library}
    assert loose
    assert all(name.startswith(("_Py", "__Py")) for name in loose), loose
    assert module.has_code_signature or kind != "arm64", "Apple's processors require a signature"
    assert any(symbol.name == "_PyInit__stribeck" for symbol in module.exported_symbols)


@pytest.fixture(scope="module")
def here(tmp_path_factory):
    """Results of the wheel for this machine."""
    packages = tmp_path_factory.mktemp("here")
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--target", packages, "--only-binary=:all:"]
    subprocess.run([*pip, "--no-deps", NUMPY, wheel_of("manylinux_2_17_x86_64")], check=True)
    code = f"import sys; sys.path.append({str(packages)!r})\n{CODE}"
    done = subprocess.run([sys.executable, "-I", "-S", "-c", code], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_bits_on_arm_are_those_here(here, tmp_path):
    assert platform.machine() == "x86_64"
    root = arm.python(OUT / "arm")
    arm.install(tmp_path, NUMPY, wheel_of("manylinux_2_17_aarch64"))
    assert arm.output(root, tmp_path, CODE) == here
    print("figure: wheel for Linux on ARM, under qemu: runs of all laws and three systems, equal to the last bit")
