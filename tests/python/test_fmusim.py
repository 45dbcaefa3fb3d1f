"""Every FMU in fmusim, the simulator of the Reference FMUs: both versions alike, and FMI 3.0 in event mode."""

import csv
import shutil
import subprocess

import pytest
from events import CASES, H
from fmi3 import FOLDER
from fmpy import read_model_description

from examples.fmpy.coupling import models_in, path_of

PROGRAM = shutil.which("fmusim")
pytestmark = pytest.mark.skipif(
    PROGRAM is None, reason="needs fmusim of github.com/modelica/Reference-FMUs on the search path"
)
MODELS = models_in(FOLDER)


def simulate(fmu, folder, start, outputs, interval, stop, *options) -> list[dict[str, str]]:
    """The rows of a run in co-simulation."""
    table = folder / "table.csv"
    words = ["--interface-type", "cs", "--stop-time", stop, "--output-interval", interval, "--output-file", table]
    for name, value in start.items():
        words += ["--start-value", name, value]
    for name in outputs:
        words += ["--output-variable", name]
    command = [str(word) for word in [PROGRAM, *words, *options, fmu]]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout + done.stderr
    # Booleans are words in one version, and digits in the other.
    text = table.read_text(encoding="utf-8").replace("true", "1").replace("false", "0")
    return list(csv.DictReader(text.splitlines()))


IN_EVENT_MODE = ("--event-mode-used", "--early-return-allowed")


@pytest.mark.parametrize("model", MODELS)
def test_both_versions_print_the_same(model, tmp_path):
    known = read_model_description(str(path_of(model, FOLDER)), validate=False).modelVariables
    outputs = [one.name for one in known if one.causality == "output" and not one.shape]
    moves = any((one.name, one.causality) == ("velocity", "input") for one in known)
    arguments = (tmp_path, {"velocity": 2e-3} if moves else {}, outputs, 0.01, 0.5)
    rows = simulate(path_of(model, FOLDER), *arguments)
    assert len(rows) == 51
    assert rows == simulate(path_of(model), *arguments)
    with_events = simulate(path_of(model, FOLDER), *arguments, *IN_EVENT_MODE)
    assert len(with_events) >= 51
    assert float(with_events[-1]["time"]) == pytest.approx(0.5)


@pytest.mark.parametrize("case", CASES)
def test_contacts_stick_and_slip_at_the_times_of_the_closed_form(case, tmp_path):
    model, start, time, sticks = CASES[case]
    rows = simulate(path_of(model, FOLDER), tmp_path, start, ["sticking"], H, 0.5, *IN_EVENT_MODE)
    event = next(row for row in rows if (row["sticking"] == "1") == sticks and float(row["time"]) > 0.0)
    assert float(event["time"]) == pytest.approx(time, abs=1e-9)
