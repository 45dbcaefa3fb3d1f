"""The Python package against the FMUs, closed forms and the command line; and what it refuses."""

import copy
import doctest
import os
import pickle
import random
import subprocess
import sys
import threading
import zipfile
from importlib import import_module
from pathlib import Path

import numpy
import pandas
import pytest
import stribeck
from command_line import program

from examples.fmpy.coupling import FMUS, laws_in, open_fmu, path_of

LAWS = [str(law) for law in stribeck.laws()]
# For programs that find the package where these tests do.
ELSEWHERE = {**os.environ, "PYTHONPATH": str(Path(stribeck.__file__).parents[1])}
SAMPLES = 150
DT = 1e-3


def motion(law, seed):
    """Inputs of a law that reverse and come to rest, over the samples."""
    draw = numpy.random.default_rng(seed)
    time = DT * numpy.arange(SAMPLES)
    inputs = {}
    for name in stribeck.law(law).inputs:
        if name.startswith("normal_force"):
            inputs[name] = 10.0 + 5.0 * numpy.sin(40.0 * time)
        elif name.startswith("normal_"):
            inputs[name] = numpy.full(SAMPLES, 1.0 if name == "normal_z" else 0.0)
        elif name == "external_force":
            inputs[name] = draw.normal(0.0, 1.0, SAMPLES)
        else:
            inputs[name] = 0.02 * draw.normal(0.0, 1.0, SAMPLES) * numpy.sin(15.0 * time)
            inputs[name][40:60] = 0.0
    return inputs


def stepped(law, inputs, held):
    """The same through the law's FMU, call by call."""
    outputs = list(stribeck.law(law).outputs)
    with open_fmu(path_of(law)) as fmu:
        given = fmu.references(*inputs)
        is_real = {name: stribeck.law(law).outputs[name].kind == "real" for name in outputs}
        wanted = {name: fmu.references(name) for name in outputs}
        rows = []
        for sample in range(SAMPLES):
            fmu.slave.setReal(given, [float(values[sample]) for values in inputs.values()])
            read = [fmu.slave.getReal if is_real[name] else fmu.slave.getBoolean for name in outputs]
            rows.append([float(get(wanted[name])[0]) for get, name in zip(read, outputs, strict=True)])
            if sample + 1 < SAMPLES:
                slopes = [(values[sample + 1] - values[sample]) / DT for values in inputs.values()]
                if not held:
                    fmu.slave.setRealInputDerivatives(given, [1] * len(given), slopes)
                fmu.slave.doStep(DT * sample, DT)
    return numpy.array(rows).T


def test_the_catalogue_is_that_of_the_fmus():
    assert set(LAWS) == set(laws_in(FMUS))
    assert {str(model) for model in stribeck.models()} >= {"ShockAbsorber", "BeltRig", *LAWS}
    for law in stribeck.laws():
        assert " = " in law.equations, law.name
        assert "`" not in law.equations, law.name
        assert law.source, law.name
        assert repr(law).startswith(f"{law.name}: "), law.name
        assert law._repr_html_().count("<tr>") == 1 + len(law.inputs) + len(law.parameters)
        assert all(one.help and one.bound for one in law.variables.values()), law.name


@pytest.mark.parametrize("held", [True, False])
@pytest.mark.parametrize("law", LAWS)
def test_simulate_has_the_bits_of_the_fmu(law, held):
    inputs = motion(law, 15)
    result = stribeck.simulate(law, dt=DT, held=held, **inputs)
    expected = stepped(law, inputs, held)
    for name, column in zip(stribeck.law(law).outputs, expected, strict=True):
        assert result[name].tobytes() == column.tobytes(), name
    assert numpy.abs(result[next(name for name in result if name.startswith("friction_force"))]).max() > 0.1


