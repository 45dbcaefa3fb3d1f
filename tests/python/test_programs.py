"""The example programs as a user starts them."""

import csv
import subprocess
import sys

import belt_solutions
import numpy
import pytest
from coupling import FMUS, PROJECT, laws_in
from matplotlib.image import imread


def start(program: str, *options: str, folder) -> subprocess.CompletedProcess:
    """Runs a program in a separate folder."""
    command = [sys.executable, str(PROJECT / "examples" / "fmpy" / program), *options]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300)


def is_drawn(path) -> bool:
    """Whether there is something in every ninth of the picture, not only in the middle one as after an error."""
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
    assert table.shape == (10_001, 8)
    assert heading[4] == "acceleration [m/s2]"
    assert table[-1, 0] == 10.0
    assert is_drawn(tmp_path / "a" / "b.c.png")


def test_belt_reports_a_step_that_is_too_long_for_a_steep_law(tmp_path):
    steep = ["belt.py", "--model", "BrownMcPhee", "--time", "1"]
    done = start(*steep, "--set", "mass=0", folder=tmp_path)
    assert "a block at rest chatters unless --step is below 4.2e-04 s" in done.stdout
    done = start(*steep, "--set", "mass=0", "--step", "4e-4", folder=tmp_path)
    assert "chatters" not in done.stdout
    done = start(*steep, folder=tmp_path)
    assert "chatters" not in done.stdout, "with its mass the law looks ahead"


def test_several_models_share_a_picture_and_have_a_table_each(tmp_path):
    """By Newton's law the acceleration of 2 kg is that of the forces; the block starts at rest on the belt, and slips
    when the spring force reaches the static friction."""
    options = ["--model", "CoulombStiction", "Liang", "LuGrePlanar", "--time", "12"]
    rig = ["--rig", "mass=2", "--rig", "belt_velocity=0.2", "--rig", "position=0.1"]
    done = start("belt.py", *options, *rig, folder=tmp_path)
    assert done.returncode == 0, done.stderr
    for model in options[1:4]:
        heading, table = table_of(tmp_path / "out" / f"belt_{model}.csv")
        column = dict(zip([name.split()[0] for name in heading], table.T, strict=True))
        newton = (column["external_force"] - column["friction_force"]) / 2.0
        assert column["acceleration"] == pytest.approx(newton, abs=1e-8)
        assert (column["position"][0], column["block_velocity"][0]) == (0.1, 0.2)
        assert column["block_velocity"] - column["velocity"] == pytest.approx(0.2, abs=1e-9)
        # From x = 0.1 m at 0.2 m/s to f_s / k = 0.15 * 2 kg * 9.81 m/s2 / 2 N/m.
        if model == "CoulombStiction":
            slip = column["time"][column["sticking"] == 0.0][0]
            assert slip == pytest.approx((1.4715 - 0.1) / 0.2, abs=2e-3)
    assert is_drawn(tmp_path / "out" / "belt.png")


def test_belt_reports_a_step_that_is_too_long_for_a_law_that_chatters(tmp_path):
    """At 1 ms the speeds at rest reach the Stribeck velocity; the block then slips early, and the period is short."""
    done = start("belt.py", "--model", "FrictionalLag", "CoulombStiction", folder=tmp_path)
    assert done.stdout.count("--step is too long for this law: half of it gives 5.7") == 1


def test_belt_says_that_a_step_was_not_checked(tmp_path):
    """Before the second slip there is no period, at no step."""
    done = start("belt.py", "--model", "CoulombStiction", "--time", "1", folder=tmp_path)
    assert "the block never slips\n--step was not checked: --time is too short" in done.stdout


