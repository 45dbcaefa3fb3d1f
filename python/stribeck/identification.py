"""Parameters of laws from measured friction, with their uncertainty."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stribeck import _stribeck
from stribeck._stribeck import Refused
from stribeck.catalogue import Description


class Columns(Protocol):
    """Arrays by name: a mapping, a data frame of pandas, an open file of arrays."""

    def keys(self) -> Iterable[Any]:
        """The names."""

    def __getitem__(self, name: Any, /) -> Any:
        """An array."""


Record: TypeAlias = str | os.PathLike[str] | Mapping[str, ArrayLike] | Columns
"""A table of a rig: a file, or what has arrays in SI units (a dict, a data frame) by the names `time`, `force`,
`displacement` or `velocity`, and perhaps `normal_force`, which may be a single number. Names may have other units,
those of a joint too: `force [N m]`, `displacement [deg]`. `velocity` and `force` without `time` are a map of friction
at constant speed."""


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
    """Interval of 95 %, the wider one of linearisation and profile likelihood."""
    repeated: tuple[float, float] | None
    """Interval of 95 %, from a block bootstrap of the residuals."""
    text: str
    """Value and intervals as `stribeck identify` prints them, or why there are none."""


@dataclass(frozen=True)
class Judgement:
    """Values that were given, judged by the data: by `reference`, `evaluate`, or `fix` for every parameter."""

    source: str
    """The preset, the file, or `fix`."""
    values: dict[str, float]
    rms: float
    """RMS residual of the values."""
    fit_rms: float | None
    """That of the best fit of the same law, if one was made."""
    outside: dict[str, tuple[float, float]]
    """For each value outside the interval of 95 % of the fit, that interval."""
    verdict: str
    warnings: list[str]
    note: str | None
    """That the values are for another law, if they are."""


@dataclass(frozen=True)
class Fit:
    """A law fitted to records."""

    law: str
    rms: float
    """RMS residual, N, or N m for a joint."""
    noise: float
    """The same without outliers, if the loss is robust."""
    validation: dict[str, float]
    """RMS residual in each validation record."""
    delta_bic: float
    """Criterion (BIC) above that of the best law."""
    tied: bool
    """Whether it cannot be distinguished from the best law."""
    repeatable: bool
    """Whether two searches agreed."""
    estimates: dict[str, Estimate]
    lack_of_fit: dict[str, Any] | None
    """Of a map with repeats: the `ratio` F of its misfit to their scatter, its degrees of `freedom`, and whether the
    scatter has `explained` it."""
    warnings: list[str]
    values: dict[str, float]
    """The parameters of the law that were held or that the data determine, as `force` and `simulate` take them."""
    judgement: Judgement | None
    """Judgement of values that were given, by the data."""


class Identification:
    """Laws fitted to records, the best first."""

    def __init__(self, text: str, records: dict[str, dict[str, NDArray[np.float64 | np.bool_]]]) -> None:
        found = json.loads(text)
        self.fits = [_fit(one) for one in found["laws"]]
        """The fits."""
        self.units: dict[str, str] = found["units"]
        """Units of `force`, `displacement` and `velocity`: those of a joint if a column has one (`force [N m]`)."""
        self.refused: dict[str, str] = {one["law"]: one["reason"] for one in found["refused"]}
        """Laws that cannot be fitted, with the reason."""
        self.findings: dict[str, list[str]] = found["findings"]
        """Remarks on each record: first its assumed initial state (`taken to begin at rest, with the contact unloaded`,
        or `in steady sliding`), then which columns were used, what is missing or doubtful."""
        self.records = records
        """For each record the arrays `time`, `velocity`, `normal_force`, `force`, `predicted` by the best law, and
        whether each sample was `fitted`: those at rest and at the ends are not. A map has no `time`. With `axis=True`
        they are averages, one every half window of the filter. Arrays are called `record 1` and so on, files by their
        names."""

    @property
    def best(self) -> Fit:
        """The best fit."""
        return self.fits[0]

    def __repr__(self) -> str:
        best = self.best
        lines = [f"{best.law}: RMS residual {best.rms:.4g} {self.units['force']}"]
        lines += [f"  {one.name}: {one.text}" for one in best.estimates.values()]
        lines += [f"  warning: {warning}" for warning in best.warnings]
        if best.judgement is not None:
            given = best.judgement
            lines.append(f"  {given.source}: RMS residual {given.rms:.4g} {self.units['force']}: {given.verdict}")
        lines += [f"  {fit.law}: ΔBIC {fit.delta_bic:.1f}" for fit in self.fits[1:]]
        return "\n".join(lines)


def _fit(one: dict[str, Any]) -> Fit:
    names = ("name", "unit", "verdict", "value", "text")
    ends = ("interval", "repeated")
    estimates = [
        Estimate(**{name: each[name] for name in names}, **{name: each[name] and tuple(each[name]) for name in ends})
        for each in one["estimates"]
    ]
    plain = (
        "law",
        "rms",
        "noise",
        "validation",
        "delta_bic",
        "tied",
        "repeatable",
        "lack_of_fit",
        "warnings",
        "values",
    )
    return Fit(
        **{name: one[name] for name in plain},
        estimates={each.name: each for each in estimates},
        judgement=one["judgement"] and _judgement(one["judgement"]),
    )


def _judgement(one: dict[str, Any]) -> Judgement:
    return Judgement(**one | {"outside": {each["name"]: tuple(each["interval"]) for each in one["outside"]}})


def identify(
    records: Record | Sequence[Record],
    law: str | Description | Sequence[str | Description] = (),
    *,
    motion: Record | None = None,
    hold_out: Record | Sequence[Record] = (),
    **options: Any,
) -> Identification:
    """Fits the parameters of a law, or of several (`"all"`). Same names, same numbers as `stribeck identify`.

    `motion` is the table of a camera with its own clock. `hold_out` has validation records, which are not fitted;
    `Fit.validation` has their RMS residuals. Of the other options, those with NAME=... are dictionaries here, and
    LOW:HIGH is a pair:

    {options}

    A record is assumed to begin at rest with the contact unloaded, or in steady sliding if it is fast there: see the
    first of its `findings`. Unused columns may hold anything.

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
    kinds = {"record": _several("records", records), "held out": _several("hold_out", hold_out)}
    _refuse_twins(kinds)
    arrays: dict[str, dict[str, Any]] = {}
    names = {
        kind: [_placed(f"{kind} {at}", record, arrays) for at, record in enumerate(all_of_kind, 1)]
        for kind, all_of_kind in kinds.items()
    }
    entries = {name: value for name, value in options.items() if value is not None}
    entries |= {"records": names["record"], "hold_out": names["held out"], "law": _names("law", law)}
    if "fit" in entries:
        entries["fit"] = _names("fit", entries["fit"])
    if motion is not None:
        entries["motion"] = _placed("motion", motion, arrays)
    text, tables = _stribeck.identify(entries, arrays)
    return Identification(text, dict(tables))


