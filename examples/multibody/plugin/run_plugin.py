"""The quarter car in MuJoCo with its strut inside the simulator, as an actuator plugin written in C++.

    python -m examples.multibody.plugin.run_plugin --step 1e-3

Builds the plugin (see build_plugin.py), drives over the bump with it and with the FMU, and prints the differences: both
exchange force and motion once per step, so the motions are the same. Writes <out>.csv.
"""

import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from time import perf_counter
from xml.sax.saxutils import quoteattr

import mujoco
import numpy
from tqdm import tqdm

from examples.fmpy.coupling import FMUS, CouplingError, main, numbers_of, path_of, write_csv
from examples.multibody import mjcf
from examples.multibody.hosted_strut import open_strut
from examples.multibody.mujoco_host import QuarterCar, simulate
from examples.multibody.plugin.build_plugin import build
from examples.multibody.report import cases_of, quarter_car_options, steps_of
from examples.multibody.suspension import DOUBLE_WISHBONE, strut_parameters

PLUGIN = "stribeck.shock_absorber"

# Recorded quantities of both variants, with units.
COLUMNS = {"time": "s", "length": "m", "velocity": "m/s", "body_height": "m", "force": "N"}


@cache
def load_plugin() -> None:
    """Builds the plugin and registers it with MuJoCo, once per process."""
    mujoco.mj_loadPluginLibrary(str(build()))


def keys_of(values: Mapping[str, object]) -> dict[str, str]:
    """The keys of the plugin: a table is one, with a list of its first values."""
    keys: dict[str, list[float]] = {}
    for name, value in values.items():
        begin, _, rest = name.partition("[")
        index, _, end = rest.partition("]")
        found = keys.setdefault(begin + end, [])
        if index and int(index) != len(found) + 1:
            raise CouplingError(f"{name}: the plugin takes the values of a table in order, from the first")
        found.append(float(value))
    return {key: " ".join(map(repr, found)) for key, found in keys.items()}


def parts(parameters: Mapping[str, object], fmus: Path = FMUS) -> mjcf.Parts:
    """The double wishbone with the plugin as its actuator."""
    made = mjcf.double_wishbone("fl", DOUBLE_WISHBONE)
    values = keys_of(numbers_of(path_of("ShockAbsorber", fmus), parameters)).items()
    config = "".join(f'<config key={quoteattr(name)} value="{value}"/>' for name, value in values)
    made.extensions = [f'<plugin plugin="{PLUGIN}"><instance name="fl.strut">{config}</instance></plugin>']
    made.actuators = [f'<plugin name="fl.strut" plugin="{PLUGIN}" instance="fl.strut" tendon="fl.strut"/>']
    return made


def simulate_plugin(
    parameters: Mapping[str, object], label: str, step: float = 1e-3, time: float = 4.0, fmus: Path = FMUS
) -> dict[str, numpy.ndarray]:
    """Drives over the bump."""
    load_plugin()
    car = QuarterCar(DOUBLE_WISHBONE, parts(parameters, fmus), step)
    rows = []
    for at in tqdm(steps_of(time, step), desc=label, unit="step", leave=False, disable=None):
        seen = [at * step, *car.look(), car.body_height()]
        car.move(at * step)
        rows.append([*seen, float(car.data.actuator_force[0])])
    return dict(zip(COLUMNS, numpy.array(rows).T, strict=True))


def program() -> None:
    """Runs the simulations selected on the command line."""
    options = quarter_car_options(__doc__, out="out/mujoco_plugin").parse_args()
    load_plugin()
    for label, parameters in cases_of(options, strut_parameters(DOUBLE_WISHBONE)).items():
        begin = perf_counter()
        plugin = simulate_plugin(parameters, label, options.step, options.time, options.fmus)
        middle = perf_counter()
        with open_strut(parameters, DOUBLE_WISHBONE.length(), options.native, options.fmus) as strut:
            other = simulate(strut, label, step=options.step, time=options.time)
        seconds = (middle - begin) / options.time, (perf_counter() - middle) / options.time
        table = Path(f"{options.out}_{label.replace(' ', '_')}.csv")
        write_csv(table, {f"{name} [{unit}]": plugin[name] for name, unit in COLUMNS.items()})
        apart = {name: numpy.abs(plugin[name] - getattr(other, name)).max() for name in ("body_height", "force")}
        print(
            f"{label}: plugin and FMU differ by {apart['body_height']:.1e} m, {apart['force']:.1e} N; "
            f"{seconds[0]:.3f} s and {seconds[1]:.3f} s per simulated second\n{table}"
        )


if __name__ == "__main__":
    sys.exit(main(program))
