"""The belt benchmark through the FMUs, against the exact stick-slip cycle of Coulomb friction and against physics."""

import numpy
import pytest
import stribeck
from analysis import BENCHMARK, maxima, measure, stick_slip, without_stiction
from belt import EXCHANGES, BeltRun, limit_of_step, run_belt

from examples.fmpy.coupling import FMUS, CouplingError

HOLDING = ["CoulombStiction", "Karnopp"]
EXACT = stick_slip(**BENCHMARK)
STATIC, KINETIC = 1.4715, 0.981  # levels of the benchmark, N


def stuck(run: BeltRun, margin: int = 5) -> list[slice]:
    """The five intervals in which the contact sticks, without their first steps, in which the block comes to rest."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], run.sticking.astype(int), [0]))))
    intervals = [slice(begin + margin, end - 1) for begin, end in zip(edges[0::2], edges[1::2], strict=True)]
    assert len(intervals) == 5
    return intervals


def cycle_of(run: BeltRun):
    """The measured cycle."""
    return measure(run.time, run.position, run.sticking)


def test_coulomb_with_stiction_gives_the_exact_cycle(belt):
    cycle = cycle_of(belt("CoulombStiction"))
    assert cycle.period == pytest.approx(EXACT.period, rel=1e-3)
    assert cycle.first_slip == pytest.approx(EXACT.first_slip, abs=2e-3)
    assert cycle.x_max == pytest.approx(EXACT.x_max, rel=2e-3)


@pytest.mark.parametrize("step", [1e-2, 1e-3, 1e-4])
def test_the_coupling_is_of_first_order(belt, step):
    """At 8 s the block slips with -0.212054 m/s; its position may be that of one step earlier or later."""
    run = belt("CoulombStiction", step=step, time=8.0)
    assert abs(run.position[-1] - 0.697052775767) < 0.212054 * step


@pytest.mark.parametrize("step", [1e-3, 1e-2])
@pytest.mark.parametrize("exchange", EXCHANGES)
@pytest.mark.parametrize("model", HOLDING)
def test_a_stuck_block_moves_with_the_belt(belt, model, exchange, step):
    """The remaining velocity is that caused by the change of the spring force in a step or two: k v_b h^2 / m is 2e-7
    m/s at 1 ms."""
    run = belt(model, step=step, exchange=exchange)
    remainder = 1e-6 * (step / 1e-3) ** 2
    for interval in stuck(run):
        assert numpy.abs(run.velocity[interval]).max() < remainder


@pytest.mark.parametrize("step", [1e-3, 1e-2])
@pytest.mark.parametrize("exchange", EXCHANGES)
@pytest.mark.parametrize("model", HOLDING)
def test_the_force_does_not_alternate_while_stuck(belt, model, exchange, step):
    """The force follows the spring, a straight line: chatter would show as bends of alternating sign."""
    run = belt(model, step=step, exchange=exchange)
    for interval in stuck(run):
        bends = numpy.diff(run.friction_force[interval], 2)
        alternating = (bends[1:] * bends[:-1] < 0.0) & (numpy.minimum(abs(bends[1:]), abs(bends[:-1])) > 1e-9)
        assert not alternating.any()


@pytest.mark.parametrize("step", [1e-3, 1e-2])
@pytest.mark.parametrize("exchange", EXCHANGES)
def test_exchange_schemes_and_steps_agree(belt, exchange, step):
    cycle = cycle_of(belt("CoulombStiction", step=step, exchange=exchange))
    assert cycle.period == pytest.approx(EXACT.period, rel=step)
    assert cycle.first_slip == pytest.approx(EXACT.first_slip, abs=3.0 * step)
    assert cycle.x_max == pytest.approx(EXACT.x_max, rel=2.0 * step)


def test_karnopp_starts_with_the_exact_slip(belt):
    """The static level acts until the block has left the band, so the first slip is larger than Coulomb's."""
    run = belt("Karnopp")
    instants, heights = maxima(run.time, run.position)
    assert instants[0] == pytest.approx(7.646874883109, abs=5e-3)
    assert heights[0] == pytest.approx(0.755151250958, rel=1e-3)


def test_karnopp_with_mass_has_the_cycle_of_a_band_that_captures(belt):
    """Stick, then through the band at the static level, then slip until the band is reached from the other side.

    In the band x = x_S + (v_b / w) sin w t, left when v_b (1 - cos w t) = v_0. The slip starts at x_exit with the
    velocity v_b - v_0 and ends, by symmetry about f_C / k, with the same velocity at 2 f_C / k - x_exit, where the
    block is held.
    """
    w, belt_velocity, band = numpy.sqrt(2.0), 0.1, 1e-3
    onset, centre = STATIC / 2.0, KINETIC / 2.0
    in_band = numpy.arccos(1.0 - band / belt_velocity) / w
    exit_from_centre = onset + belt_velocity / w * numpy.sin(w * in_band) - centre
    slip = 2.0 / w * (numpy.pi - numpy.arctan(exit_from_centre * w / (belt_velocity - band)))
    stick = (onset - (centre - exit_from_centre)) / belt_velocity
    assert cycle_of(belt("Karnopp")).period == pytest.approx(stick + in_band + slip, rel=1e-3)


