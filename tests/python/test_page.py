"""The library behind the page, built for this machine, against the Python package: same questions, same bits."""

import ctypes
import json
import os
import random
import sys
from pathlib import Path

import numpy as np
import pytest
import stribeck

ROOT = Path(__file__).resolve().parents[2]
NAMES = {"win32": "stribeck_page.dll", "darwin": "libstribeck_page.dylib"}


@pytest.fixture(scope="module")
def library():
    folder = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "debug"
    library = ctypes.CDLL(str(folder / NAMES.get(sys.platform, "libstribeck_page.so")))
    library.stribeck_alloc.argtypes = [ctypes.c_size_t]
    library.stribeck_alloc.restype = ctypes.c_void_p
    library.stribeck_ask.restype = ctypes.c_size_t
    library.stribeck_answer.restype = ctypes.c_void_p
    return library


@pytest.fixture(scope="module")
def ask(library):
    """A function that puts a question; it returns the answer and its arrays."""

    def put(question):
        text = question if isinstance(question, bytes) else json.dumps(question).encode()
        ctypes.memmove(library.stribeck_alloc(len(text)), text, len(text))
        length = library.stribeck_ask()
        answer = ctypes.string_at(library.stribeck_answer(), length)
        end = 8 + int.from_bytes(answer[:4], "little")
        told = json.loads(answer[8:end])
        numbers = np.frombuffer(answer[end:])
        assert len(numbers) == sum(told["lengths"]) == int.from_bytes(answer[4:8], "little")
        return told["answer"], np.split(numbers, np.cumsum(told["lengths"])[:-1])

    return put


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
    velocity = np.linspace(-0.01, 0.01, 21)
    series = {
        "model": "LuGre",
        "set": {"mu_s": 0.2},
        "inputs": {"velocity": velocity.tolist(), "normal_force": [12.0]},
        "results": ["friction_force"],
    }
    _, (curve,) = ask({"ask": "settle", **series})
    assert np.array_equal(curve, stribeck.force("LuGre", velocity, 12.0, mu_s=0.2))
    _, (strokes,) = ask({"ask": "follow", "every": 1e-4, "series": series})
    loop = stribeck.simulate("LuGre", velocity=velocity, normal_force=12.0, mu_s=0.2, dt=1e-4)
    assert np.array_equal(strokes, loop["friction_force"])


def test_fits_are_those_of_the_package(ask, tmp_path):
    rig = {"law": "Dahl", "mass": 2.0, "normal_force": 20.0, "duration": 1.0, "faults": False, "seed": 5}
    files, _ = ask({"ask": "rig", **rig})
    known = {"table": files["force"], "mass": 2.0, "normal_force": 20.0}
    quality, arrays = ask({"ask": "quality", **known})
    assert quality["samples"] == len(arrays[0]) == 1001
    fit, _ = ask({"ask": "fit", "known": known, "wanted": {"laws": ["Dahl"], "budget": 100, "repetitions": 0}})
    record = tmp_path / "force.csv"
    record.write_text(files["force"])
    there = stribeck.identify(str(record), "Dahl", mass=2.0, normal_force=20.0, budget=100, repetitions=0)
    values = fit["ranking"]["laws"][0]["values"]
    assert values == dict(there.best.values)
    assert abs(values["mu_k"] - files["truth"]["mu_k"]) < 0.01 * files["truth"]["mu_k"]


@pytest.mark.parametrize(
    ("question", "reason"),
    [
        (b"", "EOF"),
        (b'{"ask":"weather"}', "unknown variant `weather`"),
        ({"ask": "solve", "run": {"law": ["LuGer"]}, "law": "LuGer"}, "'LuGer' does not exist (did you mean 'LuGre'?)"),
        ({"ask": "settle", "model": "Dahl", "inputs": {"speed": [1.0]}, "results": []}, "'speed' does not exist"),
        ({"ask": "ssv", "model": "Dahl", "set": {"mu_k": -1}}, "mu_k = -1: must be >= 0"),
        (
            {"ask": "follow", "every": 0.0, "series": {"model": "Dahl", "inputs": {}, "results": []}},
            "every = 0 s: must be > 0",
        ),
        (
            {
                "ask": "settle",
                "model": "Dahl",
                "inputs": {"velocity": [1, 2], "normal_force": [1, 2, 3]},
                "results": [],
            },
            "velocity has 2 samples: must have 1 or 3",
        ),
        ({"ask": "quality", "table": "time [s]\n1\n", "mass": 1.0}, "1 samples; at least 20 are needed"),
        ({"ask": "quality", "table": "", "mass": -1.0}, "mass = -1: must be >= 0"),
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