def test_the_strut_has_the_bits_of_its_fmu():
    time = DT * numpy.arange(SAMPLES)
    inputs = {
        "length": 0.1775 + 0.01 * numpy.sin(40.0 * time),
        "velocity": 0.4 * numpy.cos(40.0 * time),
        "side_force_m": 100.0 * numpy.sin(9.0 * time),
    }
    zero = {name: 0.0 for name in stribeck.model("ShockAbsorber").inputs if name not in inputs}
    zero["temperature_ambient"] = 293.15
    result = stribeck.simulate(
        "ShockAbsorber", dt=DT, held=True, record="force", **inputs, **zero, **{"friction.model": "LuGre"}
    )
    with open_fmu(path_of("ShockAbsorber"), {"friction.model": "LuGre"}) as fmu:
        names = [*inputs, *zero]
        for sample in range(SAMPLES):
            values = [float(inputs[name][sample]) if name in inputs else zero[name] for name in names]
            fmu.slave.setReal(fmu.references(*names), values)
            (force,) = fmu.slave.getReal(fmu.references("force"))
            assert result["force"][sample] == force, sample
            fmu.slave.doStep(DT * sample, DT)


def test_runs_by_rows_are_those_of_single_runs_with_any_number_of_threads():
    inputs = motion("LuGre", 3)
    velocities = numpy.stack([inputs["velocity"] * factor for factor in (0.5, 1.0, 2.0)])
    stiffness = [1e4, 1e5, 3e5]
    together = [
        stribeck.simulate("LuGre", velocity=velocities, normal_force=10.0, sigma_0=stiffness, dt=DT, threads=threads)
        for threads in (1, 2, 7)
    ]
    for run, sigma_0 in enumerate(stiffness):
        alone = stribeck.simulate("LuGre", velocity=velocities[run], normal_force=10.0, sigma_0=sigma_0, dt=DT)
        for name in alone.columns:
            for result in together:
                assert result[name][run].tobytes() == alone[name].tobytes(), name


def test_times_may_be_uneven():
    time = numpy.cumsum([0.0, 1e-3, 5e-3, 1e-4])
    velocity = numpy.array([1e-3, 2e-3, -1e-3, 1e-3])
    result = stribeck.simulate("Dahl", velocity=velocity, normal_force=10.0, time=time)
    dahl = stribeck.Model("Dahl", normal_force=10.0)
    for sample in range(4):
        dahl.velocity = velocity[sample]
        assert result["friction_force"][sample] == dahl.friction_force
        if sample < 3:
            step = time[sample + 1] - time[sample]
            dahl.step(step, velocity=(velocity[sample + 1] - velocity[sample]) / step)


def test_steady_forces_are_closed_forms():
    velocity = numpy.array([-0.5, -1e-3, 1e-4, 0.02])
    mu_k, mu_s, v_s = 0.1, 0.15, 1e-3
    levels = mu_k + (mu_s - mu_k) * numpy.exp(-((numpy.abs(velocity) / v_s) ** 2))
    values = {"mu_k": mu_k, "mu_s": mu_s, "stribeck_velocity": v_s, "viscous_coefficient": 0.4}
    loads = numpy.array([[5.0], [20.0]])
    expected = loads * levels * numpy.sign(velocity) + 0.4 * velocity
    for law in ("Stribeck", "LuGre"):
        exponent = {"stribeck_exponent": 2.0} if "stribeck_exponent" in stribeck.law(law).parameters else {}
        forces = stribeck.force(law, velocity, loads, **values, **exponent)
        numpy.testing.assert_allclose(forces, expected, rtol=1e-8)
    assert stribeck.force("Coulomb", 0.0, 10.0, external_force=0.3) == 0.3
    assert isinstance(stribeck.force("Coulomb", 1.0, 10.0), float)
    with pytest.raises(stribeck.Refused, match="keep fluctuating"):
        stribeck.force("Bristle", 0.1, 10.0)


