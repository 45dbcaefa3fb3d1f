"""Creep of a block on a slope: the laws of the project in MuJoCo and exudyn, and what docs/creep.md says of them."""

import datetime
import functools
import re
import sys

import pytest
import stribeck

from examples.fmpy.coupling import FMUS, PROJECT
from examples.multibody.creep import __main__ as creep
from examples.multibody.creep import closed_form, exudyn_friction, hosted, mujoco_friction
from examples.multibody.creep.page import grouped, shown, write_page
from examples.multibody.creep.slope import DURATION, LOADS, MASS, MU, SETTLED, STEP, Case, Slope, drift
from examples.multibody.creep.table import OWN, read_rows, write_rows

DOCS = PROJECT / "docs"
ROWS = read_rows(DOCS / "creep.csv")
SHORT = 2.0  # s
STEPS = round(SHORT / STEP)
SIMULATORS = [*mujoco_friction.cases(), *exudyn_friction.cases()]
CASES = {(case.simulator, case.friction, case.options): case for case in (*hosted.cases(FMUS), *SIMULATORS)}


def one_per_law(laws) -> list[Case]:
    """Cases of these laws, in the workbench and in both simulators."""
    return [case for (_, friction, _), case in CASES.items() if friction in laws]


def name_of(case: Case) -> str:
    return f"{case.simulator}-{case.friction}"


@functools.cache
def speed(case: Case, load: float) -> float:
    """Mean speed in the second after the block has settled."""
    return drift(case.measure(Slope(load), STEPS)) / (SHORT - SETTLED)


@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("case", one_per_law(set(hosted.HOLDING) - {"Dahl"}), ids=name_of)
def test_a_law_with_stiction_holds_the_block(case, load):
    positions = case.measure(Slope(load), STEPS)
    assert abs(positions[-1] - positions[-round(0.2 / STEP)]) < 1e-12
    if "mass" in case.options:
        assert not positions.any(), "not even bristles yield"
    else:
        assert positions[-1] > 0.5 * Slope(load).pull / 1e5, "the bristles have yielded"


@pytest.mark.parametrize("load", LOADS)
@pytest.mark.parametrize("case", one_per_law(hosted.CREEPING), ids=name_of)
def test_a_regularised_law_creeps_where_its_curve_carries_the_load(case, load):
    expected = case.speed(load)
    slope = Slope(load)
    parameters = {name: value for name, value in hosted.LAWS[case.friction].items() if name != "mass"}
    assert stribeck.force(case.friction, expected, slope.normal_force, **parameters) == pytest.approx(slope.pull, 1e-12)
    assert speed(case, load) == pytest.approx(expected, 1e-6)


@pytest.mark.parametrize("mass", [0.5, 1.0, 1.5])
@pytest.mark.parametrize("host", [hosted.in_mujoco, hosted.in_exudyn])
def test_a_law_holds_what_it_is_told(host, mass):
    """Half or one and a half times the right mass does no harm; a load that is not given lets the body creep."""
    slope = Slope(0.9)
    parameters = {"mu_k": MU, "mu_s": MU, "mass": mass}
    with hosted.open_law("CoulombStiction", parameters, slope, FMUS) as law:
        assert not host(law, slope, 500).any()
    if mass <= MASS:
        with hosted.open_law("CoulombStiction", parameters, slope, FMUS, told=False) as law:
            positions = host(law, slope, 500)
        assert (positions[-1] - positions[250]) / (250 * STEP) == pytest.approx(STEP * slope.pull / mass, 1e-9)


@pytest.mark.parametrize("case", SIMULATORS, ids=name_of)
def test_friction_of_a_simulator_is_as_strong_as_that_of_the_laws(case):
    """Half a second from rest under 1.1 times the level."""
    slope = Slope(1.1)
    distance = case.measure(slope, round(0.5 / STEP))[-1]
    assert distance == pytest.approx(0.5 * 0.5**2 * (slope.pull - slope.level) / MASS, rel=0.12)


