#!/usr/bin/env python3
"""Processor time of `stribeck.force`, `stribeck.simulate` and a step of a `stribeck.batch` beside the same work as one
would write it with numpy and with numba, each in one thread. All in turn in each round; medians of times, and of the
ratio to the faster one of the other two within a round. Prints the tables of docs/python.md.

    pip install -r benches/requirements.txt && python3 benches/arrays.py    with a Python that has the wheel
"""

import math
import statistics
import time
from collections.abc import Callable

import numba
import numpy
import stribeck
from numba import njit, prange

POINTS = 1_000_000
ROUNDS = 41
MU_K, MU_S, LOAD, V_S, VISCOUS, V_0, SIGMA_0, SIGMA_1 = 0.1, 0.15, 10.0, 1e-3, 0.1, 1e-3, 1e5, 1e5**0.5
F_C, F_S = MU_K * LOAD, MU_S * LOAD
DT = 1e-4
# Contacts that are stepped together, and steps in a round.
CONTACTS, STEPS = 4096, 20
# Laws without modes.
STEPPED = (
    *("Ambrosio", "Andersson", "Awrejcewicz", "BengisuAkay", "Bernard", "BlimanSorine", "BrownMcPhee", "Coulomb"),
    *("CoulombViscous", "Dahl", "Dankowicz", "Hollars", "LinearStiction", "RooneyDeravi", "Specker"),
    *("SpeckerDynamic", "Stribeck", "Threlfall", "ThrelfallModified"),
)

Work = Callable[[], numpy.ndarray]


def lugre(v):
    return (F_C + (F_S - F_C) * numpy.exp(-((v / V_S) ** 2))) * numpy.sign(v) + VISCOUS * v


def brown_mcphee(v):
    u = numpy.abs(v) / V_0
    rise = F_C * numpy.tanh(4.0 * u) + (F_S - F_C) * u / (0.25 * u * u + 0.75) ** 2
    return rise * numpy.sign(v)


def coulomb_viscous(v):
    return F_C * numpy.sign(v) + VISCOUS * v


@njit(parallel=True)
def lugre_in_numba(v):
    forces = numpy.empty_like(v)
    for i in prange(len(v)):
        u = v[i] / V_S
        forces[i] = (F_C + (F_S - F_C) * math.exp(-u * u)) * numpy.sign(v[i]) + VISCOUS * v[i]
    return forces


@njit(parallel=True)
def brown_mcphee_in_numba(v):
    forces = numpy.empty_like(v)
    for i in prange(len(v)):
        u = abs(v[i]) / V_0
        part = 0.25 * u * u + 0.75
        forces[i] = (F_C * math.tanh(4.0 * u) + (F_S - F_C) * u / (part * part)) * numpy.sign(v[i])
    return forces


@njit(parallel=True)
def coulomb_viscous_in_numba(v):
    forces = numpy.empty_like(v)
    for i in prange(len(v)):
        forces[i] = F_C * numpy.sign(v[i]) + VISCOUS * v[i]
    return forces


@njit(inline="always")
def held(v, z):
    """The force of LuGre, and the deflection after a step at a held velocity."""
    u = v / V_S
    level = F_C + (F_S - F_C) * math.exp(-u * u)
    force = SIGMA_0 * z + SIGMA_1 * (v - SIGMA_0 * abs(v) * z / level) + VISCOUS * v
    steady = math.copysign(level, v) / SIGMA_0
    return force, steady + (z - steady) * math.exp(-SIGMA_0 * abs(v) * DT / level)


@njit
def lugre_along(v):
    forces, z = numpy.empty_like(v), 0.0
    for i in range(len(v)):
        forces[i], z = held(v[i], z)
    return forces


@njit(parallel=True)
def lugre_runs(v):
    forces = numpy.empty_like(v)
    for run in prange(v.shape[0]):
        z = 0.0
        for i in range(v.shape[1]):
            forces[run, i], z = held(v[run, i], z)
    return forces


@njit
def lugre_step(v, z, forces):
    """A step of many contacts, and the force after it."""
    for i in range(len(v)):
        u = v[i] / V_S
        level = F_C + (F_S - F_C) * math.exp(-u * u)
        steady = math.copysign(level, v[i]) / SIGMA_0
        z[i] = steady + (z[i] - steady) * math.exp(-SIGMA_0 * abs(v[i]) * DT / level)
        forces[i] = SIGMA_0 * z[i] + SIGMA_1 * (v[i] - SIGMA_0 * abs(v[i]) * z[i] / level) + VISCOUS * v[i]


def force(law: str, v: numpy.ndarray, **more) -> Work:
    """Work of ours, with the constants above."""
    known = {"mu_k": MU_K, "mu_s": MU_S, "viscous_coefficient": VISCOUS, "transition_velocity": V_0}
    values = {name: value for name, value in known.items() if name in stribeck.law(law).parameters}
    if law == "BrownMcPhee":
        values["viscous_coefficient"] = 0.0
    return lambda: stribeck.force(law, v, LOAD, threads=1, **values, **more)


