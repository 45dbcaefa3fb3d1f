"""Identification in Python against the command line and closed forms; and what it refuses."""

import json
import math
import re
import subprocess
from pathlib import Path

import mujoco
import numpy
import pandas
import pytest
import scipy.io
import stribeck
from command_line import program


@pytest.fixture(scope="module")
def rig(tmp_path_factory):
    """A record of a virtual rig with Dahl's law, written by the command line."""
    folder = tmp_path_factory.mktemp("rig")
    values = ["--set", "mu_k=0.2", "--set", "sigma_0=3e4"]
    program("rig", "--law", "Dahl", "--duration", "1", *values, "--out", folder)
    return folder / "force.csv"


def test_identify_gives_the_numbers_of_the_command_line(rig):
    found = stribeck.identify(rig, ["Coulomb", "Dahl"], mass=2.0, normal_force=20.0, repetitions=10)
    arguments = ["--law", "Coulomb,Dahl", "--mass", "2", "--normal-force", "20", "--repetitions", "10", "--json"]
    output = program("identify", rig, *arguments).stdout
    for fit, other in zip(found.fits, json.loads(output)["laws"], strict=True):
        assert (fit.law, fit.rms, fit.values) == (other["law"], other["rms"], other["values"])
        assert [one.value for one in fit.estimates.values()] == [one["value"] for one in other["estimates"]]
    assert found.best.law == "Dahl"
    assert not found.fits[1].tied
    low, high = found.best.estimates["mu_k"].interval
    assert low < 0.2 < high
    record = found.records["force"]
    rest = (record["force"] - record["predicted"])[record["fitted"]]
    assert 0 < rest.size < record["force"].size
    assert numpy.sqrt(numpy.sum(rest**2) / (rest.size - 2)) == pytest.approx(found.best.rms, rel=1e-12)
    again = stribeck.simulate("Dahl", velocity=record["velocity"], normal_force=20.0, dt=1e-3, **found.best.values)
    acceleration = numpy.gradient(record["velocity"], 1e-3)
    # The window of the filter and the differences of the second order; at the ends the filter has one side only.
    apart = again["friction_force"] + 2.0 * acceleration - record["predicted"]
    assert numpy.abs(apart[record["fitted"]]).max() < 0.05
    text = found.best.estimates["mu_k"].text
    assert text.startswith(f"{found.best.values['mu_k']:.5f} (95 %: {low:.5f} to {high:.5f}; repeated ")
    assert f"  mu_k: {text}\n" in repr(found)


def test_a_map_without_time_is_fitted_as_steady_sliding():
    speeds = numpy.array([1e-3, 2e-3, 4e-3, 8e-3, 0.015, 0.03, 0.06, 0.1, 0.2])
    velocity = numpy.tile(numpy.concatenate([-speeds, speeds]), 3)
    level = 3.0 + 1.0 * numpy.exp(-((velocity / 0.01) ** 2)) + 6.0 * numpy.abs(velocity)
    force = numpy.sign(velocity) * level + numpy.random.default_rng(3).normal(0.0, 0.02, velocity.size)
    columns = {"velocity": velocity, "force": force}
    found = stribeck.identify(columns, ["LuGre", "CoulombViscous"], normal_force=10.0, repetitions=0)
    assert found.best.law == "LuGre"
    assert found.best.lack_of_fit["explained"]
    assert not found.fits[1].lack_of_fit["explained"]
    assert found.best.lack_of_fit["freedom"] == [14, 36]
    for name, truth in {"mu_k": 0.3, "mu_s": 0.4, "stribeck_velocity": 0.01, "viscous_coefficient": 6.0}.items():
        low, high = found.best.estimates[name].interval
        assert low - (high - low) < truth < high + (high - low)
    assert found.best.estimates["sigma_0"].value is None
    assert "a map cannot tell it" in found.best.estimates["sigma_0"].verdict
    (record,) = found.records.values()
    assert "time" not in record
    assert numpy.abs(record["predicted"] - numpy.sign(velocity) * level).max() < 0.03
    with pytest.raises(stribeck.Refused, match="force has 53 values, velocity has 54"):
        stribeck.identify({"velocity": velocity, "force": force[:-1]}, "LuGre", normal_force=10.0)
    with pytest.raises(stribeck.Refused, match="with 1 the coefficients are forces"):
        stribeck.identify(columns, "LuGre")


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    """A LuGre contact, identified and written for other programs; the folder and what the program said."""
    folder = tmp_path_factory.mktemp("exported")
    values = ["--set", "mu_k=0.2", "--set", "mu_s=0.3", "--set", "sigma_0=2e4"]
    program("rig", "--law", "LuGre", "--duration", "2", *values, "--out", folder)
    known = ["--law", "LuGre", "--mass", "2", "--normal-force", "20", "--repetitions", "0"]
    said = {
        ending: program("identify", folder / "force.csv", *known, "--out", folder / f"law.{ending}").stderr
        for ending in ("xml", "urdf", "py")
    }
    return folder, said


