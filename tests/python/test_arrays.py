"""Arrays that the Python package reads and fills: steady sliding by formulas of numpy, and arrays of the caller."""

import numpy
import pytest
import stribeck
from numpy.lib.stride_tricks import as_strided

# Enough for several threads, with a remainder for every width of registers; all sizes, both directions, rest.
POINTS = 50_003
TIME = 1e-3 * numpy.arange(40)
# Each input of a law along samples, with many runs.
MOTION = {"velocity": 1e-3 * numpy.sin(30.0 * TIME), "normal_force": 10.0, "dt": 1e-3}


def velocities():
    draw = numpy.random.default_rng(5)
    values = 10.0 ** draw.uniform(-8.0, 1.5, POINTS) * draw.choice([-1.0, 1.0], POINTS)
    values[::1000] = 0.0
    return values


def fade(v):
    return numpy.exp(-((v / 1e-3) ** 2))


def level(v, f_c=1.0, f_s=1.5):
    return f_c + (f_s - f_c) * fade(v)


# Forces of steady sliding as the papers print them, at f_n = 10 N with mu_k = 0.1 and mu_s = 0.15.
STEADY = {
    "LuGre": lambda v: level(v) * numpy.sign(v) + 0.1 * v,
    "ElastoPlastic": lambda v: level(v) * numpy.sign(v) + 0.1 * v,
    "Dahl": numpy.sign,
    "Dankowicz": numpy.sign,
    "BlimanSorine": numpy.sign,
    "ResetIntegrator": numpy.sign,
    "CoulombStiction": numpy.sign,
    "CoulombViscous": lambda v: numpy.sign(v) + 0.1 * v,
    "Stribeck": lambda v: level(v) * numpy.sign(v),
}


@pytest.mark.parametrize("law", STEADY)
def test_steady_sliding_of_many_points(law):
    v = velocities()
    levels = {name: value for name, value in (("mu_k", 0.1), ("mu_s", 0.15)) if name in stribeck.law(law).parameters}
    forces = stribeck.force(law, v, 10.0, **levels)
    # Of a bristle a rounding error of the velocity is left, times its damping of 316 N.s/m.
    assert (numpy.abs(forces - STEADY[law](v)) / (1.0 + numpy.abs(v))).max() < 2e-13
    # The same bits one by one, by any number of threads, and where the loads are an array as well.
    some = slice(3, 200)
    assert [stribeck.force(law, one, 10.0, **levels) for one in v[some]] == list(forces[some])
    assert stribeck.force(law, v, 10.0, threads=1, **levels).tobytes() == forces.tobytes()
    assert stribeck.force(law, v, numpy.full(POINTS, 10.0), **levels).tobytes() == forces.tobytes()


def test_forces_go_into_arrays_of_the_caller():
    v = velocities()
    wanted = stribeck.force("LuGre", v, 10.0)
    out = numpy.full(POINTS, numpy.nan)
    assert stribeck.force("LuGre", v, 10.0, out=out) is out
    assert out.tobytes() == wanted.tobytes()
    # Every second one, backwards; over the velocities; from overlapping ones.
    apart = numpy.full((2 * POINTS,), numpy.nan)
    stribeck.force("LuGre", v, 10.0, out=apart[::-2])
    assert apart[::-2].tobytes() == wanted.tobytes()
    assert numpy.isnan(apart[::2]).all()
    over = v.copy()
    stribeck.force("LuGre", over, 10.0, out=over)
    assert over.tobytes() == wanted.tobytes()
    buffer = numpy.append(v, 0.0)
    stribeck.force("LuGre", buffer[:-1], 10.0, out=buffer[1:])
    assert buffer[1:].tobytes() == wanted.tobytes()
    single = stribeck.force("LuGre", v, 10.0, dtype="float32")
    assert single.dtype == numpy.float32
    assert (single == wanted.astype(numpy.float32)).all()


@pytest.mark.parametrize("runs", [None, 37])
@pytest.mark.parametrize("law", ["LuGre", "Coulomb", "ElastoPlastic"])
def test_results_go_into_arrays_of_the_caller(law, runs):
    drawn = {} if runs is None else {"mu_k": numpy.linspace(0.05, 0.1, runs)}
    wanted = stribeck.simulate(law, **MOTION, **drawn)
    shape = wanted["friction_force"].shape
    power, sticking = numpy.empty(shape), numpy.empty(shape, numpy.float32)
    found = stribeck.simulate(law, **MOTION, **drawn, out={"dissipated_power": power, "sticking": sticking})
    assert found["dissipated_power"] is power
    assert found["sticking"] is sticking
    assert (sticking == wanted["sticking"]).all()
    for name in ("friction_force", "dissipated_energy", "dissipated_power"):
        assert found[name].tobytes() == wanted[name].tobytes()
    force = numpy.empty(shape)
    alone = stribeck.simulate(law, **MOTION, **drawn, record="friction_force", out=force)
    assert alone["friction_force"] is force
    assert force.tobytes() == wanted["friction_force"].tobytes()
    small = stribeck.simulate(law, **MOTION, **drawn, dtype=numpy.float32)
    assert all((small[name] == wanted[name].astype(numpy.float32)).all() for name in wanted if name != "time")


