"""The laws on the belt with the step that each needs, against solutions without the library and those of the workbench;
and the search for the step."""

import math

import belt_solutions
import convergence
import numpy
import pytest
import stribeck
from analysis import AGREEMENT, Cycle, difference, measure
from belt import BeltRun, is_random, run_belt

from examples.fmpy.coupling import FMUS, CouplingError, laws_in

# Their force passes from one level to the other at rest within a speed that no step resolves.
STEEP = ["RateAndState"]

# Long enough for the second slip of every law with stiction, and for three turns without.
DURATION = 20.0


@pytest.mark.parametrize("law", laws_in(FMUS))
def test_every_law_on_the_belt_has_the_motion_of_its_own_solution(law):
    if law in STEEP:
        with pytest.raises(CouplingError, match="a block at rest needs steps below"):
            convergence.converged(law, DURATION)
        return
    found = convergence.converged(law, DURATION)
    assert abs(found.difference) <= AGREEMENT
    expected = belt_solutions.periods().get(law)
    if expected is not None:
        assert (found.cycle.period, found.finer.period) == pytest.approx((expected, expected), rel=1e-2)
    record, until = ["rig.position", "friction.sticking"], 9.0 if is_random(law) else DURATION
    solution = stribeck.solve("belt", law, until=until, tol=1e-4, every=1e-3, record=record)
    solved = measure(solution.time, solution["rig.position"], solution["friction.sticking"] > 0.5)
    # With the mass of the block Karnopp's law stops it inside the band, in which its equation keeps the velocity.
    is_first_only = is_random(law) or law == "Karnopp"
    assert abs(difference(found.finer, solved, is_first_only)) <= 2.0 * AGREEMENT, solved


def test_every_solution_belongs_to_a_law():
    assert set(belt_solutions.periods()) <= set(laws_in(FMUS))


def test_the_step_is_halved_until_the_period_stays(monkeypatch):
    """A period with an error of 40 h: at 0.25 ms half of it is 0.5 % of 1 s, apart from that of the finer run."""

    def run(_fmus, model, step, duration, every):
        assert every == max(1, round(1e-3 / step))
        time = numpy.linspace(0.0, duration, 4001)
        position = numpy.cos(2.0 * numpy.pi * time / (1.0 + 40.0 * step))
        return BeltRun(model, time, position, *[time] * 5, time > 0.0)

    monkeypatch.setattr(convergence, "run_belt", run)
    found = convergence.converged("Dahl", 4.0)
    assert found.step == 2.5e-4
    assert found.cycle.period == pytest.approx(1.01, abs=1e-4)
    assert found.difference == pytest.approx(1.01 / 1.005 - 1.0, abs=1e-5)


def test_a_law_that_does_not_settle_is_rejected(monkeypatch):
    def run(_fmus, model, step, duration, **_):
        time = numpy.linspace(0.0, duration, 4001)
        return BeltRun(model, time, numpy.cos(2.0 * numpy.pi * time * step**0.1), *[time] * 5, time > 0.0)

    monkeypatch.setattr(convergence, "run_belt", run)
    with pytest.raises(CouplingError, match=r"Dahl: still -6.70% from 7.8125e-06 s to 3.90625e-06 s, not converged"):
        convergence.converged("Dahl", 12.0)


def test_a_block_that_never_reverses_cannot_be_compared():
    with pytest.raises(CouplingError, match="CoulombStiction: the block never reverses in 5 s"):
        convergence.converged("CoulombStiction", 5.0)


def test_whole_motions_are_compared_and_random_ones_by_their_first_maximum():
    cycle = Cycle(first_slip=7.0, first_maximum=7.5, period=4.5, x_min=0.2, x_max=0.7)
    early = Cycle(first_slip=5.0, first_maximum=6.0, period=4.5, x_min=0.2, x_max=0.7)
    low = Cycle(first_slip=7.0, first_maximum=7.5, period=4.5, x_min=0.2, x_max=0.56)
    assert [difference(one, cycle, False) for one in (early, low)] == pytest.approx([-0.2, -0.2])
    assert [difference(one, cycle, True) for one in (early, low)] == pytest.approx([-0.2, 0.0])
    once = Cycle(first_slip=7.0, first_maximum=7.5, period=math.nan, x_min=math.nan, x_max=0.7)
    assert difference(once, cycle, False) == 0.0


def test_random_bonds_have_the_same_first_maximum_at_each_step_and_not_the_same_periods():
    cycles = []
    for step in (1e-3, 2.5e-4):
        run = run_belt(model="Bristle", step=step, every=round(1e-3 / step))
        cycles.append(measure(run.time, run.position, run.sticking))
    assert cycles[0].first_maximum == pytest.approx(cycles[1].first_maximum, rel=1e-3)
    assert abs(cycles[0].period / cycles[1].period - 1.0) > AGREEMENT


def test_the_delay_differential_equation_is_solved_well():
    assert belt_solutions.frictional_lag(step=5e-5) == pytest.approx(belt_solutions.frictional_lag(), rel=1e-6)


def test_without_lag_the_law_is_the_one_of_the_static_curve():
    """A lag of one step against the fall of the level within 1 um/s: Coulomb friction with stiction."""
    period = belt_solutions.frictional_lag(time_lag=1e-4, stribeck_velocity=1e-6)
    assert period == pytest.approx(belt_solutions.periods()["CoulombStiction"], rel=1e-3)


def test_the_acceleration_is_connected():
    """Before the block comes to rest it slows down: the force is that of the lower branch, to the last digits."""
    run = run_belt(model="Wojewoda", step=1e-4, time=10.5, parameters={"acceleration_source": "Input"})
    slow = (run.velocity < -1e-3) & (run.velocity > -2e-3)
    slows_down = slow & (run.acceleration > 0.1) & ~run.sticking
    assert slows_down.any()
    fading = numpy.exp(-500.0 * -run.velocity[slows_down])
    assert -run.friction_force[slows_down] == pytest.approx(0.981 - 0.4905 * fading, abs=1e-9)


def test_a_call_that_fails_ends_the_run_with_the_reason_of_the_model():
    with pytest.raises(CouplingError, match="fmi2"):
        run_belt(model="Dahl", rig={"block_velocity": 1e308, "stiffness": 1e300})