def within_itself():
    """A dictionary without an end."""
    values = {}
    values["mu_s"] = values
    return values


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: stribeck.law("Lugre"), r"model 'Lugre' does not exist \(did you mean 'LuGre'\?\)"),
        (lambda: stribeck.law("ShockAbsorber"), "ShockAbsorber is a shock absorber model, not a friction law"),
        (lambda: stribeck.force("LuGre", 1.0, 10.0, sigma0=1.0), "'sigma0' does not exist.*'sigma_0'"),
        (lambda: stribeck.force("LuGre", 1.0, -10.0), "normal_force = -10: must be >= 0 and finite"),
        (lambda: stribeck.force("LuGre", [1.0, numpy.nan], 10.0), "point 1: velocity = NaN: must be a finite number"),
        (lambda: stribeck.force("LuGre", [1.0, 2.0], [1.0] * 3), r"do not fit together: velocity \(2,\)"),
        (lambda: stribeck.force("Liang", 1.0, 10.0), "Liang has the inputs velocity_x"),
        (lambda: stribeck.simulate("LuGre", velocity=[0.0, 1.0], dt=1e-3), "LuGre needs the input normal_force"),
        (
            lambda: stribeck.simulate("Wojewoda", velocity=[0.0, 1.0], normal_force=1.0, dt=1e-3),
            "needs the input acceleration .for example numpy.gradient",
        ),
        (
            lambda: stribeck.simulate("LuGre", velocity=[0.0, 1.0], normal_force=[1.0] * 3, dt=1e-3),
            "numbers of samples differ: velocity 2, normal_force 3",
        ),
        (
            lambda: stribeck.simulate("LuGre", velocity=[0.0, 1.0], normal_force=1.0, dt=1e-3, mu_k=[0.1, -0.1]),
            "run 1: mu_k = -0.1: must be > 0 and finite",
        ),
        (
            lambda: stribeck.simulate("LuGre", velocity=[0.0, numpy.inf], normal_force=1.0, dt=1e-3),
            r"sample 1 \(t = 0.001 s\): velocity = inf",
        ),
        (lambda: stribeck.simulate("LuGre", velocity=0.0, normal_force=1.0, dt=0.0), "dt = 0.0 s: must be > 0"),
        (
            lambda: stribeck.simulate("LuGre", velocity=[0.0, 1.0, 2.0], normal_force=1.0, time=[0.0, 1.0, 1.0]),
            r"time\[2\] = 1.0 s after 1.0 s: must grow",
        ),
        (lambda: stribeck.simulate("LuGre", friction_force=1.0, dt=1.0), "friction_force is computed"),
        (lambda: stribeck.solve("belt", "LuGre", set={"mas": 1.0}), "'mas' does not exist .did you mean 'mass'"),
        (lambda: stribeck.solve("blet"), "system 'blet' does not exist .did you mean 'belt'"),
        (lambda: stribeck.solve("belt", solver="rodas"), "solver 'rodas' does not exist .did you mean 'rodas5p'"),
        (lambda: stribeck.solve("belt", tolerance=1e-6), "unknown field `tolerance`, expected one of .*`tol`"),
        (lambda: stribeck.solve("belt", vary="mu_s=0.1:0.2:3"), "vary: use stribeck.study"),
        (lambda: stribeck.compare("belt", []), "law names no friction law"),
        (lambda: stribeck.force("LuGre", [1.0], 1.0, threads=0), "threads = 0: must be >= 1"),
        (lambda: stribeck.force("LuGre", [1.0], 1.0, threads=-1), "threads = -1: must be >= 1"),
        (lambda: stribeck.solve("belt", until="soon"), 'invalid type: string "soon", expected f64 in `until`$'),
        (lambda: stribeck.solve("belt", set=within_itself()), "dictionaries and lists in more than 32 levels"),
        (lambda: stribeck.compare("belt", "LuGr"), "did you mean 'LuGre'"),
        (lambda: stribeck.ShockAbsorber().friction.mu_q, "did you mean 'friction.mu_"),
        (
            lambda: stribeck.simulate("LuGre", velocity=[], normal_force=1.0, dt=1.0),
            "samples: velocity 0: must be >= 1",
        ),
        (lambda: stribeck.simulate("LuGre", velocity=0.0, normal_force=1.0, dt=1.0, record=[]), "record names no"),
        (lambda: stribeck.solve("belt", every=1e-300), "every = 1e-300 s gives 4e301 rows: at most 20000000"),
        (
            lambda: stribeck.simulate("LuGre", velocity=[0.0, 1e-3, numpy.inf], normal_force=1.0, dt=1e-300),
            "t = 2e-300",
        ),
        (lambda: stribeck.solve("belt", tol=0.5), "tolerance = 5e-1: must be between"),
        (lambda: stribeck.solve("belt", tol=1e-14, check=True), "tolerance = 1e-14: a check needs a tenth of it"),
        (lambda: stribeck.Model("LuGre", mu_k=-1.0), "mu_k = -1: must be > 0 and finite"),
        (lambda: stribeck.Model("ShockAbsorber").friction.set_model, "'friction.set_model' does not exist"),
        (lambda: stribeck.Model("ShockAbsorber", **{"friction.model": "Lugre"}), "'Lugre' does not exist.*'LuGre'"),
        (lambda: stribeck.Model("LuGre", preset="none"), "preset of LuGre 'none' does not exist"),
        (lambda: stribeck.fmu("Lugre"), "did you mean 'LuGre'"),
    ],
)
def test_refusals_name_variable_value_and_limit(call, message):
    with pytest.raises(stribeck.Refused, match=message):
        call()
    assert issubclass(stribeck.Refused, ValueError)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: stribeck.force("Coulomb", numpy.ma.masked_equal([1.0, 2.0], 2.0), 1.0), "velocity: some .* masked"),
        (lambda: stribeck.simulate("Coulomb", velocity=0.0, normal_force=1.0, dt="x"), "dt = 'x': must be a number"),
        (
            lambda: stribeck.simulate("Coulomb", velocity=0.0, normal_force=1.0, dt="1e-3"),
            "dt = '1e-3': must be a number",
        ),
        (
            lambda: stribeck.simulate("Coulomb", velocity=0.0, normal_force=1.0, dt=1.0, held="no"),
            "held = 'no': must be",
        ),
        (lambda: stribeck.solve("belt", ["LuGre", "Dahl"]), "must be one law; stribeck.compare takes several"),
        (lambda: stribeck.Model("LuGre").step("1e-3"), "dt = '1e-3': must be a number"),
        (lambda: stribeck.Model("LuGre").step(1e-3, velocity="1"), "velocity = '1': must be a number"),
        (lambda: stribeck.solve("belt", set={"mu_k": None}), "set: mu_k: must be real number, not NoneType"),
        (lambda: stribeck.solve({"law": "LuGre"}), "system: must be a name or a path, not dict"),
        (
            lambda: stribeck.simulate(
                "Coulomb", velocity=0.0, normal_force=1.0, time=numpy.array(["2026-11-24"], "M8[s]")
            ),
            "time: must be numbers, in s, not datetime64",
        ),
    ],
)
def test_what_is_no_number_is_a_type_error(call, message):
    with pytest.raises(TypeError, match=message):
        call()


