"""Pictures for the example programs."""

from pathlib import Path

import numpy
from matplotlib.axes import Axes
from matplotlib.figure import Figure

BLUE, RED, GREY = "#1f5a96", "#c0392b", "#6b7280"
PALE = "#e8eef5"


def labelled(axes: Axes, across: str, up: str) -> Axes:
    """Labels axes and gives them the common style of all pictures."""
    axes.set_xlabel(across)
    axes.set_ylabel(up)
    axes.grid(color="#d9dde3", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    return axes


def over_time(time: numpy.ndarray, *rows: Axes) -> None:
    """Gives stacked axes the same time axis, with numbers at the lowest one."""
    for axes in rows:
        axes.set_xlim(time[0], time[-1])
        axes.tick_params(labelbottom=axes is rows[-1])


def save(figure: Figure, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110)


def draw_replay(result, path: Path) -> None:
    """The recorded inputs, and the friction force over time, velocity and displacement."""
    motion = result.motion
    figure = Figure(figsize=(12, 7.2), layout="constrained")
    figure.suptitle(f"Recorded motion, friction model {result.model}")
    panels = figure.subplot_mosaic(
        [["velocity", "velocity"], ["load", "load"], ["force", "force"], ["f(v)", "f(x)"]],
        height_ratios=[1, 1, 1, 2.2],
    )
    velocity = labelled(panels["velocity"], "", "velocity\n[mm/s]")
    load = labelled(panels["load"], "", "normal force\n[N]")
    force = labelled(panels["force"], "time [s]", "friction force\n[N]")
    over_velocity = labelled(panels["f(v)"], "velocity [mm/s]", "friction force [N]")
    over_position = labelled(panels["f(x)"], "position [mm]", "friction force [N]")
    velocity.plot(motion.time, 1e3 * motion.velocity, color=BLUE, linewidth=0.9)
    load.plot(motion.time, motion.normal_force, color=GREY, linewidth=0.5)
    force.plot(motion.time, result.friction_force, color=RED, linewidth=0.9)
    over_time(motion.time, velocity, load, force)
    over_velocity.plot(1e3 * motion.velocity, result.friction_force, color=RED, linewidth=0.6)
    over_position.plot(1e3 * motion.position, result.friction_force, color=RED, linewidth=0.6)
    save(figure, path)
