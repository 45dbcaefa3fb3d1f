"""Pictures for the example programs."""

from pathlib import Path

import numpy
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter

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


def _shade_sticking(axes: Axes, time: numpy.ndarray, sticking: numpy.ndarray) -> None:
    """Shades the intervals in which the contact sticks."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], sticking.astype(int), [0]))))
    for begin, end in zip(edges[0::2], edges[1::2], strict=True):
        axes.axvspan(time[begin], time[min(end, len(time) - 1)], color=PALE, linewidth=0)


def save(figure: Figure, path: Path) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, dpi=110)


def draw_belt(run, path: Path) -> None:
    """Position, velocity and friction force over time, and friction force over velocity."""
    figure = Figure(figsize=(12, 7.2), layout="constrained")
    figure.suptitle(f"Block on a moving belt, friction model {run.model}")
    places = [["position", "law"], ["velocity", "law"], ["force", "law"]]
    panels = figure.subplot_mosaic(places, width_ratios=[1.6, 1])
    position = labelled(panels["position"], "", "position [m]")
    velocity = labelled(panels["velocity"], "", "velocity [m/s]")
    force = labelled(panels["force"], "time [s]", "friction force [N]")
    law = labelled(panels["law"], "velocity of the block relative to the belt [mm/s]", "friction force [N]")
    over_time(run.time, position, velocity, force)
    for axes in (position, velocity, force):
        _shade_sticking(axes, run.time, run.sticking)
    position.plot(run.time, run.position, color=BLUE, label="block")
    velocity.plot(run.time, run.block_velocity, color=BLUE, label="block")
    velocity.plot(run.time, run.block_velocity - run.velocity, color=GREY, linestyle="--", linewidth=1, label="belt")
    force.plot(run.time, run.friction_force, color=RED)
    figure.legend(
        handles=[*velocity.get_lines(), Patch(color=PALE, label="sticking")],
        loc="outside upper right",
        ncols=3,
        frameon=False,
    )
    law.plot(1e3 * run.velocity, run.friction_force, color=RED, linewidth=1.2)
    # Linear within 1 mm/s, where friction laws vary most, logarithmic outside.
    law.set_xscale("symlog", linthresh=1.0, linscale=1.0)
    law.set_xlim(min(-1e3, 1e3 * run.velocity.min()), max(1e1, 1e3 * run.velocity.max()))
    law.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    save(figure, path)


def draw_overlay(runs, path: Path) -> None:
    """Several friction models in the same axes: position, relative velocity, acceleration and friction force."""
    figure = Figure(figsize=(12, 9), layout="constrained")
    figure.suptitle("Block on a moving belt")
    rows = figure.subplots(4, 1)
    quantities = {
        "position [m]": "position",
        "velocity relative\nto the belt [m/s]": "velocity",
        "acceleration [m/s2]": "acceleration",
        "friction force [N]": "friction_force",
    }
    for axes, (up, name) in zip(rows, quantities.items(), strict=True):
        labelled(axes, "time [s]" if axes is rows[-1] else "", up)
        # The ten colours repeat; from the eleventh model on the lines are dashed, then dotted.
        for at, run in enumerate(runs):
            style = ("-", "--", ":", "-.")[at // 10 % 4]
            axes.plot(run.time, getattr(run, name), color=f"C{at % 10}", linestyle=style, linewidth=1.1)
    over_time(runs[0].time, *rows)
    for line, run in zip(rows[0].get_lines(), runs, strict=True):
        line.set_label(run.model)
    figure.legend(handles=rows[0].get_lines(), loc="outside lower center", ncols=min(len(runs), 6), frameon=False)
    save(figure, path)


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


def draw_comparison(runs, path: Path) -> None:
    """Position of the block over time, one small picture per friction model; many models are shown in several
    columns."""
    columns = 1 if len(runs) <= 8 else 4
    rows = -(-len(runs) // columns)
    figure = Figure(figsize=(12 if columns == 1 else 16, 1.3 * rows + 1.2), layout="constrained")
    figure.suptitle("Block on a moving belt: the same benchmark with each friction model")
    figure.supylabel("position [m]", fontsize="medium")
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, run in zip(grid.flat, runs, strict=False):
        labelled(axes, "", "")
        _shade_sticking(axes, run.time, run.sticking)
        axes.plot(run.time, run.position, color=BLUE)
        axes.set_title(run.model, loc="left", fontsize="medium")
        axes.set_xlim(run.time[0], run.time[-1])
    for axes in grid.flat[len(runs) :]:
        axes.set_axis_off()
    figure.supxlabel("time [s]", fontsize="medium")
    figure.legend(handles=[Patch(color=PALE, label="sticking")], loc="outside upper right", frameon=False)
    save(figure, path)
