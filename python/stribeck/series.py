"""Friction along given motions, and in steady sliding."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from stribeck import _stribeck
from stribeck._stribeck import Refused
from stribeck.catalogue import Description, Variable, law, model, number
from stribeck.places import Floats, Places
from stribeck.results import Result
from stribeck.threads import checked

# Inputs that may be left out, with the value that is taken for them and shown with the result.
UNLOADED = {"external_force": 0.0}


def force(
    name: str | Description,
    velocity: ArrayLike,
    normal_force: ArrayLike,
    *,
    preset: str | None = None,
    threads: int | None = None,
    out: Floats | None = None,
    dtype: DTypeLike | None = None,
    **parameters: Any,
) -> Floats:
    """Friction force in N in steady sliding: at a velocity held until the force no longer changes.

    All arguments are broadcast against each other, as numpy does it. `velocity` is in m/s, `normal_force` in N;
    parameters are those of `stribeck.law(name).parameters`, in SI units. At velocity 0 a law without memory carries the
    `external_force`, up to its static level; it is 0 if it is not given. Leave out `mass`: with it a step may stop the
    body, which is not steady sliding. The forces go into the array `out` if there is one, and are float32 if that, or
    `dtype`, says so; after a refusal `out` may hold some of them.

    >>> force("Coulomb", [-1.0, 2.0], 10.0, mu_k=[[0.1], [0.3]])
    array([[-1.,  1.],
           [-3.,  3.]])

    Raises `stribeck.Refused`, a ValueError, for a name that does not exist, a value outside its bound, and a law whose
    force keeps fluctuating at a held velocity.
    """
    described = law(name)
    if "velocity" not in described.inputs:
        raise Refused(f"{described.name} has the inputs {', '.join(described.inputs)}: use stribeck.simulate")
    given = {"velocity": velocity, "normal_force": normal_force, **parameters}
    # Steady sliding has no acceleration.
    for other in described.inputs:
        given.setdefault(other, 0.0)
    arrays = {key: numbers(described.find(key), value) for key, value in given.items()}
    shape = _broadcast(arrays)
    places = Places(shape, ["friction_force"], {} if out is None else {"friction_force": out}, dtype)
    columns = {key: _column(array, shape) for key, array in arrays.items()}
    found = _stribeck.settle(
        described.name,
        preset=preset,
        parameters=[(key, column[:, None]) for key, column in columns.items() if key not in described.inputs],
        inputs=[(key, column) for key, column in columns.items() if key in described.inputs],
        results=places.names,
        points=int(np.prod(shape, dtype=np.int64)),
        threads_asked=checked(threads),
        out=places.given(columns.values()),
    )
    forces = places.filled(found)["friction_force"]
    # Indexing by () turns a single number into a scalar.
    return forces if out is not None else forces[()]


def _column(array: NDArray[np.float64], shape: tuple[int, ...]) -> NDArray[np.float64]:
    """One number, or one for each point of a shape."""
    if array.size != 1:
        array = np.broadcast_to(array, shape)
    return np.require(array, np.float64, ["C", "A"]).reshape(-1)


def simulate(
    name: str | Description,
    *,
    dt: float | None = None,
    time: ArrayLike | None = None,
    held: bool = False,
    preset: str | None = None,
    record: Sequence[str] | None = None,
    threads: int | None = None,
    out: Floats | Mapping[str, Floats] | None = None,
    dtype: DTypeLike | None = None,
    **values: Any,
) -> Result:
    """Results of a model along given inputs.

    An input is a number, an array over time or an array of the shape (runs, samples); a parameter is a number, the name
    of a choice, or an array with one value per run. The samples are `dt` seconds apart, or at the times `time`. Between
    two samples inputs move along straight lines; with `held` they keep the earlier value, as in an FMU without input
    derivatives. Results at a sample belong to the inputs of the sample. `record` chooses the results (default: all
    outputs). They go into the arrays `out`, a mapping from names to arrays or the array of a single result, as far as
    there are some, and are float32 where that, or `dtype`, says so; after a refusal `out` may hold some of them.

    >>> import numpy
    >>> t = numpy.arange(0.0, 1.0, 1e-3)
    >>> result = simulate("LuGre", velocity=1e-3 * numpy.sin(6.28 * t), normal_force=10.0, dt=1e-3, sigma_0=[1e4, 1e5])
    >>> result["friction_force"].shape, result.units["friction_force"]
    ((2, 1000), 'N')

    All inputs must be given, apart from `external_force`, which is 0 if it is not. Runs are made by all processors,
    with the interpreter lock released; the bits do not depend on the number of `threads`. Raises `stribeck.Refused`, a
    ValueError, naming run, sample, variable, value and bound.
    """
    if not isinstance(held, (bool, np.bool_)):
        raise TypeError(f"held = {held!r}: must be True or False")
    described = model(name)
    # A misspelled name is reported before a missing input.
    arrays = {key: numbers(described.find(key), value) for key, value in values.items()}
    assumed = _assumed(described, arrays)
    arrays |= {key: np.asarray(value) for key, value in assumed.items()}
    times, step = _sampling(dt, time)
    inputs = {key: array for key, array in arrays.items() if key in described.inputs}
    samples = _samples(inputs, times)
    runs, single = _runs(described, arrays)
    results = _results(described, record)
    shape = (samples,) if single else (runs, samples)
    places = Places(shape, results, _given(out, results), dtype)
    inputs, times = places.apart(inputs, times)
    flat = _stribeck.follow(
        described.name,
        preset=preset,
        parameters=[(key, array.reshape(-1, 1)) for key, array in arrays.items() if key not in described.inputs],
        inputs=[(key, np.atleast_2d(array)) for key, array in inputs.items()],
        dt=step,
        times=times,
        held=bool(held),
        results=results,
        runs=runs,
        samples=samples,
        threads_asked=checked(threads),
        out=places.given(arrays.values()),
    )
    times = _every(step, samples) if times is None else times
    units = {key: described.variables[key].unit for key in [*results, *inputs]}
    return Result(described.name, times, places.filled(flat), units, assumed, inputs)


def _sampling(dt: float | None, time: ArrayLike | None) -> tuple[NDArray[np.float64] | None, float]:
    """The times, or the interval between them."""
    if (dt is None) == (time is None):
        raise TypeError("give either dt or time")
    return (None, checked_step(dt)) if time is None else (_times(time), 0.0)


def _every(step: float, samples: int) -> NDArray[np.float64]:
    """Times at this interval."""
    times = np.arange(samples, dtype=np.float64)
    # In place: new memory takes longer than a cheap law.
    times *= step
    return times


def numbers(variable: Variable, value: Any) -> NDArray[np.float64]:
    """A value, or an array of values, as numbers."""
    if variable.role == "Output":
        raise Refused(f"{variable.name} is computed and cannot be set")
    if isinstance(value, str):
        return np.asarray(variable.number(value))
    if np.ma.is_masked(value):
        raise TypeError(f"{variable.name}: some of its numbers are masked")
    array = np.asarray(value)
    if array.dtype.kind == "U" and variable.kind == "choice":
        return np.array([variable.number(str(one)) for one in array.ravel()]).reshape(array.shape)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"{variable.name}: must be numbers, not {array.dtype}")
    return np.asarray(array, dtype=np.float64, order="C")


def _broadcast(arrays: Mapping[str, NDArray[np.float64]]) -> tuple[int, ...]:
    try:
        return np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise Refused(f"the shapes do not fit together: {shapes}") from None


def _assumed(described: Description, given: Mapping[str, object]) -> dict[str, float]:
    """Default values of inputs that are not given; an error for those without a default."""
    missing = [name for name in described.inputs if name not in given]
    needed = [name for name in missing if name not in UNLOADED]
    if needed:
        hint = " (for example numpy.gradient(velocity, dt))" if needed[0] == "acceleration" else ""
        raise Refused(f"{described.name} needs the input {needed[0]}{hint}")
    return {name: UNLOADED[name] for name in missing}


def _times(time: ArrayLike) -> NDArray[np.float64]:
    given = np.asarray(time)
    if given.dtype.kind not in "iuf":
        raise TypeError(f"time: must be numbers, in s, not {given.dtype}")
    times = np.ascontiguousarray(given, dtype=np.float64)
    if times.ndim != 1:
        raise Refused(f"time has the shape {times.shape}: must have one dimension")
    late = np.flatnonzero(~(np.diff(times) > 0.0))
    if late.size:
        at = int(late[0])
        raise Refused(f"time[{at + 1}] = {times[at + 1]} s after {times[at]} s: must grow")
    return times


def checked_step(dt: float | None) -> float:
    step = number("dt", dt)
    if not 0.0 < step < np.inf:
        raise Refused(f"dt = {step} s: must be > 0 and finite")
    return step


def _samples(inputs: Mapping[str, NDArray[np.float64]], times: NDArray[np.float64] | None) -> int:
    """Number of samples, on which all inputs and the times agree."""
    for name, array in inputs.items():
        if array.ndim > 2:
            raise Refused(f"{name} has the shape {array.shape}: must be (samples) or (runs, samples)")
    lengths = {name: array.shape[-1] for name, array in inputs.items() if array.ndim > 0 and array.shape[-1] != 1}
    if times is not None:
        lengths["time"] = len(times)
    return _agreed("samples", lengths)


def _runs(described: Description, arrays: Mapping[str, NDArray[np.float64]]) -> tuple[int, bool]:
    """Number of runs, and whether it is a single run without an axis of runs."""
    counts = {}
    for name, array in arrays.items():
        runs_axis = array.ndim - (1 if name in described.inputs else 0)
        if runs_axis > 1:
            raise Refused(f"{name} has the shape {array.shape}: must have one value per run")
        if runs_axis == 1:
            counts[name] = array.shape[0]
    return _agreed("runs", {name: count for name, count in counts.items() if count != 1}), not counts


def _agreed(what: str, numbers: Mapping[str, int]) -> int:
    """The number of samples or runs on which all arrays agree; 1 if there is none."""
    listed = ", ".join(f"{name} {number}" for name, number in numbers.items())
    if len(set(numbers.values())) > 1:
        raise Refused(f"the numbers of {what} differ: {listed}")
    agreed = next(iter(numbers.values()), 1)
    if agreed == 0:
        raise Refused(f"number of {what}: {listed}: must be >= 1")
    return agreed


def _given(out: Floats | Mapping[str, Floats] | None, results: list[str]) -> Mapping[str, Any]:
    """The arrays for results, by name."""
    if out is None or isinstance(out, Mapping):
        return out or {}
    if len(results) > 1:
        raise Refused(f"out: must be a mapping from names to arrays, for the results {', '.join(results)}")
    return {results[0]: out}


def _results(described: Description, record: Sequence[str] | None) -> list[str]:
    if record is None:
        return list(described.outputs)
    names = [record] if isinstance(record, str) else list(record)
    if not names:
        raise Refused("record names no result")
    return [described.find(name).name for name in names]
