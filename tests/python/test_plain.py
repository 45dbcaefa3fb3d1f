"""FMUs in which every variable is Real, as a host uses them that knows no other type."""

import shutil

import fmpy
import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from fmpy.validation import validate_fmu
from pathsim import Connection, Simulation
from pathsim.blocks import Constant
from pathsim_fmi import CoSimulationFMU

from examples.fmpy.coupling import FMUS, CouplingError, models_in, open_fmu, path_of

FOLDER = FMUS / "plain"
MODELS = models_in(FOLDER)


def everything(fmu) -> dict[str, float]:
    """All variables, read as Real."""
    variables = fmu.description.modelVariables
    return dict(zip([v.name for v in variables], fmu.slave.getReal([v.valueReference for v in variables]), strict=True))


def test_every_model_is_packed():
    assert models_in(FMUS) == MODELS


@pytest.mark.parametrize("model", MODELS)
def test_all_variables_are_real_and_have_the_values_of_the_others(model):
    """Those of the FMU with types, read by type: Booleans as 0 and 1, choices by number."""
    with open_fmu(path_of(model, FOLDER)) as plain, open_fmu(path_of(model)) as typed:
        assert {variable.type for variable in plain.description.modelVariables} == {"Real"}
        assert plain.description.modelName == f"{model} (plain)"
        get = {"Real": typed.slave.getReal, "Boolean": typed.slave.getBoolean}
        for fmu in (plain, typed):
            fmu.slave.doStep(0.0, 1e-3)
        found = everything(plain)
        for variable in typed.description.modelVariables:
            (value,) = get.get(variable.type, typed.slave.getInteger)([variable.valueReference])
            assert found[variable.name] == value or value != value, variable.name


@pytest.mark.parametrize("model", ["Karnopp", "ShockAbsorber", "PositionControl"])
def test_validates(model):
    assert validate_fmu(str(path_of(model, FOLDER))) == []


def test_choices_and_booleans_are_set_by_number():
    """A choice acts as that of the FMU with types; what is none is refused, with the limit."""
    with (
        open_fmu(path_of("ShockAbsorber", FOLDER), {"friction.model": 1.0, "spring.enabled": 0.0}) as plain,
        open_fmu(path_of("ShockAbsorber"), {"friction.model": 1, "spring.enabled": False}) as typed,
    ):
        forces = [fmu.slave.getReal(fmu.references("force", "force_spring")) for fmu in (plain, typed)]
        assert forces[0] == forces[1]
        assert forces[0][1] == 0.0
    for name, value in [("friction.model", 1.5), ("friction.model", 0.0), ("spring.enabled", 2.0)]:
        with pytest.raises(Exception, match=name), open_fmu(path_of("ShockAbsorber", FOLDER), {name: value}):
            pass


def test_the_fmu_with_types_still_refuses_a_boolean_as_real():
    with pytest.raises(CouplingError, match="sticking .* is not of type Real"), open_fmu(path_of("LuGre")) as fmu:
        fmu.slave.getReal(fmu.references("sticking"))


@pytest.mark.parametrize("model", ["Karnopp", "LuGre"])
def test_pathsim_runs_them(model):
    """A host that reads every output as Real: the values of so many steps of the FMU with types."""
    inputs = {"velocity": 2e-3, "normal_force": 9.81}
    fmu = CoSimulationFMU(str(path_of(model, FOLDER)), dt=1e-3)
    sources = {name: Constant(value) for name, value in inputs.items()}
    wires = [Connection(source, fmu[name]) for name, source in sources.items()]
    Simulation([*sources.values(), fmu], wires, dt=1e-3, log=False).run(0.05)
    found = dict(zip(fmu.fmu_wrapper.output_refs, fmu.outputs.to_array(), strict=True))
    with open_fmu(path_of(model)) as typed:
        typed.slave.setReal(typed.references(*inputs), list(inputs.values()))
        # It also makes the step that begins at its end.
        for number in range(51):
            typed.slave.doStep(number * 1e-3, 1e-3)
        shown = ("friction_force", "dissipated_energy", "dissipated_power")
        assert [found[name] for name in shown] == typed.slave.getReal(typed.references(*shown))
        assert [bool(found["sticking"])] == typed.slave.getBoolean(typed.references("sticking"))


def test_pathsim_refuses_those_with_types():
    with pytest.raises(FMICallException, match="fmi2GetReal"):
        CoSimulationFMU(str(path_of("LuGre")), dt=1e-3)


def test_a_state_of_one_form_is_one_of_the_other():
    """The same model and the same row: only the view differs."""
    with open_fmu(path_of("LuGre", FOLDER)) as plain, open_fmu(path_of("LuGre")) as typed:
        for fmu in (plain, typed):
            fmu.slave.setReal(fmu.references("velocity"), [1e-3])
        plain.slave.doStep(0.0, 1e-3)
        state = plain.slave.getFMUstate()
        saved = plain.slave.serializeFMUstate(state)
        plain.slave.freeFMUstate(state)
        state = typed.slave.deSerializeFMUstate(saved)
        typed.slave.setFMUstate(state)
        typed.slave.freeFMUstate(state)
        shown = ("friction_force", "bristle_deflection")
        assert typed.slave.getReal(typed.references(*shown)) == plain.slave.getReal(plain.references(*shown))


def test_a_plain_guid_makes_no_other_model():
    """The guid of one model's plain FMU in the FMU of another is refused with the name that it does not have."""
    path = path_of("LuGre", FOLDER)
    description, folder = fmpy.read_model_description(str(path)), fmpy.extract(str(path))
    try:
        slave = FMU2Slave(
            guid=description.guid.replace("{", "{0", 1),
            modelIdentifier="LuGre",
            unzipDirectory=str(folder),
            instanceName="LuGre",
        )
        with pytest.raises(Exception, match="instantiate"):
            slave.instantiate()
    finally:
        slave.freeLibrary()
        shutil.rmtree(folder, ignore_errors=True)
