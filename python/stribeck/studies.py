"""Studies: many runs of a system, a few numbers of each."""

from __future__ import annotations

import csv
import os
import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from stribeck import _stribeck
from stribeck._stribeck import Refused
from stribeck.catalogue import hint
from stribeck.threads import checked

if TYPE_CHECKING:
    import distributed
    import pandas


class Table(Mapping[str, NDArray[Any]]):
    """The table of a study: a mapping from names to arrays with a value per row; `law` and `end` are texts. A run that
    did not come to its end has its reason in `end`, and NaN as results."""

    def __init__(self, path: Path) -> None:
        self.path = path
        """File of the table."""
        with path.open(newline="", encoding="utf-8") as file:
            names, *rows = csv.reader(file)
        texts = dict(zip(names, zip(*rows, strict=True), strict=True))
        self.columns = {name: _column(name, values) for name, values in texts.items()}

    def __getitem__(self, name: str) -> NDArray[Any]:
        if name not in self.columns:
            raise KeyError(f"{name!r} is not a column of the study{hint(name, self)}")
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

    def to_parquet(self, path: str | os.PathLike[str]) -> None:
        """Writes the table as a Parquet file; needs pyarrow (`pip install stribeck[parquet]`)."""
        import pyarrow
        import pyarrow.parquet

        pyarrow.parquet.write_table(pyarrow.table(self.columns), os.fspath(path))


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
    client: distributed.Client | None = None,
    max_failures: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Table | None:
    """Runs a study, as `stribeck study` does, and returns its table.

    `study` is the path of a file, or a dictionary with the same entries: `samples`, `seed`, `keep`, `vary`, `table`,
    `run`. Finished chunks are kept in `folder`: the same call resumes an interrupted study. With `shard`, such as
    "2/8", only that part is run and nothing is returned; a call without it then runs what is missing, and joins all.
    The shard "array" is that of a job array of SLURM, PBS, Grid Engine or AWS Batch.

    With `client`, a client of Dask (`pip install stribeck[dask]`), the workers of its cluster run the chunks and return
    them: they need this package, and the files that the study names under the same paths, but not `folder`. The bytes
    of the table are the same. More than `max_failures` failed runs end the study with an error. `progress`, such as
    `print`, is called now and then with the number of finished rows and that of all.

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
    spec = dict(study) if isinstance(study, Mapping) else os.fspath(Path(study).resolve())
    if client is not None:
        if shard is not None or threads is not None:
            raise TypeError("client: a cluster divides the study itself, without shard and threads")
        _send_out(spec, Path(folder), client, max_failures, progress)
    # Existing chunks are not run again.
    _stribeck.make_study(
        spec,
        os.fspath(folder),
        shard=shard or "1/1",
        threads_asked=checked(threads),
        max_failures=max_failures,
        progress=progress,
    )
    return None if shard else Table(Path(_stribeck.merge_study(spec, os.fspath(folder))))


def _send_out(
    spec: str | dict[str, Any],
    folder: Path,
    client: distributed.Client,
    max_failures: int | None,
    progress: Callable[[int, int], object] | None,
) -> None:
    """Runs the missing chunks on the workers of a cluster, and writes them to the folder as they arrive."""
    import distributed

    rows, count, missing = _stribeck.missing_chunks(spec, os.fspath(folder))
    folder.mkdir(parents=True, exist_ok=True)
    # Not pure: the files of a study may have changed since an earlier call.
    chunks = [client.submit(_chunk, spec, f"{number + 1}/{count}", pure=False) for number, _ in missing]
    done, failures = rows - sum(made for _, made in missing), 0
    try:
        for _, (name, content, made, failed) in distributed.as_completed(chunks, with_results=True):
            # Under another name first: the file appears only when it is complete.
            temporary = folder / f".{name}-{os.getpid()}"
            temporary.write_bytes(content)
            temporary.replace(folder / name)
            done, failures = done + made, failures + failed
            if progress is not None:
                progress(done, rows)
            if max_failures is not None and failures > max_failures:
                raise Refused(f"{failures} rows did not come to their end, more than {max_failures} (max_failures)")
    finally:
        client.cancel(chunks)


def _chunk(spec: str | dict[str, Any], shard: str) -> tuple[str, bytes, int, int]:
    """Runs one chunk of a study; returns the name and contents of its file, and the numbers of rows and failed rows."""
    with tempfile.TemporaryDirectory() as folder:
        made, _, failed = _stribeck.make_study(
            spec, folder, shard=shard, threads_asked=1, max_failures=None, progress=None
        )
        (file,) = Path(folder).iterdir()
        return file.name, file.read_bytes(), made, failed