def test_replay_writes_table_and_picture(tmp_path):
    done = start("replay.py", "--model", "Dahl", "--hold", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    table = numpy.loadtxt(tmp_path / "out" / "replay.csv", delimiter=",", skiprows=1)
    assert table.shape == (10_501, 6)
    assert is_drawn(tmp_path / "out" / "replay.png")


def test_demo_shows_all_models(tmp_path):
    done = start("demo.py", "--time", "20", folder=tmp_path)
    assert done.returncode == 0, done.stderr
    lines = [line.split() for line in done.stdout.splitlines()]
    table = {line[0]: line for line in lines if len(line) > 8 and line[2] == "ms"}
    assert set(table) == set(laws_in(FMUS))
    for line in table.values():
        period, finer = float(line[3]), float(line[5])
        assert period == pytest.approx(finer, rel=5e-3)
        assert float(line[7].rstrip("%")) == pytest.approx(100.0 * (period / finer - 1.0), abs=2e-3)
    for model, expected in belt_solutions.periods().items():
        assert float(table[model][3]) == pytest.approx(expected, rel=1e-2), model
        assert float(table[model][5]) == pytest.approx(expected, rel=1e-2), model
    for model in table:
        assert is_drawn(tmp_path / "out" / "belt" / f"{model}.png")
    assert is_drawn(tmp_path / "out" / "comparison.png")
    assert is_drawn(tmp_path / "out" / "replay.png")
    assert is_drawn(tmp_path / "out" / "four_post.png")
    heave = {line[0]: float(line[-6]) for line in lines if line and line[0] in ("no", "50") and len(line) == 8}
    assert 0.0 < heave["50"] < heave["no"]


def table_of(path):
    """Heading and numbers of a CSV file."""
    with path.open(encoding="utf-8") as file:
        return file.readline().strip().split(","), numpy.loadtxt(file, delimiter=",")


def test_quarter_car_writes_tables_and_pictures(tmp_path):
    options = ["--levels", "0", "30", "--frequencies", "2", "5", "--set", "gas.enabled=0", "--car", "body_mass=60"]
    done = start("quarter_car.py", *options, folder=tmp_path)
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
    done = start("four_post.py", *options, "--set", "rear.spring.k=3e4", folder=tmp_path)
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
    done = start("lane_change.py", "--levels", "0", "50", "--steer", "path", "--laws", folder=tmp_path)
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
        ("belt.py", ["--model", "Lugre"], "error: no FMU of the model 'Lugre' in"),
        ("belt.py", ["--model", "BeltRig"], "error: BeltRig is not a friction model; there are"),
        ("belt.py", ["--set", "mu=1"], "error: CoulombStiction has no parameter 'mu'; it has mu_k, mu_s"),
        ("belt.py", ["--set", "mu_s"], "argument --set: 'mu_s' is not of the form name=value"),
        ("belt.py", ["--set", "mu_s=0.05"], "mu_s = 0.05"),
        ("belt.py", ["--set", "mu_S=0.2"], "Did you mean mu_s"),
        (
            "belt.py",
            ["--set", "normal_force=-1"],
            "error: CoulombStiction: fmi2SetReal: normal_force = -1: must be >= 0",
        ),
        ("belt.py", ["--set", "velocity=1"], "error: velocity comes from BeltRig: it cannot be set"),
        ("belt.py", ["--model", "LuGre", "Liang", "--set", "stribeck_velocity=1"], "error: Liang has no parameter"),
        ("belt.py", ["--model", "LuGrePlanr"], "Did you mean LuGrePlanar"),
        ("belt.py", ["--rig", "mas=2"], "error: BeltRig has no parameter 'mas'; it has mass, stiffness, belt_velocity"),
        ("belt.py", ["--rig", "mas=2"], "Did you mean mass?"),
        ("belt.py", ["--rig", "mass=-2"], "error: BeltRig: fmi2SetReal: mass = -2: must be > 0 and finite"),
        ("belt.py", ["--rig", "mass=heavy"], "error: mass = 'heavy': must be a number (Real)"),
        ("belt.py", ["--rig", "friction_force=1"], "error: friction_force comes from the friction model"),
        ("belt.py", ["--rig", "mass"], "argument --rig: 'mass' is not of the form name=value"),
        ("belt.py", ["--step", "0"], "argument --step: '0' must be > 0 and finite"),
        ("belt.py", ["--step", "fast"], "argument --step: 'fast' is not a number"),
        ("belt.py", ["--fmus", "nowhere"], "there is none: run `python3 tasks.py pack`"),
        ("quarter_car.py", ["--levels", "-1"], "argument --levels: '-1' must be >= 0 and finite"),
        ("quarter_car.py", ["--set", "spring.stiffness=1"], "error: ShockAbsorber has no parameter 'spring.stiffness'"),
        ("quarter_car.py", ["--car", "mass=1"], "error: QuarterCar has no parameter 'mass'"),
        ("four_post.py", ["--time", "0.5"], "argument --time: must be at least two periods, 1 s"),
        ("four_post.py", ["--model", "Lugre"], "error: friction.model = 'Lugre': must be one of None, Coulomb"),
        ("four_post.py", ["--delay", "nan"], "argument --delay: 'nan' must be finite"),
        ("four_post.py", ["--laws", "Lugre"], "error: friction.model = 'Lugre': must be one of None, Coulomb"),
        ("lane_change.py", ["--set", "c1.mu_s=-1"], "c1.mu_s = -1"),
        ("lane_change.py", ["--fmus", "nowhere"], "there is none: run `python3 tasks.py pack`"),
        ("lane_change.py", ["--steer", "left"], "argument --steer: invalid choice: 'left'"),
        ("replay.py", ["--motion", "absent.csv"], "error: cannot read absent.csv: No such file"),
    ],
)
def test_mistakes_are_reported_in_one_line_without_traceback(tmp_path, program, options, message):
    done = start(program, *options, folder=tmp_path)
    assert done.returncode in (1, 2)
    assert message in done.stderr
    assert "Traceback" not in done.stderr
    assert not (tmp_path / "out").exists()
