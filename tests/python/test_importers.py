"""Every FMU in importers of different origin, alone and in a loop with a host: one scheme, the same numbers."""

import math
import os
import platform
import subprocess
import sys

import numpy
import pytest
from fmi3 import FOLDER
from fmpy.fmi1 import FMICallException
from importers import IMPORTERS, difference, fmutool_errors, in_container, in_fmpy, rust_master, system
from importers3 import IMPORTERS3, IN_EVENT_MODE, in_version_3, with_common_events

from examples.fmpy.coupling import FMUS, CouplingError, friction_models_in, models_in, path_of, variables_of

MODELS = models_in(FMUS)
# Without the law whose force passes from one level to the other at rest within a speed that no step resolves: what it
# does there depends on the last digit.
LAWS = [law for law in friction_models_in(FMUS) if "reference_velocity" not in variables_of(path_of(law))]
CORNERS = ["fl", "fr", "rl", "rr"]
# 2 ms as a power of two that is a whole number of nanoseconds, in which libcosim counts: with others its steps differ
# in the last digits from those of a master that counts in seconds.
STEP, STEPS = 2.0**-9, 200
# Steep laws do not chatter on the belt with this one.
BELT_STEP, BELT_STEPS = 1e-4, 1500
TOLERANCE = 1e-11

# fmpy is the reference for the others.
OTHERS = [
    pytest.param(
        name,
        marks=pytest.mark.skipif(
            name in ("ecos", "libcosim") and (sys.platform != "linux" or platform.machine() != "x86_64"),
            reason="Ecos and libcosim need Linux on x86-64",
        ),
    )
    for name in IMPORTERS
    if name != "fmpy"
]


def real_variables(model: str, causality: str) -> dict[str, float]:
    """Start values of the real inputs or outputs of a model."""
    variables = variables_of(path_of(model)).items()
    return {name: float(v.start or 0.0) for name, v in variables if v.causality == causality and v.type == "Real"}


def wave(start: float, least: float = -math.inf) -> list[float]:
    """The signal of an input: 1.5 periods about its start value, with a twentieth of it as amplitude, or with 0.01. At
    its lower bound, the lower half-wave is folded up."""
    amplitude = 0.05 * abs(start) or 0.01
    waves = [amplitude * math.sin(3.0 * math.pi * number / STEPS) for number in range(STEPS)]
    return [start + (value if start - amplitude >= least else abs(value)) for value in waves]


def alone(model: str) -> tuple:
    """A model with a signal at each input, and all its outputs."""
    known = variables_of(path_of(model))
    signals = {
        ("model", name): wave(start, float(known[name].min or -math.inf))
        for name, start in real_variables(model, "input").items()
    }
    outputs = [f"model.{name}" for name in real_variables(model, "output")]
    return system({"model": path_of(model)}), STEP, STEPS, outputs, signals


def on_the_belt(law: str) -> tuple:
    """A law with the rig; the spring is strained so far that the block breaks away during the run."""
    known = variables_of(path_of(law))
    links = [("law.friction_force", "rig.friction_force"), ("rig.velocity", "law.velocity")]
    start = {"rig.position": 0.73}
    if "external_force" in known:
        links.append(("rig.external_force", "law.external_force"))
    if "mass" in known:
        start["law.mass"] = 1.0
    watched = ["rig.position", "rig.block_velocity", "rig.velocity", "rig.external_force"]
    return system({"rig": path_of("BeltRig"), "law": path_of(law)}, links, start), BELT_STEP, BELT_STEPS, watched, {}


def quarter_car() -> tuple:
    """The shock absorber in the quarter car, on a wavy road."""
    links = [
        ("car.length", "strut.length"),
        ("car.velocity", "strut.velocity"),
        ("strut.force", "car.strut_force"),
    ]
    signals = {("car", name): wave(0.0) for name in ("road_height", "road_velocity")}
    watched = ["car.body_height", "car.wheel_velocity", "car.length", "car.tyre_load"]
    return (
        system({"car": path_of("QuarterCar"), "strut": path_of("ShockAbsorber")}, links),
        STEP,
        STEPS,
        watched,
        signals,
    )


def four_post_car() -> tuple:
    """Four shock absorbers in the four-post car, two of whose posts move."""
    links = []
    for corner in CORNERS:
        links += [
            (f"car.{corner}.length", f"{corner}.length"),
            (f"car.{corner}.velocity", f"{corner}.velocity"),
            (f"{corner}.force", f"car.{corner}.strut_force"),
        ]
    signals = {("car", name): wave(0.0) for name in ("fl.post_height", "rr.post_height")}
    watched = ["car.heave", "car.pitch", "car.roll", *(f"car.{corner}.length" for corner in CORNERS)]
    struts = {corner: path_of("ShockAbsorber") for corner in CORNERS}
    return system({"car": path_of("FourPostCar"), **struts}, links), STEP, STEPS, watched, signals


CASES = {
    **{f"{model}": (alone, model) for model in MODELS},
    **{f"BeltRig with {law}": (on_the_belt, law) for law in LAWS},
    "QuarterCar with ShockAbsorber": (quarter_car,),
    "FourPostCar with ShockAbsorber": (four_post_car,),
}


@pytest.fixture(scope="module")
def in_reference():
    """Each case in fmpy, run once."""
    records = {}

    def run(case: str) -> dict[str, numpy.ndarray]:
        if case not in records:
            build, *arguments = CASES[case]
            records[case] = in_fmpy(*build(*arguments))
        return records[case]

    return run


