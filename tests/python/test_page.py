"""The library behind the page, built for this machine, against the Python package: same questions, same bits."""

import json
import math
import random

import numpy as np
import pytest
import stribeck
from page import PROJECT


@pytest.mark.parametrize(
    ("system", "law", "settings"),
    [
        ("belt", "CoulombStiction", {"rig.mass": 1.5}),
        ("motion", "LuGre", {"friction.velocity.amplitude": 0.002}),
        ("dyno-ramps", "Karnopp", {"strut.side_force_m": 250.0}),
    ],
)
def test_runs_are_those_of_the_package(ask, system, law, settings):
    answer, arrays = ask({"ask": "solve", "run": {"system": system, "law": [law], "set": settings}, "law": law})
    solution = stribeck.solve(system, law, set=settings)
    assert np.array_equal(arrays[0], solution["time"])
    for column, values in zip(answer["columns"], arrays[1:-1], strict=True):
        assert np.array_equal(values, solution[column["name"]]), column
    assert arrays[-1].tolist() == [time for time, _ in solution.events]


def test_curves_and_strokes_are_those_of_the_package(ask):
    law = {"model": "LuGre", "set": {"mu_s": 0.2}, "held": {"normal_force": 12.0}, "velocity": 0.01}
    strokes = {**law, "stroke": 1e-3, "speed": 2e-3}
    _, (velocity, curve) = ask({"ask": "curve", **strokes})
    assert velocity[0] == -0.01 == -velocity[-1]
    assert np.array_equal(curve, stribeck.force("LuGre", velocity, 12.0, mu_s=0.2))
    answer, (way, speed, force) = ask({"ask": "strokes", **strokes})
    dt = answer["every"]
    # A stroke is as long as it is asked for, and its speed changes evenly.
    assert way.max() - way.min() == pytest.approx(1e-3)
    assert np.abs(np.diff(speed)) == pytest.approx(np.full(speed.size - 1, 2e-3 / 100))
    loop = stribeck.simulate("LuGre", velocity=speed, normal_force=12.0, mu_s=0.2, dt=dt)
    assert np.array_equal(force, loop["friction_force"])


def test_types_of_the_page_are_those_of_the_library(ask):
    written = (PROJECT / "web" / "page" / "types.ts").read_text(encoding="utf-8")
    assert written == ask.types(), "run `python3 tasks.py types`"


def test_fits_are_those_of_the_package(ask, tmp_path):
    rig = {"law": "Dahl", "mass": "2", "normal_force": "20", "duration": "1", "faults": "false", "seed": "5"}
    files, _ = ask({"ask": "rig", "rig": rig})
    fit = {
        "records": "force.csv",
        "law": "Dahl",
        "mass": "2",
        "normal_force": "20",
        "budget": "100",
        "repetitions": "0",
    }
    question = {"fit": fit, "files": {"force.csv": files["force"]}}
    quality, arrays = ask({"ask": "quality", **question})
    assert quality["record"]["samples"] == len(arrays[0]) == 1001
    fit, _ = ask({"ask": "fit", **question})
    record = tmp_path / "force.csv"
    record.write_text(files["force"])
    there = stribeck.identify(str(record), "Dahl", mass=2.0, normal_force=20.0, budget=100, repetitions=0)
    values = fit["ranking"]["laws"][0]["values"]
    assert values == dict(there.best.values)
    assert abs(values["mu_k"] - files["truth"]["mu_k"]) < 0.01 * files["truth"]["mu_k"]


