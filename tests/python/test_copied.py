"""What the page copies, for drawn settings: it runs elsewhere, and gives the same bits."""

import contextlib
import csv
import io
import json
import os
import random
import shlex
import subprocess
from pathlib import Path

import numpy as np
import pytest
import stribeck
from command_line import program

from examples.fmpy.coupling import PROJECT

DRAWN = 30
# The laws that the solver makes whole steps for: the others take longer, by the same road.
LAWS = ["Coulomb", "CoulombStiction", "Karnopp", "LuGre", "Dahl", "Andersson", "Stribeck", "Leuven", "Gonthier"]
SYSTEMS = {
    "belt": {"rig.mass": (0.5, 2.0), "rig.belt_velocity": (0.05, 0.2), "friction.mu_k": (0.05, 0.1)},
    "motion": {"friction.mu_k": (0.05, 0.1), "friction.velocity.amplitude": (0.003, 0.006)},
    "dyno": {"strut.length.amplitude": (0.01, 0.02), "strut.side_force_m": (100.0, 300.0)},
}
# Options of an identification as a user of the page types them.
OPTIONS = {
    "scale": lambda draw: f"force={draw.uniform(0.9, 1.1)}",
    "window": lambda draw: repr(draw.uniform(0.01, 0.03)),
    "skip": lambda draw: repr(draw.uniform(0.05, 0.1)),
    "rest": lambda draw: repr(draw.uniform(0.0, 1e-3)),
    "fit": lambda draw: draw.choice(["offset", "mass", "mass, offset"]),
    "range": lambda draw: f"mu_k=0.001:{draw.uniform(0.3, 3.0)}",
    "loss": lambda draw: draw.choice(["squares", "robust"]),
    "seed": lambda draw: str(draw.randrange(1000)),
    "folds": lambda _: "2",
}


def done(text):
    """What a Python program leaves behind."""
    names = {}
    with contextlib.redirect_stdout(io.StringIO()):
        exec(text, names)
    return names


def compiled(text, folder):
    """The rows that a C program prints."""
    libraries = Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target")) / "debug"
    source, binary = folder / "copied.c", folder / "copied"
    source.write_text(text)
    strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-O0"]
    link = ["-L", libraries, "-lstribeck", f"-Wl,-rpath,{libraries}"]
    subprocess.run(["cc", *strict, "-I", PROJECT / "include", source, "-o", binary, *link], check=True)
    output = subprocess.run([binary], capture_output=True, text=True, check=True).stdout
    return list(csv.reader(io.StringIO(output)))


@pytest.mark.parametrize("number", range(DRAWN))
def test_a_run_is_the_same_elsewhere(ask, tmp_path, number):
    draw = random.Random(number)
    system, law = draw.choice(list(SYSTEMS)), draw.choice(LAWS)
    drawn = {name: draw.uniform(*ends) for name, ends in SYSTEMS[system].items() if draw.random() < 0.7}
    run = {"system": system, "law": [law], "set": drawn, "until": draw.uniform(0.05, 0.2), "every": 0.005}
    if draw.random() < 0.5:
        run["solver"] = "co-simulation"
    elif draw.random() < 0.5:
        run["tol"] = 10.0 ** draw.uniform(-9.0, -5.0)
    job = {"run": run}
    solved, arrays = ask({"ask": "solve", "run": run, "law": law})
    assert solved["reached"], solved
    names = ["time", *(column["name"] for column in solved["columns"])]
    columns = dict(zip(names, arrays, strict=False))
    command = shlex.split(ask({"ask": "command", "job": job})[0]["text"])
    program(*command[1:], "--out", str(tmp_path / "run.csv"))
    table = np.genfromtxt(tmp_path / "run.csv", delimiter=",", skip_header=1)
    assert np.array_equal(table, np.stack(list(columns.values()), axis=1)), command
    solution = done(ask({"ask": "python", "job": job})[0]["text"])["solution"]
    for name, values in columns.items():
        assert np.array_equal(solution[name], values), name
    if run.get("solver") == "co-simulation":
        heading, *rows = compiled(ask({"ask": "c", "run": run, "law": law})[0]["text"], tmp_path)
        for name, *values in zip(heading, *rows, strict=True):
            assert [float(value) for value in values] == columns[name.split(" [")[0]].tolist(), name


