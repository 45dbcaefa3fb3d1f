"""The examples for learning: joints between bounds of Coulomb, and a gradient of JAX beside differences."""

import numpy
import pytest

from examples.learning import joints as example


def test_joints_move_between_the_bounds_of_coulomb():
    joints, torque, steps = example.Joints(50), 2.0, 100
    for _ in range(steps):
        velocity = joints.step(numpy.full(50, torque)).copy()
    time = steps * example.DT
    batch = joints.friction
    levels = 10.0 * numpy.array([batch["mu_k"], batch["mu_s"]])
    fastest, slowest = time / example.INERTIA * (torque - levels)
    # Viscous friction takes less than the speed times its coefficient, over the whole time.
    slowest = slowest - time / example.INERTIA * 0.02 * fastest
    assert ((slowest < velocity) & (velocity < fastest)).all()
    # Half of them begin anew, and are held by less than their level.
    mask = numpy.arange(50) % 2 == 0
    joints.reset(mask)
    assert (batch.time == numpy.where(mask, 0.0, batch.time.max())).all()
    held = 0.5 * levels[0]
    for _ in range(500):
        velocity = joints.step(held)
    assert numpy.abs(velocity[mask]).max() < 1e-3


def test_a_gradient_of_jax_is_that_of_differences():
    pytest.importorskip("jax", reason="without JAX there is no gradient of it")
    from examples.learning import gradient

    friction, first = gradient.Friction(4), numpy.array([0.05, 0.1, 0.15, 0.2])
    mu_k = numpy.linspace(0.06, 0.12, 4)
    sums = gradient.jax.grad(lambda first, mu_k: gradient.distances(friction, first, mu_k).sum(), (0, 1))
    slopes = sums(gradient.jnp.asarray(first), gradient.jnp.asarray(mu_k))
    for number, change in ((0, 1e-6), (1, 1e-7)):
        ends = []
        for sign in (1.0, -1.0):
            given = [first, mu_k]
            given[number] = given[number] + sign * change
            ends.append(numpy.asarray(gradient.distances(friction, *map(gradient.jnp.asarray, given))))
        numpy.testing.assert_allclose(slopes[number], (ends[0] - ends[1]) / (2.0 * change), rtol=1e-5)
