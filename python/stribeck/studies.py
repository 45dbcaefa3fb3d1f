"""Studies: many runs of a system, a few numbers of each."""

from __future__ import annotations

import csv
import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stribeck import _stribeck

if TYPE_CHECKING:
    import pandas


class Table(Mapping[str, NDArray[Any]]):
    """The table of a study: a mapping from names to arrays with a value per row; `law` and `end` are texts. A run that
    did not come to its end has its reason in `end`, and NaN in what was to be kept of it."""

    def __init__(self, path: Path) -> None:
        self.path = path
        """File of the table."""
        with path.open(newline="", encoding="utf-8") as file:
            names, *rows = csv.reader(file)
        texts = dict(zip(names, zip(*rows, strict=True), strict=True))
        self.columns = {name: _column(name, values) for name, values in texts.items()}

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __repr__(self) -> str:
        failed = int((self["end"] != "reached").sum())
        return f"<study of {len(self['row'])} rows, {failed} failed: {', '.join(self)}>"

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with a line per row."""
        import pandas

        return pandas.DataFrame(self.columns).set_index("row")


def _column(name: str, values: tuple[str, ...]) -> NDArray[Any]:
    if name in ("law", "end"):
        return np.array(values)
    if name == "row":
        return np.array([int(value) for value in values])
    return np.array([float(value or "nan") for value in values])


def study(
    study: str | os.PathLike[str] | Mapping[str, Any],
    folder: str | os.PathLike[str],
    *,
    shard: str | None = None,
    threads: int | None = None,
) -> Table | None:
    """Makes a study, as `stribeck study` does, and returns its table.

    `study` is the path of a file, or a dictionary with the same entries: `samples`, `seed`, `keep`, `vary`, `table`,
    `run`. Finished chunks are kept in `folder`: the same call goes on where it was interrupted. With `shard`, such as
    "2/8", only that part is made and nothing is returned; a call without it then makes what is missing, and joins all.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     table = study(
    ...         {
    ...             "samples": 3,
    ...             "keep": ["max rig.position"],
    ...             "vary": {"mu_s": {"uniform": [0.1, 0.2]}},
    ...             "run": {"until": 1.0},
    ...         },
    ...         folder,
    ...     )
    >>> table
    <study of 3 rows, 0 failed: row, law, mu_s, max rig.position, end>
    """
    spec = dict(study) if isinstance(study, Mapping) else os.fspath(study)
    _stribeck.make_study(spec, os.fspath(folder), shard=shard or "1/1", threads_asked=threads)
    return None if shard else Table(Path(_stribeck.merge_study(spec, os.fspath(folder))))
