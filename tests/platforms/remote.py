"""Runs an FMU in fmpy and writes its outputs: remote.py FMU FILE. In a separate process, because a lost server hangs
it."""

import sys
from pathlib import Path

import numpy
from fmpy import simulate_fmu

from examples.fmpy.coupling import variables_of

TIME = numpy.linspace(0.0, 0.1, 21)


def inputs_of(fmu: Path) -> numpy.ndarray | None:
    """Every input as a wave about its start value, within its bounds."""
    columns = {"time": TIME}
    for at, (name, variable) in enumerate(variables_of(fmu).items()):
        if variable.causality == "input" and variable.type == "Real":
            start = float(variable.start)
            lowest, highest = (float(bound) if bound else None for bound in (variable.min, variable.max))
            wave = start + 0.01 * max(abs(start), 1.0) * numpy.sin(100.0 * TIME + at)
            columns[name] = wave if lowest is highest is None else numpy.clip(wave, lowest, highest)
    return numpy.rec.fromarrays(list(columns.values()), names=list(columns)) if len(columns) > 1 else None


def main(fmu: str, file: str) -> None:
    """Makes 100 steps and writes one row per step."""
    outputs = [name for name, variable in variables_of(Path(fmu)).items() if variable.causality == "output"]
    result = simulate_fmu(fmu, stop_time=0.1, output_interval=1e-3, input=inputs_of(Path(fmu)), output=outputs)
    numpy.save(file, result)


if __name__ == "__main__":
    main(*sys.argv[1:])