def test_names_that_do_not_exist_are_told_as_python_tells_them():
    assert not hasattr(stribeck.Model("LuGre"), "velocit")
    result = stribeck.simulate("LuGre", velocity=[0.0, 1e-3], normal_force=1.0, dt=1e-3)
    with pytest.raises(KeyError, match="'friction' is not among the results of LuGre .did you mean 'friction_force'"):
        result["friction"]
    with pytest.raises(KeyError, match="'Dahl' is not among the laws"):
        stribeck.compare("belt", "LuGre", until=0.1)["Dahl"]
    assert len({stribeck.law("LuGre"), stribeck.law("LuGre")}) == 1
    assert repr(stribeck.ShockAbsorber().bump).startswith("<bump of ShockAbsorber: ")


def test_numbers_and_arrays_of_numpy_describe_a_study(tmp_path):
    spec = {
        "samples": numpy.int64(3),
        "keep": ["max rig.position"],
        "vary": {"mu_s": {"uniform": numpy.array([0.12, 0.2])}},
        "run": {"until": numpy.float64(1.0)},
    }
    assert repr(stribeck.study(spec, tmp_path)).startswith("<study of 3 rows, 0 failed")


def test_a_thousand_bad_calls_raise_and_nothing_else():
    """Values, shapes and names at random: an exception of Python, or finite results."""
    draw = random.Random(15)
    bad = [
        None,
        "x",
        [],
        [[]],
        [[[1.0]]],
        numpy.nan,
        -numpy.inf,
        1e308,
        -1.0,
        object(),
        {},
        numpy.zeros((3, 0)),
        1j,
        b"1",
    ]
    good = [0.0, 1e-3, [0.0, 1.0], numpy.ones((2, 3)), True, numpy.float32(1.5), numpy.arange(3)]
    names = ["velocity", "normal_force", "mu_k", "sigma_0", "external_force", "variant", "mass", "nothing"]
    raised = 0
    for _ in range(1000):
        law = draw.choice([*LAWS, "ShockAbsorber", "x", ""])
        values = {name: draw.choice(draw.choice([bad, good])) for name in draw.sample(names, 4)}
        calls = [
            lambda: stribeck.simulate(law, dt=draw.choice([1e-3, 0.0, -1.0, None]), **values),  # noqa: B023
            lambda: stribeck.force(law, values.get("velocity", 1.0), 1.0),  # noqa: B023
            lambda: stribeck.Model(law, **values),  # noqa: B023
        ]
        try:
            result = draw.choice(calls)()
        except (ValueError, TypeError, OverflowError):
            raised += 1
        else:
            columns = result.columns.values() if isinstance(result, stribeck.Result) else []
            assert all(numpy.isfinite(column).all() for column in columns), (law, values)
    assert 500 < raised < 1000, raised


