"""The rows of docs/creep.csv."""

import csv
from dataclasses import dataclass, fields
from pathlib import Path

# Name of the workbench among the simulators.
OWN = "Stribeck"


@dataclass(frozen=True)
class Row:
    """Drift with a kind of friction, options and a load, and when and with which version it was measured."""

    simulator: str
    version: str
    measured: str
    # `law`: a law of this project; `own`: friction of the simulator.
    kind: str
    friction: str
    options: str
    load: float
    # Displacement in m while the block settles, and after that; neither of a run that failed.
    settled: float | None
    drift: float | None
    # Drift in m that a formula gives, if there is one.
    expected: float | None
    # Distance above the level as a part of that of Coulomb friction, see `slope.slid`.
    sliding: float | None
    failure: str


def write_rows(path: Path, rows: list[Row]) -> None:
    """Writes the table; numbers have all their digits."""
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        names = [field.name for field in fields(Row)]
        writer.writerow([f"{name} [m]" if name in ("settled", "drift", "expected") else name for name in names])
        writer.writerows([getattr(row, name) for name in names] for row in rows)


def read_rows(path: Path) -> list[Row]:
    """Reads the table."""

    def number(text: str) -> float | None:
        return float(text) if text else None

    with path.open(encoding="utf-8", newline="") as file:
        _, *rows = csv.reader(file)
    return [Row(*row[:6], float(row[6]), *map(number, row[7:11]), row[11]) for row in rows]