def frozen():
    array = numpy.empty(2)
    array.flags.writeable = False
    return array


def test_results_over_inputs_leave_the_inputs_as_they_were():
    """Velocity and time of a result are those of the call, whatever was written over the arrays."""
    velocity, time = numpy.array([1e-3, 2e-3, -1e-3]), numpy.array([0.0, 0.1, 0.25])
    wanted = stribeck.simulate("LuGre", velocity=velocity, normal_force=1.0, time=time, record="friction_force")
    for over in (velocity.copy(), time.copy()):
        given = {"velocity": velocity, "time": time} | {"velocity" if over[0] else "time": over}
        result = stribeck.simulate("LuGre", **given, normal_force=1.0, record="friction_force", out=over)
        assert over.tobytes() == result["friction_force"].tobytes() == wanted["friction_force"].tobytes()
        assert (result.inputs["velocity"] == velocity).all()
        assert (result["time"] == time).all()


def test_a_dead_time_is_waited_for():
    """A force that follows the past by seconds is that of long sliding."""
    held = stribeck.simulate(
        "Armstrong", velocity=numpy.full(401, 0.01), normal_force=5.0, dt=1.0, held=True, time_lag=3.0, mu_s=1.0
    )
    force = stribeck.force("Armstrong", 0.01, 5.0, time_lag=3.0, mu_s=1.0)
    assert force == pytest.approx(held["friction_force"][-1], rel=1e-6)


def overlapping():
    memory = numpy.empty(len(MOTION["velocity"]) + 1)
    return {"friction_force": memory[:-1], "dissipated_power": memory[1:]}


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (
            lambda _: stribeck.simulate("LuGre", **MOTION, out=overlapping()),
            ValueError,
            "friction_force and dissipated_power share memory",
        ),
        (
            lambda _: stribeck.force("LuGre", [1.0, 2.0], 1.0, out=as_strided(numpy.empty(1), (2,), (0,))),
            ValueError,
            "friction_force has several elements in one place",
        ),
        (
            lambda out: stribeck.force("LuGre", [1.0, 2.0], 1.0, out=out[:1]),
            ValueError,
            r"shape \(1,\): must be \(2,\)",
        ),
        (
            lambda out: stribeck.force("LuGre", [1.0, 2.0], 1.0, out=out.astype(int)),
            TypeError,
            "int64: must be float64",
        ),
        (lambda _: stribeck.force("LuGre", [1.0, 2.0], 1.0, out=[0.0, 0.0]), TypeError, "array of numpy, not list"),
        (lambda _: stribeck.force("LuGre", [1.0, 2.0], 1.0, out=frozen()), ValueError, "friction_force is read-only"),
        (lambda _: stribeck.force("LuGre", 1.0, 1.0, dtype="int32"), TypeError, "int32: must be float64 or float32"),
        (
            lambda out: stribeck.force("LuGre", [1.0, 2.0], 1.0, out=out, dtype="float32"),
            TypeError,
            "float64: must be float32",
        ),
        (
            lambda _: stribeck.force("Coulomb", [0.0, 1.0], 1e41, dtype="float32"),
            ValueError,
            "friction_force has values beyond the largest number of float32",
        ),
        (lambda out: stribeck.simulate("LuGre", **MOTION, out=out), ValueError, "out: must be a mapping from names"),
        (
            lambda out: stribeck.simulate("LuGre", **MOTION, out={"force": out}),
            ValueError,
            "force is not among the results",
        ),
        (
            lambda _: stribeck.simulate("Coulomb", **MOTION | {"normal_force": 1e41}, dtype="float32"),
            ValueError,
            "friction_force has values beyond the largest number of float32",
        ),
        (
            lambda _: stribeck.force("LuGre", numpy.append(velocities(), numpy.inf), 1.0),
            ValueError,
            f"point {POINTS}: velocity = inf: must be a finite number",
        ),
        (
            lambda _: stribeck.force("LuGre", numpy.append(velocities(), 1e200), 1.0),
            ValueError,
            f"point {POINTS}: the outputs of steady sliding would not be finite at velocity = 1e200",
        ),
        (
            lambda _: stribeck.force("LuGre", velocities(), numpy.append([-1.0], numpy.ones(POINTS - 1))),
            ValueError,
            "point 0: normal_force = -1: must be >= 0",
        ),
    ],
)
def test_what_does_not_fit_is_refused(call, error, message):
    with pytest.raises(error, match=message):
        call(numpy.zeros(2))
