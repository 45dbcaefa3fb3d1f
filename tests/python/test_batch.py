"""Batches of the Python package against formulas in 50 digits, and with and without the registers of the processor."""

import os
import subprocess
import sys
from pathlib import Path

import mpmath
import numpy
import pytest
import stribeck
from mpmath import mpf

ROWS = 64
LOAD, MU_K, MU_S = 10.0, 0.1, 0.15
# Error allowed, as a part of the static level: that of a number and of the few operations after it.
ALLOWED = 4e-15
# Laws that run in the lanes of registers, with and without memory, and one that does not.
LAWS = ["Threlfall", "BrownMcPhee", "Specker", "Andersson", "LuGre", "Dahl", "ElastoPlastic"]


def velocities():
    """Of all sizes around the transitions, in both directions, and rest."""
    draw = numpy.random.default_rng(8)
    sizes = 10.0 ** draw.uniform(-7.0, 0.5, ROWS)
    return numpy.append(sizes * draw.choice([-1.0, 1.0], ROWS), 0.0)


def threlfall(v, f_c, _f_s):
    v_0 = mpf(0.002)
    return f_c * (1 - mpmath.exp(-3 * abs(v) / v_0)) * mpmath.sign(v)


def brown_mcphee(v, f_c, f_s):
    u = v / mpf(0.002)
    return f_c * mpmath.tanh(4 * u) + (f_s - f_c) * u / (u * u / 4 + mpf(3) / 4) ** 2


def specker(v, f_c, f_s):
    v_0, v_sp = mpf(0.002), mpf(0.003)
    peak = f_s - f_c * mpmath.tanh(v_sp / v_0)
    u = v / v_sp
    return f_c * mpmath.tanh(v / v_0) + peak * u * mpmath.exp((1 - u * u) / 2)


@pytest.mark.parametrize(
    ("law", "formula", "values"),
    [
        ("Threlfall", threlfall, {"transition_velocity": 0.002}),
        ("BrownMcPhee", brown_mcphee, {"transition_velocity": 0.002, "mu_s": MU_S}),
        ("Specker", specker, {"transition_velocity": 0.002, "peak_velocity": 0.003, "mu_s": MU_S}),
    ],
)
def test_forces_are_those_of_50_digits(law, formula, values):
    mpmath.mp.dps = 50
    v = velocities()
    f_c, f_s = mpf(MU_K) * mpf(LOAD), mpf(MU_S) * mpf(LOAD)
    exact = [formula(mpf(float(one)), f_c, f_s) for one in v]
    found = stribeck.force(law, v, LOAD, mu_k=MU_K, **values)
    errors = [abs(mpf(float(one)) - other) / f_s for one, other in zip(found, exact, strict=True)]
    print(f"figure: {law}: largest error {float(max(errors)):.1e} of the level")
    assert max(errors) < ALLOWED
    # One by one, by another way: with a parameter per point nothing is made side by side.
    alone = stribeck.force(law, v, LOAD, mu_k=numpy.full(v.shape, MU_K), **values)
    assert alone.tobytes() == found.tobytes()


def test_a_step_of_bristles_is_that_of_50_digits():
    """dz/dt = v - sigma_0 |v| z / g(v) over a step, and the force after it."""
    mpmath.mp.dps = 50
    v, h, sigma_0, v_s = velocities(), 1e-4, 1e5, 1e-3
    result = stribeck.simulate(
        "LuGre",
        velocity=v[:, None],
        normal_force=LOAD,
        mu_k=MU_K,
        mu_s=MU_S,
        sigma_0=sigma_0,
        sigma_1=0.0,
        viscous_coefficient=0.0,
        stribeck_velocity=v_s,
        time=[0.0, h],
        held=True,
        record="friction_force",
    )
    step = mpf([0.0, h][1])
    for speed, force in zip(v, result["friction_force"][:, 1], strict=True):
        speed = mpf(float(speed))
        g = mpf(LOAD) * (mpf(MU_K) + (mpf(MU_S) - mpf(MU_K)) * mpmath.exp(-((speed / mpf(v_s)) ** 2)))
        exact = g * mpmath.sign(speed) * -mpmath.expm1(-mpf(sigma_0) * abs(speed) * step / g)
        assert abs(mpf(float(force)) - exact) / (mpf(MU_S) * mpf(LOAD)) < ALLOWED, speed


HUGE = [0.0, 1.0, -1e-3, 1e155, -1e155, 1.7e308, -1.7e308]
MEMORYLESS = [law.name for law in stribeck.laws() if "external_force" in law.inputs]


@pytest.mark.parametrize("law", MEMORYLESS)
def test_numbers_near_the_largest_one_are_refused_as_in_steps(law):
    """Forces without the energy are made side by side, without steps; with it step by step, as in the FMU."""
    draw = numpy.random.default_rng(4)
    refused = 0
    for held, dt in [(False, 1e-3), (True, 1e-3), (False, 1e300), (True, 1e-300)] * 8:
        inputs = {name: draw.choice(HUGE, 20) for name in stribeck.law(law).inputs}
        inputs["normal_force"] = numpy.abs(inputs["normal_force"])
        found = []
        for record in (["friction_force"], ["friction_force", "dissipated_energy"]):
            try:
                result = stribeck.simulate(law, dt=dt, held=held, record=record, **inputs)
                found.append(result["friction_force"].tobytes())
            except stribeck.Refused as reason:
                found.append(str(reason))
        assert found[0] == found[1]
        refused += isinstance(found[0], str)
    assert refused > 0


CODE = """
import hashlib, numpy, stribeck
draw = numpy.random.default_rng(3)
velocity = 5e-3 * draw.normal(size=(37, 41))
found = hashlib.sha256()
for law in {laws}:
    for held in (True, False):
        result = stribeck.simulate(law, velocity=velocity, normal_force=10.0, dt=1e-3, held=held)
        for name in result.columns:
            found.update(result[name].tobytes())
    found.update(stribeck.force(law, velocity, 10.0).tobytes())
print(found.hexdigest())
"""


def test_the_bits_are_the_same_whatever_the_registers():
    elsewhere = {**os.environ, "PYTHONPATH": str(Path(stribeck.__file__).parents[1])}
    found = set()
    for registers in ("scalar", "neon", "avx2", "avx512"):
        code = [sys.executable, "-c", CODE.format(laws=LAWS)]
        environment = {**elsewhere, "STRIBECK_REGISTERS": registers}
        found.add(subprocess.run(code, capture_output=True, text=True, check=True, env=environment).stdout)
    assert len(found) == 1
    assert len(found.pop()) == 65
