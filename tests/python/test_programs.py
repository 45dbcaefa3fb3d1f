"""The example programs as a user starts them."""

import csv

import numpy
import pytest
from command_line import run_example
from matplotlib.image import imread

from examples.fmpy.coupling import FMUS, laws_in


def is_drawn(path) -> bool:
    """Whether there is something in every ninth of the picture, not only in the middle one as after an error."""
    picture = imread(path)[:, :, :3]
    tiles = [tile for row in numpy.array_split(picture, 3, axis=0) for tile in numpy.array_split(row, 3, axis=1)]
    return all((tile < 0.9).any(axis=2).mean() > 0.002 for tile in tiles)


def test_replay_writes_table_and_picture(tmp_path):
    done = run_example("fmpy.replay", "--model", "Dahl", "--hold", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    table = numpy.loadtxt(tmp_path / "out" / "replay.csv", delimiter=",", skiprows=1)
    assert table.shape == (10_501, 6)
    assert is_drawn(tmp_path / "out" / "replay.png")


def test_demo_shows_all_models(tmp_path):
    done = run_example("fmpy.demo", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    lines = [line.split() for line in done.stdout.splitlines()]
    table = {line[0]: line for line in lines if len(line) == 6 and line[2] == "N"}
    assert set(table) == set(laws_in(FMUS))
    for law, line in table.items():
        # Under 50 N: no coefficient of friction is 1, and each has slid for 20 strokes of 10 mm.
        assert 0.0 < float(line[1]) < 50.0, law
        assert 0.0 < float(line[3]) < 50.0 * 20.0 * 10e-3, law
        assert is_drawn(tmp_path / "out" / "replay" / f"{law}.png"), law
    assert is_drawn(tmp_path / "out" / "four_post.png")
    heave = {line[0]: float(line[-6]) for line in lines if line and line[0] in ("no", "50") and len(line) == 8}
    assert 0.0 < heave["50"] < heave["no"]


def table_of(path):
    """Heading and numbers of a CSV file."""
    with path.open(encoding="utf-8") as file:
        return file.readline().strip().split(","), numpy.loadtxt(file, delimiter=",")


def test_quarter_car_writes_tables_and_pictures(tmp_path):
    options = ["--levels", "0", "30", "--frequencies", "2", "5", "--set", "gas.enabled=0", "--car", "body_mass=60"]
    done = run_example("fmpy.quarter_car", *options, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    heading, ratios = table_of(tmp_path / "out" / "quarter_car.csv")
    assert heading == ["frequency [Hz]", "body; no friction", "travel; no friction", "body; 30 N", "travel; 30 N"]
    assert ratios.shape == (2, 5)
    heading, motion = table_of(tmp_path / "out" / "quarter_car_30_N.csv")
    assert heading[0] == "time [s]"
    assert "tyre_load [N]" in heading
    assert motion.shape[1] == len(heading)
    assert is_drawn(tmp_path / "out" / "quarter_car.png")
    assert is_drawn(tmp_path / "out" / "quarter_car_loops.png")


def test_four_post_writes_tables_and_pictures(tmp_path):
    options = ["--levels", "0", "40", "--time", "1", "--laws", "Dahl", "Threlfall", "--tolerance", "1e-3"]
    done = run_example("fmpy.four_post", *options, "--set", "rear.spring.k=3e4", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    heading, motion = table_of(tmp_path / "out" / "four_post_40_N.csv")
    assert "rl.force_friction [N]" in heading
    assert motion.shape == (1001, len(heading))
    with (tmp_path / "out" / "four_post_laws.csv").open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    assert [row[0] for row in rows] == ["law", "Dahl", "Threlfall"]
    assert min(float(row[3]) for row in rows[1:]) == 1.0
    assert is_drawn(tmp_path / "out" / "four_post.png")
    assert (tmp_path / "out" / "four_post_laws.png").is_file()


def test_lane_change_writes_tables_and_pictures(tmp_path):
    done = run_example("fmpy.lane_change", "--levels", "0", "50", "--steer", "path", "--laws", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "mm from the nearest cone" in done.stdout
    heading, motion = table_of(tmp_path / "out" / "lane_change_50_N.csv")
    assert "steering_angle [rad]" in heading
    assert motion.shape == (5001, len(heading))
    assert is_drawn(tmp_path / "out" / "lane_change.png")
    assert is_drawn(tmp_path / "out" / "lane_change_path.png")
    assert not (tmp_path / "out" / "lane_change_laws.csv").exists()


@pytest.mark.parametrize(
    ("program", "options", "message"),
    [
        ("fmpy.replay", ["--model", "Lugre"], "error: no FMU of the model 'Lugre' in"),
        ("fmpy.replay", ["--model", "BeltRig"], "error: BeltRig is not a friction model; there are"),
        ("fmpy.replay", ["--model", "LuGrePlanr"], "Did you mean LuGrePlanar"),
        (
            "fmpy.replay",
            ["--model", "Dahl", "--set", "mu=1"],
            "error: Dahl has no parameter 'mu'; it has mu_k",
        ),
        ("fmpy.replay", ["--set", "mu_s"], "argument --set: 'mu_s' is not of the form name=value"),
        ("fmpy.replay", ["--set", "mu_s=0.05"], "mu_s = 0.05"),
        ("fmpy.replay", ["--set", "mu_S=0.2"], "Did you mean mu_s"),
        ("fmpy.replay", ["--set", "normal_force=-1"], "error: LuGre: fmi2SetReal: normal_force = -1: must be >= 0"),
        ("fmpy.replay", ["--fmus", "nowhere"], "there is none: run `python3 tasks.py pack`"),
        ("fmpy.quarter_car", ["--car", "body_mas=2"], "Did you mean body_mass?"),
        ("fmpy.quarter_car", ["--car", "body_mass=-2"], "error: QuarterCar: fmi2SetReal: body_mass = -2: must be > 0"),
        ("fmpy.quarter_car", ["--car", "body_mass=heavy"], "error: body_mass = 'heavy': must be a number (Real)"),
        ("fmpy.quarter_car", ["--car", "body_mass"], "argument --car: 'body_mass' is not of the form name=value"),
        ("fmpy.quarter_car", ["--step", "0"], "argument --step: '0' must be > 0 and finite"),
        ("fmpy.quarter_car", ["--step", "fast"], "argument --step: 'fast' is not a number"),
        ("fmpy.quarter_car", ["--levels", "-1"], "argument --levels: '-1' must be >= 0 and finite"),
        (
            "fmpy.quarter_car",
            ["--set", "spring.stiffness=1"],
            "ShockAbsorber has no parameter 'spring.stiffness'",
        ),
        ("fmpy.quarter_car", ["--car", "mass=1"], "error: QuarterCar has no parameter 'mass'"),
        ("fmpy.four_post", ["--time", "0.5"], "argument --time: must be at least two periods, 1 s"),
        ("fmpy.four_post", ["--model", "Lugre"], "error: friction.model = 'Lugre': must be one of None, Coulomb"),
        ("fmpy.four_post", ["--delay", "nan"], "argument --delay: 'nan' must be finite"),
        ("fmpy.four_post", ["--laws", "Lugre"], "error: friction.model = 'Lugre': must be one of None, Coulomb"),
        ("fmpy.lane_change", ["--set", "c1.mu_s=-1"], "c1.mu_s = -1"),
        ("fmpy.lane_change", ["--fmus", "nowhere"], "there is none: run `python3 tasks.py pack`"),
        ("fmpy.lane_change", ["--steer", "left"], "argument --steer: invalid choice: 'left'"),
        ("fmpy.replay", ["--motion", "absent.csv"], "error: cannot read absent.csv: No such file"),
    ],
)
def test_mistakes_are_reported_in_one_line_without_traceback(tmp_path, program, options, message):
    done = run_example(program, *options, folder=tmp_path)
    assert done.returncode in (1, 2)
    assert message in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()