def test_results_that_do_not_fit_into_memory_are_refused():
    huge = numpy.broadcast_to(numpy.float64(0.0), (2**30, 2**24))
    with pytest.raises(MemoryError):
        stribeck.simulate("LuGre", velocity=huge, normal_force=1.0, dt=1e-3)


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda model: pickle.loads(pickle.dumps(model))])
def test_a_copy_of_a_model_goes_on_alone(copied):
    strut = stribeck.ShockAbsorber(**{"friction.model": "LuGre", "length": 0.1775, "velocity": 0.1})
    lag = stribeck.Model("FrictionalLag", normal_force=10.0, velocity=1e-3, mu_s=0.2)
    for model, force in [(strut, "force"), (lag, "friction_force")]:
        model.step(1e-3)
        other = copied(model)
        assert type(other) is type(model)
        before = other[force]
        for _ in range(20):
            model.step(1e-3, velocity=0.05)
        assert (other.time, other[force]) == (1e-3, before)
        for _ in range(20):
            other.step(1e-3, velocity=0.05)
        assert (other.time, other[force], other.velocity) == (model.time, model[force], model.velocity)
        assert model[force] != before


def test_threads_of_python_share_a_model():
    contact = stribeck.Model("LuGre", normal_force=10.0, velocity=0.01)

    def work():
        for _ in range(500):
            contact.step(1e-4)

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    alone = stribeck.Model("LuGre", normal_force=10.0, velocity=0.01)
    for _ in range(4000):
        alone.step(1e-4)
    assert (contact.friction_force, contact.dissipated_energy) == (alone.friction_force, alone.dissipated_energy)


def test_results_keep_their_numbers_while_others_are_made():
    """The memory of results that are gone is used again, that of others is not."""
    velocity = 5e-3 * numpy.sin(0.01 * numpy.arange(20_000))

    def force(law, mu_k):
        return stribeck.simulate(law, velocity=velocity, normal_force=1.0, dt=DT, mu_k=mu_k)["friction_force"]

    kept = [force("Coulomb", 0.1 + 0.01 * number) for number in range(5)]
    for number in range(20):
        force("Dahl", 0.2 + 0.01 * number)
        stribeck.force("Coulomb", velocity, 2.0)
    for number, values in enumerate(kept):
        expected = (0.1 + 0.01 * number) * numpy.sign(velocity)
        assert values.tobytes() == expected.tobytes(), number
    kept[0][:] = 1.0
    assert kept[0].flags.writeable
    assert numpy.abs(force("Coulomb", 0.3)).max() == 0.3


def test_calls_leave_no_memory_behind():
    resource = pytest.importorskip("resource")
    # Beyond what is used again without asking the system.
    velocity = numpy.zeros((2, 10_000))

    def calls(count):
        for _ in range(count):
            stribeck.simulate("LuGre", velocity=velocity, normal_force=1.0, dt=1e-3)
            with pytest.raises(stribeck.Refused):
                stribeck.simulate("LuGre", velocity=velocity, normal_force=-1.0, dt=1e-3)

    calls(5)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    calls(50)
    # 50 results of 20,000 samples and six columns would be 48 MB.
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 8_000


