"""Arrays that results go into: arrays of the caller, or new ones."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from itertools import combinations
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import DTypeLike, NDArray

from stribeck._stribeck import Refused

Floats: TypeAlias = NDArray[np.float64] | NDArray[np.float32]

NUMBERS = (np.dtype(np.float64), np.dtype(np.float32))


class Places:
    """Places for the results of a call, of one shape: the arrays `out`, and new ones of the type `dtype`."""

    def __init__(
        self,
        shape: tuple[int, ...],
        names: list[str],
        out: Mapping[str, Any],
        dtype: DTypeLike | None,
        plain: bool = True,
    ) -> None:
        asked = None if dtype is None else np.dtype(dtype)
        if asked is not None and asked not in NUMBERS:
            raise TypeError(f"dtype = {asked}: must be float64 or float32")
        for name, array in out.items():
            if name not in names:
                raise Refused(f"out: {name} is not among the results {', '.join(names)}")
            _check(name, array, shape, asked)
        for one, other in combinations(out, 2):
            if np.shares_memory(out[one], out[other]):
                raise Refused(f"out: {one} and {other} share memory")
        self.shape, self.names, self.out = shape, names, dict(out)
        # Without one of these the results go into memory that is used again and again.
        self.is_plain = plain and not out and asked in (None, NUMBERS[0])
        self.new = asked or NUMBERS[0]
        self.flat: list[Floats] = []

    def apart(
        self, inputs: Mapping[str, NDArray[np.float64]], times: NDArray[np.float64] | None
    ) -> tuple[dict[str, NDArray[np.float64]], NDArray[np.float64] | None]:
        """Inputs and times, as copies where results will be written over them: a result keeps what it was computed
        from."""

        def kept(array: NDArray[np.float64]) -> NDArray[np.float64]:
            return array.copy() if any(np.may_share_memory(array, place) for place in self.out.values()) else array

        return {key: kept(array) for key, array in inputs.items()}, None if times is None else kept(times)

    def given(self, others: Iterable[NDArray[np.float64]]) -> list[Floats] | None:
        """The arrays that are written to, flat; none if new ones of float64 will do. An array that overlaps with
        another one, or is not contiguous, gets its numbers at the end."""
        if self.is_plain:
            return None
        taken = list(others)
        for name in self.names:
            array = self.out.get(name)
            # A matrix has no flat form of its own.
            array = None if array is None else np.asarray(array)
            if array is None:
                self.flat.append(np.empty(self.shape, self.new).reshape(-1))
                continue
            is_free = array.flags.c_contiguous and not any(np.may_share_memory(array, other) for other in taken)
            taken.append(array)
            self.flat.append(
                (array if is_free and array.flags.aligned else np.empty(self.shape, array.dtype)).reshape(-1)
            )
        return self.flat

    def filled(self, new: list[NDArray[np.float64]]) -> dict[str, Floats]:
        """The results by name, once they are there."""
        found = {}
        for name, flat in zip(self.names, new if self.is_plain else self.flat, strict=True):
            array = self.out.get(name)
            if array is None:
                array = flat.reshape(self.shape)
            elif not np.may_share_memory(array, flat):
                array[...] = flat.reshape(self.shape)
            found[name] = array
        return found


def _check(name: str, array: Any, shape: tuple[int, ...], asked: np.dtype[Any] | None) -> None:
    """Refuses what cannot hold a result."""
    if not isinstance(array, np.ndarray):
        raise TypeError(f"out: {name} must be an array of numpy, not {type(array).__name__}")
    if array.dtype not in NUMBERS or asked not in (None, array.dtype):
        raise TypeError(f"out: {name} has the type {array.dtype}: must be {asked or 'float64 or float32'}")
    if array.shape != shape:
        raise Refused(f"out: {name} has the shape {array.shape}: must be {shape}")
    if not array.flags.writeable:
        raise Refused(f"out: {name} is read-only")
    if any(count > 1 and stride == 0 for count, stride in zip(array.shape, array.strides, strict=True)):
        raise Refused(f"out: {name} has several elements in one place")
