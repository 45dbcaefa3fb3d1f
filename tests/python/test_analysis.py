"""The closed forms of the belt benchmark, and the measurement of a cycle, on known motions."""

import numpy
import pytest
from analysis import BENCHMARK, maxima, measure, stick_slip, without_stiction

COULOMB = {name: value for name, value in BENCHMARK.items() if name != "mu_s"}


def test_stick_slip_has_the_published_numbers():
    cycle = stick_slip(**BENCHMARK)
    assert cycle.period == pytest.approx(7.52342224657, abs=1e-11)
    assert cycle.first_slip == pytest.approx(7.3575, abs=1e-13)
    assert cycle.first_maximum == pytest.approx(7.555990388745, abs=1e-12)
    assert cycle.x_max == pytest.approx(0.745740205493, abs=1e-12)
    assert cycle.x_min == pytest.approx(0.235259794507, abs=1e-12)


def test_without_stiction_has_the_published_numbers():
    cycle = without_stiction(**COULOMB)
    assert cycle.period == pytest.approx(4.44288293816, abs=1e-11)
    assert cycle.first_slip == pytest.approx(4.905, abs=1e-13)
    assert cycle.first_maximum == pytest.approx(4.905 + 4.44288293816 / 4.0, abs=1e-11)
    assert cycle.x_min == pytest.approx(0.419789321881, abs=1e-12)
    assert cycle.x_max == pytest.approx(0.561210678119, abs=1e-12)


def test_equal_levels_are_the_law_without_stiction():
    limit = stick_slip(**COULOMB, mu_s=COULOMB["mu_k"])
    exact = without_stiction(**COULOMB)
    assert (limit.period, limit.x_max) == pytest.approx((exact.period, exact.x_max), rel=1e-14)


def test_a_slow_belt_waits_for_twice_the_excess_and_slips_for_half_a_period():
    slow = stick_slip(**BENCHMARK | {"belt_velocity": 1e-9})
    waiting = 2.0 * 0.24525 / 1e-9
    assert slow.period - waiting == pytest.approx(numpy.pi / numpy.sqrt(2.0), abs=1e-6)


def test_maxima_lie_between_the_samples_and_ripple_is_not_counted():
    time = numpy.arange(0.0, 20.0, 0.01)
    ripple = 1e-3 * numpy.cos(200.0 * time)
    instants, heights = maxima(time, 1.0 - numpy.cos(2.0 * time))
    assert instants == pytest.approx(numpy.pi * (numpy.arange(6) + 0.5), abs=1e-6)
    assert heights == pytest.approx(2.0, abs=1e-8)
    assert len(maxima(time, 1.0 - numpy.cos(2.0 * time) + ripple)[0]) == 6


def test_a_truncated_maximum_is_omitted():
    time = numpy.arange(0.0, 4.7, 0.01)
    instants, _ = maxima(time, 1.0 - numpy.cos(2.0 * time))
    assert len(instants) == 1


def test_the_first_maximum_of_a_record_that_begins_above_the_middle_is_truncated():
    time = numpy.arange(0.0, 10.0, 0.01)
    instants, heights = maxima(time, numpy.cos(2.0 * time))
    assert instants == pytest.approx(numpy.pi * numpy.array([1.0, 2.0]), abs=1e-6)
    assert heights == pytest.approx(1.0, abs=1e-8)


def test_a_block_that_never_slips_has_no_cycle():
    time = numpy.linspace(0.0, 5.0, 100)
    cycle = measure(time, 0.1 * time, numpy.ones(100, dtype=bool))
    assert numpy.isnan([cycle.first_slip, cycle.first_maximum, cycle.period, cycle.x_max, cycle.x_min]).all()
