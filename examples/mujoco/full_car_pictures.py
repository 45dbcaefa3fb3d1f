"""The pictures of the full car."""

from collections.abc import Mapping
from pathlib import Path

import numpy
from matplotlib.figure import Figure
from pictures import BLUE, RED, _axes, _over_time, _save

Runs = Mapping[str, Mapping[str, numpy.ndarray]]


def _figure(title: str, rows: list[str]) -> tuple[Figure, dict]:
    """Panels over time on the left; on the right friction over velocity and over compression, front left."""
    figure = Figure(figsize=(12, 7.2), layout="constrained")
    figure.suptitle(title, x=0.02, horizontalalignment="left")
    half = len(rows) // 2
    places = [[row, "f(v)" if at < half else "f(s)"] for at, row in enumerate(rows)]
    return figure, figure.subplot_mosaic(places, width_ratios=[1.5, 1])


def _draw(runs: Runs, title: str, rows: dict[str, tuple[str, float]], path: Path) -> None:
    """`rows` are the quantities over time, each with its label and the factor of its unit."""
    figure, panels = _figure(title, list(rows))
    time = next(iter(runs.values()))["time"]
    for name, (label, _) in rows.items():
        _axes(panels[name], "time [s]" if name == list(rows)[-1] else "", label)
    _axes(panels["f(v)"], "velocity of the strut, front left [m/s]", "friction force [N]")
    _axes(panels["f(s)"], "length of the strut, front left [mm]", "friction force [N]")
    for at, (label, run) in enumerate(runs.items()):
        look = {"color": RED if label == "with friction" else BLUE, "linewidth": 1.2, "zorder": 4 - at}
        for name, (_, factor) in rows.items():
            panels[name].plot(time, factor * run[name], label=label, **look)
        panels["f(v)"].plot(run["fl.velocity"], run["fl.friction"], **look)
        panels["f(s)"].plot(1e3 * run["fl.length"], run["fl.friction"], **look)
    _over_time(time, *(panels[name] for name in rows))
    figure.legend(handles=panels[next(iter(rows))].get_lines(), loc="outside upper right", ncols=2, frameon=False)
    _save(figure, path)


def draw_four_post(runs: Runs, title: str, path: Path) -> None:
    """Heave, pitch, friction and tyre load over time."""
    rows = {
        "heave": ("heave [mm]", 1e3),
        "pitch": ("pitch [degrees]", 57.29577951308232),
        "fl.friction": ("friction, fl [N]", 1.0),
        "fl.tyre_load": ("tyre load, fl [kN]", 1e-3),
    }
    _draw(runs, title, rows, path)


def draw_lane_change(runs: Runs, title: str, path: Path) -> None:
    """Path, roll, friction and tyre load over time."""
    rows = {
        "position_y": ("lateral position [m]", 1.0),
        "roll": ("roll [degrees]", 57.29577951308232),
        "fl.friction": ("friction, fl [N]", 1.0),
        "fl.tyre_load": ("tyre load, fl [kN]", 1e-3),
    }
    _draw(runs, title, rows, path)