def test_what_was_measured_is_corrected_by_what_a_fit_finds(ask):
    rig = {"law": "Dahl", "mass": "2", "normal_force": "20", "duration": "1", "faults": "false", "seed": "5"}
    files, (time, friction) = ask({"ask": "rig", "rig": rig})
    known = {"law": "Dahl", "normal_force": "20", "fit": "mass"}
    fit = {"records": "r.csv", **known, "budget": "200", "repetitions": "0"}
    question = {"fit": fit, "files": {"r.csv": files["force"]}}
    quality, (*_, raw) = ask({"ask": "quality", **question})
    answer, (times, _, velocity, measured, explained) = ask({"ask": "fit", **question})
    assert answer["cycles"] == 0
    assert answer["noise"] == quality["record"]["noise"]
    assert np.allclose(times, time, rtol=0.0, atol=1e-9)
    assert velocity.size == time.size

    def rms(difference):
        return np.sqrt(np.mean(difference**2))

    # Before the mass is found its inertia lies on the friction; afterwards noise alone is left.
    assert rms(raw - friction) > 0.15
    assert rms(measured - friction) < 0.06
    assert rms(explained - friction) < 0.03
    (law,) = answer["ranking"]["laws"]
    # Samples at the ends, where the velocity is not known as well, do not count there.
    ends = (time.size - law["samples"]) // 2
    squares = law["rms"] ** 2 * (law["samples"] - len(law["estimates"]))
    assert np.sum((measured - explained)[ends:-ends] ** 2) == pytest.approx(squares, rel=1e-9)


def test_a_periodic_record_has_a_mean_cycle_before_and_after_a_fit(ask):
    rows = [(0.002 * number, 0.01 * math.sin(2 * math.pi * 0.002 * number)) for number in range(2001)]
    forces = [2.0 * math.copysign(1.0, math.cos(2 * math.pi * t)) + 0.01 * math.sin(1e4 * t * t) for t, _ in rows]
    table = "time [s],displacement [m],force [N]\n" + "".join(
        f"{t},{way},{force}\n" for (t, way), force in zip(rows, forces, strict=True)
    )
    fit = {"records": "r.csv", "law": "Coulomb", "normal_force": "10", "mass": "0", "budget": "60", "repetitions": "0"}
    question = {"fit": fit, "files": {"r.csv": table}}
    before, (*_, phase, _, _, mean) = ask({"ask": "quality", **question})
    after, (*_, same, _, _, measured, explained) = ask({"ask": "fit", **question})
    assert before["record"]["cycles"] == after["cycles"] > 1
    assert np.array_equal(phase, same)
    # Where it turns, the law has its own sign.
    slides = np.minimum(np.abs(mean), np.abs(explained)) > 1.9
    assert slides.mean() > 0.9
    assert np.allclose(measured[slides], mean[slides], atol=0.02)
    assert np.allclose(explained[slides], measured[slides], atol=0.02)


def test_averages_that_mix_both_directions_are_gaps_in_the_noise_that_is_left_of_them(ask):
    rows = [(0.001 * number, 0.02 * math.sin(6.0 * 0.001 * number)) for number in range(4001)]
    force = [
        2.0 * math.copysign(1.0, math.cos(6.0 * t)) - 36.0 * 3.0 * way + 0.1 * math.sin(1e6 * t * t) for t, way in rows
    ]
    lines = (f"{t},{way},{newtons}\n" for (t, way), newtons in zip(rows, force, strict=True))
    table = "time [s],displacement [m],force [N]\n" + "".join(lines)
    asked = {"records": "r.csv", "axis": "true", "law": "Coulomb", "budget": "60", "repetitions": "0"}
    question = {"fit": asked, "files": {"r.csv": table}}
    before, _ = ask({"ask": "quality", **question})
    answer, (_, _, velocity, measured, explained) = ask({"ask": "fit", **question})
    gaps = np.isnan(measured)
    assert 0.0 < gaps.mean() < 0.3
    assert np.abs(velocity[gaps]).max() < np.abs(velocity[~gaps]).max() / 2.0
    assert np.isfinite(explained).all()
    # Averages have less noise than samples.
    assert 0.0 < answer["noise"] < before["record"]["noise"] / 3.0
    assert np.sqrt(np.mean((measured - explained)[~gaps] ** 2)) < 5.0 * answer["noise"]


