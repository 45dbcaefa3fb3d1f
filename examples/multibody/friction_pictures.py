"""Pictures for the multibody examples: runs with and without friction, superimposed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from examples.fmpy.pictures import BLUE, GREY, RED, labelled, over_time, save


@dataclass(frozen=True)
class Quantity:
    """A column of a run and how to show it."""

    column: str
    label: str
    factor: float = 1.0

    def of(self, run: Mapping[str, numpy.ndarray]) -> numpy.ndarray:
        """Its values in the unit of the label."""
        return self.factor * run[self.column]


def draw_runs(
    title: str,
    runs: Mapping[str, Mapping[str, numpy.ndarray]],
    rows: Sequence[Quantity],
    loops: Sequence[tuple[Quantity, Quantity]],
    path: Path,
) -> None:
    """Quantities over time on the left, one quantity over another on the right.

    Of two runs the first one, with friction, is red and on top. A column `road_height` is drawn in the first row.
    """
    figure = Figure(figsize=(12, 7.2), layout="constrained")
    figure.suptitle(title, x=0.02, horizontalalignment="left")
    left, right = figure.subfigures(1, 2, width_ratios=[1.5, 1])
    upper, panels = left.subplots(len(rows), 1), right.subplots(len(loops), 1)
    first = next(iter(runs.values()))
    for axes, quantity in zip(upper, rows, strict=True):
        labelled(axes, "time [s]" if quantity is rows[-1] else "", quantity.label)
    over_time(first["time"], *upper)
    for axes, (across, up) in zip(panels, loops, strict=True):
        labelled(axes, across.label, up.label).xaxis.set_major_locator(MaxNLocator(6))
    colours = [RED, BLUE] if len(runs) > 1 else [BLUE]
    for at, (run, colour) in enumerate(zip(runs.values(), colours, strict=True)):
        _draw_run(run, upper, rows, panels, loops, {"color": colour, "linewidth": 1.2, "zorder": 4 - at})
    lines = dict(zip(runs, upper[0].get_lines(), strict=True))
    if "road_height" in first:
        road = {"color": GREY, "linestyle": "--", "linewidth": 1}
        lines["road"] = upper[0].plot(first["time"], rows[0].factor * first["road_height"], **road)[0]
    left.align_ylabels(upper)
    figure.legend(lines.values(), lines.keys(), loc="outside upper right", ncols=3, frameon=False)
    save(figure, path)


def _draw_run(
    run: Mapping[str, numpy.ndarray],
    upper: Sequence[Axes],
    rows: Sequence[Quantity],
    panels: Sequence[Axes],
    loops: Sequence[tuple[Quantity, Quantity]],
    look: Mapping[str, object],
) -> None:
    for axes, quantity in zip(upper, rows, strict=True):
        axes.plot(run["time"], quantity.of(run), **look)
    for axes, (across, up) in zip(panels, loops, strict=True):
        axes.plot(across.of(run), up.of(run), **look)
