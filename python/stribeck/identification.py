"""Parameters of laws from measured friction, and how far to trust them."""

from __future__ import annotations

import json
import operator
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stribeck import _stribeck
from stribeck._stribeck import Refused
from stribeck.catalogue import Description


class Columns(Protocol):
    """What has arrays by name: a mapping, a data frame of pandas, an open file of arrays."""

    def keys(self) -> Iterable[Any]:
        """The names."""

    def __getitem__(self, name: Any, /) -> Any:
        """An array."""


Record: TypeAlias = str | os.PathLike[str] | Mapping[str, ArrayLike] | Columns
"""A table of a rig: a file, or what has arrays in SI units (a dict, a data frame) by the names `time`, `force`,
`displacement` or `velocity`, and perhaps `normal_force`, which may be a single number."""

# Seeds and counts are unsigned numbers of 64 bits.
MOST = 2**64 - 1


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
    """RMS residual, N."""
    noise: float
    """The same without outliers, if the loss is robust, N."""
    validation: dict[str, float]
    """RMS residual in each validation record, N."""
    delta_bic: float
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
        """For each record what is to be known of it: first how it is taken to begin (`taken to begin at rest, with the
        contact unloaded`, or `in steady sliding`), then which columns were taken, what is missing or doubtful."""
        self.records = records
        """For each record the arrays `time`, `velocity`, `normal_force`, `force`, `explained` by the best law, and
        whether each sample was `fitted`: those at rest and at the ends are not. With `axis=True` they are averages, one
        every half window of the filter. Arrays are called `record 1` and so on, files by their names."""

    @property
    def best(self) -> Fit:
        """The best fit."""
        return self.fits[0]

    def __repr__(self) -> str:
        best = self.best
        lines = [f"{best.law}: RMS residual {best.rms:.4g} N"]
        lines += [f"  {one.name}: {one.text}" for one in best.estimates.values()]
        lines += [f"  warning: {warning}" for warning in best.warnings]
        lines += [f"  {fit.law}: ΔBIC {fit.delta_bic:.1f}" for fit in self.fits[1:]]
        return "\n".join(lines)


def _fit(one: dict[str, Any]) -> Fit:
    names = ("name", "unit", "verdict", "value", "text")
    ends = ("interval", "repeated")
    estimates = [
        Estimate(**{name: each[name] for name in names}, **{name: each[name] and tuple(each[name]) for name in ends})
        for each in one["estimates"]
    ]
    plain = ("law", "rms", "noise", "validation", "delta_bic", "tied", "repeatable", "warnings", "values")
    return Fit(**{name: one[name] for name in plain}, estimates={each.name: each for each in estimates})


