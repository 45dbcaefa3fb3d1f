"""Rules of FMI 2.0 for modelDescription.xml that FMPy and the schema do not check, and proof that each can fail."""

import re
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import pytest
from descriptions import DESCRIPTIONS, drop, duplicates, edit, experiment_breaches, remove_last


def kind_of(variable: Element) -> Element:
    """The element that holds type, start and bounds of a variable."""
    return next(child for child in variable if child.tag in {"Real", "Integer", "Boolean", "String", "Enumeration"})


def range_breaches(root: Element) -> list[str]:
    """min <= start <= max; an enumeration without bounds of its own has those of its items."""
    items = {kind.get("name"): len(kind.findall("Enumeration/Item")) for kind in root.iter("SimpleType")}
    found = []
    for variable in root.iter("ScalarVariable"):
        kind = kind_of(variable)
        if kind.tag == "Boolean":
            continue
        is_choice = kind.tag == "Enumeration"
        low = float(kind.get("min", 1 if is_choice else "-inf"))
        high = float(kind.get("max", items[kind.get("declaredType")] if is_choice else "inf"))
        start = float(kind.get("start", low if low > float("-inf") else min(0.0, high)))
        if not low <= high:
            found.append(f"{variable.get('name')}: min {low} > max {high}")
        elif not low <= start <= high:
            found.append(f"{variable.get('name')}: start {start} outside {low} to {high}")
    return found


def start_breaches(root: Element) -> list[str]:
    """Start values are required according to causality and initial (FMI 2.0.5 section 2.2.7)."""
    found = []
    for variable in root.iter("ScalarVariable"):
        needs = variable.get("causality") in {"input", "parameter"} or variable.get("initial") in {"exact", "approx"}
        if needs != (kind_of(variable).get("start") is not None):
            found.append(f"{variable.get('name')}: start value {'missing' if needs else 'where none may be'}")
    return found


def name_breaches(root: Element) -> list[str]:
    """Unique names and value references, and a model identifier that is a C identifier."""
    identifiers = [
        root.find(tag).get("modelIdentifier") for tag in ("CoSimulation", "ModelExchange") if root.find(tag) is not None
    ]
    found = [f"modelIdentifier {name}" for name in identifiers if not re.fullmatch("[A-Za-z_][A-Za-z0-9_]*", name)]
    for path, key in [
        ("UnitDefinitions/Unit", "name"),
        ("TypeDefinitions/SimpleType", "name"),
        ("LogCategories/Category", "name"),
        ("ModelVariables/ScalarVariable", "name"),
        ("ModelVariables/ScalarVariable", "valueReference"),
    ]:
        found += [f"{path} {key} {name} twice" for name in duplicates([e.get(key) for e in root.findall(path)])]
    return found


def reference_breaches(root: Element) -> list[str]:
    """Referenced units and types exist."""
    units = {unit.get("name") for unit in root.findall("UnitDefinitions/Unit")}
    types = {kind.get("name") for kind in root.findall("TypeDefinitions/SimpleType")}
    named = [(element, "unit", units) for element in root.iter("Real") if element.get("unit")]
    named += [
        (kind_of(v), "declaredType", types) for v in root.iter("ScalarVariable") if kind_of(v).get("declaredType")
    ]
    return [f"no {key} {element.get(key)}" for element, key, known in named if element.get(key) not in known]


def structure_breaches(root: Element) -> list[str]:
    """Outputs, derivatives and initial unknowns are complete, in rising order, with dependencies that exist."""
    variables = root.findall("ModelVariables/ScalarVariable")
    numbered = list(enumerate(variables, start=1))
    outputs = [i for i, v in numbered if v.get("causality") == "output"]
    derivatives = [i for i, v in numbered if kind_of(v).get("derivative") is not None]
    unknowns = [i for i in outputs if variables[i - 1].get("initial") != "exact"] + derivatives
    listed = {
        part: [int(unknown.get("index")) for unknown in root.findall(f"ModelStructure/{part}/Unknown")]
        for part in ("Outputs", "Derivatives", "InitialUnknowns")
    }
    found = [] if listed["Outputs"] == outputs else ["Outputs are not the outputs"]
    if listed["Derivatives"] != derivatives:
        found.append("Derivatives are not the derivatives")
    if not set(unknowns) <= set(listed["InitialUnknowns"]):
        found.append(f"InitialUnknowns lack {set(unknowns) - set(listed['InitialUnknowns'])}")
    found += [f"{part} are not in order" for part, indices in listed.items() if indices != sorted(set(indices))]
    for unknown in root.find("ModelStructure").iter("Unknown"):
        dependencies = unknown.get("dependencies", "").split()
        if not all(1 <= int(index) <= len(variables) for index in dependencies):
            found.append(f"dependencies of {unknown.get('index')} that do not exist")
        if unknown.get("dependenciesKind") and len(unknown.get("dependenciesKind").split()) != len(dependencies):
            found.append(f"dependenciesKind of {unknown.get('index')} has another length")
    return found


