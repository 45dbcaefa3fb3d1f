"""Every packed FMU through fmpy, as used by an importer: alone, side by side, saved, differentiated, and misused."""

import math
import os
import re
import subprocess
import sys
from contextlib import ExitStack
from pathlib import Path

import numpy
import pytest
from fmpy import simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.validation import validate_fmu
from resume import drive

from examples.fmpy.coupling import (
    FMUS,
    PROJECT,
    CouplingError,
    friction_models_in,
    models_in,
    open_fmu,
    path_of,
    variables_of,
)

MODELS = models_in(FMUS)
FRICTION_MODELS = friction_models_in(FMUS)
WEIGHT = 9.81  # start value of the normal force, N


def outputs_of(fmu) -> list[float]:
    """All real outputs."""
    variables = fmu.description.modelVariables
    return fmu.slave.getReal([v.valueReference for v in variables if v.causality == "output" and v.type == "Real"])


def start(model: str, name: str) -> float:
    """Start value of a variable; 0 if the model has none of that name."""
    variable = variables_of(path_of(model)).get(name)
    return float(variable.start) if variable else 0.0


def kinetic(model: str) -> str | None:
    """Name of the kinetic coefficient of friction."""
    described = variables_of(path_of(model)).items()
    return next((name for name, one in described if one.description.startswith("Kinetic coefficient of fr")), None)


def coefficient(model: str, speed: float) -> float:
    """Kinetic coefficient of friction by default; for a rolling wheel that of its resistance, for rock that of steady
    sliding, mu_0 + (a - b) ln(v / v_0)."""
    if known := start(model, "mu_0"):
        slope = start(model, "direct_effect") - start(model, "evolution_effect")
        return known + slope * math.log(speed / start(model, "reference_velocity"))
    name = kinetic(model)
    return start(model, name) if name else start(model, "lever_arm") / start(model, "wheel_radius")


def test_the_models_of_the_library_are_there():
    assert set(MODELS) >= {"BeltRig", "BrownMcPhee", "CoulombStiction", "Dahl", "Karnopp", "LuGre"}


@pytest.mark.parametrize("model", MODELS)
def test_validates(model):
    assert validate_fmu(str(path_of(model))) == []


@pytest.mark.parametrize("model", MODELS)
def test_simulates_with_default_settings(model):
    outputs = [name for name, variable in variables_of(path_of(model)).items() if variable.causality == "output"]
    result = simulate_fmu(str(path_of(model)), stop_time=2.0, step_size=1e-3, output_interval=1e-2, output=outputs)
    assert len(result) == 201
    assert all(numpy.isfinite(result[name]).all() for name in outputs)


@pytest.mark.parametrize("velocity", [1.0, -1.0])
@pytest.mark.parametrize("model", FRICTION_MODELS)
def test_steady_sliding_resists_with_the_kinetic_level(model, velocity):
    signals = numpy.array(
        [(0.0, velocity, WEIGHT)], dtype=[("time", float), ("velocity", float), ("normal_force", float)]
    )
    result = simulate_fmu(str(path_of(model)), stop_time=1.0, output_interval=1e-2, input=signals)
    level = coefficient(model, abs(velocity)) * WEIGHT + start(model, "viscous_coefficient") * abs(velocity)
    # A random law has the level on average; four standard deviations of its force, sigma Delta sqrt(N / 18).
    noise = 0.0
    if "bristle_count" in variables_of(path_of(model)):
        count, stiffness = start(model, "bristle_count"), start(model, "mu_s") * WEIGHT / start(model, "delta")
        reach = 3.0 * start(model, "delta") * (1.0 - start(model, "mu_k") / start(model, "mu_s"))
        noise = 4.0 * stiffness / count * reach * numpy.sqrt(count / 18.0)
    expected = numpy.sign(velocity) * level
    assert result["friction_force"][-1] == pytest.approx(expected, rel=1e-5, abs=noise)


@pytest.mark.parametrize("model", FRICTION_MODELS)
def test_simulates_with_an_input_signal(model):
    """A slow stroke there and back: the force opposes the motion at both mid-strokes, and energy is dissipated."""
    time = numpy.linspace(0.0, 1.0, 101)
    columns = [("time", float), ("velocity", float)]
    signals = numpy.array(list(zip(time, 0.05 * numpy.sin(2.0 * numpy.pi * time), strict=True)), dtype=columns)
    result = simulate_fmu(
        str(path_of(model)),
        stop_time=1.0,
        output_interval=1e-2,
        input=signals,
        output=["friction_force", "dissipated_energy"],
    )
    level = coefficient(model, 0.05)
    assert result["friction_force"][25] > 0.9 * level * 10.0
    assert result["friction_force"][75] < -0.9 * level * 10.0
    path = 4.0 * 0.05 / (2.0 * numpy.pi)
    assert result["dissipated_energy"][-1] == pytest.approx(level * WEIGHT * path, rel=0.1)


