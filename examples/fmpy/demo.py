#!/usr/bin/env python3
"""Runs the FMUs in dist/ and draws the results to out/: every friction FMU on the belt, one of them along a recorded
motion, and a car on four posts with and without friction in its struts.
"""

import argparse
import sys
from pathlib import Path

from analysis import AGREEMENT
from belt import BeltRun
from car_pictures import draw_four_post
from convergence import converged
from coupling import FMUS, CouplingError, friction_path_of, laws_in, main
from four_post import report, run_four_post
from make_motion import MOTION
from pictures import draw_belt, draw_comparison, draw_replay
from replay import read_motion, replay
from vehicle import Choice, Run, friction, label_of

OUT = Path("out")
TIME = 40.0
REPLAYED = "LuGre"

# Friction of each strut in N, off and on.
LEVELS = (0.0, 50.0)
FREQUENCY = 2.0


def run_on_belt(models: list[str], time: float) -> list[BeltRun]:
    """Runs the models for `time` and prints a line of the table for each."""
    print(f"Block on a moving belt, {time:g} s. The step of each law is halved until the last period")
    print(f"changes by at most {AGREEMENT:.1%}; it is then within {2.0 * AGREEMENT:.0%} of that of a converged run.\n")
    print(f"{'model':19} {'step':>11} {'period':>10} {'at half step':>13} {'difference':>11} {'steps/s':>9}  remarks")
    runs = []
    for model in models:
        found = converged(model, time)
        times = f"{1e3 * found.step:8.4g} ms {found.value:8.4f} s {found.finer:11.4f} s"
        remarks = "; ".join(found.remarks)
        line = f"{model:19} {times} {found.difference:+11.3%} {found.speed:9.0f}  {remarks}"
        print(line.rstrip(), flush=True)
        draw_belt(found.run, OUT / "belt" / f"{model}.png")
        runs.append(found.run)
    return runs


def run_posts() -> list[Run]:
    """The car on four posts, without and with friction."""
    print(f"\nCar on four posts at {FREQUENCY:g} Hz, without friction and with {LEVELS[-1]:g} N in each strut:\n")
    runs = [run_four_post(Choice(FMUS, friction("LuGre", level)), FREQUENCY, label=label_of(level)) for level in LEVELS]
    report(runs, FREQUENCY)
    return runs


def program() -> None:
    """Runs all models and prints where the results are."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--time", type=float, default=TIME, help=f"duration of the runs on the belt in s (default: {TIME:g})"
    )
    time = parser.parse_args().time
    models = laws_in(FMUS)
    if not models:
        raise CouplingError(f"no friction FMU in {FMUS}: run `python3 tasks.py pack`")
    runs = run_on_belt(models, time)
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
