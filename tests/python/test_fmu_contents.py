"""What an FMU holds beside description and library, in both versions of FMI: terminals, icon, presets, results."""

import csv
import io
import posixpath
import re
import zipfile
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import fmpy
import pytest
from lxml import etree

from examples.fmpy.coupling import FMUS

FOLDERS = {"2.0": FMUS, "3.0": FMUS / "fmi3"}
ALL = [path for folder in FOLDERS.values() for path in sorted(folder.glob("*.fmu"))]
SCHEMA = etree.XMLSchema(file=Path(fmpy.__file__).parent / "schema" / "fmi3" / "fmi3TerminalsAndIcons.xsd")

TERMINALS = "terminalsAndIcons/terminalsAndIcons.xml"
REF, STRUCT = (f"extra/org.fmi-standard.fmi-ls-{name}/fmi-ls-manifest.xml" for name in ("ref", "struct"))
LAYERED = "{http://fmi-standard.org/fmi-ls-manifest}"
VALUES = "{http://ssp-standard.org/SSP1/SystemStructureParameterValues}"
MAP = "org.fmi-standard.fmi-ls-struct.map"
# Folders of libraries (FMI 2.0.5, section 2.3; FMI 3.0.2, section 2.5.1.4).
PLATFORMS = {
    "2.0": r"(linux|win|darwin)(32|64)|aarch64-linux",
    "3.0": r"(x86|x86_64|aarch32|aarch64)-(linux|windows|darwin)",
}
Files = dict[str, bytes]


def files_of(path: Path) -> Files:
    with zipfile.ZipFile(path) as archive:
        return {name: b"" if name.startswith("binaries/") else archive.read(name) for name in archive.namelist()}


def variables_of(files: Files) -> dict[str, Element]:
    """The variables of the description by name."""
    variables = ElementTree.fromstring(files["modelDescription.xml"]).find("ModelVariables")
    return {variable.get("name"): variable for variable in variables}


def version_of(files: Files) -> str:
    return ElementTree.fromstring(files["modelDescription.xml"]).get("fmiVersion")


def platform_breaches(files: Files) -> list[str]:
    version = version_of(files)
    folders = {name.split("/")[1] for name in files if name.startswith("binaries/")}
    icon = {"2.0": "model.png", "3.0": "terminalsAndIcons/icon.png"}[version]
    found = [f"folder {name}" for name in sorted(folders) if not re.fullmatch(PLATFORMS[version], name)]
    return found + ([] if folders else ["no library"]) + ([] if icon in files else [f"no {icon}"])


def terminal_breaches(files: Files) -> list[str]:
    """The schema; members are variables that a connection may join; their names are unique."""
    if TERMINALS not in files:
        return []
    root, variables = etree.fromstring(files[TERMINALS]), variables_of(files)
    if not SCHEMA.validate(root):
        return [entry.message for entry in SCHEMA.error_log]
    found, names = [], [terminal.get("name") for terminal in root.iter("Terminal")]
    found += [f"terminal {name} twice" for name in names if names.count(name) > 1]
    for terminal in root.iter("Terminal"):
        members = [member.get("memberName") for member in terminal]
        found += [f"member {name} twice" for name in members if members.count(name) > 1]
        for member in terminal:
            variable = variables.get(member.get("variableName"))
            if variable is None:
                found.append(f"no variable {member.get('variableName')}")
            elif variable.get("causality") not in {"input", "output", "parameter"}:
                found.append(f"{member.get('variableName')} is {variable.get('causality')}")
        if (terminal.get("terminalKind") or "").startswith(MAP):
            found += map_breaches(terminal, variables)
    return found


def map_breaches(terminal: Element, variables: dict[str, Element]) -> list[str]:
    """Points and values of a map are arrays of one size (FMI-LS-STRUCT, section 4)."""
    kinds = [member.get("variableKind") for member in terminal]
    arrays = [variables[member.get("variableName")] for member in terminal][:2]
    sizes = {tuple(dimension.get("valueReference") for dimension in array.findall("Dimension")) for array in arrays}
    found = [] if kinds[:2] == [f"{MAP}.domain", f"{MAP}.codomain"] else [f"kinds {kinds}"]
    return found + ([] if len(sizes) == 1 and () not in sizes else [f"{terminal.get('name')}: sizes differ"])


def manifest_breaches(files: Files) -> list[str]:
    """Manifests have the attributes of FMI 3.0.2, section 2.6, those of FMI-LS-REF name files that exist."""
    found = []
    for path in (name for name in files if name.endswith("fmi-ls-manifest.xml")):
        root = ElementTree.fromstring(files[path])
        if root.get(f"{LAYERED}fmi-ls-name") != path.split("/")[1]:
            found.append(f"{path}: fmi-ls-name {root.get(f'{LAYERED}fmi-ls-name')}")
        found += [f"{path}: no {key}" for key in ("version", "description") if not root.get(f"{LAYERED}fmi-ls-{key}")]
    for related in ElementTree.fromstring(files[REF]):
        source = posixpath.join(posixpath.dirname(REF), related.get("source"))
        if source not in files:
            found.append(f"no {source}")
        if related.get("role") not in {"parameter", "testcase", "result"}:
            found.append(f"role {related.get('role')}")
    has_maps = MAP.encode() in files.get(TERMINALS, b"")
    return found + ([] if has_maps == (STRUCT in files) else ["a manifest of maps without maps, or maps without one"])


