"""Systems of models, solved to a tolerance."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from stribeck import _stribeck
from stribeck._stribeck import Refused
from stribeck.catalogue import Description, hint, laws
from stribeck.results import Result, frame

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Difference:
    """The largest difference of a result from that of a finer run, over the output times."""

    largest: float
    """The difference, without sign, in the unit of the result."""
    part: float
    """The same in parts of the range, from the smallest to the largest value of both runs."""
    time: float
    """Output time of the difference in s."""


@dataclass(frozen=True)
class Check:
    """The difference of a run from one at a tenth of its steps' tolerance, or of its communication step."""

    of: str
    """What was made finer: `tolerance` or `step`."""
    finer: float
    """The tolerance of the finer run, or its communication step in s."""
    end: str
    """How the finer run ended."""
    differences: dict[str, Difference]
    """The largest difference of each result."""
    fault: str | None
    """Why the tolerance or the step does not hold; None if it does."""


@dataclass(frozen=True)
class Deviation:
    """A quantity of a co-simulation beside that of the solution."""

    value: float
    solution: float
    unit: str
    part: float
    """The difference: of a time in parts of the interval, of a force or a velocity in parts of the largest one, of a
    position in parts of its range, of a number as it is."""


@dataclass(frozen=True)
class FoundStep:
    """The largest communication step of an order of exchange."""

    step: float | None
    """The largest step in s with which, and with all smaller ones that were tried, the motion is close to the solution;
    None if there is none."""
    deviations: dict[str, Deviation]
    """The quantities at this step."""
    trials: dict[float, str | None]
    """The steps that were tried, from the largest on: why the motion is not close to the solution, or None if it is."""


class Solution(Result):
    """Motion of a system: its results over time, its events, and what it has cost."""

    def __init__(self, system: str, answer: Mapping[str, Any]) -> None:
        columns = {name: column for name, _, column in answer["columns"]}
        units = {name: unit for name, unit, _ in answer["columns"]}
        title = f"{answer['law']} in {system}" if answer["law"] else system
        super().__init__(title, answer["time"], columns, units)
        self.system = system
        """The system."""
        self.law: str | None = answer["law"]
        """The friction law, if a part of the system can be any."""
        self.solver: str = answer["solver"]
        """The solver that was used."""
        self.events: list[tuple[float, str]] = answer["events"]
        """Time of each event in s, and the part that had it."""
        self.statistics: dict[str, int] = answer["statistics"]
        """Steps, rejected steps, evaluations of the rates, Jacobians."""
        self.end: str = answer["end"]
        """How the run ended."""
        self.seconds: float = answer["seconds"]
        """Time on the clock."""
        self.check: Check | None = _check(answer["check"])
        """The difference from a finer run, if one was asked for and the run came to its end."""
        self.fault: str | None = answer["fault"]
        """Why the motion is not what was asked for: how the run ended, or what the check says."""


def _check(answer: Mapping[str, Any] | None) -> Check | None:
    if answer is None:
        return None
    differences = {name: Difference(*numbers) for name, numbers in answer["differences"]}
    return Check(answer["of"], answer["finer"], answer["end"], differences, answer["fault"])


class NotConverged(RuntimeError):
    """A run that did not come to its end, or whose tolerance does not hold by its check. `solution` is the motion up to
    there."""

    def __init__(self, solution: Solution) -> None:
        super().__init__(f"{solution.title}: {solution.fault}")
        self.solution = solution


class Comparison(Mapping[str, Solution]):
    """Motions of one system with several laws: a mapping from the law's name. `failed` has those that did not come to
    their end, or whose tolerance does not hold."""

    def __init__(self, system: str, solutions: dict[str, Solution], failed: dict[str, Solution]) -> None:
        self.system = system
        self.solutions = solutions
        self.failed = failed

    def __getitem__(self, law: str) -> Solution:
        if law in self.failed:
            raise NotConverged(self.failed[law])
        if law not in self.solutions:
            raise KeyError(f"{law!r} is not among the laws that were compared{hint(law, self)}")
        return self.solutions[law]

    def __contains__(self, law: object) -> bool:
        return law in self.solutions

    def __iter__(self) -> Iterator[str]:
        return iter(self.solutions)

    def __len__(self) -> int:
        return len(self.solutions)

    def __repr__(self) -> str:
        both = {**self.solutions, **self.failed}
        rows = [f"{law}: {one.fault or one.end}, {len(one.events)} events" for law, one in both.items()]
        laws = "1 law" if len(rows) == 1 else f"{len(rows)} laws"
        return "\n".join([f"<{self.system} with {laws}>", *rows])

    def plot(self, name: str, over: str = "time") -> Figure:
        """Draws one result of all laws over time or over another result, dotted where a run did not come to its end.
        Returns matplotlib's Figure, as `Result.plot`."""
        import matplotlib.pyplot as plt

        figure, axis = plt.subplots(layout="constrained")
        for law, one in {**self.solutions, **self.failed}.items():
            axis.plot(one[over], one[name], ":" if law in self.failed else "-", linewidth=1.0, label=law)
            axis.set(xlabel=one._label(over), ylabel=one._label(name), title=self.system)
        frame(axis)
        axis.legend()
        return figure


