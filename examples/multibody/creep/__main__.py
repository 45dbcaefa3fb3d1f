"""Measures how far a block creeps on a slope in a minute, and writes docs/creep.md, docs/creep.csv and docs/creep.png.

    python -m examples.multibody.creep

A simulator that is not installed keeps the rows of docs/creep.csv with their date and version; the program says which
ones, and how to install them. With --only NAME the others are kept as well.
"""

import argparse
import datetime
import importlib
import sys
from pathlib import Path

from tqdm import tqdm

from examples.fmpy.coupling import FMUS, PROJECT, CouplingError, main
from examples.multibody.creep.page import draw, write_page
from examples.multibody.creep.slope import DURATION, LOADS, SETTLED, STEP, Case, Slope, drift, slid
from examples.multibody.creep.table import OWN, Row, read_rows, write_rows

# Modules with the friction of a simulator, and how it is installed.
SIMULATORS = {
    "MuJoCo": ("mujoco_friction", "pip install mujoco"),
    "exudyn": ("exudyn_friction", "pip install exudyn"),
    "Drake": ("drake_friction", "pip install drake"),
    "Bullet": ("bullet_friction", "pip install pybullet"),
}


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", choices=[*SIMULATORS, OWN], action="append", help="measure this one only; repeatable")
    parser.add_argument("--fmus", type=Path, default=FMUS, help="folder of the FMUs (default: dist)")
    parser.add_argument("--out", type=Path, default=PROJECT / "docs", help="folder of the page (default: docs)")
    return parser.parse_args()


def measured(case: Case, kind: str, version: str) -> list[Row]:
    """A row for each load."""
    today = datetime.date.today().isoformat()
    rows = []
    sliding = slid(case.measure)
    for load in tqdm(LOADS, desc=f"{case.simulator}, {case.friction}, {case.options}", leave=False, disable=None):
        about = (case.simulator, version, today, kind, case.friction, case.options, load)
        expected = None if case.speed is None else DURATION * case.speed(load)
        try:
            positions = case.measure(Slope(load), round((SETTLED + DURATION) / STEP))
        except CouplingError as error:
            rows.append(Row(*about, None, None, expected, sliding, str(error)))
            continue
        settled = float(positions[round(SETTLED / STEP)])
        rows.append(Row(*about, settled, drift(positions), expected, sliding, ""))
    return rows


def of_laws(only: list[str] | None, fmus: Path) -> list[Row]:
    """Rows of the project's laws, in the workbench and in simulators."""
    if only is not None and not {OWN, "MuJoCo", "exudyn"} & set(only):
        return []
    from examples.multibody.creep.hosted import cases, version_of

    return [
        row
        for case in cases(fmus)
        if only is None or case.simulator in only
        for row in measured(case, "law", version_of(case.simulator))
    ]


def of_simulators(only: list[str] | None) -> list[Row]:
    """Rows of the friction that the simulators have."""
    rows = []
    for name, (module, install) in SIMULATORS.items():
        if only is not None and name not in only:
            continue
        try:
            simulator = importlib.import_module(f"examples.multibody.creep.{module}")
        except ImportError as error:
            print(f"{name} is not measured, its rows are kept ({error}): {install}", file=sys.stderr)
            continue
        for case in simulator.cases():
            rows += measured(case, "own", simulator.VERSION)
    return rows


def program() -> None:
    """Measures, and writes table, picture and page."""
    options = arguments()
    options.out.mkdir(parents=True, exist_ok=True)
    table = options.out / "creep.csv"
    kept = read_rows(table) if table.is_file() else []
    rows = of_laws(options.only, options.fmus) + of_simulators(options.only)
    # A simulator that was measured loses all its earlier rows: options may have gone.
    again = {(row.simulator, row.kind) for row in rows}
    order = [OWN, *SIMULATORS]
    rows += [row for row in kept if (row.simulator, row.kind) not in again]
    rows.sort(key=lambda row: (row.kind, order.index(row.simulator)))
    write_rows(table, rows)
    draw(rows, options.out / "creep.png")
    write_page(rows, options.out / "creep.md")
    for name in ("creep.csv", "creep.png", "creep.md"):
        print(options.out / name)


if __name__ == "__main__":
    sys.exit(main(program))
