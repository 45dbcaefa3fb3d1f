#!/usr/bin/env python3
"""A gradient through friction: JAX differentiates a body that slides to rest by its first velocity and its mu_k.

The step of a batch becomes a function of JAX by `jax.pure_callback`, with exact derivatives by `jax.custom_vjp`. A
descent along the gradient finds the velocities with which all bodies have slid as far as they should.

    pip install dist/stribeck-*.whl jax && python3 examples/learning/gradient.py
"""

import jax
import jax.numpy as jnp
import numpy
import stribeck

jax.config.update("jax_enable_x64", True)

BODIES, DT, STEPS = 16, 1e-3, 40
MASS, LOAD = 1.0, 10.0  # kg, N

BY = ("bristle_deflection", "velocity", "mu_k")
OF = ("friction_force", "bristle_deflection")


class Friction:
    """A step of LuGre as a function: deflection, velocity and mu_k in, force and deflection out."""

    def __init__(self, bodies: int) -> None:
        self.batch = stribeck.batch("LuGre", bodies, normal_force=LOAD, sigma_0=1e4, stribeck_velocity=0.01)
        numbers = jax.ShapeDtypeStruct((bodies,), jnp.float64)

        @jax.custom_vjp
        def step(deflection, velocity, mu_k):
            return jax.pure_callback(self.values, (numbers, numbers), deflection, velocity, mu_k)

        def forward(*given):
            return step(*given), jax.pure_callback(self.slopes, ((numbers,) * 3,) * 2, *given)

        def backward(slopes, wanted):
            # Each result's share in the loss, times its derivative by each argument.
            return tuple(sum(share * one[by] for share, one in zip(wanted, slopes, strict=True)) for by in range(3))

        step.defvjp(forward, backward)
        self.step = step

    def place(self, given) -> None:
        """Brings the contacts to where a step begins."""
        self.batch.set(**{name: numpy.asarray(values) for name, values in zip(BY, given, strict=True)})

    def values(self, *given):
        """Force and deflection after a step."""
        self.place(given)
        return self.batch.step(DT), self.batch["bristle_deflection"]

    def slopes(self, *given):
        """Their derivatives."""
        self.place(given)
        found = self.batch.derivatives(BY, of=OF, dt=DT)
        return tuple(tuple(found[of][by] for by in BY) for of in OF)


def distances(friction: Friction, first, mu_k):
    """How far bodies slide, in m."""

    def step(state, _):
        position, velocity, deflection = state
        force, deflection = friction.step(deflection, velocity, mu_k)
        velocity = velocity - DT / MASS * force
        return (position + DT * velocity, velocity, deflection), None

    rest = jnp.zeros_like(first)
    (position, _, _), _ = jax.lax.scan(step, (rest, first, rest), None, STEPS)
    return position


def main() -> None:
    """Finds the velocities that lead all bodies to the same place."""
    friction = Friction(BODIES)
    mu_k = jnp.linspace(0.05, 0.12, BODIES)
    first, wanted = jnp.full(BODIES, 0.1), 4e-3
    loss = jax.jit(jax.value_and_grad(lambda first: jnp.sum((distances(friction, first, mu_k) - wanted) ** 2)))
    for number in range(11):
        value, slope = loss(first)
        if number % 5 == 0:
            print(f"{number}: largest error about {float(jnp.sqrt(value)):.1e} m")
        # Without friction the distance grows by the time with the velocity.
        first = first - 0.5 * slope / (STEPS * DT) ** 2
    print("velocities in m/s:", numpy.round(numpy.asarray(first)[:: BODIES // 4], 4))


if __name__ == "__main__":
    main()
