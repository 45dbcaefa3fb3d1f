"""Tables of results."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from stribeck.catalogue import hint
from stribeck.places import Floats

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Runs that a picture names (chosen): matplotlib has ten colours.
MOST_NAMED = 10


def frame(axis: Axes) -> None:
    """What all axes have: a grid, and powers of ten where numbers would be long."""
    axis.grid(alpha=0.3)
    axis.ticklabel_format(scilimits=(-3, 4))


class Result(Mapping[str, Floats]):
    """Results over time: a mapping from names to arrays, of the shape (samples) or (runs, samples), with `time`."""

    def __init__(
        self,
        title: str,
        time: NDArray[np.float64],
        columns: Mapping[str, Floats],
        units: dict[str, str],
        assumed: dict[str, float] | None = None,
        inputs: dict[str, NDArray[np.float64]] | None = None,
    ) -> None:
        self.title = title
        """Name of the model or system."""
        self.time = time
        """Times in s."""
        self.columns = columns
        self.units = {"time": "s", **units}
        """Unit of each result."""
        self.assumed = assumed or {}
        """Inputs that were not given, with the value that was taken for them."""
        self.inputs = inputs or {}
        """Inputs as they were given, for pictures of results over them."""

    def __getitem__(self, name: str) -> Floats:
        if name == "time":
            return self.time
        if name not in self.columns:
            raise KeyError(f"{name!r} is not among the results of {self.title}{hint(name, self)}")
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        yield "time"
        yield from self.columns

    def __len__(self) -> int:
        return 1 + len(self.columns)

    def __repr__(self) -> str:
        shape = next(iter(self.columns.values())).shape if self.columns else self.time.shape
        assumed = "".join(f"; {name} = {value:g} (not given)" for name, value in self.assumed.items())
        return f"<{self.title}: {', '.join(self)}; shape {shape}{assumed}>"

    def to_pandas(self) -> pandas.DataFrame:
        """A DataFrame with a column per result, over `time`; of several runs over (`run`, `time`)."""
        import pandas

        first = next(iter(self.columns.values()))
        if first.ndim == 1:
            return pandas.DataFrame(self.columns, index=pandas.Index(self.time, name="time"))
        index = pandas.MultiIndex.from_product([range(first.shape[0]), self.time], names=["run", "time"])
        return pandas.DataFrame({name: column.ravel() for name, column in self.columns.items()}, index=index)

    def to_xarray(self) -> xarray.Dataset:
        """A Dataset with the units as attributes."""
        import xarray

        axes = ("run", "time")[-next(iter(self.columns.values())).ndim :]
        columns = {name: (axes, column, {"units": self.units[name]}) for name, column in self.columns.items()}
        return xarray.Dataset(columns, coords={"time": ("time", self.time, {"units": "s"})})

    def plot(self, *names: str, over: str = "time") -> Figure:
        """Draws results, all if none is named, over time, a result or an input. Returns matplotlib's Figure. A notebook
        shows new figures by itself, and this one twice unless the line ends with a semicolon."""
        import matplotlib.pyplot as plt

        names = names or tuple(name for name in self.columns if name != over)
        if not names:
            raise ValueError(f"{self.title} has no result other than {over} to draw")
        size = (6.4, max(4.8, 2.2 * len(names)))  # inches
        figure, axes = plt.subplots(len(names), 1, sharex=True, squeeze=False, layout="constrained", figsize=size)
        for name, axis in zip(names, axes[:, 0], strict=True):
            across = self.inputs[over] if over in self.inputs else self[over]
            lines = axis.plot(np.broadcast_to(across, self[name].shape).T, self[name].T, linewidth=1.0)
            # One above the other, names in one line with their units are longer than the axes.
            axis.set_ylabel(self._label(name).replace(" in ", " in " if len(names) == 1 else "\nin "))
            frame(axis)
        if 1 < len(lines) <= MOST_NAMED:
            axes[0, 0].legend(axes[0, 0].lines, [f"run {run}" for run in range(len(lines))])
        axes[-1, 0].set_xlabel(self._label(over))
        figure.suptitle(self.title)
        return figure

    def _label(self, name: str) -> str:
        unit = self.units[name]
        return f"{name} in {unit}" if unit not in ("", "1") else name
