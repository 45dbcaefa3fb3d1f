"""Pictures for the programs with a car."""

from collections.abc import Sequence
from pathlib import Path

import numpy
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator

from examples.fmpy.pictures import BLUE, GREY, PALE, RED, labelled, over_time, save

DEGREES = 180.0 / numpy.pi

# Friction off, then on in rising levels.
COLOURS = [GREY, BLUE, RED, "#2e8b57", "#b7791f", "#6b4fa0"]


def _look(at: int) -> dict[str, object]:
    """Colour and line style of a run by its position."""
    return {"color": COLOURS[at % len(COLOURS)], "linewidth": 1.1 if at else 1.4}


def _legend(figure: Figure, axes: Axes) -> None:
    """One legend for all panels, above them."""
    figure.legend(*axes.get_legend_handles_labels(), loc="outside upper right", ncols=6, frameon=False)


def draw_transmissibility(found: Sequence, amplitude: float, path: Path) -> None:
    """Body motion and strut travel over road motion, over frequency, for each level of friction."""
    figure = Figure(figsize=(12, 5.2), layout="constrained")
    figure.suptitle(
        f"Quarter car on a sine road of {1e3 * amplitude:g} mm, by the friction of its strut", x=0.01, ha="left"
    )
    body, travel = figure.subplots(1, 2)
    labelled(body, "frequency [Hz]", "body motion / road motion")
    labelled(travel, "frequency [Hz]", "wheel travel / road motion")
    for at, one in enumerate(found):
        body.plot(one.frequency, one.body, marker=".", label=one.label, **_look(at))
        travel.plot(one.frequency, one.travel, marker=".", **_look(at))
    for axes in (body, travel):
        axes.set_xscale("log")
        axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
        axes.xaxis.set_major_formatter("{x:g}")
        axes.set_ylim(bottom=0.0)
    _legend(figure, body)
    save(figure, path)


def _loops(runs: Sequence, last: float, corner: str, velocity: Axes, displacement: Axes, friction: Axes) -> None:
    """Force over velocity and displacement, and friction over velocity, in the last seconds of each run."""
    labelled(velocity, "velocity [mm/s]", "strut force [N]")
    labelled(displacement, "length, change from rest [mm]", "strut force [N]")
    labelled(friction, "velocity [mm/s]", "friction force [N]")
    for at, run in enumerate(runs):
        part = run.time >= run.time[-1] - last
        speed, length = 1e3 * run[f"{corner}velocity"][part], run[f"{corner}length"]
        force, look = run[f"{corner}force"][part], _look(at)
        velocity.plot(speed, force, label=run.label, **look)
        displacement.plot(1e3 * (length - length[0])[part], force, **look)
        # Positive in the direction of motion, as in the laws.
        friction.plot(speed, -run[f"{corner}force_friction"][part], **look)


def draw_loops(runs: Sequence, frequency: float, periods: int, path: Path) -> None:
    """The loops of a quarter car's strut in the last periods."""
    figure = Figure(figsize=(12, 4.6), layout="constrained")
    figure.suptitle(f"Strut of the quarter car at {frequency:g} Hz", x=0.01, ha="left")
    panels = figure.subplots(1, 3)
    _loops(runs, periods / frequency, "", *panels)
    _legend(figure, panels[0])
    save(figure, path)


def _signals(runs: Sequence, last: float, panels: Sequence[tuple[Axes, str, str, float]]) -> None:
    """Signals over the last seconds, one panel each: axes, name, label and factor."""
    for axes, name, label, factor in panels:
        labelled(axes, "", label)
        for at, run in enumerate(runs):
            part = run.time >= run.time[-1] - last
            axes.plot(run.time[part], factor * run[name][part], label=run.label, **_look(at))
    rows = [axes for axes, *_ in panels]
    rows[-1].set_xlabel("time [s]")
    over_time(runs[0].time[runs[0].time >= runs[0].time[-1] - last], *rows)


def _time_and_loops(title: str, rows: int) -> tuple[Figure, Sequence[Axes], Sequence[Axes]]:
    """A figure with panels over time on the left and three loops on the right."""
    figure = Figure(figsize=(14, 9), layout="constrained")
    figure.suptitle(title, x=0.01, ha="left")
    left, right = figure.subfigures(1, 2, width_ratios=[1.45, 1])
    return figure, left.subplots(rows, 1), right.subplots(3, 1)


