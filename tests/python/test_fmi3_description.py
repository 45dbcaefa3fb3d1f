"""modelDescription.xml of FMI 3.0: the schema and FMPy's checks, rules of the standard that neither checks, and proof
that each rule can fail."""

from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import pytest
from descriptions import DESCRIPTIONS, DESCRIPTIONS_3, drop, duplicates, edit, experiment_breaches, remove_last
from fmpy import read_model_description

FLOAT = "Float64"
Variables = dict[str, Element]


def by_reference(root: Element) -> Variables:
    """The variables by their value references."""
    return {variable.get("valueReference"): variable for variable in root.find("ModelVariables")}


def size(variable: Element, known: Variables) -> int:
    """Number of elements: 1 for a scalar."""
    count = 1
    for dimension in variable.findall("Dimension"):
        count *= int(dimension.get("start") or known[dimension.get("valueReference")].get("start"))
    return count


def name_breaches(root: Element) -> list[str]:
    """Unique names and value references."""
    found = []
    for path, key in [
        ("UnitDefinitions/Unit", "name"),
        ("TypeDefinitions/*", "name"),
        ("LogCategories/Category", "name"),
        ("ModelVariables/*", "name"),
        ("ModelVariables/*", "valueReference"),
    ]:
        found += [f"{path} {key} {name} twice" for name in duplicates([e.get(key) for e in root.findall(path)])]
    return found


def dimension_breaches(root: Element) -> list[str]:
    """A dimension is a number or a structural parameter of type UInt64, which begins with at least one element
    (section 2.4.7.2)."""
    known, found = by_reference(root), []
    for variable in known.values():
        for dimension in variable.findall("Dimension"):
            name, reference = variable.get("name"), dimension.get("valueReference")
            if (reference is None) == (dimension.get("start") is None):
                found.append(f"{name}: a dimension has a size or a reference")
            elif reference is None and int(dimension.get("start")) < 1:
                found.append(f"{name}: no element")
            elif reference is not None and reference not in known:
                found.append(f"{name}: no size {reference}")
            elif reference is not None:
                given = known[reference]
                if (given.tag, given.get("causality")) != ("UInt64", "structuralParameter"):
                    found.append(f"{name}: {given.get('name')} is no structural parameter")
                elif not int(given.get("min", 0)) <= int(given.get("start")) <= int(given.get("max", 2**64)):
                    found.append(f"{given.get('name')}: start outside its limits")
        if variable.get("causality") == "structuralParameter" and variable.findall("Dimension"):
            found.append(f"{variable.get('name')}: a structural parameter with a dimension")
    return found


def start_breaches(root: Element) -> list[str]:
    """Start values where they are required, one per element, each within the limits (section 2.4.7.5)."""
    items = {kind.get("name"): len(kind.findall("Item")) for kind in root.iter("EnumerationType")}
    known, found = by_reference(root), []
    for variable in known.values():
        name, start = variable.get("name"), variable.get("start")
        is_given = variable.get("causality") in {"input", "parameter", "structuralParameter"}
        if (is_given or variable.get("initial") in {"exact", "approx"}) != (start is not None):
            found.append(f"{name}: start value {'where none may be' if start else 'missing'}")
        values = (start or "").split()
        if start is not None and len(values) != size(variable, known):
            found.append(f"{name}: {len(values)} start values for {size(variable, known)} elements")
        if variable.tag == "Boolean":
            continue
        is_choice = variable.tag == "Enumeration"
        low = float(variable.get("min", 1 if is_choice else "-inf"))
        high = float(variable.get("max", items.get(variable.get("declaredType"), 0) if is_choice else "inf"))
        if not low <= high:
            found.append(f"{name}: min {low} > max {high}")
        outside = [value for value in values if not low <= float(value) <= high]
        found += [f"{name}: start {value} outside {low} to {high}" for value in outside]
    return found


def type_breaches(root: Element) -> list[str]:
    """Types, units and display units exist; an enumeration has a type."""
    displays = {unit.get("name"): {d.get("name") for d in unit.findall("DisplayUnit")} for unit in root.iter("Unit")}
    types = {kind.get("name"): kind.tag.removesuffix("Type") for kind in root.find("TypeDefinitions")}
    found = []
    for variable in root.find("ModelVariables"):
        name, kind, unit = variable.get("name"), variable.get("declaredType"), variable.get("unit")
        if variable.tag == "Enumeration" if kind is None else types.get(kind) != variable.tag:
            found.append(f"{name}: no type {kind} for {variable.tag}")
        if unit is not None and unit not in displays:
            found.append(f"{name}: no unit {unit}")
        if variable.get("displayUnit") and variable.get("displayUnit") not in displays.get(unit, ()):
            found.append(f"{name}: no display unit {variable.get('displayUnit')} of {unit}")
    return found


