"""The results in an FMU are those that its library computes: to the bit, and with an importer's own loop."""

import zipfile

import pytest
from fmpy import simulate_fmu
from fmpy.util import read_csv
from numpy.testing import assert_allclose
from reference import FOLDER, Reference

from examples.fmpy.coupling import FMUS, models_in, open_fmu, path_of

MODELS = models_in(FMUS)


@pytest.mark.parametrize("model", MODELS)
def test_results_are_those_of_the_fmu(model):
    expected = Reference.of(path_of(model))
    moved = [name for name in expected.inputs if name != "time"]
    shown = [name for name in expected.outputs if name != "time"]
    with open_fmu(path_of(model), {name: expected.inputs[name][0] for name in moved}) as fmu:
        types = {variable.name: variable.type for variable in fmu.description.modelVariables}
        get = {"Real": fmu.slave.getReal, "Integer": fmu.slave.getInteger, "Boolean": fmu.slave.getBoolean}
        references = fmu.references(*moved)

        def read() -> list[float]:
            return [float(get[types[name]](fmu.references(name))[0]) for name in shown]

        assert read() == [expected.outputs[name][0] for name in shown]
        for row, (time, step) in enumerate(expected.steps):
            fmu.slave.setReal(references, [expected.inputs[name][row] for name in moved])
            fmu.slave.doStep(time, step)
            assert read() == [expected.outputs[name][row + 1] for name in shown], time


@pytest.mark.parametrize("model", ["LuGre", "Karnopp", "ShockAbsorber", "HydraulicDamper"])
def test_fmpy_repeats_the_results(model, tmp_path):
    """FMPy interpolates inputs between samples and adds up its own time, so that digits differ."""
    expected = Reference.of(path_of(model))
    with zipfile.ZipFile(path_of(model)) as archive:
        file = archive.extract(f"{FOLDER}/{model}_in.csv", tmp_path)
    step, end = expected.outputs["time"][1], expected.outputs["time"][-1]
    shown = [name for name in expected.outputs if name not in {"time", "sticking"}]
    result = simulate_fmu(
        str(path_of(model)), input=read_csv(file), output=shown, stop_time=end, step_size=step, output_interval=step
    )
    for name in shown:
        scale = max(map(abs, expected.outputs[name]))
        assert_allclose(result[name], expected.outputs[name], rtol=0.0, atol=1e-6 * scale + 1e-300, err_msg=name)