def identify(
    records: Record | Sequence[Record],
    law: str | Description | Sequence[str | Description] = (),
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
    fit: str | Sequence[str] = (),
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
    divides the fitted ones into parts for cross-validation; `Fit.validation` says what is left there. With `axis=True`
    the records are of an axis, M a = F - f - offset; `rest` (m/s) leaves slow samples out. What is not given is as on
    the command line.

    A record begins at rest with the contact unloaded, or in steady sliding if it is fast there: the first of its
    `findings` says which. Columns that are not used may hold anything.

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
    finds_delay = isinstance(delay, str)
    if finds_delay and delay != "find":
        raise Refused(f"delay = {delay!r}: must be a number in s, or 'find'")
    if not (isinstance(loss, str) and loss in ("squares", "robust")):
        raise Refused(f"loss = {loss!r}: must be 'squares' or 'robust'")
    if not isinstance(axis, bool | np.bool_):
        raise TypeError(f"axis = {axis!r}: must be True or False")
    known = {
        "mass": _number("mass", mass),
        "normal_force": _optional(_number, "normal_force", normal_force),
        "window": _optional(_number, "window", window),
        "column": _pairs("columns", columns, _text),
        "scale": _pairs("scale", scale, _number),
        "delay": None if finds_delay else _optional(_number, "delay", delay),
        "finds_delay": finds_delay,
        "longest_delay": _optional(_number, "longest_delay", longest_delay),
        "skip": _number("skip", skip),
        "fix": _pairs("fix", fix, _number),
        "fit": _texts("fit", fit),
        "range": _pairs("ranges", ranges, _ends),
        "budget": _optional(_count, "budget", budget),
        "seed": _optional(_count, "seed", seed),
        "repetitions": _optional(_count, "repetitions", repetitions),
        "is_robust": loss == "robust",
        "folds": _count("folds", folds),
        "rest": _optional(_number, "rest", rest),
        "axis": bool(axis),
    }
    laws = _texts("law", law)
    fitted, unseen = _several("records", records), _several("hold_out", hold_out)
    _refuse_twins({"record": fitted, "held out": unseen})
    seen = None if motion is None else _plain("motion", motion)
    text, tables = _stribeck.identify(_named("record", fitted), _named("held out", unseen), seen, laws, known)
    return Identification(text, dict(tables))


def _number(name: str, value: Any) -> float:
    is_number = np.ndim(value) == 0 and np.asarray(value).dtype.kind in "iuf"
    if not is_number:
        raise TypeError(f"{name} = {value!r}: must be a number")
    return float(value)


def _count(name: str, value: Any) -> int:
    try:
        number = operator.index(None if isinstance(value, bool) else value)
    except TypeError:
        raise TypeError(f"{name} = {value!r}: must be a whole number") from None
    if not 0 <= number <= MOST:
        raise Refused(f"{name} = {number}: must be >= 0 and <= {MOST}")
    return number


def _optional(check: Any, name: str, value: Any) -> Any:
    return None if value is None else check(name, value)


def _text(name: str, value: Any) -> str:
    if isinstance(value, Description):
        return value.name
    if not isinstance(value, str):
        raise TypeError(f"{name} = {value!r}: must be a name")
    return value


def _texts(name: str, values: Any) -> list[str]:
    """Names, of which a single one needs no list."""
    if isinstance(values, str | Description):
        return [_text(name, values)]
    if isinstance(values, Mapping) or not isinstance(values, Iterable):
        raise TypeError(f"{name} = {values!r}: must be a name or a list of names")
    return [_text(name, value) for value in values]


def _ends(name: str, value: Any) -> list[float]:
    if isinstance(value, str) or np.ndim(value) != 1 or len(value) != 2:
        raise TypeError(f"{name} = {value!r}: must be two numbers, the least and the greatest")
    return [_number(name, end) for end in value]


def _pairs(name: str, values: Any, check: Any) -> list[tuple[str, Any]]:
    if values is None:
        return []
    if not isinstance(values, Mapping):
        raise TypeError(f"{name} = {values!r}: must be a dict")
    return [(_text(f"a name in {name}", key), check(f"{name}[{key!r}]", value)) for key, value in values.items()]


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
    """Refuses a record that is given twice: it would count double, or be held against itself."""
    seen: dict[Any, str] = {}
    for kind, records in kinds.items():
        for number, record in enumerate(records, 1):
            own = f"{kind} {number}"
            is_file = isinstance(record, str | os.PathLike)
            first = seen.setdefault(os.path.realpath(record) if is_file else id(record), own)
            if first != own:
                what = f" ({os.fspath(record)})" if is_file else ""
                raise Refused(f"{own}{what} is the same as {first}: give it once")


def _named(kind: str, records: Sequence[Any]) -> list[tuple[str, Any]]:
    plain = [(f"{kind} {number}", record) for number, record in enumerate(records, 1)]
    told = [(name, _plain(name, record)) for name, record in plain]
    return [(record if isinstance(record, str) else name, record) for name, record in told]


def _plain(name: str, record: Any) -> str | dict[str, Any]:
    """The path of a file, or columns by name."""
    if isinstance(record, str | os.PathLike):
        path = os.fspath(record)
        if isinstance(path, str):
            return path
    elif _has_columns(record):
        return {str(key): _column(record[key]) for key in record.keys()}  # noqa: SIM118 (rows, in a data frame)
    raise _no_record(name, record)


def _column(values: Any) -> NDArray[np.float64] | float | str:
    """A column as numbers, or what is wrong with it, which is said if it is used: a table may have texts besides."""
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