def dragged(model, force: float, rise: float, time: float):
    """The slider in MuJoCo under a force that rises from 0 and then stays."""
    data = mujoco.MjData(model)
    model.opt.timestep = 1e-4
    while data.time < time:
        data.qfrc_applied[0] = force * min(1.0, data.time / rise)
        mujoco.mj_step(model, data)
    return data.qpos[0], data.qvel[0]


def test_a_fitted_lugre_contact_moves_in_mujoco(exported):
    folder, said = exported
    assert "Not carried over: " in (folder / "law.xml").read_text()
    assert "not carried over: mu_k" not in said["xml"]
    model = mujoco.MjModel.from_xml_path(str(folder / "law.xml"))
    # Pre-sliding under a slow rise, dz/dx = 1 - sigma_0 z / f_s: held at half of the breakaway force.
    deflection, velocity = dragged(model, 3.0, 1.0, 1.1)
    assert deflection == pytest.approx(6.0 / 2e4 * math.log(2.0), rel=0.05)
    assert abs(velocity) < 1e-5
    # Twice of it: m a = F - f_C.
    (_, before), (_, after) = (dragged(model, 12.0, 1e-3, time) for time in (0.1, 0.2))
    assert (after - before) / 0.1 == pytest.approx((12.0 - 4.0) / 2.0, rel=0.01)


def test_a_fitted_level_is_that_of_a_joint_in_urdf(exported):
    folder, said = exported
    model = mujoco.MjModel.from_xml_path(str(folder / "law.urdf"))
    assert model.dof_frictionloss[0] == pytest.approx(4.0, rel=0.01)
    assert model.body_mass[1] == 2.0
    assert "law.urdf: not carried over: sigma_0 = " in said["urdf"]


def test_a_fitted_law_is_a_module_of_python(exported):
    names = {}
    exec((exported[0] / "law.py").read_text(), names)
    assert names["force"](0.1, 20.0) == stribeck.force("LuGre", 0.1, 20.0, **names["VALUES"])
    assert names["VALUES"]["mu_k"] == pytest.approx(0.2, rel=0.01)


def test_identify_takes_arrays_and_gives_no_number_for_what_is_not_determined(rig):
    table = numpy.genfromtxt(rig, delimiter=",", names=True)
    record = dict(zip(("time", "force", "displacement"), (table[name] for name in table.dtype.names), strict=True))
    known = {"mass": 2.0, "normal_force": 20.0, "repetitions": 0}
    found = stribeck.identify(record, "Dahl", **known)
    assert found.best.values == stribeck.identify(rig, "Dahl", **known).best.values
    drive = {"t": record["time"], "x": record["displacement"], "u": record["force"] / 2}
    held = stribeck.identify(drive, "Dahl", fix={"sigma_0": 3e4}, scale={"force": 2.0}, **known)
    assert held.findings["record 1"][:4] == [
        "taken to begin at rest, with the contact unloaded",
        "column 't' was taken as time",
        "column 'u' was taken as force, times 2",
        "column 'x' was taken as displacement",
    ]
    assert held.best.values["sigma_0"] == 3e4
    assert set(held.best.estimates) == {"mu_k"}
    radius = stribeck.identify(record, "RollingResistance", **known).best
    assert radius.estimates["wheel_radius"].value is None
    assert "wheel_radius" not in radius.values
    for wrong, text in [
        ({"time": record["time"], "force": record["force"]}, "no column 'displacement'"),
        ({}, "no column 'time'; there are no columns"),
        (drive, "'u' may be the force, but not in N: give the factor to N"),
        ({"t": drive["t"], "F": drive["u"], "x": drive["x"], "q": drive["x"]}, "displacement: 'x', 'q' may be it"),
    ]:
        with pytest.raises(stribeck.Refused, match=re.escape(text)):
            stribeck.identify(wrong, "Dahl", **known)
    with pytest.raises(stribeck.Refused, match="did you mean 'Dahl'"):
        stribeck.identify(record, "Dal", **known)
    with pytest.raises(stribeck.Refused, match="did you mean 'sigma_0'"):
        stribeck.identify(record, "Dahl", fix={"sigma": 1.0}, **known)
    with pytest.raises(stribeck.Refused, match="no law was given"):
        stribeck.identify(record, [], **known)
    with pytest.raises(stribeck.Refused, match=r"record\.mf4: .*No such file"):
        stribeck.identify("record.mf4", "Dahl", **known)
    with pytest.raises(stribeck.Refused, match="motion: is for a single record"):
        stribeck.identify([record, dict(record)], "Dahl", motion=drive, **known)
    assert "`rest`: Speed in m/s below which samples are left out" in stribeck.identify.__doc__