@pytest.mark.parametrize("load", LOADS)
def test_simulators_creep_as_their_formulas_say(load):
    joints = [case for case in CASES.values() if case.speed and case.simulator == "MuJoCo" and "joint" in case.friction]
    assert len(joints) == 3
    for case in joints:
        assert speed(case, load) == pytest.approx(case.speed(load), 1e-6)
    zone = CASES["exudyn", "`GeneralContact`", "frictionProportionalZone = 0.001 m/s (default)"]
    assert speed(zone, load) == pytest.approx(1e-3 * load, 1e-3)
    elliptic = [
        speed(CASES["MuJoCo", "contacts", f'cone="elliptic" impratio="{ratio}"'], load) for ratio in ("1", "100")
    ]
    assert elliptic[0] / elliptic[1] == pytest.approx(100.0, 1e-3)


def test_formulas_of_drake_are_forces_below_the_level():
    for load in LOADS:
        part = closed_form.drake_lagged(1e-4, load) / 1e-4
        assert part / (1.0 + part**2) ** 0.5 == pytest.approx(load, 1e-14)
        part = closed_form.drake_tamsi(1e-4, load) / 1e-4
        assert part * (2.0 - part) == pytest.approx(load, 1e-14)


def test_the_table_is_complete():
    cases = grouped(ROWS)
    assert set(CASES) <= set(cases)
    assert {simulator for simulator, _, _ in cases} == {OWN, *creep.SIMULATORS}
    for by_load in cases.values():
        assert tuple(by_load) == LOADS
    for row in ROWS:
        assert re.fullmatch(r"\d+(\.\d+)+", row.version), row
        assert datetime.date.fromisoformat(row.measured) <= datetime.date.today(), row
        assert (row.drift is None) == (row.settled is None) == bool(row.failure), row


def test_drift_in_the_table_is_that_of_its_formula():
    compared = [row for row in ROWS if row.expected is not None and row.drift is not None]
    assert len({(row.simulator, row.kind, row.options) for row in compared}) > 15
    for row in compared:
        assert row.drift == pytest.approx(row.expected, rel=2e-3), row


@pytest.mark.parametrize("simulator", ["MuJoCo", "exudyn"])
def test_drift_in_the_table_is_what_a_short_run_shows(simulator):
    compared = 0
    for row in ROWS:
        case = CASES[row.simulator, row.friction, row.options] if row.simulator == simulator else None
        # Steady creep only: where it is not steady, a short run does not show it.
        if row.kind == "law" or case is None or row.drift is None or row.drift < 1e-4 or "bristles" in row.options:
            continue
        assert DURATION * speed(case, row.load) == pytest.approx(row.drift, rel=0.15), row
        compared += 1
    assert compared > 10


def test_the_page_is_written_from_the_table(tmp_path):
    write_rows(tmp_path / "creep.csv", ROWS)
    assert (tmp_path / "creep.csv").read_text(encoding="utf-8") == (DOCS / "creep.csv").read_text(encoding="utf-8")
    write_page(ROWS, tmp_path / "creep.md")
    page = (tmp_path / "creep.md").read_text(encoding="utf-8")
    assert page == (DOCS / "creep.md").read_text(encoding="utf-8")
    tables = re.findall(r"(?:^\|.*\|\n)+", page, re.MULTILINE)
    assert len(tables) == 3
    for table in tables:
        assert len({line.count("|") for line in table.splitlines()}) == 1
    for row in ROWS:
        assert f"| {row.simulator} | {row.version} | {row.measured} |" in page
        assert shown(row.drift) in page if row.drift is not None else "did not converge" in page


def test_a_simulator_that_is_missing_keeps_its_rows(tmp_path, monkeypatch, capsys):
    write_rows(tmp_path / "creep.csv", ROWS)
    monkeypatch.setitem(sys.modules, "pydrake.geometry", None)
    monkeypatch.delitem(sys.modules, "examples.multibody.creep.drake_friction", raising=False)
    monkeypatch.setattr(sys, "argv", ["creep", "--only", "Drake", "--out", str(tmp_path)])
    creep.program()
    assert "Drake is not measured, its rows are kept" in (said := capsys.readouterr().err)
    assert "pip install drake" in said
    assert read_rows(tmp_path / "creep.csv") == ROWS
    assert (tmp_path / "creep.md").read_text(encoding="utf-8") == (DOCS / "creep.md").read_text(encoding="utf-8")