@pytest.mark.parametrize(
    ("system", "law", "options", "keywords"),
    [
        ("belt", "LuGre", [], {}),
        ("belt", "CoulombStiction", ["--set", "rig.mass=2", "--tol", "1e-6"], {"set": {"rig.mass": 2.0}, "tol": 1e-6}),
        ("two-blocks", "BrownMcPhee", ["--solver", "bdf"], {"solver": "bdf"}),
        (
            "pulled-mass",
            "MaxwellSlip",
            ["--solver", "co-simulation", "--step", "1e-3", "--until", "1", "--exchange", "parallel"],
            {"solver": "co-simulation", "step": 1e-3, "until": 1.0, "exchange": "parallel"},
        ),
    ],
)
def test_solve_has_the_bits_of_the_command_line(tmp_path, system, law, options, keywords):
    program("run", "--system", system, "--law", law, *options, "--out", tmp_path / "run.csv")
    table = numpy.genfromtxt(tmp_path / "run.csv", delimiter=",", names=True, deletechars="")
    heading = (tmp_path / "run.csv").read_text(encoding="utf-8").splitlines()[0].split(",")
    solution = stribeck.solve(system, law, **keywords)
    assert [f"{name} [{solution.units[name]}]" for name in solution] == heading
    for name, column in zip(solution, table.dtype.names, strict=True):
        assert solution[name].tobytes() == numpy.ascontiguousarray(table[column]).tobytes(), name


def test_stick_slip_is_that_of_the_closed_form():
    """First slip at (f_s / k) / v_b; each slip lasts (pi + 2 atan(v_b k / (w (f_s - f_C)))) / w."""
    solution = stribeck.solve("belt", "CoulombStiction", tol=1e-12)
    w, drop = 2.0**0.5, 0.05 * 9.81 / 2.0
    lasts = (numpy.pi + 2.0 * numpy.arctan(0.1 / (w * drop))) / w
    assert solution.events[0] == (pytest.approx(7.3575, abs=1e-9), "friction")
    assert solution.events[1][0] - solution.events[0][0] == pytest.approx(lasts, abs=1e-9)
    both = stribeck.compare("belt", ["CoulombStiction", "LuGre"], until=5.0)
    assert list(both) == ["CoulombStiction", "LuGre"]
    assert "2 laws" in repr(both)


def test_a_run_that_does_not_converge_says_so_and_keeps_its_motion():
    printed = {"variant": "Printed"}
    with pytest.raises(stribeck.NotConverged, match="did not converge at 3.7.*chatters") as caught:
        stribeck.solve("belt", "RooneyDeravi", set=printed)
    assert 3.7 < caught.value.solution.time[-1] < 3.8
    both = stribeck.compare("belt", ["RooneyDeravi", "Coulomb"], set=printed)
    assert list(both) == ["Coulomb"]
    assert list(both.failed) == ["RooneyDeravi"]
    assert "RooneyDeravi" not in both
    with pytest.raises(stribeck.NotConverged):
        both["RooneyDeravi"]
    lines = {line.get_label(): line for line in both.plot("rig.position").axes[0].lines}
    assert (
        lines["RooneyDeravi"].get_xdata()[-1] == both.failed["RooneyDeravi"].time[-1] < lines["Coulomb"].get_xdata()[-1]
    )
    assert (lines["RooneyDeravi"].get_linestyle(), lines["Coulomb"].get_linestyle()) == (":", "-")


def test_a_check_is_the_difference_from_a_finer_run():
    """Against two runs made by hand; straight lines are solved exactly."""
    coarse, fine = (stribeck.solve("belt", "LuGre", tol=tol) for tol in (1e-6, 6.3e-9))
    checked = stribeck.solve("belt", "LuGre", tol=1e-6, check=True)
    assert (checked.check.of, checked.check.finer, checked.check.end) == ("tolerance", pytest.approx(6.3e-9), "reached")
    assert (checked.check.fault, checked.fault, coarse.check) == (None, None, None)
    assert list(checked.check.differences) == list(checked.columns)
    for name, found in checked.check.differences.items():
        assert numpy.array_equal(checked[name], coarse[name])
        apart = numpy.abs(coarse[name] - fine[name])
        both = numpy.concatenate([coarse[name], fine[name]])
        assert found.largest == pytest.approx(apart.max(), rel=1e-6)
        assert found.part == pytest.approx(apart.max() / numpy.ptp(both), rel=1e-6)
        assert found.time == coarse.time[apart.argmax()]
    exact = stribeck.solve("belt", "Coulomb", check=True)
    assert exact.check.differences["rig.position"].part < 1e-12


