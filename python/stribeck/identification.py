"""Parameters of laws from measured friction, and how far to trust them."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stribeck import _stribeck

Record = str | os.PathLike[str] | Mapping[str, ArrayLike]
"""A table of a rig: a file, or a mapping from `time`, `force`, `displacement` or `velocity`, and perhaps `normal_force`
to arrays in SI units."""


@dataclass(frozen=True)
class Estimate:
    """A parameter after a fit."""

    name: str
    unit: str
    verdict: str
    """`determined`, or why there is no value."""
    value: float | None
    """None unless the data determine it."""
    interval: tuple[float, float] | None
    """Interval of 95 %, by the sensitivities and the profile likelihood."""
    repeated: tuple[float, float] | None
    """Interval of 95 %, from repetitions with blocks of residuals."""
    text: str
    """Value and intervals as `stribeck identify` prints them, or why there are none."""


@dataclass(frozen=True)
class Fit:
    """A law fitted to records."""

    law: str
    rms: float
    """Root mean square of what is not explained, N."""
    noise: float
    """The same without outliers, if the loss is robust, N."""
    unseen: dict[str, float]
    """Root mean square of what is not explained in each record that was not fitted, N."""
    behind: float
    """Criterion (BIC) above that of the best law."""
    tied: bool
    """Whether it cannot be told apart from the best law."""
    repeatable: bool
    """Whether two searches agreed."""
    estimates: dict[str, Estimate]
    warnings: list[str]
    values: dict[str, float]
    """The parameters of the law that were held or that the data determine, as `force` and `simulate` take them."""


class Identification:
    """Laws fitted to records, the best first."""

    def __init__(self, text: str, records: dict[str, dict[str, NDArray[np.float64 | np.bool_]]]) -> None:
        found = json.loads(text)
        self.fits = [_fit(one) for one in found["laws"]]
        """The fits."""
        self.refused: dict[str, str] = {one["law"]: one["reason"] for one in found["refused"]}
        """Laws that cannot be fitted, with the reason."""
        self.findings: dict[str, list[str]] = found["findings"]
        """For each record what is to be known of it: which columns were taken, what is missing or doubtful."""
        self.records = records
        """For each record the arrays `time`, `velocity`, `normal_force`, `force`, `explained` by the best law, and
        whether each sample was `fitted`: those at rest and at the ends are not."""

    @property
    def best(self) -> Fit:
        """The best fit."""
        return self.fits[0]

    def __repr__(self) -> str:
        best = self.best
        lines = [f"{best.law}: {best.rms:.4g} N not explained"]
        lines += [f"  {one.name}: {one.text}" for one in best.estimates.values()]
        lines += [f"  warning: {warning}" for warning in best.warnings]
        lines += [f"  {fit.law}: behind by {fit.behind:.1f}" for fit in self.fits[1:]]
        return "\n".join(lines)


def _fit(one: dict[str, Any]) -> Fit:
    names = ("name", "unit", "verdict", "value", "text")
    ends = ("interval", "repeated")
    estimates = [
        Estimate(**{name: each[name] for name in names}, **{name: each[name] and tuple(each[name]) for name in ends})
        for each in one["estimates"]
    ]
    plain = ("law", "rms", "noise", "unseen", "behind", "tied", "repeatable", "warnings", "values")
    return Fit(**{name: one[name] for name in plain}, estimates={each.name: each for each in estimates})


def identify(
    records: Record | Sequence[Record],
    law: str | Sequence[str] = (),
    *,
    axis: bool = False,
    mass: float = 0.0,
    normal_force: float | None = None,
    motion: Record | None = None,
    window: float | None = None,
    columns: Mapping[str, str] | None = None,
    scale: Mapping[str, float] | None = None,
    delay: float | Literal["find"] | None = None,
    longest_delay: float | None = None,
    skip: float = 0.0,
    rest: float | None = None,
    fix: Mapping[str, float] | None = None,
    fit: Sequence[str] = (),
    ranges: Mapping[str, tuple[float, float]] | None = None,
    budget: int | None = None,
    seed: int | None = None,
    repetitions: int | None = None,
    loss: Literal["squares", "robust"] = "squares",
    hold_out: Record | Sequence[Record] = (),
    folds: int = 0,
) -> Identification:
    """Finds the parameters of a law, or of several (`"all"`), as `stribeck identify` does, with the same numbers.

    `mass` (kg) is that between load cell and contact, `normal_force` (N) is for records without such a column,
    `motion` is the table of a camera with its own clock. `delay="find"` looks for its delay, up to `longest_delay`
    (s). `columns` says what columns are called, `scale` multiplies them: `{"force": 35.15}` for volts of a drive with
    35.15 N/V. `fix` holds parameters, `fit` adds some that are held otherwise, `ranges` narrows them. With
    `loss="robust"` outliers count less than by their squares. `hold_out` has records that are not fitted, `folds`
    divides the fitted ones into parts for cross-validation; `Fit.unseen` says what is left there. With `axis=True`
    the records are of an axis, M a = F - f - offset; `rest` (m/s) leaves slow samples out. What is not given is as on
    the command line.

    >>> time = np.linspace(0.0, 2.0, 1001)
    >>> velocity = 0.02 * np.sin(2 * np.pi * time)
    >>> import stribeck
    >>> force = stribeck.simulate("Dahl", velocity=velocity, normal_force=20.0, dt=0.002, sigma_0=2e4)["friction_force"]
    >>> noise = np.random.default_rng(1).normal(0.0, 0.02, time.size)
    >>> found = identify({"time": time, "velocity": velocity, "force": force + noise}, "Dahl", normal_force=20.0)
    >>> round(found.best.values["mu_k"], 3)
    0.1
    >>> 0.95 < found.best.values["sigma_0"] / 2e4 < 1.05
    True
    """
    if isinstance(delay, str) and delay != "find":
        raise _stribeck.Refused(f"delay = {delay!r}: must be a number in s, or 'find'")
    if loss not in ("squares", "robust"):
        raise _stribeck.Refused(f"loss = {loss!r}: must be 'squares' or 'robust'")
    named = _named(records, "record")
    known = {
        "mass": mass,
        "normal_force": normal_force,
        "window": window,
        "column": list((columns or {}).items()),
        "scale": list((scale or {}).items()),
        "delay": None if delay == "find" else delay,
        "finds_delay": delay == "find",
        "longest_delay": longest_delay,
        "skip": skip,
        "fix": list((fix or {}).items()),
        "fit": list(fit),
        "range": [(name, list(ends)) for name, ends in (ranges or {}).items()],
        "budget": budget,
        "seed": seed,
        "repetitions": repetitions,
        "is_robust": loss == "robust",
        "folds": folds,
        "rest": rest,
        "axis": axis,
    }
    laws = [law] if isinstance(law, str) else list(law)
    seen = None if motion is None else _plain(motion)
    text, tables = _stribeck.identify(named, _named(hold_out, "held out"), seen, laws, known)
    return Identification(text, dict(tables))


def _named(records: Record | Sequence[Record], kind: str) -> list[tuple[str, str | dict[str, NDArray[np.float64]]]]:
    several = [records] if isinstance(records, str | os.PathLike | Mapping) else list(records)
    return [(_name(f"{kind} {number + 1}", record), _plain(record)) for number, record in enumerate(several)]


def _name(name: str, record: Record) -> str:
    return name if isinstance(record, Mapping) else os.fspath(record)


def _plain(record: Record) -> str | dict[str, NDArray[np.float64]]:
    if isinstance(record, Mapping):
        return {name: np.atleast_1d(np.asarray(values, dtype=float)) for name, values in record.items()}
    return os.fspath(record)