if identify.__doc__ is not None:
    identify.__doc__ = identify.__doc__.replace("{options}", _stribeck.identify_options())


def _names(name: str, values: Any) -> list[str]:
    """Names, of which a single one needs no list."""
    several = [values] if isinstance(values, str | Description) else values
    if isinstance(several, Mapping) or not isinstance(several, Iterable):
        raise TypeError(f"{name} = {values!r}: must be a name or a list of names")
    return [str(one) if isinstance(one, Description) else one for one in several]


def _has_columns(record: Any) -> bool:
    # A single column of a data frame has the names of its rows as keys.
    return hasattr(record, "keys") and hasattr(record, "__getitem__") and getattr(record, "ndim", 2) != 1


def _several(name: str, records: Any) -> list[Any]:
    """Records, of which a single one needs no list."""
    if isinstance(records, str | os.PathLike) or _has_columns(records):
        return [records]
    # The rows of an array are not records.
    if isinstance(records, bytes | np.ndarray) or not isinstance(records, Iterable):
        raise _no_record(name, records)
    return list(records)


def _no_record(name: str, record: Any) -> TypeError:
    return TypeError(
        f"{name}: {type(record).__name__} is not a record: give the name of a file, or arrays by name, as in "
        '{"time": ..., "force": ..., "displacement": ...} or a data frame'
    )


def _refuse_twins(kinds: Mapping[str, Sequence[Any]]) -> None:
    """Rejects arrays that are given twice: they would count double, or validate themselves."""
    first_uses: dict[int, str] = {}
    for kind, records in kinds.items():
        for number, record in enumerate(records, 1):
            own = f"{kind} {number}"
            first = own if isinstance(record, str | os.PathLike) else first_uses.setdefault(id(record), own)
            if first != own:
                raise Refused(f"{own} is the same as {first}: give it once")


def _placed(name: str, record: Any, arrays: dict[str, dict[str, Any]]) -> str:
    """The path of a file, or the name under which the columns are stored in `arrays`."""
    if isinstance(record, str | os.PathLike):
        path = os.fspath(record)
        if isinstance(path, str):
            return path
    elif _has_columns(record):
        arrays[name] = {str(key): _column(record[key]) for key in record.keys()}  # noqa: SIM118 (rows, in a data frame)
        return name
    raise _no_record(name, record)


def _column(values: Any) -> NDArray[np.float64] | float | str:
    """A column as numbers, or a description of the problem, raised only if the column is used (tables have texts)."""
    if np.ma.is_masked(values):
        return "has numbers that are masked: leave them out"
    try:
        array = np.asarray(values)
    except (TypeError, ValueError):
        return "must be numbers, in one dimension"
    if array.dtype.kind not in "iuf":
        return f"must be numbers, not {array.dtype}"
    if array.ndim > 1:
        return f"has the shape {array.shape}: must have one dimension"
    return array.astype(np.float64) if array.ndim else float(array)
