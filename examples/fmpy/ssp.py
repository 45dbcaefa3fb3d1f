#!/usr/bin/env python3
"""Runs a car on four posts, with the damper and in the master of your choice, from one SSP package.

    python examples/fmpy/ssp.py --variant soft --master ecos

Prints the motion of the body and writes <out>.csv.
"""

import argparse
import sys
from pathlib import Path

import numpy
from coupling import FMUS, CouplingError, main, positive, write_csv
from masters import MAIN, MASTERS, split, variants

UNITS = {"heave": "m", "pitch": "rad", "roll": "rad", "force": "N", "length": "m", "velocity": "m/s"}
WATCHED = ["car.heave", "car.pitch", "car.fl.length", "strut_fl.force", "strut_rl.force"]


def program() -> None:
    """Runs the simulation selected on the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--package", type=Path, default=FMUS / "FourPost.ssp", help="default: dist/FourPost.ssp")
    parser.add_argument("--variant", default=MAIN, help=f"description in the package (default: {MAIN})")
    parser.add_argument("--master", choices=MASTERS, default="jacobi", help="default: jacobi")
    parser.add_argument("--step", type=positive, default=1e-3, help="communication step in s (default: 1e-3)")
    parser.add_argument("--time", type=positive, default=5.0, help="simulated time in s (default: 5)")
    parser.add_argument("--out", default="out/ssp", help="result file, without extension (default: out/ssp)")
    options = parser.parse_args()
    if not options.package.is_file():
        raise CouplingError(f"no package {options.package}: run `python3 tasks.py pack`")
    steps = max(1, round(options.time / options.step))
    record = MASTERS[options.master](options.package, options.variant, options.step, steps, WATCHED)
    print(f"{options.variant} in {options.master}; the package has {', '.join(variants(options.package))}")
    heave, pitch = 1e3 * numpy.ptp(record["car.heave"]), numpy.degrees(numpy.ptp(record["car.pitch"]))
    print(f"heave {heave:.2f} mm, pitch {pitch:.3f} deg, peak to peak")
    time = options.step * numpy.arange(1, steps + 1)
    named = {f"{name} [{UNITS[split(name)[1].rpartition('.')[2]]}]": values for name, values in record.items()}
    write_csv(Path(f"{options.out}.csv"), {"time [s]": time, **named})
    print(f"{options.out}.csv")


if __name__ == "__main__":
    sys.exit(main(program))
