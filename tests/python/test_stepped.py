"""Batches that the caller steps: beside single models, runs along samples, differences and formulas of numpy."""

import numpy
import pytest
import stribeck

RUNS = 70
DT = 1e-3
# In lanes, with and without memory of their own; with modes; with memory beside the row; one that knows its body.
LAWS = {
    "LuGre": {"sigma_0": [1e4, 1e5], "mu_k": [0.05, 0.12]},
    "Threlfall": {"mu_k": [0.05, 0.2]},
    "CoulombStiction": {"mass": [0.5, 2.0]},
    "ElastoPlastic": {"mu_k": [0.05, 0.12]},
    "MaxwellSlip": {"mu_k": [0.05, 0.12]},
}


def drawn(bounds):
    draw = numpy.random.default_rng(6)
    return {name: draw.uniform(*bound, RUNS) for name, bound in bounds.items()}


def velocities(steps=6):
    return 2e-3 * numpy.random.default_rng(7).normal(size=(steps, RUNS))


@pytest.mark.parametrize("law", LAWS)
def test_each_run_is_a_model_that_is_stepped_alone(law):
    values = drawn(LAWS[law])
    batch = stribeck.batch(law, RUNS, normal_force=10.0, **values)
    models = [
        stribeck.Model(law, normal_force=10.0, **{name: value[run] for name, value in values.items()})
        for run in range(RUNS)
    ]
    for number, velocity in enumerate(velocities()):
        forces = batch.step(DT, velocity=velocity)
        for model, one in zip(models, velocity, strict=True):
            model.velocity = one
            model.step(DT)
        assert forces.tolist() == [model.friction_force for model in models], number
        for name in ("dissipated_energy", "dissipated_power", "velocity", "mu_k"):
            assert batch[name].tolist() == [model[name] for model in models], name
        if number == 3:
            # Some begin anew, with the parameters that they have.
            mask = numpy.arange(RUNS) % 3 == 0
            batch.reset(mask)
            assert (batch.time == numpy.where(mask, 0.0, models[0].time)).all()
            for run in numpy.flatnonzero(mask):
                kept = {name: value[run] for name, value in values.items()}
                models[run] = stribeck.Model(law, normal_force=10.0, velocity=velocity[run], **kept)
            assert batch["friction_force"].tolist() == [model.friction_force for model in models]


def test_forces_before_each_step_are_those_of_a_run_along_samples():
    values, samples = drawn(LAWS["LuGre"]), velocities()
    batch = stribeck.batch("LuGre", RUNS, normal_force=10.0, **values)
    found = []
    for velocity in samples:
        batch.set(velocity=velocity)
        found.append(batch["friction_force"])
        batch.step(DT)
    wanted = stribeck.simulate("LuGre", velocity=samples.T, normal_force=10.0, dt=DT, held=True, **values)
    assert (wanted["friction_force"] == numpy.array(found).T).all()


def test_states_go_on_elsewhere():
    values, samples = drawn(LAWS["LuGre"]), velocities()
    one, other = (stribeck.batch("LuGre", RUNS, normal_force=10.0, **values) for _ in range(2))
    for velocity in samples[:3]:
        one.step(DT, velocity=velocity)
    other.set(**one.states())
    assert sorted(one.states()) == ["bristle_deflection", "dissipated_energy"]
    for velocity in samples[3:]:
        assert one.step(DT, velocity=velocity).tobytes() == other.step(DT, velocity=velocity).tobytes()
    many = stribeck.batch("MaxwellSlip", 2, distribution=2, element_count=100)
    with pytest.raises(stribeck.Refused, match="MaxwellSlip keeps more than its variables show"):
        many.states()


def test_results_go_into_arrays_of_the_caller():
    samples = velocities(4)
    batch, same = (stribeck.batch("Dahl", RUNS, normal_force=10.0) for _ in range(2))
    wanted = [same.step(DT, velocity=velocity) for velocity in samples]
    out = numpy.empty(RUNS)
    assert batch.step(DT, velocity=samples[0], out=out) is out
    assert out.tobytes() == wanted[0].tobytes()
    # Over the velocities, and every second one backwards.
    over = samples[1].copy()
    batch.step(DT, velocity=over, out=over)
    assert over.tobytes() == wanted[1].tobytes()
    apart = numpy.full(2 * RUNS, numpy.nan)
    batch.step(DT, velocity=samples[2], out=apart[::-2])
    assert apart[::-2].tobytes() == wanted[2].tobytes()
    assert numpy.isnan(apart[::2]).all()
    single = batch.step(DT, velocity=samples[3], dtype="float32")
    assert single.dtype == numpy.float32
    assert (single == wanted[3].astype(numpy.float32)).all()
    sticking = batch.get("dissipated_energy", out=out)
    assert sticking is out
    assert (out == same["dissipated_energy"]).all()