RULES = [range_breaches, start_breaches, experiment_breaches, name_breaches, reference_breaches, structure_breaches]


@pytest.mark.parametrize("path", DESCRIPTIONS, ids=lambda path: path.stem)
def test_no_rule_is_broken(path: Path):
    root = ElementTree.parse(path).getroot()
    assert [breach for rule in RULES for breach in rule(root)] == []


MASS = "ModelVariables/ScalarVariable[@name='mass']"
MISTAKES = {
    "min > max": (edit(f"{MASS}/Real", min="2", max="1"), "min 2.0 > max 1.0"),
    "start outside": (edit(f"{MASS}/Real", min="2"), "start 1.0 outside 2.0"),
    "start missing": (drop(f"{MASS}/Real", "start"), "start value missing"),
    "stop before start": (edit("DefaultExperiment", stopTime="-1"), "stopTime <= startTime"),
    "negative step": (edit("DefaultExperiment", stepSize="-0.1"), "stepSize <= 0"),
    "negative tolerance": (edit("DefaultExperiment", tolerance="-1"), "tolerance <= 0"),
    "no C identifier": (edit("CoSimulation", modelIdentifier="3-D"), "modelIdentifier 3-D"),
    # That of `time`.
    "reference twice": (edit(MASS, valueReference="1564253156"), "valueReference 1564253156 twice"),
    "name twice": (edit(MASS, name="stiffness"), "name stiffness twice"),
    "unit twice": (lambda root: root.find("UnitDefinitions").append(root.find("UnitDefinitions/Unit")), "Unit name"),
    "unknown unit": (edit(f"{MASS}/Real", unit="stone"), "no unit stone"),
    "unknown type": (edit(f"{MASS}/Real", declaredType="Weight"), "no declaredType Weight"),
    "initial unknown": (remove_last("ModelStructure/InitialUnknowns"), "InitialUnknowns lack {13}"),
    "output": (remove_last("ModelStructure/Outputs"), "Outputs are not the outputs"),
    "derivative": (remove_last("ModelStructure/Derivatives"), "Derivatives are not the derivatives"),
    "dependency": (edit("ModelStructure/InitialUnknowns/Unknown", dependencies="4 99"), "dependencies of 7"),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_each_rule_can_be_broken(mistake: str):
    root = ElementTree.parse(next(path for path in DESCRIPTIONS if path.stem == "BeltRig")).getroot()
    make, message = MISTAKES[mistake]
    make(root)
    breaches = [breach for rule in RULES for breach in rule(root)]
    assert any(message in breach for breach in breaches), breaches


def test_both_contacts_of_the_strut_depend_on_the_same_columns():
    """None of the rare dependencies of either contact is missing, such as the acceleration that a few laws need. The
    memory is that of the contact itself."""
    root = ElementTree.parse(Path(__file__).parents[2] / "modelDescription" / "ShockAbsorber.xml").getroot()
    names = [variable.get("name") for variable in root.findall("ModelVariables/ScalarVariable")]
    outputs = {names[int(entry.get("index")) - 1]: entry for entry in root.findall("ModelStructure/Outputs/Unknown")}
    first, second = (
        [names[int(index) - 1] for index in outputs[name].get("dependencies").split()]
        for name in ("friction_1", "friction_2")
    )
    assert "acceleration" in first
    assert {"memory_1[1]", "memory_1[2]"} <= set(first)
    assert [name.replace("memory_1", "memory_2") for name in first] == second
