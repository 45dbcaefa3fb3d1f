"""The catalogue: models with their variables, equations and sources."""

from __future__ import annotations

import difflib
import html
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from stribeck import _stribeck
from stribeck._stribeck import Refused


@dataclass(frozen=True)
class Variable:
    """A variable of a model."""

    name: str
    """Name, such as `mu_k` or, within a part, `friction.mu_k`."""
    role: str
    """`Input`, `Fixed` or `Tunable` (parameters), `State`, `StateOutput` or `Output`."""
    kind: str
    """`real`, `integer`, `boolean` or `choice`."""
    unit: str
    """Unit; `1` for a pure number, empty for an integer, a Boolean or a choice."""
    display_unit: str | None
    """Unit in which it is usually shown."""
    start: float
    """Start value, or default of a parameter."""
    bound: str
    """Values it admits, in words."""
    minimum: float | None
    """Least value it admits."""
    maximum: float | None
    """Largest value it admits."""
    help: str
    """One line on its meaning."""
    choices: tuple[tuple[str, str], ...] = ()
    """Names of the choices of a `choice`, each with its meaning."""

    @property
    def default(self) -> float | str | bool:
        """Start value as a user writes it: the name of a choice, true or false, or a number."""
        if self.kind == "choice":
            return self.choices[int(self.start) - 1][0]
        return bool(self.start) if self.kind == "boolean" else self.start

    @property
    def admits(self) -> str:
        """Admitted values, as a user writes them."""
        if self.kind == "choice":
            return "one of " + ", ".join(name for name, _ in self.choices)
        return "True or False" if self.kind == "boolean" else self.bound

    def number(self, value: object) -> float:
        """The number that stands for a value: that of a choice, 0 or 1 for false or true."""
        if isinstance(value, str) and self.kind == "choice":
            names = [name for name, _ in self.choices]
            if value not in names:
                raise Refused(f"choice of {self.name} '{value}' does not exist{hint(value, names)}")
            return float(names.index(value) + 1)
        return number(self.name, value)


@dataclass(frozen=True)
class Preset:
    """A named set of parameters."""

    name: str
    source: str
    """Source of the values."""
    values: dict[str, float]


@dataclass(frozen=True)
class Description:
    """A model: its variables, presets and documentation."""

    name: str
    summary: str
    family: str
    """`friction`, `shock absorber`, `host` or `component`."""
    page: str = field(repr=False)
    """Documentation, in Markdown: equations, symbols, sign, limits, source."""
    variables: dict[str, Variable] = field(repr=False)
    presets: dict[str, Preset] = field(repr=False)

    def __str__(self) -> str:
        return self.name

    def __hash__(self) -> int:
        return hash(self.name)

    def of_role(self, *roles: str) -> dict[str, Variable]:
        """The variables of these roles."""
        return {name: variable for name, variable in self.variables.items() if variable.role in roles}

    @property
    def parameters(self) -> dict[str, Variable]:
        """Variables that may be set before a run."""
        return self.of_role("Fixed", "Tunable")

    @property
    def inputs(self) -> dict[str, Variable]:
        """Variables that are given over time."""
        return self.of_role("Input")

    @property
    def outputs(self) -> dict[str, Variable]:
        """Results."""
        return self.of_role("StateOutput", "Output")

    def section(self, heading: str) -> str:
        """A section of the page, such as `Equations`, `Limits` or `Source`; empty if there is none."""
        parts = re.split(r"^# (.+)$", self.page, flags=re.MULTILINE)
        sections = dict(zip((name.strip() for name in parts[1::2]), parts[2::2], strict=True))
        return sections.get(heading, "").strip("\n")

    @property
    def equations(self) -> str:
        """The equations as the source files have them; the page also explains their symbols."""
        return "\n\n".join(re.findall(r"^```text\n(.*?)\n```$", self.section("Equations"), re.MULTILINE | re.DOTALL))

    @property
    def source(self) -> str:
        """Source of the equations, with every deviation from it."""
        return self.section("Source")

    def find(self, name: str) -> Variable:
        """The variable of this name."""
        if name not in self.variables:
            raise Refused(f"variable of {self.name} '{name}' does not exist{hint(name, self.variables)}")
        return self.variables[name]

    def __repr__(self) -> str:
        lines = [f"{self.name}: {self.summary}"]
        rows = [
            (name, str(variable.default), variable.unit, variable.admits, variable.help)
            for name, variable in {**self.inputs, **self.parameters}.items()
        ]
        # A long list of choices does not widen the others.
        short = [[len(row[column]) for row in rows if len(row[column]) <= 40] for column in range(4)]
        widths = [max(lengths, default=0) for lengths in short]
        lines += ["  " + "  ".join([*map(str.ljust, row[:4], widths), row[4]]).rstrip() for row in rows]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        def row(cells: tuple[str, ...], tag: str = "td") -> str:
            return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"

        rows = [
            row((name, variable.role.lower(), str(variable.default), variable.unit, variable.admits, variable.help))
            for name, variable in {**self.inputs, **self.parameters}.items()
        ]
        head = row(("variable", "role", "default", "unit", "admits", "meaning"), "th")
        return (
            f"<h4>{html.escape(self.name)}: {html.escape(self.summary)}</h4>"
            f"<pre>{html.escape(self.equations)}</pre>"
            f"<table><thead>{head}</thead><tbody>{''.join(rows)}</tbody></table>"
        )