def test_the_block_breaks_away(in_reference):
    """The loops include interesting events."""
    velocity = in_reference("BeltRig with CoulombStiction")["rig.velocity"]
    assert abs(velocity[100]) < 1e-6 < 1e-3 < abs(velocity[-1])


@pytest.fixture(scope="module")
def differences():
    """Largest difference of each case in each importer."""
    found = []
    yield found
    print(
        f"figure: {len(CASES)} cases, {len(found)} runs in importers, largest difference {max(found, default=0.0):.1e}"
    )


@pytest.mark.parametrize("importer", OTHERS)
@pytest.mark.parametrize("case", CASES)
def test_importers_agree(case, importer, in_reference, differences):
    build, *arguments = CASES[case]
    record = IMPORTERS[importer](*build(*arguments))
    differences.append(difference(record, in_reference(case)))
    assert differences[-1] < TOLERANCE


@pytest.mark.parametrize(("version", "folder"), [("2.0", FMUS), ("3.0", FOLDER)])
@pytest.mark.parametrize("model", MODELS)
def test_fmutool_finds_nothing(model, version, folder):
    assert fmutool_errors(path_of(model, folder), version) == []


@pytest.mark.parametrize(("version", "folder"), [("2", FMUS), ("3", FOLDER)])
def test_fmi_rs_finds_nothing(version, folder):
    paths = [str(path_of(model, folder)) for model in MODELS]
    done = subprocess.run([rust_master(), "check", version, *paths], capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, f"{len(MODELS)} FMUs, no problems\n"), done.stderr


def failing(fault: float) -> tuple:
    """LuGre in two components; in step 101 the first one gets a velocity on which it fails, then a valid one again."""
    good = wave(0.0)
    bad = [*good[:100], fault, *good[101:]]
    parts = system({"bad": path_of("LuGre"), "good": path_of("LuGre")})
    watched = [f"{part}.{name}" for part in ("bad", "good") for name in real_variables("LuGre", "output")]
    return parts, STEP, STEPS, watched, {("bad", "velocity"): bad, ("good", "velocity"): good}


@pytest.mark.parametrize("fault", [1e300, math.nan], ids=["step", "input"])
@pytest.mark.parametrize("importer", [*(name for name in IMPORTERS if name != "ecos")])
def test_a_failing_fmu_ends_the_run(importer, fault):
    """An input that overflows makes fmi2DoStep fail; NaN is rejected by fmi2SetReal."""
    with pytest.raises((CouplingError, FMICallException)):
        IMPORTERS[importer](*failing(fault))


def test_a_failing_fmu_stays_harmless_if_the_run_continues():
    """Ecos continues to call: the failed component keeps its last values, and its neighbour is not affected."""
    record, fine = IMPORTERS["ecos"](*failing(1e300)), in_fmpy(*failing(0.0))
    for name in real_variables("LuGre", "output"):
        assert record[f"good.{name}"] == pytest.approx(fine[f"good.{name}"], rel=TOLERANCE)
        assert record[f"bad.{name}"][:100] == pytest.approx(fine[f"bad.{name}"][:100], rel=TOLERANCE)
        assert numpy.isfinite(record[f"bad.{name}"]).all()
    force = record["bad.friction_force"]
    assert (force[100:] == force[99]).all()


# FMPy runs each model alone in test_fmi3.py; of the loops a few are enough, unless every one is asked for.
LOOPS = ["BeltRig with CoulombStiction", "BeltRig with LuGre", "QuarterCar with ShockAbsorber"]
IS_THOROUGH = os.environ.get("STRIBECK_THOROUGH") == "1"
IN_FMI_3 = [
    (case, importer)
    for case in CASES
    for importer in IMPORTERS3
    if (importer in ("fmi", "fmi-rs") if case in MODELS else case in LOOPS) or IS_THOROUGH
]


@pytest.mark.parametrize(("case", "importer"), IN_FMI_3)
def test_fmus_of_fmi_3_have_the_same_bits(case, importer, in_reference):
    build, *arguments = CASES[case]
    parts, *rest = build(*arguments)
    record = IMPORTERS3[importer](in_version_3(parts), *rest)
    assert {name: values.tobytes() for name, values in record.items()} == {
        name: values.tobytes() for name, values in in_reference(case).items()
    }


@pytest.mark.parametrize("importer", IN_EVENT_MODE)
@pytest.mark.parametrize("model", MODELS)
def test_event_mode_leads_to_the_same_motion(model, importer, in_reference):
    """Steps that end at events, and go on from there with the same inputs, reach the same values; the strut divides
    others into internal steps, which are of first order."""
    parts, *rest = alone(model)
    record = IN_EVENT_MODE[importer](in_version_3(parts), *rest)
    tolerance = 1e-3 if "num.h_max" in variables_of(path_of(model)) else 1e-9
    assert difference(record, in_reference(model)) < tolerance


@pytest.mark.parametrize("case", CASES if IS_THOROUGH else LOOPS)
def test_a_container_of_fmus_of_fmi_3_exchanges_at_events(case):
    """It enters Event Mode with all of its FMUs, which then know each other's values at once, not a step later."""
    build, *arguments = CASES[case]
    parts, *rest = build(*arguments)
    parts = in_version_3(parts)
    assert difference(in_container(parts, *rest), with_common_events(parts, *rest)) < TOLERANCE