def test_dahl_oscillates_as_without_stiction(belt):
    exact = without_stiction(**{name: BENCHMARK[name] for name in BENCHMARK if name != "mu_s"})
    cycle = cycle_of(belt("Dahl"))
    assert cycle.period == pytest.approx(exact.period, rel=1e-3)
    assert cycle.x_max == pytest.approx(exact.x_max, rel=2e-3)


@pytest.mark.parametrize("model", ["LuGre", "Dahl"])
def test_bristle_laws_stay_within_the_static_level(belt, model):
    """At 1 ms explicit integration of the bristles would diverge; the FMUs' own steps are exact."""
    run = belt(model, time=20.0)
    assert numpy.abs(run.friction_force).max() <= 1.3 * STATIC


def test_brown_mcphee_chatters_at_most_within_the_static_level(belt):
    run = belt("BrownMcPhee", time=20.0)
    assert numpy.abs(run.friction_force).max() <= STATIC
    assert numpy.abs(run.position).max() < 0.9


@pytest.mark.parametrize("model", ["LuGre", "BrownMcPhee"])
def test_other_laws_come_near_their_reference_cycle(belt, model):
    """Solutions of the closed system by Radau and LSODA with tolerances of 1e-8 to 1e-10."""
    reference = {"LuGre": (7.073670, 0.739936), "BrownMcPhee": (7.634115, 0.750661)}
    run = belt(model)
    assert cycle_of(run).period == pytest.approx(reference[model][0], rel=5e-3)
    assert maxima(run.time, run.position)[1][0] == pytest.approx(reference[model][1], rel=5e-3)


def test_a_parameter_of_the_law_can_be_set(belt):
    weaker = stick_slip(**BENCHMARK | {"mu_s": 0.12})
    cycle = cycle_of(belt("CoulombStiction", mu_s="0.12"))
    assert cycle.period == pytest.approx(weaker.period, rel=1e-3)


def test_a_mass_given_by_the_user_replaces_that_of_the_rig(belt):
    """Without mass the law as printed alternates about the velocity of the belt: the option really reaches the FMU."""
    printed = belt("CoulombStiction", time=5.0, mass=0.0)
    assert numpy.abs(printed.velocity[10:]).max() > 1e-5


@pytest.mark.parametrize("model", ["CoulombStiction", "Liang", "LuGrePlanar"])
def test_values_of_the_rig_reach_it(model):
    """By Newton's law the acceleration of 2 kg is that of the forces; the block starts at rest on the belt, and slips
    when the spring force reaches the static friction."""
    run = run_belt(FMUS, model, time=12.0, rig={"mass": 2, "belt_velocity": 0.2, "position": 0.1})
    newton = (run.external_force - run.friction_force) / 2.0
    assert run.acceleration == pytest.approx(newton, abs=1e-8)
    assert (run.position[0], run.block_velocity[0]) == (0.1, 0.2)
    assert run.block_velocity - run.velocity == pytest.approx(0.2, abs=1e-9)
    # From x = 0.1 m at 0.2 m/s to f_s / k = 0.15 * 2 kg * 9.81 m/s2 / 2 N/m.
    if model == "CoulombStiction":
        assert run.time[~run.sticking][0] == pytest.approx((1.4715 - 0.1) / 0.2, abs=2e-3)


def test_a_steep_law_without_mass_limits_the_step():
    """2 m / (df/dv); with its mass the law looks ahead."""
    assert limit_of_step("BrownMcPhee", parameters={"mass": 0.0}) == pytest.approx(4.2e-4, abs=5e-6)
    assert limit_of_step("BrownMcPhee") == numpy.inf


def test_less_than_one_step_is_rejected(belt):
    with pytest.raises(CouplingError, match=r"time = 0\.0001 s: must be at least one step of 0\.001 s"):
        belt("CoulombStiction", time=1e-4)


@pytest.mark.parametrize("law", ["CoulombStiction", "LuGre", "BrownMcPhee"])
def test_fmus_come_to_the_motion_of_the_solver_as_their_step_falls(law):
    """The FMUs in a master are the co-simulation of the workbench, and err by the order of their step."""
    options = {"until": 12.0, "every": 1e-2, "record": ["rig.position"]}
    exact = stribeck.solve("belt", law, tol=1e-11, **options)["rig.position"]
    steps, errors = (2e-3, 1e-3, 5e-4), []
    for step in steps:
        run = run_belt(FMUS, law, step, 12.0, every=round(1e-2 / step))
        own = stribeck.solve("belt", law, solver="co-simulation", step=step, exchange="sequential", **options)
        assert numpy.abs(own["rig.position"] - run.position).max() < 1e-12
        errors.append(numpy.abs(run.position - exact).max())
    assert all(error < step for error, step in zip(errors, steps, strict=True)), errors
    if law == "CoulombStiction":
        # A switching is off by part of a step, of which half the step may happen to be a multiple.
        assert errors[2] < 0.5 * errors[0], errors
    else:
        assert errors[0] / errors[1] == pytest.approx(2.0, rel=0.05), errors
        assert errors[1] / errors[2] == pytest.approx(2.0, rel=0.05), errors