def preset_breaches(files: Files) -> list[str]:
    """A preset sets variables of this FMU, within their limits."""
    variables, found = variables_of(files), []
    for path in (name for name in files if name.endswith(".ssv")):
        for parameter in ElementTree.fromstring(files[path]).iter(f"{VALUES}Parameter"):
            name, value = parameter.get("name"), parameter[0].get("value")
            if name not in variables or variables[name].findall("Dimension"):
                found.append(f"{path}: no variable {name}")
                continue
            declared = variables[name] if version_of(files) == "3.0" else variables[name][0]
            number = {"true": 1.0, "false": 0.0}.get(value) if value in {"true", "false"} else float(value)
            low, high = float(declared.get("min", "-inf")), float(declared.get("max", "inf"))
            if not low <= number <= high:
                found.append(f"{path}: {name} = {value} outside {low} to {high}")
    return found


def result_breaches(files: Files) -> list[str]:
    """Columns are inputs or outputs of this FMU, and inputs have a value wherever outputs have one."""
    variables, found, times = variables_of(files), [], set()
    for path in (name for name in files if name.endswith(".csv")):
        heading, *rows = csv.reader(io.StringIO(files[path].decode()))
        causality = "input" if path.endswith("_in.csv") else "output"
        others = [name for name in heading[1:] if variables[name].get("causality") != causality]
        found += [f"{path}: {name} is no {causality}" for name in others]
        times.add(tuple(row[0] for row in rows))
    return found + ([] if len(times) == 1 else ["inputs and outputs at other times"])


RULES = [
    platform_breaches,
    terminal_breaches,
    manifest_breaches,
    preset_breaches,
    result_breaches,
]


def test_every_model_is_packed_in_both_versions():
    old, new = ({path.stem for path in folder.glob("*.fmu")} for folder in FOLDERS.values())
    assert old == new
    assert len(ALL) == 2 * len(old) > 0


@pytest.mark.parametrize("path", ALL, ids=lambda path: path.relative_to(FMUS).as_posix())
def test_contents_keep_every_rule(path: Path):
    files = files_of(path)
    assert [breach for rule in RULES for breach in rule(files)] == []


def text(name: str, old: str, new: str) -> Callable[[Files], None]:
    """Replaces a part of a file."""

    def replace(files: Files) -> None:
        changed = files[name].replace(old.encode(), new.encode())
        assert changed != files[name]
        files[name] = changed

    return replace


FRONT = "extra/org.fmi-standard.fmi-ls-ref/rear.ssv"
RESULTS = "extra/org.fmi-standard.fmi-ls-ref/ShockAbsorber_out.csv"
MISTAKES = {
    "folder": (lambda files: files.update({"binaries/linux64/a.so": b""}), "folder linux64"),
    "no icon": (lambda files: files.pop("terminalsAndIcons/icon.png"), "no terminalsAndIcons/icon.png"),
    "schema": (text(TERMINALS, "matchingRule=", "rule="), "matchingRule"),
    "unknown variable": (text(TERMINALS, '"length"', '"size"'), "no variable size"),
    "member twice": (text(TERMINALS, 'memberName="force"', 'memberName="length"'), "member length twice"),
    "state": (text(TERMINALS, 'variableName="length"', 'variableName="piston_velocity"'), "piston_velocity is local"),
    "kinds": (text(TERMINALS, "map.codomain", "map.domain"), "kinds"),
    "no manifest": (lambda files: files.pop(STRUCT), "maps without one"),
    "no name": (text(REF, "fmi-ls-name", "fmi-ls-title"), "fmi-ls-name None"),
    "no file": (lambda files: files.pop(FRONT), f"no {FRONT}"),
    "role": (text(REF, 'role="result"', 'role="results"'), "role results"),
    "unknown parameter": (text(FRONT, "spring.k", "spring.c"), "no variable spring.c"),
    "outside": (text(FRONT, "35000", "-35000"), "spring.k = -35000 outside"),
    "no output": (text(RESULTS, ",force,", ",length,"), "length is no output"),
    "other times": (text(RESULTS, "\n0,", "\n-1,"), "at other times"),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_each_rule_can_be_broken(mistake: str):
    files = files_of(FOLDERS["3.0"] / "ShockAbsorber.fmu")
    make, message = MISTAKES[mistake]
    make(files)
    breaches = [breach for rule in RULES for breach in rule(files)]
    assert any(message in breach for breach in breaches), breaches
