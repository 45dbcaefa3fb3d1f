"""Continues a saved run in a process of its own: resume.py MODEL STATE FROM TO. Prints the outputs, exactly."""

import math
import sys
from pathlib import Path

from coupling import Fmu, open_fmu, path_of

STEP = 1e-3


def drive(fmu: Fmu, begin: int, end: int) -> None:
    """Steps an FMU with inputs that depend on the number of the step only."""
    inputs = fmu.references(*fmu.names("input"))
    levels = [10.0 if name == "normal_force" else 1e-2 for name in fmu.names("input")]
    for at in range(begin, end):
        wave = [level * (1.0 + 1.5 * math.sin(0.05 * at)) for level in levels]
        values = [abs(value) if level > 1.0 else value for value, level in zip(wave, levels, strict=True)]
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