def test_a_component_is_led_by_its_inputs(ask):
    catalogue, _ = ask({"ask": "catalogue"})
    fitted = {one["name"]: one for one in catalogue["fitted"]}
    assert [name for name, one in fitted.items() if not one["has_load"]] == [m["name"] for m in catalogue["components"]]
    for model in catalogue["components"]:
        inputs = [one["name"] for one in model["variables"] if one["role"] == "Input" and one["name"] != "velocity"]
        drives = fitted[model["name"]]["drives"]
        assert [drive["name"] for drive in drives] == inputs
        assert all(drive["usual"] is None for drive in drives)
    (temperature,) = fitted["JointFriction"]["drives"]
    assert temperature["usual"] == 293.15
    assert fitted["Capstan"]["drives"][0]["units"] == ["N", "N.m"]


def rope(tension):
    """A record of a rope around half a drum, mu_k = 0.12 and 1 mm of pre-sliding, under a tension that grows."""
    share, before, rows = 1.0, 0.0, ["time [s],displacement [m],force [N],tension_1 [N]\n"]
    for time in (0.004 * number for number in range(250)):
        way = 4e-3 * math.sin(2 * math.pi * time)
        sense = math.copysign(1.0, way - before)
        share = sense - (sense - share) * math.exp(-abs(way - before) / 1e-3)
        before, now = way, tension + 3.0 * time
        noise = 0.01 * math.sin(1e4 * time * time)
        rows.append(f"{time},{way},{now * math.expm1(0.12 * math.pi * share) + noise},{now}\n")
    return "".join(rows)


def test_a_component_is_fitted_as_by_the_package(ask, tmp_path):
    table, record = rope(10.0), tmp_path / "rope.csv"
    fit = {"records": "rope.csv", "law": "Capstan", "fix": "preload=0", "budget": "60", "repetitions": "0"}
    here, _ = ask({"ask": "fit", "fit": fit, "files": {"rope.csv": table}})
    settings = {"fix": {"preload": 0.0}, "budget": 60, "repetitions": 0}
    record.write_text(table)
    there = stribeck.identify(str(record), "Capstan", **settings).best
    (law,) = here["ranking"]["laws"]
    assert law["values"] == dict(there.values)
    low, high = next(one["interval"] for one in law["estimates"] if one["name"] == "mu_k")
    assert 0.119 < low < 0.12 < high < 0.121
    # No system runs it in place of a law.
    assert here["toml"] is None
    assert 'name="mu_k"' in here["ssv"]
    # A column that is missing is refused in the words of the package; held, it is not needed.
    table = table.replace("tension_1", "pull")
    answer, _ = ask(quality(table, law="Capstan"))
    record.write_text(table)
    with pytest.raises(ValueError, match="it drives Capstan, in N") as refused:
        stribeck.identify(str(record), "Capstan", **settings)
    assert str(refused.value).endswith(answer["refused"].removeprefix("r.csv"))
    answer, _ = ask(quality(table, law="Capstan", fix="tension_1=10"))
    assert answer["record"]["samples"] == 250


