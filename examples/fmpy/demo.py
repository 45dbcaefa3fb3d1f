"""Runs the FMUs in dist/ and draws the results to out/: every friction FMU along a recorded motion, and a car on four
posts with and without friction in its struts.
"""

import sys
import time
from pathlib import Path

from examples.fmpy.car_pictures import draw_four_post
from examples.fmpy.coupling import FMUS, CouplingError, friction_path_of, laws_in, main
from examples.fmpy.four_post import report, run_four_post
from examples.fmpy.make_motion import MOTION
from examples.fmpy.pictures import draw_replay
from examples.fmpy.replay import read_motion, replay
from examples.fmpy.vehicle import Choice, friction, label_of

OUT = Path("out")

# Friction of each strut in N, off and on.
LEVELS = (0.0, 50.0)
FREQUENCY = 2.0


def run_along_motion(laws: list[str]) -> None:
    """Drives each law along the recorded motion, prints a line of the table and draws a picture."""
    motion = read_motion(MOTION)
    print(f"The recorded motion {MOTION.name}, {len(motion.time) - 1} steps in {motion.time[-1]:g} s:\n")
    print(f"{'model':22} {'largest force':>13} {'dissipated':>11} {'steps/s':>9}")
    for law in laws:
        begin = time.perf_counter()
        result = replay(friction_path_of(law), motion)
        speed = len(motion.time) / (time.perf_counter() - begin)
        largest = abs(result.friction_force).max()
        print(f"{law:22} {largest:11.3f} N {result.dissipated_energy[-1]:9.4f} J {speed:9.0f}", flush=True)
        draw_replay(result, OUT / "replay" / f"{law}.png")


def run_posts() -> None:
    """The car on four posts, without and with friction."""
    print(f"\nCar on four posts at {FREQUENCY:g} Hz, without friction and with {LEVELS[-1]:g} N in each strut:\n")
    runs = [run_four_post(Choice(FMUS, friction("LuGre", level)), FREQUENCY, label=label_of(level)) for level in LEVELS]
    report(runs, FREQUENCY)
    draw_four_post(runs, FREQUENCY, OUT / "four_post.png")


def program() -> None:
    """Runs all models and prints where the results are."""
    laws = laws_in(FMUS)
    if not laws:
        raise CouplingError(f"no friction FMU in {FMUS}: run `python3 tasks.py pack`")
    run_along_motion(laws)
    run_posts()
    print(f"\nPictures: {OUT / 'replay' / '<model>.png'}, {OUT / 'four_post.png'}")


if __name__ == "__main__":
    sys.exit(main(program))