def test_a_step_that_does_not_hold_is_no_solution():
    options = {"solver": "co-simulation", "step": 0.02, "check": True}
    with pytest.raises(stribeck.NotConverged, match=r"the step does not hold: .* steps of 0.002 s differs") as caught:
        stribeck.solve("belt", "LuGre", **options)
    solution = caught.value.solution
    assert (solution.end, solution.fault) == ("reached", solution.check.fault)
    assert solution.time[-1] == 40.0
    both = stribeck.compare("belt", ["LuGre", "Coulomb"], **{**options, "step": 0.01})
    assert (list(both), list(both.failed)) == (["Coulomb"], ["LuGre"])
    assert "LuGre: the step does not hold" in repr(both)


def test_the_step_that_is_found_is_right_and_a_larger_one_is_not():
    """Periods of runs made by hand, against the closed form: stiction's excess over the belt's speed, and the slip."""
    found = stribeck.find_step("belt", "CoulombStiction", exchange="parallel")["parallel"]
    assert found.trials[found.step] is None
    above = min(step for step in found.trials if step > found.step)
    assert " instead of " in found.trials[above]
    w, drop = 2.0**0.5, 0.05 * 9.81 / 2.0
    period = 2.0 * drop / 0.1 + 2.0 / w * (numpy.pi - numpy.arctan(drop * w / 0.1))
    assert found.deviations["period of friction"].solution == pytest.approx(period, rel=1e-3)
    options = {"solver": "co-simulation", "step": found.step, "exchange": "parallel", "every": 1e-3}
    run = stribeck.solve("belt", "CoulombStiction", **options)
    slips = numpy.flatnonzero(numpy.diff((numpy.abs(run["rig.velocity"]) > 4e-3).astype(int)) > 0)
    assert len(slips) > 3
    assert numpy.diff(run.time[slips]) == pytest.approx(period, rel=0.01)
    with pytest.raises(stribeck.Refused, match="step = find: is a search and no run"):
        stribeck.solve("belt", solver="co-simulation", step="find")


STUDY = {
    "samples": 1500,
    "seed": 3,
    "keep": ["max rig.position", "events"],
    "vary": {"mu_s": {"uniform": [0.12, 0.2]}, "rig.mass": {"log": [0.5, 2.0]}},
    "run": {"law": ["CoulombStiction"], "until": 5.0, "tol": 1e-6},
}


def test_a_study_is_that_of_its_runs_and_of_its_parts(tmp_path):
    table = stribeck.study(STUDY, tmp_path / "whole")
    assert len(table["row"]) == 1500
    assert set(table["end"]) == {"reached"}
    for row in (0, 700, 1499):
        values = {name: float(table[name][row]) for name in ("mu_s", "rig.mass")}
        alone = stribeck.solve("belt", "CoulombStiction", set=values, until=5.0, tol=1e-6)
        assert table["max rig.position"][row] == alone["rig.position"].max()
        assert table["events"][row] == len(alone.events)
    for shard in ("2/2", "1/2"):
        assert stribeck.study(STUDY, tmp_path / "parts", shard=shard, threads=1) is None
    assert stribeck.study(STUDY, tmp_path / "parts").path.read_bytes() == table.path.read_bytes()
    with pytest.raises(stribeck.Refused, match="belongs to another study"):
        stribeck.study({**STUDY, "seed": 4}, tmp_path / "whole")
    with pytest.raises(stribeck.Refused, match="did you mean 'mu_s'"):
        stribeck.study({**STUDY, "vary": {"mus": {"uniform": [0.12, 0.2]}}}, tmp_path / "none")