def test_a_map_of_a_joint_has_the_curve_of_its_law(ask):
    speeds = [-3.0, -2.0, -1.0, -0.5, 0.5, 1.0, 2.0, 3.0]
    rows = [(v, math.copysign(1.5, v) + 0.25 * v + noise) for v in speeds for noise in (0.02, -0.02)]
    table = "omega [rad/s],torque [N.m]\n" + "".join(f"{v},{torque}\n" for v, torque in rows)
    fit = {"records": "map.csv", "law": "CoulombViscous", "normal_force": "1", "budget": "200", "repetitions": "0"}
    question = {"fit": fit, "files": {"map.csv": table}}
    quality, arrays = ask({"ask": "quality", **question})
    assert quality["record"] is None
    assert {name: quality["map"][name] for name in ("rows", "settings", "velocities")} == {
        "rows": 16,
        "settings": 8,
        "velocities": [-3.0, 3.0],
    }
    assert quality["map"]["scatter"] == pytest.approx(0.02 * math.sqrt(2.0))
    assert [quality["labels"][name]["unit"] for name in ("force", "velocity")] == ["N.m", "rad/s"]
    assert [quality["labels"][name]["name"] for name in ("force", "velocity")] == [
        "Friction torque",
        "Angular velocity",
    ]
    assert np.array_equal(arrays, np.transpose(rows))
    answer, (explained, velocity, torque) = ask({"ask": "fit", **question})
    assert answer["curves"] == ["CoulombViscous, 1 N\u00b7m"]
    values = answer["ranking"]["laws"][0]["values"]
    assert values == pytest.approx({"mu_k": 1.5, "viscous_coefficient": 0.25}, abs=1e-9)
    there = np.isfinite(velocity)
    assert np.count_nonzero(~there) == 1
    assert (velocity[there].min(), velocity[there].max()) == (-3.0, 3.0)
    assert np.allclose(torque[there], 1.5 * np.sign(velocity[there]) + 0.25 * velocity[there], atol=1e-9)
    assert answer["noise"] == quality["map"]["scatter"]
    assert np.allclose(explained, [1.5 * np.sign(v) + 0.25 * v for v, _ in rows], atol=1e-9)


MOTION = {"velocity": 0.01, "stroke": 1e-3, "speed": 1e-3}


def quality(table, **options):
    """A question about a record."""
    return {"ask": "quality", "fit": {"records": "r.csv", **options}, "files": {"r.csv": table}}


@pytest.mark.parametrize(
    ("question", "reason"),
    [
        (b"", "EOF"),
        (b'{"ask":"weather"}', "unknown variant `weather`"),
        ({"ask": "solve", "run": {"law": ["LuGer"]}, "law": "LuGer"}, "'LuGer' does not exist (did you mean 'LuGre'?)"),
        ({"ask": "curve", "model": "Dal", **MOTION}, "'Dal' does not exist (did you mean 'Dahl'?)"),
        ({"ask": "curve", "model": "Dahl", "held": {"load": 1.0}, **MOTION}, "variable of Dahl 'load' does not exist"),
        ({"ask": "strokes", "model": "Dahl", **MOTION, "speed": 0.0}, "every = inf s: must be > 0"),
        ({"ask": "ssv", "model": "Dahl", "set": {"mu_k": -1}}, "mu_k = -1: must be >= 0"),
        (quality("time [s]\n1\n"), "1 samples; at least 20 are needed"),
        (quality("", mass="-1"), "mass = -1: must be >= 0"),
        (quality("", mas="1"), "unknown field `mas`, expected one of `records`, "),
        (quality("", budget="many"), "budget = many: must be a whole number >= 0"),
        (quality("", budget="2.5"), "budget = 2.5: must be a whole number >= 0"),
        (quality("", loss="cubes"), "loss = cubes: must be one of squares, robust"),
    ],
)
def test_what_is_wrong_is_refused_by_name(ask, question, reason):
    answer, arrays = ask(question)
    assert reason in answer["refused"], answer
    assert arrays[0].size == 0


def test_spoilt_questions_are_answered(ask):
    """Whatever bytes a question has, the answer is a refusal or a result."""
    question = json.dumps({"ask": "solve", "run": {"law": ["Dahl"], "until": 0.1, "set": {"mu_k": 0.1}}, "law": "Dahl"})
    draw = random.Random(17)
    for _ in range(300):
        text = bytearray(question.encode())
        for _ in range(draw.randint(1, 4)):
            at = draw.randrange(len(text))
            text[at : at + draw.randint(0, 3)] = bytes(draw.randrange(256) for _ in range(draw.randint(0, 3)))
        answer, _ = ask(bytes(text))
        assert "refused" in answer or answer["law"] == "Dahl"