def change_breaches(root: Element) -> list[str]:
    """Only numbers with a floating point are continuous; only continuous ones may be read within a step or be set by an
    event."""
    states = {variable.get("derivative") for variable in root.iter(FLOAT)}
    found = []
    for variable in root.find("ModelVariables"):
        name, is_continuous = variable.get("name"), variable.get("variability") == "continuous"
        if is_continuous and variable.tag != FLOAT:
            found.append(f"{name}: continuous {variable.tag}")
        if variable.get("intermediateUpdate") == "true" and not is_continuous:
            found.append(f"{name}: intermediateUpdate of a variable that is not continuous")
        if variable.get("reinit") == "true" and variable.get("valueReference") not in states:
            found.append(f"{name}: reinit of a variable that is no state")
    return found


def derivative_breaches(root: Element) -> list[str]:
    """A derivative belongs to a continuous variable with as many elements, which is local or an output."""
    known, found = by_reference(root), []
    for variable in known.values():
        if (of := variable.get("derivative")) is None:
            continue
        name, state = variable.get("name"), known.get(of)
        kinds = [("continuous", "local"), ("continuous", "output")]
        if state is None or (state.get("variability"), state.get("causality")) not in kinds:
            found.append(f"{name}: derivative of {of}, which is no continuous state")
        elif size(state, known) != size(variable, known):
            found.append(f"{name}: {size(variable, known)} derivatives of {size(state, known)} states")
    return found


def structure_breaches(root: Element) -> list[str]:
    """The model structure is complete, each list without repetition; dependencies are knowns (section 2.4.8)."""
    known = by_reference(root)
    outputs = [r for r, v in known.items() if v.get("causality") == "output"]
    derivatives = [r for r, v in known.items() if v.get("derivative") is not None]
    unknowns = [r for r in outputs if known[r].get("initial") != "exact"]
    unknowns += [r for r in derivatives if known[r].get("initial") != "exact"]
    wanted = {"Output": outputs, "ContinuousStateDerivative": derivatives, "InitialUnknown": unknowns}
    found = []
    for tag, references in wanted.items():
        listed = [entry.get("valueReference") for entry in root.findall(f"ModelStructure/{tag}")]
        found += [f"{tag} lacks {r}" for r in sorted(set(references) - set(listed))]
        found += [f"{tag} {r} is not one" for r in sorted(set(listed) - set(references))]
        found += [f"{tag} {r} twice" for r in duplicates(listed)]
    found += indicator_breaches(root, known)
    for entry in root.find("ModelStructure"):
        for dependency in entry.get("dependencies", "").split():
            is_known = dependency in known and (
                known[dependency].get("causality") in {"input", "independent"}
                or known[dependency].get("initial") == "exact"
            )
            if not is_known:
                found.append(f"{entry.tag} {entry.get('valueReference')} depends on {dependency}, which is not known")
    return found


def indicator_breaches(root: Element, known: Variables) -> list[str]:
    """Event indicators are continuous, and each is listed if the importer integrates."""
    listed = [entry.get("valueReference") for entry in root.findall("ModelStructure/EventIndicator")]
    named = [r for r, v in known.items() if v.get("name") == "event_indicators"]
    found = [] if listed == named else ["EventIndicator is not event_indicators"]
    for variable in (known[r] for r in listed if r in known):
        if (variable.tag, variable.get("variability"), variable.get("causality")) != (FLOAT, "continuous", "local"):
            found.append(f"{variable.get('name')}: no continuous event indicator")
    if listed and root.find("ModelExchange") is None:
        found.append("event indicators without Model Exchange")
    return found


RULES = [
    name_breaches,
    dimension_breaches,
    start_breaches,
    type_breaches,
    change_breaches,
    derivative_breaches,
    structure_breaches,
    experiment_breaches,
]


@pytest.mark.parametrize("path", DESCRIPTIONS_3, ids=lambda path: path.stem)
def test_conforms_to_the_schema_and_to_every_rule(path: Path):
    read_model_description(str(path), validate=True, validate_variable_names=True, validate_model_structure=True)
    root = ElementTree.parse(path).getroot()
    assert [breach for rule in RULES for breach in rule(root)] == []


def test_every_model_has_both_versions_under_one_token():
    """A library that refuses the table of an FMU of one version refuses that of the other."""
    old, new = (
        {path.stem: ElementTree.parse(path).getroot() for path in paths} for paths in (DESCRIPTIONS, DESCRIPTIONS_3)
    )
    assert {name: root.get("guid") for name, root in old.items()} == {
        name: root.get("instantiationToken") for name, root in new.items()
    }
    for name, root in new.items():
        assert root.get("fmiVersion") == "3.0"
        for interface in ("ModelExchange", "CoSimulation"):
            assert (root.find(interface) is None) == (old[name].find(interface) is None)