@pytest.fixture(scope="module")
def slid():
    """A record that begins in steady sliding, as arrays."""
    time = 1e-3 * numpy.arange(500)
    velocity = 0.01 + 0.02 * numpy.sin(20.0 * time) ** 2
    noise = numpy.random.default_rng(1).normal(0.0, 0.05, time.size)
    return {"time": time, "velocity": velocity, "force": 2.0 + noise}


CHEAP = {"law": "Coulomb", "normal_force": 20.0, "repetitions": 0, "budget": 50}


def test_identify_takes_whatever_has_arrays_by_name(slid):
    expected = stribeck.identify(slid, **CHEAP)
    assert expected.findings["record 1"][0] == "taken to begin in steady sliding"
    frame = pandas.DataFrame(slid)
    texts = {**slid, "note": ["x"] * 500, "day": numpy.zeros(3, "datetime64[s]"), "a;#b": numpy.full(500, numpy.nan)}
    for record in (frame, texts, [frame], {name: list(values) for name, values in slid.items()}):
        assert stribeck.identify(record, **CHEAP).best.values == expected.best.values
    rest = {name: value for name, value in CHEAP.items() if name not in ("law", "normal_force")}
    law = stribeck.law("Coulomb")
    for load in (20.0, numpy.full(500, 20.0)):
        assert stribeck.identify({**slid, "normal_force": load}, law, **rest).best.values == expected.best.values
    held = stribeck.identify(slid, [law], hold_out=frame, fit="offset", **{**rest, "normal_force": 20.0})
    assert list(held.best.validation) == ["held out 1"]


def test_values_that_are_held_are_judged(slid):
    assert stribeck.identify(slid, **CHEAP).best.judgement is None
    found = stribeck.identify(slid, **CHEAP, fix={"mu_k": 0.25})
    judged = found.best.judgement
    assert (judged.source, judged.values, judged.fit_rms) == ("fix", {"mu_k": 0.25}, None)
    assert judged.rms == found.best.rms
    assert judged.verdict in repr(found)


@pytest.mark.parametrize(
    ("wrong", "text"),
    [
        ({"force": numpy.zeros(499)}, "record 1: force has 499 values, time has 500"),
        ({"force": numpy.zeros((500, 2))}, "record 1: force has the shape (500, 2): must have one dimension"),
        ({"force": ["x"] * 500}, "record 1: force must be numbers, not <U1"),
        ({"force": numpy.zeros(500, complex)}, "record 1: force must be numbers, not complex128"),
        ({"time": numpy.zeros(500, "datetime64[ns]")}, "record 1: time must be numbers, not datetime64[ns]"),
        ({"force": numpy.ma.masked_less(numpy.arange(500), 9)}, "record 1: force has numbers that are masked"),
        ({"force": numpy.where(numpy.arange(500) == 7, numpy.nan, 1.0)}, "record 1: force[7] = NaN: must be a finite"),
        ({"force": 2.0}, "record 1: force is a single number: must be an array"),
        ({"normal_force": numpy.inf}, "record 1: normal_force = inf: must be a finite number"),
    ],
)
def test_identify_names_the_column_that_is_wrong(slid, wrong, text):
    with pytest.raises(stribeck.Refused, match=re.escape(text)):
        stribeck.identify({**slid, **wrong}, **CHEAP)