def number(name: str, value: Any) -> float:
    """A value as a number. Texts are refused: `float` would read them."""
    try:
        return float(None if isinstance(value, (str, bytes, bytearray)) else value)
    except (TypeError, ValueError):
        raise TypeError(f"{name} = {value!r}: must be a number") from None


def hint(name: object, known: Iterable[str]) -> str:
    """A hint with the name that the user may have meant."""
    closest = difflib.get_close_matches(str(name), list(known), 1)
    return f" (did you mean '{closest[0]}'?)" if closest else ""


@cache
def _names() -> dict[str, tuple[str, str]]:
    return {name: (family, summary) for name, family, summary in _stribeck.names()}


@cache
def _described(name: str) -> Description:
    answer = _stribeck.describe(name)  # refuses a name that does not exist
    family, summary = _names()[name]
    variables = {one["name"]: Variable(**{**one, "choices": tuple(one["choices"])}) for one in answer["variables"]}
    presets = {name: Preset(name, source, dict(values)) for name, source, values in answer["presets"]}
    # Comments of the source files begin with a space.
    page = "\n".join(line.removeprefix(" ") for line in answer["page"].splitlines())
    return Description(name, summary, family, page, variables, presets)


def model(name: str | Description) -> Description:
    """Describes a model: `stribeck.model("ShockAbsorber").parameters`.

    >>> model("LuGr")
    Traceback (most recent call last):
    stribeck.Refused: model 'LuGr' does not exist (did you mean 'LuGre'?)
    """
    return name if isinstance(name, Description) else _described(name)


def law(name: str | Description) -> Description:
    """Describes a friction law.

    >>> lugre = law("LuGre")
    >>> lugre.parameters["sigma_0"].unit
    'N/m'
    >>> "doi" in lugre.source
    True
    """
    described = model(name)
    if described.family != "friction":
        raise Refused(f"{described.name} is a {described.family} model, not a friction law")
    return described


def models() -> list[Description]:
    """Lists all models: friction laws, the shock absorber and its parts, systems that carry friction, machine parts."""
    return [_described(name) for name in _names()]


def laws() -> list[Description]:
    """Lists the friction laws.

    >>> [str(law) for law in laws()][:3]
    ['Coulomb', 'CoulombStiction', 'CoulombViscous']
    """
    return [_described(name) for name, (family, _) in _names().items() if family == "friction"]