def test_an_interrupt_ends_a_long_call():
    """As Ctrl-C does: the call ends long before the run."""
    code = """
import numpy, os, signal, stribeck, threading
signal.signal(signal.SIGINT, signal.default_int_handler)  # programs in the background inherit that it is ignored
threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    stribeck.simulate("Bristle", velocity=numpy.ones((32, 1_000_000)), normal_force=1.0, dt=1e-3, record=["sticking"])
except KeyboardInterrupt:
    print("interrupted")
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=120, env=ELSEWHERE)
    assert done.stdout == "interrupted\n", done.stderr


def test_results_can_be_kept_and_drawn():
    result = stribeck.simulate("LuGre", dt=DT, **motion("LuGre", 1))
    pandas.testing.assert_frame_equal(result.to_xarray().to_dataframe(), result.to_pandas())
    again = pickle.loads(pickle.dumps(result))
    assert all(again[name].tobytes() == result[name].tobytes() for name in result)
    assert "not given" not in repr(result)
    unloaded = stribeck.simulate("Coulomb", velocity=[0.0, 1.0], normal_force=1.0, dt=DT)
    assert "external_force = 0 (not given)" in repr(unloaded)
    (axis,) = result.plot("friction_force", over="velocity").axes
    (line,) = axis.lines
    assert line.get_xdata().tobytes() == motion("LuGre", 1)["velocity"].tobytes()
    assert line.get_ydata().tobytes() == result["friction_force"].tobytes()
    assert (axis.get_xlabel(), axis.get_ylabel()) == ("velocity in m/s", "friction_force in N")


def overlapping(texts):
    """Pairs of texts of a picture that lie upon each other."""
    boxes = [text.get_window_extent() for text in texts if text.get_text()]
    return [(one, other) for at, one in enumerate(boxes) for other in boxes[:at] if one.overlaps(other)]


def test_no_text_of_a_picture_lies_upon_another():
    loop = stribeck.simulate("LuGre", velocity=motion("LuGre", 1)["velocity"] / 100, normal_force=[[1.0], [2.0]], dt=DT)
    for figure in (
        loop.plot(),
        loop.plot("friction_force", over="velocity"),
        stribeck.solve("belt", "CoulombStiction", until=20.0).plot(),
    ):
        figure.draw_without_rendering()
        axes = figure.axes
        assert not overlapping([axis.yaxis.label for axis in axes])
        for axis in (axes[-1].xaxis, *(one.yaxis for one in axes)):
            assert not overlapping([*axis.get_ticklabels(), axis.label])
    runs = [text.get_text() for text in loop.plot().axes[0].get_legend().get_texts()]
    assert runs == ["run 0", "run 1"]


def test_fmus_have_the_bytes_of_the_packed_ones(tmp_path):
    for model in stribeck.models():
        assert stribeck.fmu(model, tmp_path).read_bytes() == path_of(str(model)).read_bytes()
    (tmp_path / "LuGre.fmu").write_bytes(b"spoilt")
    assert zipfile.is_zipfile(stribeck.fmu("LuGre", tmp_path))
    assert not list(tmp_path.glob(".*"))


def test_many_processes_ask_for_an_fmu_at_once(tmp_path):
    code = f"import stribeck, sys; sys.stdout.write(str(len(stribeck.fmu('LuGre', {str(tmp_path)!r}).read_bytes())))"
    call = [sys.executable, "-c", code]
    asked = [subprocess.Popen(call, stdout=subprocess.PIPE, text=True, env=ELSEWHERE) for _ in range(16)]
    sizes = {one.communicate(timeout=120)[0] for one in asked}
    assert sizes == {str(path_of("LuGre").stat().st_size)}
    assert [file.name for file in tmp_path.iterdir()] == ["LuGre.fmu"]


@pytest.mark.parametrize("module", ["", ".batches", ".catalogue", ".series", ".systems", ".studies", ".instances"])
def test_examples_in_the_documentation(module):
    outcome = doctest.testmod(import_module(f"stribeck{module}"), optionflags=doctest.IGNORE_EXCEPTION_DETAIL)
    assert outcome.attempted > 0
    assert outcome.failed == 0


def test_the_interface_is_documented():
    for name in stribeck.__all__:
        if name != "__version__":
            assert getattr(stribeck, name).__doc__, name