@pytest.mark.parametrize("number", range(DRAWN))
def test_strokes_are_the_same_elsewhere(ask, tmp_path, number):
    draw = random.Random(number)
    law = draw.choice([*LAWS, "Liang", "LuGrePlanar", "NonReversible", "Wojewoda"])
    described = stribeck.law(law).variables
    set_ = {name: draw.uniform(0.08, 0.1) for name in ("mu_k",) if name in described and draw.random() < 0.7}
    choices = [
        variable for variable in described.values() if variable.choices and variable.role in ("Fixed", "Tunable")
    ]
    if choices and draw.random() < 0.7:
        chosen = draw.choice(choices)
        set_[chosen.name] = draw.choice([name for name, _ in chosen.choices])
    held = {"normal_force": draw.uniform(5.0, 20.0)} if "normal_force" in described else {}
    motion = {
        "velocity": draw.uniform(0.01, 0.1),
        "stroke": draw.uniform(1e-5, 1e-3),
        "speed": draw.uniform(1e-3, 0.05),
    }
    strokes = {"model": law, "set": set_, "held": held, **motion}
    answer, arrays = ask({"ask": "strokes", **strokes})
    assert "refused" not in answer, (answer, strokes)
    way, speed, force = arrays
    names = done(ask({"ask": "python", "job": {"strokes": strokes}})[0]["text"])
    result = "friction_force" if "friction_force" in described else "friction_force_x"
    for here, there in ((way, names["way"]), (speed, names["velocity"]), (force, names["loop"][result])):
        assert np.array_equal(here, there), strokes
    curve, arrays = ask({"ask": "curve", **strokes})
    if "force" in names and "refused" not in curve:
        assert np.array_equal(arrays[0], names["held"])
        assert np.array_equal(arrays[1], names["force"])
    rows = compiled(ask({"ask": "strokes-c", **strokes})[0]["text"], tmp_path)
    assert np.array_equal(np.array(rows, float)[:, 1:], np.stack([speed, force], axis=1)), strokes


@pytest.mark.parametrize("number", range(DRAWN))
def test_an_identification_is_the_same_elsewhere(ask, tmp_path, monkeypatch, number):
    draw = random.Random(number)
    has_camera = number % 3 == 0
    rig = {"law": draw.choice(["Coulomb", "Dahl"]), "mass": "2", "normal_force": "20", "duration": "1"}
    files, _ = ask({"ask": "rig", "rig": {**rig, "faults": str(has_camera).lower(), "seed": str(number)}})
    laws = draw.sample(["Coulomb", "CoulombViscous", "Dahl"], draw.choice([1, 1, 2]))
    fit = {"records": "force.csv", "law": ",".join(laws), "mass": "2", "normal_force": "20"}
    fit |= {"budget": "50", "repetitions": "1"}
    texts = {"force.csv": files["force"]}
    if has_camera:
        fit |= {"motion": "motion.csv", "delay": draw.choice(["find", "find:0.05", "0.012"])}
        texts["motion.csv"] = files["camera"]
    elif draw.random() < 0.2:
        fit["axis"] = "true"
    for name in draw.sample(list(OPTIONS), 2):
        fit[name] = OPTIONS[name](draw)
    answer, _ = ask({"ask": "fit", "fit": fit, "files": texts})
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    monkeypatch.chdir(tmp_path)
    command = shlex.split(ask({"ask": "command", "job": {"fit": fit}})[0]["text"])
    text = ask({"ask": "python", "job": {"fit": fit}})[0]["text"]
    if "refused" in answer:
        with pytest.raises(subprocess.CalledProcessError) as failed:
            program(*command[1:], "--json")
        assert failed.value.stderr == f"stribeck: {answer['refused']}\n"
        with pytest.raises(stribeck.Refused) as refused:
            done(text)
        assert str(refused.value) == answer["refused"]
        return
    assert json.loads(program(*command[1:], "--json").stdout) == answer["ranking"], command
    found = done(text)["found"]
    for fit, other in zip(found.fits, answer["ranking"]["laws"], strict=True):
        assert (fit.law, fit.rms, fit.values, fit.warnings) == tuple(
            other[name] for name in ("law", "rms", "values", "warnings")
        )
        assert [one.text for one in fit.estimates.values()] == [one["text"] for one in other["estimates"]]
