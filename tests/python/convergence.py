"""The step that a law needs on the belt: it is halved until the results agree."""

import math
from dataclasses import dataclass
from pathlib import Path

from analysis import AGREEMENT, Cycle, difference, measure
from belt import is_random, limit_of_step, run_belt

from examples.fmpy.coupling import FMUS, CouplingError

# The first step is halved this often at most.
LONGEST, HALVINGS = 1e-3, 8

# Distance of the recorded points in s; a parabola between them finds a maximum within a microsecond.
RECORDING = 1e-3


@dataclass(frozen=True)
class Converged:
    """A step that is short enough, the motion that shows it, that with half the step, and how far they are apart."""

    step: float
    cycle: Cycle
    finer: Cycle
    difference: float


def first_step(model: str, fmu_dir: Path = FMUS) -> float:
    """A step well below that at which a block at rest would chatter."""
    step, limit = LONGEST, limit_of_step(model, fmu_dir)
    if limit < LONGEST / 2**HALVINGS:
        raise CouplingError(f"{model}: a block at rest needs steps below {limit:g} s")
    while step > 0.5 * limit:
        step *= 0.5
    return step


def converged(model: str, duration: float, fmu_dir: Path = FMUS) -> Converged:
    """Halves the step until the motion agrees with that of half the step."""
    random = is_random(model, fmu_dir)

    def cycle_at(step: float) -> Cycle:
        run = run_belt(fmu_dir, model, step, duration, every=max(1, round(RECORDING / step)))
        cycle = measure(run.time, run.position, run.sticking)
        if math.isnan(cycle.first_maximum):
            raise CouplingError(f"{model}: the block never reverses in {duration:g} s, so nothing can be compared")
        return cycle

    step = first_step(model, fmu_dir)
    cycle = cycle_at(step)
    for _ in range(HALVINGS):
        finer = cycle_at(0.5 * step)
        apart = difference(cycle, finer, random)
        if abs(apart) <= AGREEMENT:
            return Converged(step, cycle, finer, apart)
        step, cycle = 0.5 * step, finer
    raise CouplingError(f"{model}: still {apart:+.2%} from {2.0 * step:g} s to {step:g} s, not converged")