def systems() -> dict[str, str]:
    """Names of the built-in systems, with their titles.

    >>> systems()["belt"]
    'Block on a moving belt, held by a spring'
    """
    return dict(_stribeck.systems())


def solvers() -> dict[str, str]:
    """Names of the solvers, with one line on each."""
    return dict(_stribeck.solvers())


def solve(system: str = "belt", law: str | Description | None = None, **options: Any) -> Solution:
    """Motion of a system: a built-in one, or a system file (.toml). Same names, same bits as `stribeck run`.

    >>> solution = solve("belt", "CoulombStiction")
    >>> [round(time, 6) for time, part in solution.events[:2]]  # the block slips, and sticks again
    [7.3575, 9.975922]

    Options, as of `stribeck run`: `set`, a dictionary of values such as `{"rig.mass": 2.0, "mu_s": 0.2}`; `solver`, one
    of `stribeck.solvers()`; `tol`, relative and absolute tolerance; `until` and `every`, end and interval of the
    results in s; `record`, names of results such as `rig.position` or `der(rig.block_velocity)`; `events`, whether they
    are located; `check`, whether the run is repeated at a tenth of its steps' tolerance, see `Solution.check`; for
    co-simulation `step` in s, `jitter` as a part of it, and `exchange`.

    Raises `stribeck.Refused`, a ValueError, for what cannot be run, and `stribeck.NotConverged` for a run that ends
    early or whose tolerance does not hold by its check.
    """
    if law is not None and not isinstance(law, (str, Description)):
        raise TypeError(f"law = {law!r}: must be one law; stribeck.compare takes several")
    (solution,) = _solutions(system, [] if law is None else [str(law)], options)
    if solution.fault is not None:
        raise NotConverged(solution)
    return solution


def find_step(system: str = "belt", law: str | Description | None = None, **options: Any) -> dict[str, FoundStep]:
    """Largest communication steps with which a co-simulation is close to the solution of a system, by the order of
    exchange. It is close if times of slip and rest through the whole motion, forces, velocities, positions and the
    velocity at rest differ by no more than `within` (default 0.01).

    >>> found = find_step("belt", "CoulombStiction", exchange="sequential", within=0.05, until=20.0)
    >>> list(found), found["sequential"].step > 1e-4
    (['sequential'], True)

    Options as for `solve`. A system whose solution does not reach its end raises `stribeck.Refused`.
    """
    if law is not None and not isinstance(law, (str, Description)):
        raise TypeError(f"law = {law!r}: must be one law")
    names = [] if law is None else [str(law)]
    search = {"solver": "co-simulation", "step": "find"}
    answer = json.loads(_stribeck.find_step(_entries(system, names, {**search, **options})))
    if answer["end"] != "reached":
        raise Refused(f"{system}: the solution {answer['end']}")
    return {order["exchange"]: _found(order) for order in answer["orders"]}


def _found(order: Mapping[str, Any]) -> FoundStep:
    deviations = {
        one["name"]: Deviation(one["value"], one["solution"], one["unit"], one["part"])
        for trial in order["trials"]
        if trial["step"] == order["step"]
        for one in trial["deviations"]
    }
    trials = {trial["step"]: trial["fault"] for trial in order["trials"]}
    return FoundStep(order["step"], deviations, trials)


def compare(
    system: str = "belt", law: str | Description | Sequence[str | Description] | None = None, **options: Any
) -> Comparison:
    """Motions of a system with several laws, or with all of them. Options as for `solve`.

    >>> both = compare("belt", ["LuGre", "Dahl"], until=5.0)
    >>> sorted(both)
    ['Dahl', 'LuGre']
    """
    chosen = [law] if isinstance(law, (str, Description)) else law
    names = [str(one) for one in (laws() if chosen is None else chosen)]
    if not names:
        raise Refused("law names no friction law")
    solutions = dict(zip(names, _solutions(system, names, options), strict=True))
    reached = {name: one for name, one in solutions.items() if one.fault is None}
    failed = {name: one for name, one in solutions.items() if one.fault is not None}
    return Comparison(system, reached, failed)


def _entries(system: str, names: list[str], options: dict[str, Any]) -> dict[str, Any]:
    """What a file of `stribeck run` would hold."""
    if not isinstance(system, (str, os.PathLike)):
        raise TypeError(f"system: must be a name or a path, not {type(system).__name__}")
    entries = {name: value for name, value in options.items() if value is not None}
    if not entries.pop("events", True):
        entries["no-events"] = True
    if isinstance(entries.get("record"), str):
        entries["record"] = [entries["record"]]
    return {**entries, "system": str(system), "law": names}


def _solutions(system: str, names: list[str], options: dict[str, Any]) -> list[Solution]:
    answer = _stribeck.solve(_entries(system, names, options))
    return [Solution(str(system), one) for one in answer]