@pytest.mark.parametrize(
    "records", [numpy.zeros((9, 3)), numpy.zeros(9, [("time", float)]), pandas.Series([1.0]), 3.0, None, [[1.0]], b"a"]
)
def test_identify_says_what_a_record_may_be(records):
    with pytest.raises(TypeError, match="is not a record: give the name of a file, or arrays by name"):
        stribeck.identify(records, **CHEAP)


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"fix": {"mu_k": "5"}}, 'invalid type: string "5", expected f64 in `fix.mu_k`'),
        ({"fix": "mu_k"}, 'invalid type: string "mu_k", expected a table of names and values in `fix`'),
        ({"scale": {"force": [1.0]}}, "expected f64 in `scale.force`"),
        ({"column": {"force": 3}}, "invalid type: integer `3`, expected a string in `column.force`"),
        ({"range": {"mu_k": (0.1,)}}, "invalid length 1, expected an array of length 2 in `range.mu_k`"),
        ({"range": {"mu_k": 0.1}}, "expected an array of length 2 in `range.mu_k`"),
        ({"mass": "2"}, 'invalid type: string "2", expected f64 in `mass`'),
        ({"normal_force": numpy.ones(2)}, "expected f64 in `normal_force`"),
        ({"budget": 1e3}, "invalid type: floating point `1000.0`, expected u64 in `budget`"),
        ({"seed": 1.5}, "expected u64 in `seed`"),
        ({"seed": -1}, "integer `-1`, expected u64 in `seed`"),
        ({"repetitions": -1}, "expected usize in `repetitions`"),
        ({"folds": -1}, "expected usize in `folds`"),
        ({"fit": 3}, "fit = 3: must be a name or a list of names"),
        ({"law": 3}, "law = 3: must be a name or a list of names"),
        ({"law": [3]}, "invalid type: integer `3`, expected a string in `law`"),
        ({"loss": numpy.ones(2)}, "in `loss`"),
        ({"loss": "cubes"}, "unknown variant `cubes`, expected `squares` or `robust` in `loss`"),
        ({"delay": numpy.ones(2)}, "delay = [1.0, 1.0]: must be a number in s, find, or find:LONGEST in `delay`"),
        ({"axis": 1}, "invalid type: integer `1`, expected a boolean in `axis`"),
        ({"mas": 1.0}, "unknown field `mas`, expected one of `records`, "),
    ],
)
def test_identify_names_the_option_that_is_wrong(slid, options, text):
    with pytest.raises((TypeError, stribeck.Refused), match=re.escape(text)):
        stribeck.identify(slid, **{**CHEAP, **options})


def test_identify_keeps_records_apart(slid, tmp_path):
    for name in ("a.csv", "a.txt"):
        pandas.DataFrame(slid).to_csv(tmp_path / name, index=False)
    file, other = tmp_path / "a.csv", tmp_path / "a.txt"
    assert list(stribeck.identify([file, other], **CHEAP).records) == ["a.csv", "a.txt"]
    for records, hold_out, text in [
        ([slid, slid], (), "record 2 is the same as record 1: give it once"),
        (slid, slid, "held out 1 is the same as record 1: give it once"),
        ([slid, file], str(file), f"{file}: is a record and held out too"),
        ([file, str(file)], (), f"{file}: is given twice"),
    ]:
        with pytest.raises(stribeck.Refused, match=re.escape(text)):
            stribeck.identify(records, hold_out=hold_out, **CHEAP)


def test_files_of_matlab_are_read_or_refused_in_one_line():
    """Files with which scipy tests itself; none is a record. `tasks.py formats` compares their numbers."""
    files = sorted((Path(scipy.io.__file__).parent / "matlab" / "tests" / "data").glob("*.mat"))
    assert len(files) > 100
    for file in files:
        with pytest.raises(subprocess.CalledProcessError) as refused:
            program("damper", file)
        [line] = refused.value.stderr.splitlines()
        assert file.name in line
        try:
            variables = scipy.io.whosmat(file)
        except Exception:  # What scipy does not read is damaged, of version 7.3, or has a name that is not ASCII.
            assert re.search(
                r": (byte \d+: |the file is MAT 7\.3|the file has no vectors; it has \S+ \(1 x 1\)$)", line
            )
            continue
        vectors = {
            name
            for name, shape, kind in variables
            if kind in ("double", "logical") and len(shape) == 2 and min(shape) == 1 < max(shape)
        }
        for name in vectors - {"testcomplex", "testsparsecomplex"}:
            assert re.search(rf"there are .*\b{name}\b", line), line
