#!/usr/bin/env python3
"""A quarter car in exudyn with the ShockAbsorber FMU as its strut, coupled explicitly or inside the Newton iterations.

    python examples/exudyn/quarter_car.py --coupling implicit --step 1e-3

The car and the bump are those of examples/mujoco/quarter_car.py. Writes <out>.csv, <out>.png.

    --coupling implicit   the force of the strut belongs to the end of the step: each iteration restores the FMU to the
                          last accepted point and steps it with the length and velocity of the iteration (default)
               explicit   the FMU steps once, and its force is held over the step

With --native the same law runs in Python, in the same place: the implicit runs then agree to all printed digits. With
--side-loads the reaction between tube and rod is passed to the FMU, for --suspension telescope and macpherson.
"""

import sys
from collections.abc import Mapping
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "fmpy"))
sys.path.append(str(Path(__file__).resolve().parents[1] / "multibody"))

from coupling import main
from exudyn_host import SUSPENSIONS, simulate
from hosted_strut import open_strut
from report import Run, cases_of, quarter_car_options, report_quarter_car
from suspension import strut_parameters


def program() -> None:
    """Runs the simulations selected on the command line."""
    parser = quarter_car_options(__doc__, out="out/exudyn_quarter_car")
    parser.add_argument("--coupling", choices=("implicit", "explicit"), default="implicit")
    parser.add_argument("--suspension", choices=SUSPENSIONS, default="double-wishbone")
    parser.add_argument("--side-loads", action="store_true", help="pass the reaction between tube and rod to the strut")
    options = parser.parse_args()
    suspension = SUSPENSIONS[options.suspension]

    def case(label: str, parameters: Mapping[str, object]) -> Run:
        with open_strut(parameters, suspension.length(), options.native, options.fmus) as strut:
            how = (options.coupling, options.suspension, options.step, options.time, options.side_loads)
            return simulate(strut, label, *how)

    cases = cases_of(options, strut_parameters(suspension))
    runs = [case(label, parameters) for label, parameters in cases.items()]
    loads = ", side loads" if options.side_loads else ""
    title = f"Quarter car in exudyn, {options.suspension}, {options.law}{loads}, {options.coupling} coupling"
    report_quarter_car(title, runs, options.out)


if __name__ == "__main__":
    sys.exit(main(program))