def test_a_gradient_through_many_steps_is_that_of_differences():
    """Forces of a body that friction stops, by its first velocity and by mu_k: derivatives of each step, chained."""
    mass, mu_k = 1.0, numpy.linspace(0.06, 0.12, 5)
    batch = stribeck.batch("LuGre", 5, normal_force=10.0, sigma_0=1e4)

    def end(first, mu_k, slopes=False):
        batch.reset()
        batch.set(mu_k=mu_k)
        velocity = numpy.full(5, first)
        # Derivatives of velocity and deflection by the first velocity and by mu_k.
        moved, bent = numpy.array([numpy.ones(5), numpy.zeros(5)]), numpy.zeros((2, 5))
        for _ in range(30):
            batch.set(velocity=velocity)
            if slopes:
                of, by = ["friction_force", "bristle_deflection"], ["velocity", "bristle_deflection", "mu_k"]
                force, state = batch.derivatives(by, of=of, dt=DT).values()
                direct = numpy.array([numpy.zeros(5), numpy.ones(5)])
                changes = [
                    one["velocity"] * moved + one["bristle_deflection"] * bent + one["mu_k"] * direct
                    for one in (force, state)
                ]
                moved, bent = moved - DT / mass * changes[0], changes[1]
            velocity = velocity - DT / mass * batch.step(DT)
        return moved if slopes else velocity

    found, change = end(0.02, mu_k, slopes=True), 1e-6
    by_velocity = (end(0.02 + change, mu_k) - end(0.02 - change, mu_k)) / (2.0 * change)
    by_mu = (end(0.02, mu_k + change) - end(0.02, mu_k - change)) / (2.0 * change)
    numpy.testing.assert_allclose(found[0], by_velocity, rtol=1e-5)
    numpy.testing.assert_allclose(found[1], by_mu, rtol=1e-5)


@pytest.mark.parametrize("law", ["LuGre", "CoulombStiction", "MaxwellSlip", "Threlfall"])
def test_present_derivatives_are_those_of_differences(law):
    batch = stribeck.batch(law, RUNS, normal_force=numpy.linspace(5.0, 15.0, RUNS), velocity=velocities(1)[0])
    batch.step(DT)
    slopes = batch.derivatives(["velocity", "normal_force", "mu_k"])["friction_force"]
    for name, slope in slopes.items():
        value = batch[name]
        forces = []
        for sign in (1.0, -1.0):
            batch.set(**{name: value + sign * 1e-6 * numpy.abs(value)})
            forces.append(batch["friction_force"])
        batch.set(**{name: value})
        difference = (forces[0] - forces[1]) / (2e-6 * numpy.abs(value))
        numpy.testing.assert_allclose(slope, difference, rtol=1e-5, atol=1e-5 * numpy.abs(difference).max() + 1e-12)


def test_what_is_refused_names_run_variable_value_and_limit():
    batch = stribeck.batch("LuGre", RUNS, normal_force=10.0)
    before = batch.step(DT, velocity=1e-3)
    broken = numpy.where(numpy.arange(RUNS) == 41, numpy.nan, 5e-3)
    refusals = {
        "run 41: velocity = NaN: must be a finite number": lambda: batch.step(DT, velocity=broken),
        "run 0: mu_k = -1: must be > 0 and finite": lambda: batch.set(sigma_0=1e4, mu_k=-1.0),
        r"velocity has the shape \(3,\): must be one number, or \(70,\)": lambda: batch.step(DT, velocity=[1, 2, 3]),
        "mu_k is not an input: set it between steps": lambda: batch.step(DT, mu_k=0.1),
        "variable of LuGre 'speed' does not exist": lambda: batch.step(DT, speed=0.1),
        "friction_force is computed and cannot be set": lambda: batch.set(friction_force=1.0),
        "dt = 0.0 s: must be > 0 and finite": lambda: batch.step(0.0, velocity=5e-3),
        "run 0: friction_force = .*: beyond the largest number of float32": lambda: batch.step(
            DT, velocity=1e40, normal_force=1e40, dtype="float32"
        ),
        r"mask has the shape \(2,\): must be \(70,\)": lambda: batch.reset([True, False]),
        "friction_force is computed: derivatives are by": lambda: batch.derivatives("friction_force"),
        "sticking has no derivative": lambda: batch.derivatives("velocity", of="sticking"),
        "out: friction_force has the shape": lambda: batch.step(DT, out=numpy.empty(3)),
    }
    for text, call in refusals.items():
        with pytest.raises(stribeck.Refused, match=text):
            call()
    assert (batch.time == DT).all()
    assert (batch["velocity"] == 1e-3).all()
    assert batch["friction_force"].tobytes() == before.tobytes()
    for text, call in {
        "runs = 0": lambda: stribeck.batch("LuGre", 0),
        "record: force is not among the outputs of LuGre": lambda: stribeck.batch("LuGre", 2, record="force"),
        "has modes, whose steps have no derivatives": lambda: stribeck.batch("ElastoPlastic", 2).derivatives(
            "velocity", dt=DT
        ),
    }.items():
        with pytest.raises(stribeck.Refused, match=text):
            call()
    with pytest.raises(TypeError, match="mask: must be Booleans"):
        batch.reset([0, 1])
