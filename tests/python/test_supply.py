"""An FMU's account of its own parts: the list of components, the licences, and the library that contains them."""

import copy
import json
import os
import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from examples.fmpy.coupling import FMUS, PROJECT

SCHEMA = JsonStrictValidator(SchemaVersion.V1_5)
LICENSES = "documentation/licenses/"
# Before any test has run: with another search path, cargo would build the Python package again.
ENVIRONMENT = dict(os.environ)


@pytest.fixture(params=sorted(FMUS.glob("*.fmu")), ids=lambda path: path.stem)
def fmu(request) -> dict[str, bytes]:
    """The files of an FMU."""
    return files_of(request.param)


def files_of(path: Path) -> dict[str, bytes]:
    with zipfile.ZipFile(path) as archive:
        return {name: archive.read(name) for name in archive.namelist()}


def components_of(fmu: dict[str, bytes]) -> dict[str, dict]:
    """Components of an FMU by name and version."""
    components = json.loads(fmu["documentation/sbom.cdx.json"])["components"]
    return {f"{component['name']} {component.get('version')}": component for component in components}


def test_list_of_components_conforms_to_the_schema(fmu):
    assert SCHEMA.validate_str(fmu["documentation/sbom.cdx.json"].decode()) is None


@pytest.mark.parametrize(
    "spoil",
    [
        lambda sbom: sbom["components"][0].pop("name"),
        lambda sbom: sbom["components"][0].update(type="crate"),
        lambda sbom: sbom["components"][0]["hashes"][0].update(content="0123"),
        lambda sbom: sbom["dependencies"].append(copy.deepcopy(sbom["dependencies"][0])),
        lambda sbom: sbom.update(serialNumber="1"),
    ],
)
def test_schema_rejects_a_broken_list(spoil, dist):
    sbom = json.loads(files_of(dist / "LuGre.fmu")["documentation/sbom.cdx.json"])
    spoil(sbom)
    assert SCHEMA.validate_str(json.dumps(sbom)) is not None


def test_every_crate_has_its_licence_in_the_fmu(fmu):
    text = fmu[LICENSES + "crates.txt"].decode()
    crates = {name: part for name, part in components_of(fmu).items() if part.get("purl", "").startswith("pkg:cargo/")}
    assert len(crates) > 3
    for name, part in crates.items():
        assert f"\n{name}: {part['licenses'][0]['expression']}\n" in text
        assert re.search(rf"^LICEN[CS]E\S* of {re.escape(name)}$", text, re.MULTILINE), name
    listed = re.findall(r"^(\S+ [\d.]+): ", text, re.MULTILINE)
    assert sorted(listed) == sorted(crates)


def test_entry_of_the_licences_names_the_other_files(fmu):
    entry = fmu[LICENSES + "license.txt"].decode()
    others = [name.removeprefix(LICENSES) for name in fmu if name.startswith(LICENSES)]
    assert all(name in entry for name in others if name != "license.txt")


def test_tables_of_the_standard_library_bring_the_licence_of_unicode(fmu):
    assert fmu[LICENSES + "unicode.txt"].startswith(b"UNICODE LICENSE V3")
    standard_library = next(part for name, part in components_of(fmu).items() if name.startswith("rust-std "))
    assert standard_library["licenses"][0]["expression"].endswith(" AND Unicode-3.0")


def test_all_fmus_have_the_same_parts():
    parts = [components_of(files_of(path)) for path in sorted(FMUS.glob("*.fmu"))]
    assert len(parts) > 1
    assert all(part == parts[0] for part in parts)


def test_crates_of_the_standard_library_have_notices(dist):
    """If code may panic, a library contains the path of its source."""
    fmu = files_of(dist / "LuGre.fmu")
    library = next(data for name, data in fmu.items() if name.startswith("binaries/"))
    of_std = re.findall(r"/rust/deps/([\w-]+?)-(\d+\.\d[\w.+-]*)/", library.decode("latin-1"))
    assert of_std, "paths of the standard library's own crates"
    noticed = fmu[LICENSES + "rust.html"].decode()
    beside = re.search(
        r"rust\.html may leave out (.*?)\(Unlicense\)", fmu[LICENSES + "license.txt"].decode(), re.DOTALL
    )
    others = re.findall(r"\w+", beside[1])
    assert [name for name, version in of_std if f" {name}-{version}<" not in noticed and name not in others] == []


