"""A recorded motion through the friction FMUs: the numbers, the shipped recording, and faulty files."""

import numpy
import pytest

from examples.fmpy.coupling import CouplingError, path_of
from examples.fmpy.make_motion import MOTION, write_motion
from examples.fmpy.replay import COLUMNS, Motion, read_motion, replay

HEADING = ",".join(COLUMNS)


def stroke(samples: int) -> Motion:
    """One stroke there and back, 2 mm each way, under 20 N, from rest to rest."""
    time = numpy.linspace(0.0, 1.0, samples)
    velocity = 2e-3 * numpy.pi * numpy.sin(2.0 * numpy.pi * time)
    position = 1e-3 * (1.0 - numpy.cos(2.0 * numpy.pi * time))
    return Motion(time, position, velocity, numpy.full(samples, 20.0))


def test_the_script_makes_the_shipped_recording(tmp_path):
    write_motion(tmp_path / "motion.csv")
    assert (tmp_path / "motion.csv").read_bytes() == MOTION.read_bytes()
    assert MOTION.stat().st_size < 600_000


def test_the_recording_is_one_of_ten_strokes_that_fit_together():
    motion = read_motion(MOTION)
    integral = numpy.concatenate(([0.0], numpy.cumsum(0.5 * (motion.velocity[1:] + motion.velocity[:-1]) * 1e-3)))
    assert abs(integral - motion.position).max() < 5e-6
    high = motion.position > 5e-3
    assert numpy.count_nonzero(high[1:] & ~high[:-1]) == 10
    assert motion.position.max() == pytest.approx(10e-3, abs=2e-6)
    assert motion.normal_force.mean() == pytest.approx(50.0, rel=0.01)


def test_dahl_follows_the_distance_whatever_the_sampling():
    """With alpha = 1 the force on the first stroke is f_C (1 - exp(-sigma_0 x / f_C)); the error comes from the
    chords."""
    level = 0.1 * 20.0
    for samples, tolerance in ((101, 1e-2), (1001, 1e-4)):
        motion = stroke(samples)
        force = replay(path_of("Dahl"), motion).friction_force
        there = motion.time <= 0.5
        exact = level * -numpy.expm1(-1e5 * motion.position[there] / level)
        assert force[there] == pytest.approx(exact, abs=tolerance * level)


def test_interpolated_inputs_are_more_accurate_than_held_ones():
    motion = stroke(201)
    level = 0.1 * 20.0
    exact = level * -numpy.expm1(-1e5 * motion.position[:20] / level)
    linear = replay(path_of("Dahl"), motion).friction_force[:20]
    held = replay(path_of("Dahl"), motion, hold=True).friction_force[:20]
    assert abs(linear - exact).max() < 0.1 * abs(held - exact).max()


def test_the_dissipated_energy_is_the_area_of_the_loop():
    """Force over position, integrated by the trapezoidal rule; the energy stored in the bristles is below f_s^2 / 2
    sigma_0."""
    motion = stroke(2001)
    result = replay(path_of("LuGre"), motion)
    steps = numpy.diff(motion.position)
    area = numpy.sum(0.5 * (result.friction_force[1:] + result.friction_force[:-1]) * steps)
    assert result.dissipated_energy[-1] == pytest.approx(area, rel=2e-3)


@pytest.mark.parametrize(("law", "plane"), [("LuGre", "LuGrePlanar"), ("ElastoPlastic", "ElastoPlasticPlanar")])
def test_a_law_in_the_plane_is_driven_along_x(law, plane):
    """In this case it is the law along a line: same force, same energy. Moving inputs are followed to 0.05 % of 10
    um."""
    motion = stroke(501)
    for hold, error in [(True, 1e-9), (False, 1e-3)]:
        line, along_x = (replay(path_of(model), motion, hold=hold) for model in (law, plane))
        assert along_x.friction_force == pytest.approx(line.friction_force, abs=error)
        assert along_x.dissipated_energy[-1] == pytest.approx(line.dissipated_energy[-1], rel=1e3 * error)


def test_a_recording_need_not_start_at_zero():
    motion = stroke(101)
    later = Motion(motion.time + 1234.5, motion.position, motion.velocity, motion.normal_force)
    here, there = (replay(path_of("LuGre"), one).friction_force for one in (motion, later))
    assert there == pytest.approx(here, abs=1e-9)


def test_columns_are_found_by_name_and_others_are_ignored(tmp_path):
    file = tmp_path / "export.csv"
    file.write_text(
        "\ufeffnormal_force [N], note,velocity [m/s],time [s],position [m]\r\n10,a,0,0,0\r\n11,b,0.1,0.5,0.02\r\n",
        encoding="utf-8",
    )
    motion = read_motion(file)
    assert motion.time.tolist() == [0.0, 0.5]
    assert motion.velocity.tolist() == [0.0, 0.1]
    assert motion.normal_force.tolist() == [10.0, 11.0]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "must have a heading and at least two samples, has 0 lines"),
        (f"{HEADING}\n0,0,0,1\n", "must have a heading and at least two samples, has 2 lines"),
        ("time [s],position [m],velocity [mm/s],normal_force [N]\n0,0,0,1\n1,0,0,1\n", "no column 'velocity [m/s]'"),
        (f"{HEADING}\n0,0,0,1\n0.001,0,fast,1\n", "line 3: velocity [m/s] is 'fast', must be a finite number"),
        (f"{HEADING}\n0,0,0,1\n0.001,0,nan,1\n", "line 3: velocity [m/s] is 'nan', must be a finite number"),
        (f"{HEADING}\n0,0,0,1\n0.001,0,0\n", "line 3: normal_force [N] is '', must be a finite number"),
        (f"{HEADING}\n0,0,0,1\n1,0,0,1\n1,0,0,1\n", "line 4: time 1.0 s is not after 1.0 s"),
    ],
)
def test_a_faulty_file_is_rejected_with_place_and_reason(tmp_path, text, message):
    file = tmp_path / "motion.csv"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(CouplingError) as refusal:
        read_motion(file)
    assert message in str(refusal.value)
    assert str(file) in str(refusal.value)


def test_a_missing_file_and_a_binary_one_are_rejected(tmp_path):
    with pytest.raises(CouplingError, match="cannot read .*absent.csv: No such file"):
        read_motion(tmp_path / "absent.csv")
    with pytest.raises(CouplingError, match="is not a text file"):
        read_motion(path_of("LuGre"))


def test_a_load_that_the_model_rejects_is_reported_by_the_model():
    motion = stroke(11)
    motion.normal_force[5] = -1.0
    with pytest.raises(CouplingError, match="normal_force = -1: must be >= 0"):
        replay(path_of("LuGre"), motion)
