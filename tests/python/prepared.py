"""FMI functions with arguments prepared once: a step of a loop takes a seventh of the time of fmpy's functions."""

import ctypes
import functools

from fmpy.fmi1 import FMICallException

from examples.fmpy.coupling import Fmu

# The largest status with which a run continues: OK is 0, a warning 1.
WARNING = 1

# A function of an FMU that needs no more arguments and returns its status.
Call = functools.partial[int]


def prepared(fmu: Fmu, name: str, *arguments) -> Call:
    """Binds arguments of C types, which are read at each call, to a function of an FMU."""
    function = ctypes.PyDLL(None, handle=fmu.slave.dll._handle)[name]
    function.restype = ctypes.c_int
    return functools.partial(function, ctypes.c_void_p(fmu.slave.component), *arguments)


def make(*calls: Call) -> None:
    """Makes calls one after another; the first failing one ends the run."""
    for call in calls:
        status = call()
        if status > WARNING:
            raise FMICallException(function=call.func.__name__, status=status)


class Reals:
    """Real variables of an FMU; `values` holds the values read or to be set."""

    def __init__(self, fmu: Fmu, *names: str, values: ctypes.Array | None = None):
        references = fmu.references(*names)
        self.values = (ctypes.c_double * len(references))() if values is None else values
        array = (ctypes.c_uint * len(references))(*references)
        arguments = array, ctypes.c_size_t(len(references)), self.values
        self.get = prepared(fmu, "fmi2GetReal", *arguments)
        self.set = prepared(fmu, "fmi2SetReal", *arguments)


class Flag:
    """A Boolean output of an FMU."""

    def __init__(self, fmu: Fmu, name: str):
        self.values = (ctypes.c_int * 1)()
        reference = (ctypes.c_uint * 1)(*fmu.references(name))
        self.get = prepared(fmu, "fmi2GetBoolean", reference, ctypes.c_size_t(1), self.values)


class Clock:
    """Time and step of a co-simulation."""

    def __init__(self, step: float):
        self.step, self.time = ctypes.c_double(step), ctypes.c_double(0.0)

    def do_step(self, fmu: Fmu) -> Call:
        """The step of an FMU from `time`; it never goes back to an earlier time."""
        return prepared(fmu, "fmi2DoStep", self.time, self.step, ctypes.c_int(1))
