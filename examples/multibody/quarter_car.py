"""A quarter car in MuJoCo or exudyn with the ShockAbsorber FMU as its strut.

    python -m examples.multibody.quarter_car mujoco --set friction.scale=0.5 --step 5e-4
    python -m examples.multibody.quarter_car exudyn --coupling implicit --step 1e-3

The car stands until it is at rest, then the wheel runs over a bump of 5 cm. Every run is made with and without
friction, or with --no-friction only without. Writes <out>.csv, <out>.png.

    --suspension double-wishbone   the strut is a force between body and lower arm (default)
                 telescope         the same; tube and rod have mass and hang in universal joints
                 macpherson        the tube is bolted to the upright: real side loads
                 guided            the wheel slides in a straight guide: the quarter car of textbooks

    --coupling   implicit   the force of the strut belongs to the end of the step: each iteration of exudyn restores the
                            FMU to the last accepted point and steps it with the length and velocity of the iteration
                            (default in exudyn)
                 explicit   the FMU steps once, and its force is held over the step (always in MuJoCo)

With --side-loads the reaction between tube and rod, as the simulator computed it, is passed to the FMU: friction grows
with it. With --native the same law runs in Python, in the same place.
"""

import argparse
import sys
from collections.abc import Mapping
from functools import partial

from examples.fmpy.coupling import main
from examples.multibody.hosted_strut import open_strut
from examples.multibody.report import Run, cases_of, quarter_car_options, report_quarter_car
from examples.multibody.suspension import SUSPENSIONS, strut_parameters


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = quarter_car_options(__doc__, out="out/quarter_car")
    parser.add_argument("simulator", choices=("mujoco", "exudyn"))
    parser.add_argument("--coupling", choices=("implicit", "explicit"), help="of exudyn (default: implicit)")
    parser.add_argument("--suspension", choices=SUSPENSIONS, default="double-wishbone")
    parser.add_argument("--side-loads", action="store_true", help="pass the reaction between tube and rod to the strut")
    options = parser.parse_args()
    if options.simulator == "mujoco" and options.coupling == "implicit":
        parser.error("argument --coupling: MuJoCo does not iterate over a step: explicit only")
    if options.simulator == "exudyn" and options.coupling is None:
        options.coupling = "implicit"
    return options


def program() -> None:
    """Runs the simulations selected on the command line."""
    options = arguments()
    suspension = SUSPENSIONS[options.suspension]
    title = f"{options.suspension}, {options.law}{', side loads' if options.side_loads else ''}"
    # A simulator is loaded only if it is used.
    if options.simulator == "mujoco":
        from examples.multibody.mujoco_host import simulate

        title = f"Quarter car in MuJoCo, {title}"
    else:
        from examples.multibody import exudyn_host

        simulate = partial(exudyn_host.simulate, coupling=options.coupling)
        title = f"Quarter car in exudyn, {title}, {options.coupling} coupling"

    def case(label: str, parameters: Mapping[str, object]) -> Run:
        with open_strut(parameters, suspension.length(), options.native, options.fmus) as strut:
            return simulate(strut, label, options.suspension, options.step, options.time, options.side_loads)

    cases = cases_of(options, strut_parameters(suspension))
    report_quarter_car(title, [case(label, parameters) for label, parameters in cases.items()], options.out)


if __name__ == "__main__":
    sys.exit(main(program))
