"""Many instances of one model, which the caller steps together."""

from __future__ import annotations

import operator
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from stribeck import _stribeck
from stribeck._stribeck import Refused
from stribeck.catalogue import Description, Variable, model
from stribeck.places import Floats, Places
from stribeck.series import checked_step, numbers

# What is recorded if nothing else is asked for.
FORCE = "friction_force"


class Batch:
    """Runs of one model that the caller steps together: see `stribeck.batch`."""

    def __init__(
        self,
        name: str | Description,
        runs: int,
        *,
        preset: str | None = None,
        record: str = FORCE,
        **values: Any,
    ) -> None:
        self.description = model(name)
        """The model."""
        self.runs = operator.index(runs)
        """Number of runs."""
        if self.runs < 1:
            raise Refused(f"runs = {self.runs}: must be >= 1")
        if record not in self.description.outputs:
            known = ", ".join(self.description.outputs)
            raise Refused(f"record: {record} is not among the outputs of {self.description.name}: {known}")
        self.record = record
        """The output that `step` returns."""
        self._batch = _stribeck.Batch(self.description.name, preset, self.runs)
        self._columns: dict[str, int] = {}
        self.set(**values)

    def step(
        self, dt: float, *, out: Floats | None = None, dtype: DTypeLike | None = None, **inputs: ArrayLike
    ) -> Floats:
        """Advances all runs by `dt` seconds while their inputs are held, and returns the recorded output as it is then.

        Inputs that are not given keep their values; each is one number, or one for each run. The result goes into the
        array `out` if there is one. After a refusal no run has moved and no input has changed; `out` may hold results.
        """
        given = [(self._column(name), self._values(name, value, {"Input"})) for name, value in inputs.items()]
        step, result = checked_step(dt), self._column(self.record)
        if out is not None and dtype is None and self._is_plain(out, given):
            self._batch.step(step, given, result, out)
            return out
        places = self._places(self.record, out, dtype)
        (place,) = places.given(array for _, array in given)
        self._batch.step(step, given, result, place)
        return places.filled([])[self.record]

    def get(self, name: str, *, out: Floats | None = None, dtype: DTypeLike | None = None) -> Floats:
        """A variable, one value for each run; an output belongs to the present states and inputs."""
        places = self._places(name, out, dtype)
        (place,) = places.given([])
        self._batch.get(self._column(name), place)
        return places.filled([])[name]

    def __getitem__(self, name: str) -> Floats:
        return self.get(name)

    def set(self, **values: Any) -> None:
        """Sets inputs, parameters and states, each to one value or to one for each run: all, or none if one is refused.

        Names with points as `**{"friction.mu_k": 0.1}`.
        """
        self._batch.set([(self._column(name), self._values(name, value)) for name, value in values.items()])

    def reset(self, mask: ArrayLike | None = None) -> None:
        """Resets the states to their start values and the time to 0, of all runs or of those with a mask of Booleans.

        Parameters and inputs stay as they are.
        """
        if mask is None:
            return self._batch.reset(None)
        given = np.asarray(mask)
        if given.dtype.kind != "b":
            raise TypeError(f"mask: must be Booleans, not {given.dtype}")
        if given.shape != (self.runs,):
            raise Refused(f"mask has the shape {given.shape}: must be {(self.runs,)}")
        return self._batch.reset(np.ascontiguousarray(given))

    def states(self) -> dict[str, Floats]:
        """The states of all runs. `batch.set(**states)` goes on from there, in this batch or in another one with the
        same parameters. Refused for a model that keeps more than its variables show."""
        if not self._batch.shows_all_states():
            raise Refused(f"{self.description.name} keeps more than its variables show")
        return {name: self.get(name) for name in self.description.of_role("State", "StateOutput")}

    @property
    def time(self) -> NDArray[np.float64]:
        """Time of each run in s."""
        return self._batch.times()

    def derivatives(
        self, by: str | Sequence[str], *, of: str | Sequence[str] | None = None, dt: float | None = None
    ) -> dict[str, dict[str, NDArray[np.float64]]]:
        """Exact derivatives of results by inputs, parameters and states: `["friction_force"]["velocity"]`.

        Of the recorded output, unless `of` names other results. Without `dt` they are those of the present outputs,
        while the states are held. With `dt` they are those of outputs and states after a step from here, which is not
        made: with them a gradient passes through many steps. Laws whose steps have modes have the first kind only.
        """
        of_names, by_names = _names(self.record if of is None else of), _names(by)
        columns = [[self._column(name) for name in names] for names in (of_names, by_names)]
        found = iter(self._batch.derivatives(*columns, None if dt is None else checked_step(dt)))
        return {result: {name: next(found) for name in by_names} for result in of_names}

    def __repr__(self) -> str:
        return f"<{self.runs} runs of {self.description.name}>"

    def _is_plain(self, out: Any, given: list[tuple[int, NDArray[np.float64]]]) -> bool:
        """Whether results can go into an array just as it is. A short way: it is asked on every step."""
        return (
            type(out) is np.ndarray
            and out.dtype == np.float64
            and out.shape == (self.runs,)
            and out.flags.carray
            and not any(np.may_share_memory(out, array) for _, array in given)
        )

    def _places(self, name: str, out: Floats | None, dtype: DTypeLike | None) -> Places:
        return Places((self.runs,), [name], {} if out is None else {name: out}, dtype, plain=False)

    def _column(self, name: str) -> int:
        if name not in self._columns:
            self._columns[name] = self._batch.column(name)
        return self._columns[name]

    def _values(self, name: str, value: Any, roles: Iterable[str] = ()) -> NDArray[np.float64]:
        variable = self.description.variables.get(name) or self.description.find(name)
        if roles and variable.role not in roles:
            raise Refused(f"{name} is not an input: set it between steps")
        return self._each(variable, numbers(variable, value))

    def _each(self, variable: Variable, array: NDArray[np.float64]) -> NDArray[np.float64]:
        """One number, or one for each run."""
        if array.ndim == 0:
            return array.reshape(1)
        if array.shape != (self.runs,):
            raise Refused(f"{variable.name} has the shape {array.shape}: must be one number, or {(self.runs,)}")
        return array


def _names(names: str | Sequence[str]) -> list[str]:
    return [names] if isinstance(names, str) else list(names)


def batch(
    name: str | Description, runs: int, *, preset: str | None = None, record: str = FORCE, **values: Any
) -> Batch:
    """Many instances of one model, which the caller steps together: velocities in, forces out.

    Each of the `values`, inputs, parameters and states, is one for all runs, or an array with one for each. `record`
    names the output that a step returns.

    >>> contacts = batch("LuGre", 3, normal_force=10.0, sigma_0=[1e4, 1e5, 1e6])
    >>> contacts.step(1e-3, velocity=1e-5)
    array([0.00326306, 0.00416084, 0.013109  ])
    >>> contacts.derivatives("velocity")["friction_force"]["velocity"].round(1)
    array([316.3, 316.1, 314.2])

    A run has the bits of a `Model` that is stepped alone. Raises `stribeck.Refused`, a ValueError, for what is refused,
    with run, variable, value and bound; nothing has changed then.
    """
    return Batch(name, runs, preset=preset, record=record, **values)
