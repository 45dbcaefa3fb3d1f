"""Continues a saved run in a separate process: resume.py MODEL STATE FROM TO. Prints the outputs, exactly."""

import math
import sys
from pathlib import Path

from examples.fmpy.coupling import Fmu, open_fmu, path_of

STEP = 1e-3


def drive(fmu: Fmu, begin: int, end: int) -> None:
    """Steps an FMU with inputs that depend only on the number of the step."""
    names = fmu.names("input")
    inputs = fmu.references(*names)
    given = [v for v in fmu.description.modelVariables if v.causality == "input"]
    starts, bounded = {v.name: float(v.start) for v in given}, {v.name for v in given if v.min is not None}
    for at in range(begin, end):
        wave = 1.0 + 1.5 * math.sin(0.05 * at)
        # Loads sometimes vanish, everything else varies a little about its start value, or above it.
        small = {name: 1e-2 * (abs(wave) if name in bounded else wave) for name in names}
        values = [abs(10.0 * wave) if name == "normal_force" else starts[name] + small[name] for name in names]
        fmu.slave.setReal(inputs, values)
        fmu.slave.doStep(at * STEP, STEP)


def main(model: str, file: str, begin: str, end: str) -> None:
    """Reads the state, makes the steps, prints all real outputs as hexadecimal numbers."""
    with open_fmu(path_of(model)) as fmu:
        state = fmu.slave.deSerializeFMUstate(Path(file).read_bytes())
        fmu.slave.setFMUstate(state)
        fmu.slave.freeFMUstate(state)
        drive(fmu, int(begin), int(end))
        outputs = [v for v in fmu.description.modelVariables if v.causality == "output" and v.type == "Real"]
        print(*(value.hex() for value in fmu.slave.getReal([v.valueReference for v in outputs])))


if __name__ == "__main__":
    main(*sys.argv[1:])