def test_all_models_live_side_by_side():
    """With interleaved calls each model gives the same results as alone, to the bit."""
    alone = {}
    for model in MODELS:
        with open_fmu(path_of(model)) as fmu:
            drive(fmu, 0, 50)
            alone[model] = outputs_of(fmu)
    with ExitStack() as stack:
        together = {model: stack.enter_context(open_fmu(path_of(model))) for model in MODELS}
        for at in range(50):
            for fmu in together.values():
                drive(fmu, at, at + 1)
        assert {model: outputs_of(fmu) for model, fmu in together.items()} == alone


@pytest.mark.parametrize("model", MODELS)
def test_two_instances_of_a_model_do_not_affect_each_other(model):
    with open_fmu(path_of(model)) as moving, open_fmu(path_of(model)) as resting:
        before = outputs_of(resting)
        drive(moving, 0, 50)
        assert outputs_of(resting) == before
        drive(resting, 0, 50)
        assert outputs_of(resting) == outputs_of(moving)


def state_after(model: str, steps: int) -> tuple[bytes, str]:
    """The serialised state after some steps, and the outputs after as many more."""
    with open_fmu(path_of(model)) as fmu:
        drive(fmu, 0, steps)
        state = fmu.slave.getFMUstate()
        saved = fmu.slave.serializeFMUstate(state)
        fmu.slave.freeFMUstate(state)
        drive(fmu, steps, 2 * steps)
        return saved, " ".join(value.hex() for value in outputs_of(fmu))


