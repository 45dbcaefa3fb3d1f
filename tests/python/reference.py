"""The inputs and results that an FMU holds to be compared with."""

import csv
import io
import zipfile
from dataclasses import dataclass
from pathlib import Path

FOLDER = "extra/org.fmi-standard.fmi-ls-ref"
Table = dict[str, list[float]]


@dataclass(frozen=True)
class Reference:
    """Inputs at the beginning of each step; outputs at the start and after each step."""

    inputs: Table
    outputs: Table

    @classmethod
    def of(cls, fmu: Path) -> "Reference":
        """Those of an FMU."""
        with zipfile.ZipFile(fmu) as archive:
            names = archive.namelist()
            given = f"{FOLDER}/{fmu.stem}_in.csv"
            inputs = table(archive.read(given)) if given in names else {}
            return cls(inputs, table(archive.read(f"{FOLDER}/{fmu.stem}_out.csv")))

    @property
    def steps(self) -> list[tuple[float, float]]:
        """Beginning and length of each step. The length is that of the first: differences of times round."""
        times = self.outputs["time"]
        return [(time, times[1] - times[0]) for time in times[:-1]]


def table(text: bytes) -> Table:
    """The columns of a CSV file."""
    heading, *rows = csv.reader(io.StringIO(text.decode()))
    return {name: [float(row[column]) for row in rows] for column, name in enumerate(heading)}
