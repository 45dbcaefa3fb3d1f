"""The pictures of the example programs."""

from pathlib import Path

import numpy
from matplotlib.axes import Axes
from matplotlib.figure import Figure

BLUE, RED, GREY = "#1f5a96", "#c0392b", "#6b7280"
STICKING = "#e8eef5"


def _axes(axes: Axes, across: str, up: str) -> Axes:
    """Labels axes and gives them the look that all pictures share."""
    axes.set_xlabel(across)
    axes.set_ylabel(up)
    axes.grid(color="#d9dde3", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    return axes


def _shade_sticking(axes: Axes, time: numpy.ndarray, sticking: numpy.ndarray) -> None:
    """Shades the intervals in which the contact sticks."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], sticking.astype(int), [0]))))
    for begin, end in zip(edges[0::2], edges[1::2], strict=True):
        axes.axvspan(time[begin], time[min(end, len(time) - 1)], color=STICKING, linewidth=0)


def _save(figure: Figure, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110)


def draw_belt(run, path: Path) -> None:
    """Position, velocity and friction force over time, and friction force over velocity."""
    figure = Figure(figsize=(12, 7.2), layout="constrained")
    figure.suptitle(f"Block on a moving belt, friction model {run.model}")
    over_time = figure.subplot_mosaic([["x", "f(v)"], ["v", "f(v)"], ["f", "f(v)"]], width_ratios=[1.5, 1])
    position = _axes(over_time["x"], "", "position [m]")
    velocity = _axes(over_time["v"], "", "velocity [m/s]")
    force = _axes(over_time["f"], "time [s]", "friction force [N]")
    for axes in (position, velocity, force):
        _shade_sticking(axes, run.time, run.sticking)
        axes.set_xlim(run.time[0], run.time[-1])
    position.plot(run.time, run.position, color=BLUE)
    velocity.plot(run.time, run.block_velocity, color=BLUE, label="block")
    velocity.plot(run.time, run.block_velocity - run.velocity, color=GREY, linestyle="--", label="belt")
    force.plot(run.time, run.friction_force, color=RED)
    law = _axes(over_time["f(v)"], "velocity of the block relative to the belt [m/s]", "friction force [N]")
    law.plot(run.velocity, run.friction_force, color=RED)
    _save(figure, path)


def draw_replay(result, path: Path) -> None:
    """The recorded inputs, and the friction force over time, velocity and displacement."""
    motion = result.motion
    figure = Figure(figsize=(12, 7.2), layout="constrained")
    figure.suptitle(f"Recorded motion, friction model {result.model}")
    panels = figure.subplot_mosaic(
        [["velocity", "velocity"], ["load", "load"], ["force", "force"], ["f(v)", "f(x)"]],
        height_ratios=[1, 1, 1, 2.2],
    )
    velocity = _axes(panels["velocity"], "", "velocity\n[mm/s]")
    load = _axes(panels["load"], "", "normal force\n[N]")
    force = _axes(panels["force"], "time [s]", "friction force\n[N]")
    over_velocity = _axes(panels["f(v)"], "velocity [mm/s]", "friction force [N]")
    over_position = _axes(panels["f(x)"], "position [mm]", "friction force [N]")
    velocity.plot(motion.time, 1e3 * motion.velocity, color=BLUE, linewidth=0.9)
    load.plot(motion.time, motion.normal_force, color=GREY, linewidth=0.5)
    force.plot(motion.time, result.friction_force, color=RED, linewidth=0.9)
    for axes in (velocity, load, force):
        axes.set_xlim(motion.time[0], motion.time[-1])
    over_velocity.plot(1e3 * motion.velocity, result.friction_force, color=RED, linewidth=0.6)
    over_position.plot(1e3 * motion.position, result.friction_force, color=RED, linewidth=0.6)
    _save(figure, path)