@pytest.fixture(scope="module")
def built() -> dict[str, Path]:
    """The libraries as the tests build them, by their file names."""
    # With a benchmark, crates have the features with which the tests have built them.
    command = ["cargo", "build", "--workspace", "--lib", "--bench", "stribeck", "--message-format", "json"]
    text = subprocess.run(command, cwd=PROJECT, env=ENVIRONMENT, check=True, capture_output=True, text=True).stdout
    artifacts = [line for line in map(json.loads, text.splitlines()) if line["reason"] == "compiler-artifact"]
    return {Path(name).name: Path(name) for item in artifacts for name in item["filenames"]}


def exports_of(library: Path) -> list[str]:
    """The symbols that a shared library offers to others."""
    command = ["nm", "--dynamic", "--defined-only", library]
    listed = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return [line.split()[-1] for line in listed.splitlines()]


@pytest.mark.skipif(sys.platform != "linux", reason="nm lists the symbols of ELF libraries")
@pytest.mark.parametrize(("crate", "begins"), [("stribeck", None), ("stribeck_ffi", ("fmi2", "fmi3", "stribeck_"))])
def test_only_the_library_exports_c_functions(built, tmp_path, crate, begins):
    """A WebAssembly build or a Python extension links the models and exports nothing but its own functions."""
    rlib = built[f"lib{crate}.rlib"]
    source, library = tmp_path / "empty.rs", tmp_path / "libempty.so"
    source.write_text(f"extern crate {crate} as _;\n", encoding="utf-8")
    command = ["rustc", "--crate-type", "cdylib", source, "-o", library, "--extern", f"{crate}={rlib}"]
    subprocess.run([*command, "-L", f"dependency={rlib.parent / 'deps'}"], check=True)
    exported = exports_of(library)
    if begins is None:
        assert exported == []
    else:
        assert exported
        assert [name for name in exported if not name.startswith(begins)] == []
        # The library of this name adds nothing.
        assert sorted(exported) == sorted(exports_of(built["libstribeck.so"]))


@pytest.mark.skipif(sys.platform != "linux", reason="elsewhere a library has its symbols in a separate file")
def test_crates_that_symbols_and_paths_name_are_listed(built, dist):
    """The library in an FMU has no symbols, and no paths if nothing can panic; that of the tests has both."""
    library = built["libstribeck.so"].read_bytes().decode("latin-1")
    # Both forms in which Rust writes names: the crate follows the number of its letters.
    symbols = re.findall(r"(?:_ZN|Cs[0-9A-Za-z]*_)(\d+)([A-Za-z]\w*)", library)
    command = ["rustc", "--print", "target-libdir"]
    folder = Path(subprocess.run(command, cwd=PROJECT, check=True, capture_output=True, text=True).stdout.strip())
    of_std = {path.name.removeprefix("lib").rpartition("-")[0] for path in folder.glob("lib*.rlib")}
    named = {name[: int(length)] for length, name in symbols} - of_std
    crates = components_of(files_of(dist / "LuGre.fmu"))
    # Functions that are inlined everywhere, as those of nalgebra, have no symbol, and no path if they cannot panic.
    assert named >= {"libm", "stribeck"}
    assert named <= {crate.partition(" ")[0].replace("-", "_") for crate in crates}
    paths = set(re.findall(r"/registry/src/[^/]+/([\w-]+?)-(\d+\.\d[\w.+-]*)/", library))
    assert "libm" in dict(paths)
    assert {f"{name} {version}" for name, version in paths} <= set(crates)


@pytest.mark.skipif(sys.platform != "linux", reason="only ELF libraries name the compiler")
def test_standard_library_has_the_version_of_the_compiler(dist):
    fmu = files_of(dist / "LuGre.fmu")
    library = next(data for name, data in fmu.items() if name.startswith("binaries/linux64/"))
    compiler = re.search(rb"rustc version ([\d.]+)", library)
    assert compiler is not None
    assert f"rust-std {compiler[1].decode()}" in components_of(fmu)
