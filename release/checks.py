"""Tests of a release as a user gets it: from its files alone, in empty folders with a space in their names, and with an
empty search path where no compiler is needed."""

import hashlib
import json
import os
import shlex
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from collections.abc import Callable
from pathlib import Path

from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from release import macos, made
from release.making import PROJECT, VERSION, Release, foreign

# Libraries that every system of a kind has, in lower case; programs for Linux are static.
OF_SYSTEMS = {
    "apple-darwin": {"/usr/lib/libsystem.b.dylib"},
    "linux-musl": set(),
    "windows-gnu": {
        *("api-ms-win-core-synch-l1-2-0.dll", "bcryptprimitives.dll", "kernel32.dll", "msvcrt.dll", "ntdll.dll")
    },
}


class NotChecked(Exception):
    """This machine cannot do a check; the text says why."""


class Failed(Exception):
    """An artefact does not do its job."""


def printed(command: tuple[str | Path, ...], folder: Path, settings: dict[str, str]) -> str:
    """What a command prints; fails with its messages."""
    words = [str(word) for word in command]
    done = subprocess.run(words, cwd=folder, env=settings, capture_output=True, encoding="utf-8", errors="replace")
    if done.returncode != 0:
        raise Failed(f"exit code {done.returncode}: {shlex.join(words)}\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


def call(*command: str | Path, folder: Path, **environment: str) -> str:
    """Runs a command as a user with an empty search path would. Returns what it prints."""
    return printed(command, folder, {"PATH": "", "HOME": str(folder), "LANG": "C.UTF-8", **environment})


def call_here(*command: str | Path, folder: Path, **environment: str) -> str:
    """Runs a command with everything that is on this machine. Returns what it prints."""
    return printed(command, folder, {**os.environ, **environment})


def expect(text: str, wanted: str) -> None:
    """Fails unless the text contains the wanted one."""
    if wanted not in text:
        raise Failed(f"should contain {wanted!r}: {text[-2000:]}")


def unpacked(archive: Path, folder: Path) -> Path:
    """Unpacks an archive; returns its only folder."""
    if archive.suffix == ".zip":
        zipfile.ZipFile(archive).extractall(folder)
    else:
        with tarfile.open(archive) as packed:
            packed.extractall(folder, filter="data")
    return folder / archive.name.removesuffix(".zip").removesuffix(".tar.gz").removesuffix(".crate")


def only(release: Path, pattern: str) -> Path:
    """The file for this machine that has such a name."""
    found = sorted(release.glob(pattern))
    if not found:
        raise NotChecked(f"the release has no {pattern}")
    return found[0]


def program_path(*names: str) -> dict[str, str]:
    """A search path with compilers, if these programs are here."""
    for name in names:
        if shutil.which(name) is None:
            raise NotChecked(f"{name} not found")
    return {"PATH": os.environ["PATH"]}


def sums(release: Path, _: Path) -> str:
    """Every file has its checksum and its line in the list."""
    page = (release / "index.html").read_text(encoding="utf-8")
    lines = (release / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    named = dict(reversed(line.split("  ", 1)) for line in lines)
    files = {path.relative_to(release).as_posix() for path in release.rglob("*") if path.is_file()} - {"SHA256SUMS"}
    if set(named) != files:
        raise Failed(f"with a checksum or there, not both: {sorted(set(named) ^ files)}")
    for name, wanted in named.items():
        if hashlib.sha256((release / name).read_bytes()).hexdigest() != wanted:
            raise Failed(f"{name} has another checksum")
        if name != "index.html" and f'href="{name}"' not in page:
            raise Failed(f"index.html does not list {name}")
    return f"{len(files)} files"


def places(release: Path, _: Path) -> str:
    """No file, also within archives, names a folder of the machine that built it."""
    places = foreign()
    count = 0
    for path in sorted(release.rglob("*")):
        for name, content in made.within(path.name, path.read_bytes()) if path.is_file() else ():
            count += 1
            for place in places:
                if place in content:
                    raise Failed(f"{path.name}: {name} contains {place.decode()}")
    return f"{count} files, those within archives included"


FMPY = """
import sys, tempfile, zipfile
import fmpy
for kind in sys.argv[1:]:
    folder = tempfile.mkdtemp()
    zipfile.ZipFile(kind).extractall(folder)
    name = next(path for path in __import__("pathlib").Path(folder).rglob("Coulomb.fmu"))
    asked = {"output": ["friction_force"], "start_values": {"velocity": 0.1, "normal_force": 20.0, "mu_k": 0.3}}
    result = fmpy.simulate_fmu(str(name), stop_time=0.01, step_size=1e-3, **asked)
    # The level of sliding: mu_k times the normal force.
    assert abs(result["friction_force"][-1] - 0.3 * 20.0) < 1e-12, result["friction_force"][-1]
    print("done", name.stem)
"""


def fmus(release: Path, folder: Path) -> str:
    """A law in fmpy, of both versions of FMI, from the archives."""
    archives = [only(release, f"stribeck-*-{kind}.zip") for kind in ("fmi2", "fmi3")]
    text = call(sys.executable, "-I", "-c", FMPY, *archives, folder=folder, TMPDIR=str(folder))
    if text.count("done Coulomb") != len(archives):
        raise Failed(text)
    return "Coulomb of FMI 2.0 and 3.0 in fmpy"


def c_sources(release: Path, folder: Path) -> str:
    """A law as C for controllers is compiled with all warnings."""
    path = program_path("cc")
    sources = unpacked(only(release, "stribeck-*-c-sources.zip"), folder)
    flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-c"]
    found = sorted(sources.glob("*.c"))[:3]
    if len(found) < 3:
        raise Failed(f"the archive has {len(found)} sources, and three of them are to be compiled")
    for source in found:
        call("cc", *flags, source.name, "-o", source.stem + ".o", folder=sources, **path)
    return "three laws compiled as C99"


def kit(release: Path) -> Path:
    """The kit for this machine."""
    names = {"linux": "linux64", "darwin": "darwin64", "win32": "win64"}
    return only(release, f"sdk/stribeck-*-sdk-{names.get(sys.platform, sys.platform)}.*")


def cmake(release: Path, folder: Path) -> str:
    """The examples by find_package, with the shared and the static library."""
    cmake = Path(sys.executable).parent / "cmake"
    path = program_path("cc", "c++", "make")
    if not cmake.exists() and shutil.which("cmake") is None:
        raise NotChecked("cmake not found")
    program = cmake if cmake.exists() else Path(shutil.which("cmake"))
    sdk = unpacked(kit(release), folder)
    examples = shutil.copytree(sdk / "share" / "stribeck" / "examples", folder / "my programs")
    text = (examples / "CMakeLists.txt").read_text(encoding="utf-8")
    # As a user's own project would have it: the place comes from the command line.
    own = text.replace(' PATHS "${CMAKE_CURRENT_LIST_DIR}/../../.." NO_DEFAULT_PATH', "")
    (examples / "CMakeLists.txt").write_text(own, encoding="utf-8")
    call(program, "-S", examples, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={sdk}", folder=folder, **path)
    call(program, "--build", folder / "build", folder=folder, **path)
    for linked in ("stribeck", "static"):
        expect(call(folder / "build" / f"belt_{linked}", folder=folder), "identical to the last bit")
        expect(call(folder / "build" / f"fmu_master_{linked}", folder=folder), "slips 5 times")
        call(folder / "build" / f"hysteresis_{linked}", "loop.csv", folder=folder)
    wanted = VERSION.split(".")
    for version in (f"{wanted[0]}.{int(wanted[1]) + 1}", "99"):
        asked = own.replace(f"find_package(stribeck {VERSION}", f"find_package(stribeck {version}")
        (examples / "CMakeLists.txt").write_text(asked, encoding="utf-8")
        try:
            call(program, "-S", examples, "-B", folder / version, f"-DCMAKE_PREFIX_PATH={sdk}", folder=folder, **path)
        except Failed as refusal:
            # Another message is that of a package that is not found.
            expect(" ".join(str(refusal).split()), f'compatible with requested version "{version}"')
            continue
        raise Failed(f"find_package takes {VERSION} for {version}")
    return "seven programs in C and C++, shared and static; later versions refused"


def pkg_config(release: Path, folder: Path) -> str:
    """Programs in C and C++ by pkg-config."""
    path = program_path("pkg-config", "cc", "c++")
    sdk = unpacked(kit(release), folder)
    path["PKG_CONFIG_PATH"] = str(sdk / "lib" / "pkgconfig")
    examples = sdk / "share" / "stribeck" / "examples"
    version = call("pkg-config", "--modversion", "stribeck", folder=folder, **path).strip()
    if version != VERSION:
        raise Failed(f"pkg-config says version {version}")
    flags = shlex.split(call("pkg-config", "--cflags", "--libs", "stribeck", folder=folder, **path))
    static = shlex.split(
        call("pkg-config", "--cflags", "--libs-only-other", "--static", "stribeck", folder=folder, **path)
    )
    private = shlex.split(call("pkg-config", "--libs-only-l", "--static", "stribeck", folder=folder, **path))
    private = [flag for flag in private if flag != "-lstribeck"]
    search = [f"-Wl,-rpath,{sdk / 'lib'}", "-lm"]
    for name, compiler in {"belt.c": ["cc", "-std=c99"], "hysteresis.cpp": ["c++", "-std=c++17"]}.items():
        call(*compiler, examples / name, "-o", folder / "shared", *flags, *search, folder=folder, **path)
        library = sdk / "lib" / "libstribeck.a"
        call(*compiler, examples / name, "-o", folder / "static", *static, library, *private, folder=folder, **path)
        arguments = ["loop.csv"] if name.endswith("cpp") else []
        both = [call(folder / linked, *arguments, folder=folder) for linked in ("shared", "static")]
        if both[0] != both[1] or not both[0]:
            raise Failed(f"{name}: the shared and the static library print different results")
    return "a program in C and one in C++, shared and static"


def program(release: Path, folder: Path) -> str:
    """The program's first run, without anything else on the machine; page, completions and manual."""
    machine = {"linux": "x86_64-unknown-linux-musl"}.get(sys.platform, "*")
    place = unpacked(only(release, f"program/stribeck-*-{machine}.*"), folder)
    stribeck = place / "stribeck"
    expect(call(stribeck, "--version", folder=folder), VERSION)
    expect(call(stribeck, "models", folder=folder), "LuGre")
    call(stribeck, "run", "--system", "belt", "--law", "CoulombStiction", "--out", "belt.csv", folder=folder)
    rows = (folder / "belt.csv").read_text(encoding="utf-8").splitlines()
    if len(rows) < 4000:
        raise Failed(f"belt.csv has {len(rows)} rows, and 40 s every 10 ms were asked for")
    if (place / "page.html").is_file():
        call(stribeck, "page", "--out", "page.html", folder=folder)
    for name in ("completions/stribeck.bash", "man/man1/stribeck.1", "man/man1/stribeck-identify.1"):
        expect((place / name).read_text(encoding="utf-8"), "identify")
    script = place / "completions" / "stribeck.bash"
    if shutil.which("bash") is not None:
        ask = "COMP_WORDS=(stribeck ide); COMP_CWORD=1; _stribeck stribeck ide stribeck; echo ${COMPREPLY[@]}"
        expect(call(shutil.which("bash"), "-c", f"source {shlex.quote(str(script))}; {ask}", folder=folder), "identify")
    return "models and a run; completions of bash; manual pages"


def headers(release: Path, folder: Path) -> str:
    """Programs for all systems need only what these have; Apple's processors get signed ones."""
    try:
        import lief
    except ImportError:
        raise NotChecked("lief not found: .venv/bin/python -m pip install -r requirements-platforms.txt") from None
    found = sorted((release / "program").glob("stribeck-*"))
    if not found:
        raise NotChecked("the release has no program")
    for packed in found:
        (system,) = (name for name in OF_SYSTEMS if name in packed.name)
        name = "stribeck.exe" if "windows" in system else "stribeck"
        binary = lief.parse(str(unpacked(packed, folder) / name))
        needed = {getattr(library, "name", library).lower() for library in binary.libraries}
        if not needed <= OF_SYSTEMS[system]:
            raise Failed(f"{packed.name} needs {', '.join(sorted(needed - OF_SYSTEMS[system]))}")
        if "apple" in packed.name:
            oldest = ".".join(map(str, binary.build_version.minos[:2]))
            if oldest != macos.OLDEST:
                raise Failed(f"{packed.name} is for macOS {oldest} or newer, not {macos.OLDEST}")
            if "aarch64" in packed.name and not binary.has_code_signature:
                raise Failed(f"{packed.name} is not signed, which Apple's processors require")
    return f"{len(found)} programs need nothing but their systems"


def environment(folder: Path) -> Path:
    """A virtual environment of Python; its Python."""
    call(sys.executable, "-m", "venv", folder / "my python", folder=folder, PATH=os.environ["PATH"])
    return folder / "my python" / ("Scripts" if os.name == "nt" else "bin") / "python"


def pip(python: Path) -> list[str | Path]:
    """The words that install something."""
    return [python, "-m", "pip", "--disable-pip-version-check", "--quiet", "install"]


TOUR = """
import numpy, stribeck
assert len(stribeck.laws()) > 30
force = stribeck.force("Coulomb", numpy.array([-0.1, 0.1]), 20.0, mu_k=0.3)
assert numpy.allclose(force, [-6.0, 6.0]), force
print(stribeck.solve("belt", "CoulombStiction", until=12.0).events[0])
print(stribeck.fmu("LuGre"))
"""


def wheel(release: Path, folder: Path) -> str:
    """pip install, and what the package's page shows first."""
    tags = {"linux": "*linux*x86_64", "darwin": "macosx*", "win32": "win_amd64"}
    packed = only(release, f"python/stribeck-*-{tags.get(sys.platform, '*')}.whl")
    python = environment(folder)
    call_here(*pip(python), packed, folder=folder)
    text = call(python, "-I", "-c", TOUR, folder=folder, STRIBECK_CACHE=str(folder / "cache"))
    expect(text, "LuGre.fmu")
    return f"{packed.name} in a new environment of Python {sys.version.split()[0]}"


def sdist(release: Path, folder: Path) -> str:
    """The sources of the package become a wheel, without the repository; not optimised, which would take long."""
    program_path("cargo", "cc")
    packed = only(release, "python/stribeck-*.tar.gz")
    cheap = {"LTO": "off", "OPT_LEVEL": "0", "CODEGEN_UNITS": "16", "STRIP": "none"}
    settings = {f"CARGO_PROFILE_RELEASE_{name}": value for name, value in cheap.items()}
    settings |= {"CARGO_TARGET_DIR": str(folder / "target"), "TMPDIR": str(folder)}
    python = environment(folder)
    call_here(*pip(python), packed, folder=folder, **settings)
    text = call(python, "-I", "-c", "import stribeck; print(len(stribeck.laws()))", folder=folder)
    return f"built by maturin, {text.strip()} laws"


def crates(release: Path, folder: Path) -> str:
    """The core, unpacked, compiles by itself; the others ask for crates that no registry has yet."""
    program_path("cargo", "cc")
    packed = only(release, "crates/stribeck-[0-9]*.crate")
    place = unpacked(packed, folder)
    call_here("cargo", "check", "--quiet", "--target-dir", folder / "target", folder=place)
    return f"{packed.name} compiles alone"


OPENED = """
import { chromium } from "playwright-core";
const [program, address] = process.argv.slice(1);
const browser = await chromium.launch({ executablePath: program, args: ["--no-sandbox"] });
const page = await browser.newPage();
page.on("console", (message) => console.log("message:", message.text()));
await page.goto(address);
await page.waitForSelector('[data-kind="force-over-time"] canvas', { timeout: 120000 });
console.log("drawn");
await browser.close();
"""


def page(release: Path, _: Path) -> str:
    """The page draws its first curves in Chromium."""
    file = only(release, "page.html")
    chromium = shutil.which("chromium")
    if chromium is None or shutil.which("node") is None:
        raise NotChecked("chromium or node not found")
    # Playwright is that of the page's tests.
    web = PROJECT / "web"
    text = call_here("node", "--input-type=module", "--eval", OPENED, chromium, file.as_uri(), folder=web)
    if text.strip() != "drawn":
        raise Failed(text)
    return "opened as a file in Chromium"


def components(release: Path, _: Path) -> str:
    """The lists of components conform to CycloneDX 1.5, and every component has a licence."""
    validator = JsonStrictValidator(SchemaVersion.V1_5)
    texts = {}
    for path in sorted(release.rglob("*")):
        if path.name == "sbom.cdx.json" or path.suffix in (".zip", ".gz", ".fmu", ".ssp", ".whl"):
            found = made.within(path.name, path.read_bytes())
            texts |= {f"{path.name}: {name}": content for name, content in found if name.endswith("sbom.cdx.json")}
    for name, content in texts.items():
        fault = validator.validate_str(content.decode())
        listed = json.loads(content).get("components", [])
        bare = [one.get("name") for one in listed if one.get("type") == "library" and not one.get("licenses")]
        if fault is not None or bare:
            raise Failed(f"{name}: {fault}; without a licence: {bare}")
    if "sbom.cdx.json: sbom.cdx.json" not in texts:
        raise NotChecked("the release has no sbom.cdx.json")
    return f"{len(texts)} lists"


CHECKS: list[Callable[[Path, Path], str]] = [
    *(sums, places, fmus, c_sources, cmake, pkg_config, program, headers, wheel, sdist, crates, page, components),
]


def main(release: Release) -> int:
    """Runs all checks; says what was not checked. Returns an exit code."""
    failed = 0
    for check in CHECKS:
        with tempfile.TemporaryDirectory(prefix="a user of it ") as folder:
            try:
                print(f"figure: {check.__name__}: {check(release.folder.resolve(), Path(folder))}", flush=True)
            except NotChecked as reason:
                print(f"figure: {check.__name__}: NOT CHECKED: {reason}", flush=True)
            except Failed as fault:
                failed += 1
                print(f"figure: {check.__name__}: FAILED: {fault}", flush=True)
    others = [name for name in release.platforms if name not in ("host", "linux64")]
    for name in others:
        print(f"figure: library and wheel for {name}: NOT RUN here; `tasks.py platforms` and `wheels` run them")
    return 1 if failed else 0
