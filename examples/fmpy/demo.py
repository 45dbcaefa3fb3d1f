#!/usr/bin/env python3
"""Runs the FMUs in dist/ and draws the results in out/: every friction FMU on the belt, one of them along a recorded
motion, and a car on four posts with and without friction in its struts.
"""

import sys
import time
from pathlib import Path

from analysis import BENCHMARK, Cycle, measure, stick_slip, without_stiction
from belt import BeltRun, limit_of_step, run_belt
from car_pictures import draw_four_post
from coupling import FMUS, CouplingError, friction_models_in, friction_path_of, main, variables_of
from four_post import report, run_four_post
from make_motion import MOTION
from pictures import draw_belt, draw_comparison, draw_replay
from replay import read_motion, replay
from vehicle import Choice, Run, friction, label_of

OUT = Path("out")
STEPS = (1e-3, 5e-4, 2e-4, 1e-4, 5e-5, 2e-5, 1e-5)
TIME = 40.0
REPLAYED = "LuGre"

# Friction of each strut in N, off and on.
LEVELS = (0.0, 50.0)
FREQUENCY = 2.0


def closed_form(model: str) -> tuple[str, Cycle]:
    """The exact cycle that a model should come close to: the one of Coulomb friction with or without stiction."""
    if "mu_s" in variables_of(friction_path_of(model)):
        return "with stiction", stick_slip(**BENCHMARK)
    return "without stiction", without_stiction(**{name: BENCHMARK[name] for name in BENCHMARK if name != "mu_s"})


def step_for(model: str) -> float:
    """The longest step that is well below the one at which a block at rest would chatter."""
    return next(step for step in STEPS if step <= 0.5 * limit_of_step(model))


def timed_run(model: str, step: float) -> tuple[BeltRun, float]:
    """A run on the belt, and the steps per second of wall time; reading and extracting the FMUs included."""
    begin = time.perf_counter()
    run = run_belt(model=model, step=step, time=TIME)
    return run, (len(run.time) - 1) / (time.perf_counter() - begin)


def run_on_belt(models: list[str]) -> list[BeltRun]:
    """Runs the models and prints a line of the table for each."""
    print(f"Block on a moving belt, {TIME:g} s, against the closed form of Coulomb friction:\n")
    print(f"{'model':19} {'step':>7} {'period':>10}   {'closed form':26} {'deviation':>9} {'steps/s':>9}")
    runs = []
    for model in models:
        step = step_for(model)
        run, speed = timed_run(model, step)
        name, exact = closed_form(model)
        period = measure(run.time, run.position, run.sticking).period
        deviation = period / exact.period - 1.0
        left = f"{model:19} {1e3 * step:4g} ms {period:8.4f} s"
        print(f"{left}   {exact.period:.4f} s {name:17} {deviation:+9.2%} {speed:9.0f}", flush=True)
        draw_belt(run, OUT / "belt" / f"{model}.png")
        runs.append(run)
    return runs


def run_posts() -> list[Run]:
    """The car on four posts, without and with friction."""
    print(f"\nCar on four posts at {FREQUENCY:g} Hz, without friction and with {LEVELS[-1]:g} N in each strut:\n")
    runs = [run_four_post(Choice(FMUS, friction("LuGre", level)), FREQUENCY, label=label_of(level)) for level in LEVELS]
    report(runs, FREQUENCY)
    return runs


def program() -> None:
    """Runs all models and prints where the results are."""
    models = friction_models_in(FMUS)
    if not models:
        raise CouplingError(f"no friction FMU in {FMUS}: run `python3 tasks.py pack`")
    runs = run_on_belt(models)
    draw_comparison(runs, OUT / "comparison.png")
    result = replay(friction_path_of(REPLAYED), read_motion(MOTION))
    draw_replay(result, OUT / "replay.png")
    energy, span = result.dissipated_energy[-1], result.motion.time[-1]
    print(f"\n{REPLAYED} along the recorded motion {MOTION.name}: {energy:.4g} J dissipated in {span:g} s")
    draw_four_post(run_posts(), FREQUENCY, OUT / "four_post.png")
    pictures = ("comparison.png", "belt/<model>.png", "replay.png", "four_post.png")
    print(f"\nPictures: {', '.join(str(OUT / picture) for picture in pictures)}")


if __name__ == "__main__":
    sys.exit(main(program))
