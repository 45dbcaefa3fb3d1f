"""C sources as FMUs of FMI 3.0: what fmpy compiles by their build description does what the FMU with a library does."""

import shutil

import pytest
from c_sources import built, make, motion, needs_wasm
from fmi3 import FOLDER, open_instance
from fmpy import read_model_description
from fmpy.validation import validate_fmu

pytestmark = needs_wasm

# Arrays of parameters, with a size, of states and of results; a memory, a choice, a count.
MODEL = "MaxwellSlip"


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """The FMU with a library, and that with C sources, compiled."""
    folder = tmp_path_factory.mktemp("fmus")
    make("pack", MODEL, "--sources", "--out", folder)
    packed = folder / "fmi3" / f"{MODEL}.fmu"
    assert packed.stat().st_size < 400_000
    assert validate_fmu(str(packed)) == []
    archive = shutil.make_archive(str(folder / "archive"), "zip", built(packed, folder / "sources"))
    compiled = folder / "compiled" / f"{MODEL}.fmu"
    compiled.parent.mkdir()
    shutil.move(archive, compiled)
    return FOLDER / f"{MODEL}.fmu", compiled


def told(instance, call):
    """That a call was refused, and how."""
    with pytest.raises(Exception, match="failed with status") as refusal:
        call()
    instance.fmu.reset()
    return str(refusal.value)


def start(instance, elements: int):
    instance.fmu.enterConfigurationMode()
    instance.set("element_size", [elements])
    instance.fmu.exitConfigurationMode()
    instance.set("element_count", [elements])
    instance.fmu.enterInitializationMode(startTime=0.5)
    instance.fmu.exitInitializationMode()


def everything(instance, elements: int) -> list[list[float]]:
    """The values of all variables but those that only event mode and Model Exchange have."""
    names = [name for name in instance.variables if name != "event_indicators"]
    sized = [name for name in names if name in ("element.stiffness_share", "element.strength_share")]
    return [instance.get(name, elements if name in sized else None) for name in names]


def run(instance, elements: int) -> list:
    """Results of a motion, with derivatives of every kind and the state as bytes."""
    fmu, results, time = instance.fmu, [], 0.5
    start(instance, elements)
    inputs = [instance.reference(name) for name in ("velocity", "normal_force")]
    known = [*inputs, instance.reference("element.force")]
    force = [instance.reference("friction_force"), instance.reference("dissipated_energy")]
    for dt, values in motion(MODEL, 100):
        fmu.setFloat64(inputs, values[:2])
        results.append(fmu.doStep(time, dt))
        time += dt
        results.append(everything(instance, elements))
        results.append(fmu.getOutputDerivatives(force, [1, 2]))
        seed = [1.0, 0.5, *[0.25] * len(instance.get("element.force"))]
        results.append(fmu.getDirectionalDerivative(force[:1], known, seed))
        results.append(fmu.getAdjointDerivative(force[:1], known, [2.0], nSensitivity=len(seed)))
    state = fmu.getFMUState()
    results.append(bytes(fmu.serializeFMUState(state)))
    results.append(fmu.doStep(time, 1e-3))
    after = everything(instance, elements)
    fmu.setFMUState(state)
    fmu.doStep(time, 1e-3)
    assert everything(instance, elements) == after
    fmu.freeFMUState(state)
    again = fmu.deserializeFMUState(results[-2])
    fmu.setFMUState(again)
    fmu.freeFMUState(again)
    return [*results, after]


@pytest.mark.parametrize("elements", [64, 3])
def test_an_fmu_of_sources_does_what_that_with_a_library_does(both, elements):
    runs = []
    for path in both:
        with open_instance(path) as instance:
            runs.append(run(instance, elements))
    assert str(runs[0]) == str(runs[1])


def test_refusals_are_those_of_the_library(both):
    """As statuses; a size that is too small ends the initialization."""
    seen = []
    for path in both:
        with open_instance(path) as instance:
            fmu, reference = instance.fmu, instance.reference
            refusals = [
                lambda: fmu.setFloat64([reference("mu_k")], [-1.0]),  # noqa: B023
                lambda: fmu.setFloat64([reference("element.stiffness_share")], [0.1]),  # noqa: B023
                lambda: fmu.getInt32([reference("mu_k")]),  # noqa: B023
                lambda: fmu.getFloat32([reference("mu_k")]),  # noqa: B023
                lambda: fmu.getFloat64([7]),  # noqa: B023
                lambda: fmu.setUInt64([reference("element_size")], [3]),  # noqa: B023
                lambda: fmu.setFloat64([reference("time")], [1.0]),  # noqa: B023
                lambda: fmu.doStep(0.0, 1e-3),  # noqa: B023
                lambda: fmu.enterEventMode(),  # noqa: B023
            ]
            answers = [told(instance, call) for call in refusals]
            fmu.enterConfigurationMode()
            answers.append(told(instance, lambda: fmu.setUInt64([reference("element_size")], [65])))  # noqa: B023
            fmu.enterConfigurationMode()
            instance.set("element_size", [3])
            fmu.exitConfigurationMode()
            fmu.enterInitializationMode(startTime=0.0)
            answers.append(told(instance, fmu.exitInitializationMode))
            seen.append(answers)
    assert seen[0] == seen[1]


def test_what_sources_do_not_do_is_not_declared_and_refused(both):
    interface = read_model_description(str(both[1])).coSimulation
    assert not interface.hasEventMode
    assert not interface.providesIntermediateUpdate
    with pytest.raises(Exception, match="instantiate"), open_instance(both[1], events=True):
        pass