@pytest.mark.parametrize("model", MODELS)
def test_a_saved_state_continues_in_another_process(model, tmp_path):
    """500 steps here, the next 500 there: bit for bit the same as 1000 steps here."""
    saved, expected = state_after(model, 500)
    file = tmp_path / "state.bin"
    file.write_bytes(saved)
    environment = {**os.environ, "PYTHONPATH": str(PROJECT)}
    resume = Path(__file__).with_name("resume.py")
    command = [sys.executable, str(resume), model, str(file), "500", "1000"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == expected.split()


def test_corrupted_states_are_rejected_and_change_nothing():
    """Every bit pattern with one changed bit per byte, and every wrong length; afterwards the run continues as
    before."""
    saved, expected = state_after("LuGre", 10)
    corrupted = [saved[:-1], saved + b"\0", b"", bytes(len(saved))]
    corrupted += [saved[:at] + bytes([saved[at] ^ 1]) + saved[at + 1 :] for at in range(len(saved))]
    with open_fmu(path_of("LuGre")) as fmu:
        drive(fmu, 0, 10)
        state, before = fmu.slave.getFMUstate(), outputs_of(fmu)
        fmu.slave.setDebugLogging(False, [])
        for data in corrupted:
            with pytest.raises(FMICallException):
                fmu.slave.deSerializeFMUstate(data)
            assert outputs_of(fmu) == before
        # After an error FMI requires a state that is known to be good.
        fmu.slave.setFMUstate(state)
        fmu.slave.freeFMUstate(state)
        drive(fmu, 10, 20)
        assert [value.hex() for value in outputs_of(fmu)] == expected.split()


def test_a_state_of_another_model_is_rejected():
    saved, _ = state_after("Dahl", 10)
    with pytest.raises(CouplingError, match="LuGre"), open_fmu(path_of("LuGre")) as fmu:
        fmu.slave.deSerializeFMUstate(saved)


def derivative(fmu, unknown: str, known: str) -> float:
    """Partial derivative from fmi2GetDirectionalDerivative."""
    return fmu.slave.getDirectionalDerivative(fmu.references(unknown), fmu.references(known), [1.0])[0]


def test_directional_derivatives_of_lugre():
    """With f = s0 z + s1 (v - s0 |v| z / g) + s2 v, g = f_C + (f_s - f_C) exp(-(v / v_S)^2), for v > 0."""
    s0, s1, s2, v_s, v = 1e5, 316.22776601683794, 0.1, 1e-3, 5e-4
    with open_fmu(path_of("LuGre")) as fmu:
        fmu.slave.setReal(fmu.references("velocity"), [v])
        fmu.slave.doStep(0.0, 0.01)
        z = fmu.slave.getReal(fmu.references("bristle_deflection"))[0]
        excess = 0.4905 * numpy.exp(-((v / v_s) ** 2))
        g, slope = 0.981 + excess, -2.0 * v / v_s**2 * excess
        by_velocity = s1 * (1.0 - s0 * z / g + s0 * v * z * slope / g**2) + s2
        by_load = s1 * s0 * v * z / (g * WEIGHT)
        assert derivative(fmu, "friction_force", "velocity") == pytest.approx(by_velocity, rel=1e-12)
        assert derivative(fmu, "friction_force", "normal_force") == pytest.approx(by_load, rel=1e-12)


def test_directional_derivative_of_brown_mcphee():
    """The slope of eq. (6.30): at rest (4 f_C + 16/9 (f_s - f_C)) / v_0, elsewhere with B = u^2 / 4 + 3 / 4."""
    with open_fmu(path_of("BrownMcPhee")) as fmu:
        assert derivative(fmu, "friction_force", "velocity") == pytest.approx(3924.0 + 872.0, rel=1e-12)
        fmu.slave.setReal(fmu.references("velocity"), [1.7e-3])
        u = 1.7
        b = u**2 / 4.0 + 0.75
        slope = (4.0 * 0.981 / numpy.cosh(4.0 * u) ** 2 + 0.4905 * (b - u**2) / b**3) / 1e-3
        # The hyperbolic tangent is 1 - 2.5e-6 here, so that its slope has lost six digits.
        assert derivative(fmu, "friction_force", "velocity") == pytest.approx(slope, rel=1e-9)


def test_directional_derivatives_of_coulomb_with_stiction():
    """Stuck, the force is the external force; sliding, it is mu_k times the normal force."""
    with open_fmu(path_of("CoulombStiction")) as fmu:
        fmu.slave.setReal(fmu.references("external_force"), [-0.7])
        assert derivative(fmu, "friction_force", "external_force") == 1.0
        assert derivative(fmu, "friction_force", "normal_force") == 0.0
        fmu.slave.setReal(fmu.references("velocity"), [-0.2])
        assert derivative(fmu, "friction_force", "external_force") == 0.0
        assert derivative(fmu, "friction_force", "normal_force") == -0.1
        assert derivative(fmu, "dissipated_power", "velocity") == pytest.approx(-0.981, rel=1e-15)


def test_input_derivatives_drive_the_rig_exactly():
    """A force f0 + f1 t on the oscillator: x = -(f0 + f1 t) / k + (f0 / k) cos w t + ((v0 + f1 / k) / w) sin w t."""
    k, w, v0, f0, f1, t = 2.0, numpy.sqrt(2.0), 0.1, 0.3, -0.8, 1.7
    with open_fmu(path_of("BeltRig")) as fmu:
        force = fmu.references("friction_force")
        fmu.slave.setReal(force, [f0])
        fmu.slave.setRealInputDerivatives(force, [1], [f1])
        fmu.slave.doStep(0.0, t)
        exact = -(f0 + f1 * t) / k + f0 / k * numpy.cos(w * t) + (v0 + f1 / k) / w * numpy.sin(w * t)
        assert fmu.slave.getReal(fmu.references("position"))[0] == pytest.approx(exact, abs=1e-14)


def test_input_derivatives_drive_dahl_as_the_distance_demands():
    """Dahl's force depends on the distance only: v = a t over 10 ms is a way of a t^2 / 2."""
    acceleration, t = 0.2, 0.01
    with open_fmu(path_of("Dahl")) as fmu:
        fmu.slave.setRealInputDerivatives(fmu.references("velocity"), [1], [acceleration])
        fmu.slave.doStep(0.0, t)
        exact = 0.981 * -numpy.expm1(-1e5 * 0.5 * acceleration * t**2 / 0.981)
        assert fmu.slave.getReal(fmu.references("friction_force"))[0] == pytest.approx(exact, rel=1e-8)


def test_output_derivatives_of_the_rig():
    """x' is the velocity, x'' = -(k x + f) / m, and the spring force changes with -k x'."""
    with open_fmu(path_of("BeltRig"), {"position": 0.2, "block_velocity": -0.3, "mass": 2.0}) as fmu:
        fmu.slave.setReal(fmu.references("friction_force"), [0.5])
        outputs = fmu.references("position", "block_velocity", "velocity", "external_force")
        rates = fmu.slave.getRealOutputDerivatives(outputs, [1] * 4)
        assert rates == pytest.approx([-0.3, -0.45, -0.45, 0.6], rel=1e-14)


def test_output_derivative_of_dahl():
    """df/dt = sigma_0 v (1 - f / f_C) for v > 0."""
    with open_fmu(path_of("Dahl")) as fmu:
        fmu.slave.setReal(fmu.references("velocity"), [1e-3])
        fmu.slave.doStep(0.0, 5e-3)
        force = fmu.references("friction_force")
        value = fmu.slave.getReal(force)[0]
        rate = fmu.slave.getRealOutputDerivatives(force, [1])[0]
        assert rate == pytest.approx(1e5 * 1e-3 * (1.0 - value / 0.981), rel=1e-12)


@pytest.mark.parametrize("model", FRICTION_MODELS)
def test_a_parameter_outside_its_bound_is_rejected_with_name_value_and_limit(model, capfd):
    parameter = kinetic(model) or ("mu_0" if start(model, "mu_0") else "lever_arm")
    refusal = f"{model}: fmi2SetReal: {parameter} = NaN: must be >=? 0 and finite"
    with pytest.raises(CouplingError, match=refusal):
        with open_fmu(path_of(model), {parameter: "nan"}):
            pass
    assert re.search(refusal + r" \[logStatusDiscard\]", capfd.readouterr().err)


@pytest.mark.parametrize("model", FRICTION_MODELS)
def test_an_input_outside_its_bound_is_rejected_and_the_old_value_stays(model, capfd):
    with open_fmu(path_of(model)) as fmu:
        load = fmu.references("normal_force")
        with pytest.raises(FMICallException):
            fmu.slave.setReal(load, [-1.0])
        assert fmu.slave.getReal(load) == [WEIGHT]
    assert (
        f"{model}: fmi2SetReal: normal_force = -1: must be >= 0 and finite [logStatusDiscard]" in capfd.readouterr().err
    )


@pytest.mark.parametrize("model", FRICTION_MODELS)
def test_a_slope_that_leads_an_input_out_of_its_bound_is_rejected(model):
    """From 20 N with -210 N/s the load would be -1 N after 0.1 s."""
    with pytest.raises(CouplingError, match="normal_force = -1: must be >= 0 and finite"):
        with open_fmu(path_of(model)) as fmu:
            inputs = fmu.references("velocity", "normal_force")
            fmu.slave.setReal(inputs, [2e-3, 20.0])
            fmu.slave.setRealInputDerivatives(inputs, [1, 1], [0.0, -210.0])
            fmu.slave.doStep(0.0, 0.1)


def test_the_reason_of_a_failed_call_becomes_the_text_of_the_error():
    with pytest.raises(CouplingError, match="Dahl: fmi2SetReal: normal_force = -1: must be >= 0 and finite"):
        with open_fmu(path_of("BeltRig")), open_fmu(path_of("Dahl")) as fmu, open_fmu(path_of("LuGre")):
            fmu.slave.setReal(fmu.references("normal_force"), [-1.0])


def test_inconsistent_parameters_are_rejected():
    with pytest.raises(CouplingError, match=r"mu_s = 0\.05.*mu_k = 0\.1"), open_fmu(path_of("LuGre"), {"mu_s": 0.05}):
        pass


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [("mu_k", -1.0, "mu_k = -1: must be > 0 and finite"), ("mu_s", 0.05, "mu_s = 0.05: must be >= mu_k = 0.1")],
)
def test_the_reason_is_logged_even_with_logging_off(name, value, reason):
    """In a separate process, with fmpy's defaults: loggingOn is false, messages are printed."""
    program = (
        f"from fmpy import simulate_fmu; simulate_fmu({str(path_of('LuGre'))!r}, start_values={{{name!r}: {value}}})"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert done.returncode != 0
    assert reason in done.stdout


def test_unknown_names_are_answered_with_the_known_ones():
    with pytest.raises(CouplingError, match="no FMU of the model 'Lugre' .* there are .*LuGre"):
        path_of("Lugre")
    with pytest.raises(CouplingError, match="LuGre has no parameter 'mu'; it has .*mu_k, mu_s"):
        with open_fmu(path_of("LuGre"), {"mu": 0.1}):
            pass
    with pytest.raises(CouplingError, match="exchange = 'Sideways': must be one of Sequential, Parallel"):
        with open_fmu(path_of("Karnopp"), {"exchange": "Sideways"}):
            pass
    with pytest.raises(CouplingError, match=r"mu_k = 'rough': must be a number \(Real\)"):
        with open_fmu(path_of("Karnopp"), {"mu_k": "rough"}):
            pass


def test_an_empty_folder_is_answered_with_the_command_that_fills_it(tmp_path):
    with pytest.raises(CouplingError, match="there is none: run `python3 tasks.py pack`"):
        path_of("LuGre", tmp_path)


def test_nothing_is_left_behind(tmp_path, monkeypatch):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    with open_fmu(path_of("LuGre")):
        assert len(list(tmp_path.iterdir())) == 1
    with pytest.raises(CouplingError), open_fmu(path_of("LuGre"), {"mu_k": -1.0}):
        pass
    assert list(tmp_path.iterdir()) == []