VARIABLES = "ModelVariables"
MASS = f"{VARIABLES}/Float64[@name='friction.mass']"
TABLE = f"{VARIABLES}/Float64[@name='damper.tab_v']"
SIZE = f"{VARIABLES}/UInt64[@name='damper.tab_size']"
LAW = f"{VARIABLES}/Enumeration[@name='friction.model']"
STICKING = f"{VARIABLES}/Boolean[@name='sticking']"
INDICATORS = f"{VARIABLES}/Float64[@name='event_indicators']"
# The value reference of `time`.
TIME = "1564253156"
MISTAKES = {
    "name twice": (edit(MASS, name="velocity"), "name velocity twice"),
    "reference twice": (edit(MASS, valueReference=TIME), f"valueReference {TIME} twice"),
    "both dimensions": (edit(f"{TABLE}/Dimension", start="16"), "damper.tab_v: a dimension has a size or a reference"),
    "no element": (edit(f"{INDICATORS}/Dimension", start="0"), "event_indicators: no element"),
    "unknown size": (edit(SIZE, valueReference="1"), "damper.tab_v: no size"),
    "size of another kind": (edit(f"{TABLE}/Dimension", valueReference=TIME), "time is no structural parameter"),
    "size too large": (edit(SIZE, start="17"), "damper.tab_size: start outside its limits"),
    "few start values": (edit(TABLE, start="0 1"), "damper.tab_v: 2 start values for 16 elements"),
    "one start value outside": (edit(TABLE, min="-0.9"), "damper.tab_v: start -1 outside -0.9"),
    "min > max": (edit(MASS, min="2", max="1"), "friction.mass: min 2.0 > max 1.0"),
    "choice outside": (edit(LAW, start="99"), "friction.model: start 99 outside"),
    "start missing": (drop(MASS, "start"), "friction.mass: start value missing"),
    "start of a result": (edit(STICKING, start="false"), "sticking: start value where none may be"),
    "unknown unit": (edit(MASS, unit="stone"), "friction.mass: no unit stone"),
    "unknown display unit": (edit(MASS, displayUnit="st"), "friction.mass: no display unit st of kg"),
    "unknown type": (edit(MASS, declaredType="Weight"), "friction.mass: no type Weight"),
    "no type": (drop(LAW, "declaredType"), "friction.model: no type None for Enumeration"),
    "continuous Boolean": (edit(STICKING, variability="continuous"), "sticking: continuous Boolean"),
    "within a step": (edit(STICKING, intermediateUpdate="true"), "sticking: intermediateUpdate"),
    "reinit": (edit(MASS, reinit="true"), "friction.mass: reinit of a variable that is no state"),
    "derivative of nothing": (
        edit(f"{VARIABLES}/Float64[@derivative]", derivative="1"),
        "which is no continuous state",
    ),
    "short derivative": (
        edit(f"{VARIABLES}/Float64[@name='der(memory_1)']/Dimension", start="1"),
        "der(memory_1): 1 derivatives of 2 states",
    ),
    "output": (remove_last("ModelStructure", "Output"), "Output lacks"),
    "derivative": (remove_last("ModelStructure", "ContinuousStateDerivative"), "ContinuousStateDerivative lacks"),
    "initial unknown": (remove_last("ModelStructure", "InitialUnknown"), "InitialUnknown lacks"),
    "another output": (edit("ModelStructure/Output", valueReference=TIME), f"Output {TIME} is not one"),
    "indicators": (remove_last("ModelStructure", "EventIndicator"), "EventIndicator is not event_indicators"),
    "jumping indicators": (edit(INDICATORS, variability="discrete"), "event_indicators: no continuous"),
    "indicators for nobody": (lambda root: root.remove(root.find("ModelExchange")), "without Model Exchange"),
    "unknown dependency": (edit("ModelStructure/Output", dependencies="1"), "depends on 1, which is not known"),
    "stop before start": (edit("DefaultExperiment", stopTime="-1"), "stopTime <= startTime"),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_each_rule_can_be_broken(mistake: str):
    root = ElementTree.parse(next(path for path in DESCRIPTIONS_3 if path.stem == "ShockAbsorber")).getroot()
    make, message = MISTAKES[mistake]
    make(root)
    breaches = [breach for rule in RULES[:2] for breach in rule(root)]
    # Sizes can be counted only where they exist.
    breaches = breaches or [breach for rule in RULES[2:] for breach in rule(root)]
    assert any(message in breach for breach in breaches), breaches