def draw_four_post(runs: Sequence, frequency: float, path: Path) -> None:
    """Body, front left corner, and the loops of its strut in the last period, for each level of friction."""
    title = f"Car on four posts at {frequency:g} Hz, by the friction of each strut"
    figure, (heave, pitch, travel, friction, load), loops = _time_and_loops(title, 5)
    _signals(
        runs,
        2.0 / frequency,
        [
            (heave, "heave", "heave [mm]", 1e3),
            (pitch, "pitch", "pitch [deg]", DEGREES),
            (travel, "fl.length", "strut length\nfront left [mm]", 1e3),
            (friction, "fl.force_friction", "its friction,\nresisting [N]", -1.0),
            (load, "fl.tyre_load", "tyre load\nfront left [N]", 1.0),
        ],
    )
    _loops(runs, 1.0 / frequency, "fl.", *loops)
    _legend(figure, heave)
    save(figure, path)


def draw_lane_change(runs: Sequence, path: Path) -> None:
    """Body, front left corner, and the loops of its strut, for each level of friction."""
    title = "Double lane change at constant speed, by the friction of each strut"
    figure, (acceleration, roll, rest, travel, force, load), loops = _time_and_loops(title, 6)
    _signals(
        runs,
        runs[0].time[-1],
        [
            (acceleration, "lateral_acceleration", "lateral acc.\n[m/s2]", 1.0),
            (roll, "roll", "roll\n[deg]", DEGREES),
            (rest, "roll", "the same,\nclose [deg]", DEGREES),
            (travel, "fl.length", "strut length\nfl [mm]", 1e3),
            (force, "fl.force", "strut force\nfl [N]", 1.0),
            (load, "fl.tyre_load", "tyre load\nfl [N]", 1.0),
        ],
    )
    # The same signal, enlarged so that its value at the end fills half of the panel.
    left = 2.0 * max(0.01, *(DEGREES * abs(run["roll"][-1]) for run in runs))
    rest.set_ylim(-left, left)
    _loops(runs, runs[0].time[-1], "fl.", *loops)
    _legend(figure, roll)
    save(figure, path)


def draw_course(runs: Sequence, course: Sequence, width: float, path: Path) -> None:
    """The track of a car of the given width between the cones, and the steering angle."""
    figure = Figure(figsize=(13, 6), layout="constrained")
    figure.suptitle("Path through the cones", x=0.01, ha="left")
    track, steering = figure.subplots(2, 1, height_ratios=[1.6, 1], sharex=True)
    labelled(track, "", "to the left [m]")
    labelled(steering, "forward [m]", "steering angle [deg]")
    cones = numpy.array([cone for lane in course for cone in lane.cones()])
    track.plot(*cones.T, linestyle="", marker="^", color="#d97706", markersize=4, label="cones")
    x, y = runs[-1]["position_x"], runs[-1]["position_y"]
    track.fill_between(x, y - 0.5 * width, y + 0.5 * width, color=PALE, label="width of the car")
    for at, run in enumerate(runs):
        track.plot(run["position_x"], run["position_y"], label=run.label, **_look(at))
        steering.plot(run["position_x"], DEGREES * run["steering_angle"], **_look(at))
    _legend(figure, track)
    save(figure, path)


def draw_laws(runs: Sequence, last: float, path: Path) -> None:
    """Friction over velocity of the front left strut in the last seconds, one panel for each law."""
    columns = min(3, len(runs))
    rows = -(-len(runs) // columns)
    figure = Figure(figsize=(13, 3.2 * rows + 0.6), layout="constrained")
    figure.suptitle("Friction of the front left strut over its velocity, by the law", x=0.01, ha="left")
    grid = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    for axes, run in zip(grid.flat, runs, strict=False):
        labelled(axes, "", "")
        part = run.time >= run.time[-1] - last
        velocity, friction = 1e3 * run["fl.velocity"][part], -run["fl.force_friction"][part]
        axes.plot(velocity, friction, color=RED, linewidth=0.9)
        axes.set_title(run.label, loc="left", fontsize="medium")
    for axes in grid.flat[len(runs) :]:
        axes.set_axis_off()
    figure.supxlabel("velocity [mm/s]", fontsize="medium")
    figure.supylabel("friction force [N]", fontsize="medium")
    save(figure, path)