def simulate(v: numpy.ndarray) -> Work:
    values = {"mu_k": MU_K, "mu_s": MU_S, "viscous_coefficient": VISCOUS, "sigma_0": SIGMA_0, "sigma_1": SIGMA_1}
    given = {"velocity": v, "normal_force": LOAD, "dt": DT, "held": True, "record": "friction_force", "threads": 1}
    return lambda: stribeck.simulate("LuGre", **given, **values)["friction_force"]


def stepped(law: str, v: numpy.ndarray) -> Work:
    """Steps of many contacts, into the same array."""
    known = {"mu_k": MU_K, "mu_s": MU_S, "viscous_coefficient": VISCOUS, "sigma_0": SIGMA_0, "sigma_1": SIGMA_1}
    values = {name: value for name, value in known.items() if name in stribeck.law(law).parameters}
    batch = stribeck.batch(law, len(v), normal_force=LOAD, **(values if law == "LuGre" else {}))
    forces = numpy.empty_like(v)

    def work():
        for _ in range(STEPS):
            batch.step(DT, velocity=v, out=forces)
        return forces

    return work


def stepped_in_numba(v: numpy.ndarray) -> Work:
    z, forces = numpy.zeros_like(v), numpy.empty_like(v)

    def work():
        for _ in range(STEPS):
            lugre_step(v, z, forces)
        return forces

    return work


def measured(works: list[Work | None]) -> list[list[float] | None]:
    """Times in ms of each work, all in turn in each round."""
    times = [None if work is None else [] for work in works]
    for _ in range(ROUNDS + 2):
        for work, list_of_times in zip(works, times, strict=True):
            if work is not None:
                begin = time.process_time()
                work()
                list_of_times.append((time.process_time() - begin) * 1e3)
    # The first rounds compile, and take new memory from the system.
    return [None if one is None else one[2:] for one in times]


def line(text: str, works: list[Work | None], times_as: float = 1.0) -> None:
    """Compares the numbers, and prints a line of the table: ours, numpy, numba, in ms or as another unit."""
    found = [work() for work in works if work is not None]
    assert all(numpy.allclose(found[0], other, rtol=1e-6, atol=1e-6) for other in found[1:]), text
    times = measured(works)
    others = [one for one in times[1:] if one is not None]
    ratio = [ours / min(others) for ours, *others in zip(times[0], *others, strict=True)] if others else None
    cells = ["" if one is None else f"{times_as * statistics.median(one):.2f}" for one in times]
    cells.append("" if ratio is None else f"{statistics.median(ratio):.2f}")
    print(f"| {text} | {' | '.join(cells)} |", flush=True)


def main() -> None:
    """Prints the table."""
    numba.set_num_threads(1)
    print(f"numpy {numpy.__version__}, numba {numba.__version__}\n")
    v = numpy.random.default_rng(1).uniform(-5e-3, 5e-3, POINTS)
    print("| | Stribeck | numpy | numba | ratio |\n|---|---|---|---|---|")
    line(
        '`force("CoulombViscous")`',
        [force("CoulombViscous", v), lambda: coulomb_viscous(v), lambda: coulomb_viscous_in_numba(v)],
    )
    line('`force("BrownMcPhee")`', [force("BrownMcPhee", v), lambda: brown_mcphee(v), lambda: brown_mcphee_in_numba(v)])
    line('`force("LuGre")`', [force("LuGre", v), lambda: lugre(v), lambda: lugre_in_numba(v)])
    out = numpy.empty_like(v)
    line('`force("LuGre", out=...)`', [force("LuGre", v, out=out), lambda: lugre(v), lambda: lugre_in_numba(v)])
    for law in ("Dahl", "SpeckerDynamic", "Gonthier", "ElastoPlastic", "ResetIntegrator"):
        line(f'`force("{law}")`', [force(law, v), None, None])
    path = 5e-3 * numpy.sin(20.0 * DT * numpy.arange(100_000))
    line('`simulate("LuGre")`, 100,000 samples', [simulate(path), None, lambda: lugre_along(path)])
    paths = numpy.random.default_rng(2).uniform(0.5, 1.5, (10_000, 1)) * path[:1000]
    line("10,000 runs of 1,000 samples", [simulate(paths), None, lambda: lugre_runs(paths)])
    print(f"\nA step of {CONTACTS} contacts, in us\n\n| | Stribeck | numpy | numba | ratio |\n|---|---|---|---|---|")
    v, us = v[:CONTACTS].copy(), 1e3 / STEPS
    line('`batch("LuGre").step`', [stepped("LuGre", v), None, stepped_in_numba(v)], us)
    for law in STEPPED:
        line(f'`batch("{law}").step`', [stepped(law, v), None, None], us)


if __name__ == "__main__":
    main()
