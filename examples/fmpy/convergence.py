"""The step that a law needs on the belt: it is halved until the results agree."""

import math
import time
from dataclasses import dataclass
from pathlib import Path

from analysis import AGREEMENT, compared_time, measure
from belt import BeltRun, is_random, limit_of_step, run_belt
from coupling import FMUS, CouplingError, friction_path_of, variables_of

# The first step is halved this often at most.
LONGEST, HALVINGS = 1e-3, 8

# Distance of the recorded points in s; a parabola between them finds a maximum within a microsecond.
RECORDING = 1e-3


@dataclass(frozen=True)
class Converged:
    """A run whose step is short enough, with the measured value that shows it, and that with half the step."""

    run: BeltRun
    step: float
    value: float
    finer: float
    speed: float
    remarks: list[str]

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


def remarks_on(model: str, fmu_dir: Path = FMUS) -> list[str]:
    """Remarks on a law for readers of the table."""
    variables = variables_of(friction_path_of(model, fmu_dir))
    remarks = {
        "velocity_x": "along x",
        "acceleration": "its force jumps with the acceleration, which is that of the previous step",
        "seed": "random bonds: compared by the time of the first maximum, since the period scatters",
    }
    return [remark for name, remark in remarks.items() if name in variables]


def converged(model: str, duration: float, fmu_dir: Path = FMUS) -> Converged:
    """Halves the step until the measured time agrees with that of half the step."""
    step, random, remarks = first_step(model, fmu_dir), is_random(model, fmu_dir), remarks_on(model, fmu_dir)
    run, speed = _timed(model, step, duration, fmu_dir)
    too_long = [f"{1e3 * step:g} ms would give {measured(run, random):.4f} s"]
    for _ in range(HALVINGS):
        finer, finer_speed = _timed(model, 0.5 * step, duration, fmu_dir)
        found = Converged(run, step, measured(run, random), measured(finer, random), speed, remarks)
        if abs(found.difference) <= AGREEMENT:
            return found
        remarks = too_long + remarks_on(model, fmu_dir)
        step, run, speed = 0.5 * step, finer, finer_speed
    raise CouplingError(f"{model}: still {found.difference:+.2%} from {2.0 * step:g} s to {step:g} s, not converged")


def _timed(model: str, step: float, duration: float, fmu_dir: Path) -> tuple[BeltRun, float]:
    """A run on the belt, and the steps per second of wall time; reading and extracting the FMUs included."""
    begin, every = time.perf_counter(), max(1, round(RECORDING / step))
    run = run_belt(fmu_dir, model, step, duration, every=every)
    return run, duration / step / (time.perf_counter() - begin)
