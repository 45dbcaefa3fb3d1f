"""The example programs as a user starts them."""

import subprocess
import sys

import numpy
import pytest
from coupling import PROJECT
from matplotlib.image import imread


def start(program: str, *options: str, folder) -> subprocess.CompletedProcess:
    """Runs a program in a folder of its own."""
    command = [sys.executable, str(PROJECT / "examples" / "fmpy" / program), *options]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)


def is_drawn(path) -> bool:
    """Is there something in every ninth of the picture? Not in the one in the middle only, as after an error."""
    picture = imread(path)[:, :, :3]
    tiles = [tile for row in numpy.array_split(picture, 3, axis=0) for tile in numpy.array_split(row, 3, axis=1)]
    return all((tile < 0.9).any(axis=2).mean() > 0.002 for tile in tiles)


def test_belt_writes_table_and_picture(tmp_path):
    options = ["--model", "LuGre", "--time", "10", "--set", "mu_s=0.12", "--exchange", "feedthrough", "--out", "a/b.c"]
    done = start("belt.py", *options, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "LuGre: first slip at 5." in done.stdout
    with (tmp_path / "a" / "b.c.csv").open(encoding="utf-8") as file:
        heading = file.readline().strip().split(",")
        table = numpy.loadtxt(file, delimiter=",")
    assert heading[:2] == ["time [s]", "position [m]"]
    assert table.shape == (10_001, 7)
    assert table[-1, 0] == 10.0
    assert is_drawn(tmp_path / "a" / "b.c.png")


def test_belt_says_that_a_step_is_too_long_for_a_steep_law(tmp_path):
    steep = ["belt.py", "--model", "BrownMcPhee", "--time", "1"]
    done = start(*steep, "--set", "mass=0", folder=tmp_path)
    assert "a block at rest chatters unless --step is below 4.2e-04 s" in done.stdout
    done = start(*steep, "--set", "mass=0", "--step", "4e-4", folder=tmp_path)
    assert "chatters" not in done.stdout
    done = start(*steep, folder=tmp_path)
    assert "chatters" not in done.stdout, "with its mass the law looks ahead"


def test_replay_writes_table_and_picture(tmp_path):
    done = start("replay.py", "--model", "Dahl", "--hold", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    table = numpy.loadtxt(tmp_path / "out" / "replay.csv", delimiter=",", skiprows=1)
    assert table.shape == (10_501, 6)
    assert is_drawn(tmp_path / "out" / "replay.png")


def test_demo_shows_all_models(tmp_path):
    done = start("demo.py", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    lines = [line.split() for line in done.stdout.splitlines()]
    table = {line[0]: line for line in lines if len(line) > 8 and line[2] == "ms"}
    assert set(table) >= {"BrownMcPhee", "CoulombStiction", "Dahl", "Karnopp", "LuGre"}
    assert float(table["CoulombStiction"][-2].rstrip("%")) == pytest.approx(0.0, abs=0.1)
    assert float(table["Dahl"][-2].rstrip("%")) == pytest.approx(0.0, abs=0.1)
    for model in table:
        assert is_drawn(tmp_path / "out" / "belt" / f"{model}.png")
    assert is_drawn(tmp_path / "out" / "comparison.png")
    assert is_drawn(tmp_path / "out" / "replay.png")


@pytest.mark.parametrize(
    ("program", "options", "message"),
    [
        ("belt.py", ["--model", "Lugre"], "error: no FMU of the model 'Lugre' in"),
        ("belt.py", ["--model", "BeltRig"], "error: BeltRig is no friction model; there are"),
        ("belt.py", ["--set", "mu=1"], "error: CoulombStiction has no parameter 'mu'; it has mu_k, mu_s"),
        ("belt.py", ["--set", "mu_s"], "argument --set: 'mu_s' is not of the form name=value"),
        ("belt.py", ["--set", "mu_s=0.05"], "mu_s = 0.05"),
        ("belt.py", ["--step", "0"], "argument --step: '0' must be > 0 and finite"),
        ("belt.py", ["--step", "fast"], "argument --step: 'fast' is not a number"),
        ("belt.py", ["--fmus", "nowhere"], "there is none: run `python3 tasks.py pack`"),
        ("replay.py", ["--motion", "absent.csv"], "error: cannot read absent.csv: No such file"),
    ],
)
def test_mistakes_are_answered_in_one_line_without_traceback(tmp_path, program, options, message):
    done = start(program, *options, folder=tmp_path)
    assert done.returncode in (1, 2)
    assert message in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()
