"""What the tests of both versions of a description have in common."""

from collections.abc import Callable
from pathlib import Path
from xml.etree.ElementTree import Element

PROJECT = Path(__file__).parents[2]
DESCRIPTIONS = sorted((PROJECT / "modelDescription").glob("*.xml"))
DESCRIPTIONS_3 = sorted((PROJECT / "modelDescription" / "fmi3").glob("*.xml"))


def duplicates(words: list[str]) -> list[str]:
    """Words that occur more than once."""
    return sorted({word for word in words if words.count(word) > 1})


def edit(path: str, **attributes: str) -> Callable[[Element], None]:
    """Gives the first element at `path` other attributes."""
    return lambda root: root.find(path).attrib.update(attributes)


def drop(path: str, attribute: str) -> Callable[[Element], None]:
    """Takes an attribute from the first element at `path`."""
    return lambda root: root.find(path).attrib.pop(attribute)


def remove_last(path: str, tag: str = "*") -> Callable[[Element], None]:
    """Removes the last child of this tag."""

    def remove(root: Element) -> None:
        parent = root.find(path)
        parent.remove(parent.findall(tag)[-1])

    return remove


def experiment_breaches(root: Element) -> list[str]:
    """A default experiment that ends before it starts, or has no step."""
    values = {name: float(value) for name, value in root.find("DefaultExperiment").attrib.items()}
    found = [f"{name} <= 0" for name in ("tolerance", "stepSize") if not values.get(name, 1.0) > 0.0]
    if not values.get("startTime", 0.0) < values.get("stopTime", float("inf")):
        found.append("stopTime <= startTime")
    return found
