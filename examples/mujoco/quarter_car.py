#!/usr/bin/env python3
"""A quarter car in MuJoCo with the ShockAbsorber FMU as its strut.

    python examples/mujoco/quarter_car.py --set friction.scale=0.5 --step 5e-4

The car stands until it is at rest, then the wheel runs over a bump of 5 cm. Every run is made with and without
friction, or with --no-friction only without. Writes <out>.csv, <out>.png.

    --suspension double-wishbone   the strut is a force between body and lower arm (default)
                 telescope         the same; tube and rod have mass and hang in universal joints
                 macpherson        the tube is bolted to the upright: real side loads
                 guided            the wheel slides in a straight guide: the quarter car of textbooks

With --side-loads the reaction between tube and rod, as computed by MuJoCo, is passed to the FMU: friction grows with
it.
"""

import sys
from collections.abc import Mapping
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "fmpy"))
sys.path.append(str(Path(__file__).resolve().parents[1] / "multibody"))

from coupling import main
from hosted_strut import open_strut
from mujoco_host import SUSPENSIONS, simulate
from report import Run, cases_of, quarter_car_options, report_quarter_car
from suspension import strut_parameters


def program() -> None:
    """Runs the simulations selected on the command line."""
    parser = quarter_car_options(__doc__, out="out/mujoco_quarter_car")
    parser.add_argument("--suspension", choices=SUSPENSIONS, default="double-wishbone")
    parser.add_argument("--side-loads", action="store_true", help="pass the reaction between tube and rod to the strut")
    options = parser.parse_args()
    suspension = SUSPENSIONS[options.suspension][0]

    def case(label: str, parameters: Mapping[str, object]) -> Run:
        with open_strut(parameters, suspension.length(), options.native, options.fmus) as strut:
            return simulate(strut, label, options.suspension, options.step, options.time, options.side_loads)

    cases = cases_of(options, strut_parameters(suspension))
    runs = [case(label, parameters) for label, parameters in cases.items()]
    loads = ", side loads" if options.side_loads else ""
    report_quarter_car(f"Quarter car in MuJoCo, {options.suspension}, {options.law}{loads}", runs, options.out)


if __name__ == "__main__":
    sys.exit(main(program))
