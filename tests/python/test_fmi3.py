"""FMUs of FMI 3.0 beside those of FMI 2.0: the same bits for the same steps, states and derivatives; arrays and their
sizes; FMPy's own loops."""

from ctypes import c_double

import pytest
from events import CASES, H
from exchange import open_part
from fmi3 import FOLDER, integrating, open_instance, stepping
from fmpy import simulate_fmu
from fmpy.validation import validate_fmu
from numpy.testing import assert_array_equal
from reference import Reference

from examples.fmpy.coupling import models_in, open_fmu, path_of

MODELS = models_in(FOLDER)


@pytest.mark.parametrize("model", MODELS)
def test_steps_have_the_bits_of_fmi_2(model):
    """The reference results, which test_reference_results.py compares with the FMUs of FMI 2.0."""
    expected = Reference.of(path_of(model, FOLDER))
    assert expected == Reference.of(path_of(model))
    moved = [name for name in expected.inputs if name != "time"]
    shown = [name for name in expected.outputs if name != "time"]
    with stepping(model, {name: [expected.inputs[name][0]] for name in moved}) as instance:
        assert [instance.get(name) for name in shown] == [[expected.outputs[name][0]] for name in shown]
        for row, (time, step) in enumerate(expected.steps):
            for name in moved:
                instance.set(name, [expected.inputs[name][row]])
            event, terminates, early, reached = instance.fmu.doStep(time, step)
            # Without event mode nothing is asked of the importer.
            assert (event, terminates, early) == (False, False, False)
            assert reached == pytest.approx(time + step, rel=1e-12)
            assert [instance.get(name) for name in shown] == [[expected.outputs[name][row + 1]] for name in shown]


EXCHANGED = ["LuGre", "Coulomb", "MaxwellSlip", "Leuven", "CylinderFriction", "BeltRig", "ShockAbsorber", "QuarterCar"]


@pytest.mark.parametrize("model", EXCHANGED)
def test_states_derivatives_and_indicators_are_those_of_fmi_2(model):
    """Element by element, also where FMI 3.0 has arrays; and the same through the variables of that name."""
    with open_part(model) as old, integrating(model) as new:
        states, indicators = new.fmu.getNumberOfContinuousStates(), new.fmu.getNumberOfEventIndicators()
        assert (states, indicators) == (old.states, old.indicators)

        def read(call, count: int) -> list[float]:
            values = (c_double * count)()
            call(values, count)
            return list(values)

        shifted = [value + 1e-7 * (1 + place) for place, value in enumerate(old.x)]
        old.x = shifted
        new.fmu.setContinuousStates((c_double * states)(*shifted), states)
        assert read(new.fmu.getContinuousStates, states) == shifted
        assert_array_equal(read(new.fmu.getContinuousStateDerivatives, states), old.rates())
        assert_array_equal(read(new.fmu.getEventIndicators, indicators), old.event_indicators())
        if indicators:
            assert new.get("event_indicators") == read(new.fmu.getEventIndicators, indicators)
        rates = [unknown.variable.name for unknown in new.description.derivatives]
        assert [rate for name in rates for rate in new.get(name)] == list(old.rates())


def test_a_table_is_one_array():
    """Read, set and used as one by one in FMI 2.0."""
    points = [-2.0, -0.5, 0.0, 0.5, 1.5, *[0.0] * 11]
    forces = [-900.0, -300.0, 0.0, 400.0, 900.0, *[0.0] * 11]
    scalars = {f"damper.tab_v[{i}]": value for i, value in enumerate(points, start=1)}
    scalars |= {f"damper.tab_f[{i}]": value for i, value in enumerate(forces, start=1)}
    scalars |= {"damper.mode": 2, "damper.tab_n": 5, "velocity": 0.3}
    arrays = {name: [value] for name, value in scalars.items() if "[" not in name}
    with (
        open_fmu(path_of("ShockAbsorber"), scalars) as old,
        stepping("ShockAbsorber", arrays | {"damper.tab_v": points, "damper.tab_f": forces}) as new,
    ):
        assert new.get("damper.tab_v") == points
        assert new.get("damper.tab_size") == [16.0]
        for at in range(5):
            old.slave.doStep(at * 1e-3, 1e-3)
            new.fmu.doStep(at * 1e-3, 1e-3)
        shown = ["force", "force_damper", "dissipated_energy"]
        assert [new.get(name)[0] for name in shown] == old.slave.getReal(old.references(*shown))


def test_a_table_may_be_made_shorter():
    """In configuration mode, to no less than what is in use."""
    points, forces = [-1.0, 0.0, 1.0], [-500.0, 0.0, 700.0]
    with open_instance("HydraulicDamper", {"damper.mode": [2], "velocity": [0.5]}) as instance:
        instance.set("damper.tab_n", [3])
        instance.fmu.enterConfigurationMode()
        instance.set("damper.tab_size", [3])
        instance.fmu.exitConfigurationMode()
        instance.set("damper.tab_v", points)
        instance.set("damper.tab_f", forces)
        instance.fmu.enterInitializationMode(startTime=0.0)
        instance.fmu.exitInitializationMode()
        assert instance.get("damper.tab_v", count=3) == points
        # Half way between the points; the force opposes the motion.
        assert abs(instance.get("force")[0]) == pytest.approx(350.0, rel=1e-12)


def test_derivatives_forwards_and_backwards_are_those_of_fmi_2():
    """One number each, and both directions agree."""
    with open_fmu(path_of("LuGre")) as old, stepping("LuGre") as new:
        old.slave.setReal(old.references("velocity"), [5e-4])
        old.slave.doStep(0.0, 0.01)
        new.set("velocity", [5e-4])
        new.fmu.doStep(0.0, 0.01)
        for known in ("velocity", "normal_force", "bristle_deflection"):
            of, by = old.references("friction_force"), old.references(known)
            expected = old.slave.getDirectionalDerivative(of, by, [1.0])
            assert new.fmu.getDirectionalDerivative(of, by, [1.0]) == expected
            assert new.fmu.getAdjointDerivative(of, by, [1.0]) == expected


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
@pytest.mark.parametrize("model", ["LuGre", "Karnopp", "BeltRig", "ShockAbsorber", "MaxwellSlip"])
def test_fmpy_runs_both_kinds(model, kind):
    path = str(FOLDER / f"{model}.fmu")
    output = ["velocity"] if model == "BeltRig" else ["dissipated_energy"]
    result = simulate_fmu(path, fmi_type=kind, stop_time=0.1, output_interval=1e-3, output=output)
    assert len(result) == 101
    old = simulate_fmu(str(path_of(model)), fmi_type=kind, stop_time=0.1, output_interval=1e-3, output=output)
    for name in output:
        assert result[name][-1] == pytest.approx(old[name][-1], rel=1e-6, abs=1e-12)


@pytest.mark.parametrize("case", CASES)
def test_contacts_stick_and_slip_at_the_times_of_the_closed_form(case):
    """In FMPy's own loop."""
    model, start, time, sticks = CASES[case]
    rows = simulate_fmu(
        str(FOLDER / f"{model}.fmu"),
        fmi_type="CoSimulation",
        start_values=start,
        output=["sticking"],
        output_interval=H,
        stop_time=0.5,
        use_event_mode=True,
        early_return_allowed=True,
    )
    event = next(row for row in rows if row["sticking"] == sticks and row["time"] > 0.0)
    assert event["time"] == pytest.approx(time, abs=1e-9)


@pytest.mark.parametrize("model", ["LuGre", "ShockAbsorber"])
def test_validates(model):
    assert validate_fmu(str(FOLDER / f"{model}.fmu")) == []
