#!/usr/bin/env python3
"""Cost of `stribeck.simulate` for a long series, as a part of that of the native loop over the same samples:
`stribeck_run` of the C interface, from the library in the package's FMUs. Processor time, both in turn in each round;
medians.

    python3 benches/simulate.py    with a Python that has the wheel
"""

import ctypes
import statistics
import tempfile
import time
import zipfile

import numpy
import stribeck

SAMPLES = 100_000
DT = 1e-4
ROUNDS = 15
LAWS = ["Coulomb", "CoulombStiction", "Threlfall", "BrownMcPhee", "Karnopp", "Dahl", "LuGre", "MaxwellSlip"]


class Arrays(ctypes.Structure):
    """`stribeck_samples` and `stribeck_results`."""

    _fields_ = (("references", ctypes.c_void_p), ("values", ctypes.c_void_p), ("count", ctypes.c_size_t))


class Native:
    """A law in C, and arrays for its results."""

    def __init__(self, library: ctypes.CDLL, law: str, inputs: dict[str, numpy.ndarray], names: list[str]) -> None:
        self.library = library
        self.model = ctypes.c_void_p()
        assert library.stribeck_create(law.encode(), ctypes.byref(self.model)) == 0
        self.results = {name: numpy.empty(SAMPLES) for name in names}
        self.given, self.found = self.arrays(inputs), self.arrays(self.results)

    def arrays(self, columns: dict[str, numpy.ndarray]) -> Arrays:
        """The columns as the C interface takes them."""
        found = ctypes.c_uint32()
        references = numpy.empty(len(columns), dtype=numpy.uint32)
        for number, name in enumerate(columns):
            assert self.library.stribeck_find(self.model, name.encode(), ctypes.byref(found)) == 0, name
            references[number] = found.value
        pointers = numpy.array([column.ctypes.data for column in columns.values()], dtype=numpy.uintp)
        arrays = Arrays(references.ctypes.data, pointers.ctypes.data, len(columns))
        arrays.kept = (references, pointers)
        return arrays

    def run(self) -> None:
        """Leads it along the samples from the start."""
        self.library.stribeck_reset(self.model)
        status = self.library.stribeck_run(
            self.model, ctypes.c_double(DT), SAMPLES, 1, ctypes.byref(self.given), ctypes.byref(self.found)
        )
        assert status == 0


def main() -> None:
    """Prints a line per law."""
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(stribeck.fmu("LuGre", folder)) as fmu:
        (name,) = (name for name in fmu.namelist() if name.startswith("binaries/"))
        library = ctypes.CDLL(fmu.extract(name, folder))
    handles = [ctypes.c_void_p] * 2
    library.stribeck_run.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_size_t, ctypes.c_int, *handles]
    times = DT * numpy.arange(SAMPLES)
    velocity = 5e-3 * numpy.sin(20.0 * times) * numpy.cos(3.0 * times)
    for law in LAWS:
        inputs = {name: numpy.zeros(SAMPLES) for name in stribeck.law(law).inputs}
        inputs |= {"velocity": velocity, "normal_force": numpy.full(SAMPLES, 10.0)}
        names = list(stribeck.law(law).outputs)
        native = Native(library, law, inputs, names)

        def simulated(law=law, inputs=inputs):
            return stribeck.simulate(law, dt=DT, held=True, threads=1, **inputs)

        rounds = []
        # The first rounds take new memory from the system; the median does not see them.
        for _ in range(ROUNDS):
            costs = []
            for work in (native.run, simulated):
                begin = time.process_time()
                work()
                costs.append((time.process_time() - begin) / SAMPLES * 1e9)
            rounds.append(costs)
        result = simulated()
        assert all(result[name].tobytes() == native.results[name].tobytes() for name in names), law
        ratio = statistics.median(ours / theirs for theirs, ours in rounds)
        theirs, ours = (statistics.median(costs) for costs in zip(*rounds, strict=True))
        print(f"figure: {law}: native {theirs:.1f} ns a sample, simulate {ours:.1f} ns, ratio {ratio:.2f}", flush=True)


if __name__ == "__main__":
    main()
