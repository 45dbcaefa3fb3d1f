#!/usr/bin/env python3
"""Runs every friction FMU in dist/ on the belt, one of them along a recorded motion, and draws the results in out/."""

import sys
import time
from math import inf, isnan
from pathlib import Path

from analysis import BENCHMARK, Cycle, measure, stick_slip, without_stiction
from belt import BeltRun, run_belt
from coupling import FMUS, friction_models_in, friction_path_of, main, variables_of
from make_motion import MOTION
from pictures import draw_belt, draw_comparison, draw_replay
from replay import read_motion, replay

OUT = Path("out")
STEP = 1e-3
TIME = 40.0


def closed_form(model: str) -> tuple[str, Cycle]:
    """The exact cycle that a model should come close to: the one of Coulomb friction with or without stiction."""
    if "mu_s" in variables_of(friction_path_of(model)):
        return "with stiction", stick_slip(**BENCHMARK)
    return "without stiction", without_stiction(**{name: BENCHMARK[name] for name in BENCHMARK if name != "mu_s"})


def timed_run(model: str) -> tuple[BeltRun, float]:
    """A run on the belt, and the steps per second of wall time; reading and extracting the FMUs included."""
    begin = time.perf_counter()
    run = run_belt(model=model, step=STEP, time=TIME)
    return run, (len(run.time) - 1) / (time.perf_counter() - begin)


def program() -> None:
    """Runs all models and prints the table."""
    models = friction_models_in(FMUS)
    print(f"Block on a moving belt, {TIME:g} s in steps of {1e3 * STEP:g} ms:\n")
    print(f"{'model':16} {'period [s]':>10}  {'Coulomb friction':16} {'period [s]':>10} {'deviation':>9} {'steps/s':>9}")
    runs = []
    for model in models:
        run, speed = timed_run(model)
        name, exact = closed_form(model)
        period = measure(run.time, run.position, run.sticking).period
        deviation = period / exact.period - 1.0
        print(f"{model:16} {period:10.4f}  {name:16} {exact.period:10.4f} {deviation:+9.2%} {speed:9.0f}")
        draw_belt(run, OUT / "belt" / f"{model}.png")
        runs.append(run)
    draw_comparison(runs, OUT / "comparison.png")
