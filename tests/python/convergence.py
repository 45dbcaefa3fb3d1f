"""The step that a law needs on the belt: it is halved until the results agree."""

import math
from dataclasses import dataclass
from pathlib import Path

from analysis import AGREEMENT, compared_time, measure
from belt import BeltRun, is_random, limit_of_step, run_belt

from examples.fmpy.coupling import FMUS, CouplingError

# The first step is halved this often at most.
LONGEST, HALVINGS = 1e-3, 8

# Distance of the recorded points in s; a parabola between them finds a maximum within a microsecond.
RECORDING = 1e-3


@dataclass(frozen=True)
class Converged:
    """A step that is short enough, the measured value that shows it, and that with half the step."""

    step: float
    value: float
    finer: float

    @property
    def difference(self) -> float:
        """Relative difference of the run from the one with half its step."""
        return self.value / self.finer - 1.0


def measured(run: BeltRun, random: bool) -> float:
    """The value by which the run is compared."""
    value = compared_time(measure(run.time, run.position, run.sticking), random)
    if math.isnan(value):
        raise CouplingError(f"{run.model}: the block never reverses in {run.time[-1]:g} s, so nothing can be compared")
    return value


def first_step(model: str, fmu_dir: Path = FMUS) -> float:
    """A step well below that at which a block at rest would chatter."""
    step, limit = LONGEST, limit_of_step(model, fmu_dir)
    while step > 0.5 * limit:
        step *= 0.5
    return step


def converged(model: str, duration: float, fmu_dir: Path = FMUS) -> Converged:
    """Halves the step until the measured time agrees with that of half the step."""
    random = is_random(model, fmu_dir)

    def value_at(step: float) -> float:
        return measured(run_belt(fmu_dir, model, step, duration, every=max(1, round(RECORDING / step))), random)

    step = first_step(model, fmu_dir)
    value = value_at(step)
    for _ in range(HALVINGS):
        found = Converged(step, value, value_at(0.5 * step))
        if abs(found.difference) <= AGREEMENT:
            return found
        step, value = 0.5 * step, found.finer
    raise CouplingError(f"{model}: still {found.difference:+.2%} from {2.0 * step:g} s to {step:g} s, not converged")
