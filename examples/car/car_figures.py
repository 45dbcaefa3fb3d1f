"""Figures of a study: all laws in the same axes, for one strut."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from examples.car.car_description import CORNERS, Car
from examples.car.car_struts import RestingStrut, parameters_of
from examples.car.car_study import NONE, Outcome
from examples.car.manoeuvres import LaneChange, Manoeuvre
from examples.fmpy.pictures import BLUE, GREY, RED, labelled, over_time, save

DEGREES = 180.0 / numpy.pi
# Half the width of a zoom, in s.
ZOOM = 0.15
CORNER_COLOURS = dict(zip(CORNERS, (RED, BLUE, "#d98c00", "#2f855a"), strict=True))


def style_of(at: int, law: str) -> dict[str, object]:
    """The look of a law: ten colours, then dashed and dotted; black without friction."""
    if law == NONE:
        return {"color": "black", "linewidth": 1.6, "zorder": 5, "label": "no friction"}
    style = ("-", "--", ":", "-.")[at // 10 % 4]
    return {"color": f"C{at % 10}", "linestyle": style, "linewidth": 0.9, "label": law}


def draw_laws(axes: Axes, outcomes: Sequence[Outcome], across: str, up: str, skip_none: bool = False) -> None:
    """One column over another, for each law."""
    for at, outcome in enumerate(outcomes):
        if not (skip_none and outcome.law == NONE):
            axes.plot(outcome.columns[across], outcome.columns[up], **style_of(at, outcome.law))


def legend_below(figure: Figure, axes: Axes) -> None:
    """The names of the laws below all axes."""
    lines = axes.get_lines()
    # As many columns of long names as the figure is wide for.
    columns = min(int(0.68 * figure.get_figwidth()), len(lines))
    figure.legend(handles=lines, loc="outside lower center", ncols=columns, frameon=False, fontsize="small")


def draw_spring_curves(car: Car, path: Path) -> None:
    """Force at rest over the compression of the front and rear struts, with stops (Fig. 9.22)."""
    figure = Figure(figsize=(7, 4.5), layout="constrained")
    axes = labelled(figure.subplots(), "compression from full extension [mm]", "force at rest [kN]")
    for name, colour in (("fl", RED), ("rl", BLUE)):
        strut = RestingStrut(parameters_of(car, NONE, {})[name])
        extended = float(car.corners[name].strut["geom.length_extended"])
        stroke = float(car.corners[name].strut["geom.stroke"])
        compression = numpy.linspace(0.0, stroke, 200)
        forces = [1e-3 * strut.at(extended - value)[0] for value in compression]
        axes.plot(1e3 * compression, forces, color=colour, label={"f": "front", "r": "rear"}[name[0]])
    axes.legend(frameon=False)
    save(figure, path)


def draw_kinematics(title: str, tables: Mapping[str, Mapping[str, numpy.ndarray]], inwards: float, path: Path) -> None:
    """Camber, steer and motion ratio over the travel of a wheel, for positions of the rack by their labels."""
    figure = Figure(figsize=(11, 4), layout="constrained")
    figure.suptitle(title, x=0.02, horizontalalignment="left")
    panels = figure.subplots(1, 3)
    quantities = (
        ("camber", "camber [deg]", -inwards * DEGREES),
        ("steer", "steer, to the left [deg]", DEGREES),
        ("motion_ratio", "strut travel per wheel travel", 1.0),
    )
    for axes, (column, label, factor) in zip(panels, quantities, strict=True):
        labelled(axes, "travel of the wheel [mm]", label)
        for at, (name, table) in enumerate(tables.items()):
            axes.plot(1e3 * table["travel"], factor * table[column], color=f"C{at}", label=name)
    if len(tables) > 1:
        figure.legend(handles=panels[0].get_lines(), loc="outside upper right", ncols=len(tables), frameon=False)
    save(figure, path)


def draw_course(outcomes: Sequence[Outcome], course: LaneChange, path: Path) -> None:
    """Angle of the steering wheel over time (Fig. 9.24), and the paths between the cones."""
    figure = Figure(figsize=(11, 6), layout="constrained")
    upper, lower = figure.subplots(2, 1)
    labelled(upper, "time [s]", "steering wheel [deg]")
    labelled(lower, "distance [m]", "path of the front axle [m]")
    for at, outcome in enumerate(outcomes):
        look = style_of(at, outcome.law)
        upper.plot(outcome.columns["time"], DEGREES * outcome.columns["steering_wheel"], **look)
        lower.plot(outcome.columns["front_x"], outcome.columns["front_y"], **look)
    for lane in course.lanes:
        x, y = zip(*lane.cones(), strict=True)
        lower.plot(x, y, "^", color="#d98c00", markersize=5, zorder=6)
    legend_below(figure, upper)
    save(figure, path)


def draw_wheels(outcome: Outcome, path: Path) -> None:
    """Loads of the tyres and compression of the struts of one run (Fig. 9.25)."""
    figure = Figure(figsize=(11, 6), layout="constrained")
    rows = figure.subplots(3, 1)
    time = outcome.columns["time"]
    for axes, (column, label, factor) in zip(
        rows,
        (
            ("load", "tyre load [N]", 1.0),
            ("force_y", "lateral force [N]", 1.0),
            ("length", "length of the strut [mm]", 1e3),
        ),
        strict=True,
    ):
        labelled(axes, "time [s]" if axes is rows[-1] else "", label)
        for name, colour in CORNER_COLOURS.items():
            axes.plot(time, factor * outcome.columns[f"{name}.{column}"], color=colour, linewidth=1.1, label=name)
    over_time(time, *rows)
    figure.legend(handles=rows[0].get_lines(), loc="outside upper right", ncols=4, frameon=False)
    save(figure, path)


def draw_posts(course: Manoeuvre, outcome: Outcome, path: Path) -> None:
    """Heights of the front and rear posts (Fig. 9.29)."""
    figure = Figure(figsize=(9, 3), layout="constrained")
    axes = labelled(figure.subplots(), "time [s]", "height of the post [mm]")
    time = outcome.columns["time"]
    for name, colour in (("fl", RED), ("rl", BLUE)):
        heights = [1e3 * course.road(name, float(at), 0.0)[0] for at in time]
        axes.plot(time, heights, color=colour, label={"f": "front", "r": "rear"}[name[0]])
    axes.legend(frameon=False, loc="upper right")
    save(figure, path)


def draw_forces(outcomes: Sequence[Outcome], strut: str, path: Path) -> None:
    """Force of a strut over time, with zooms on its fastest rebound and compression (Figs. 9.26, 9.27, 9.31, 9.32)."""
    figure = Figure(figsize=(12, 7), layout="constrained")
    panels = figure.subplot_mosaic([["all", "all"], ["rebound", "compression"]])
    labelled(panels["all"], "time [s]", f"force of the strut {strut} [N]")
    draw_laws(panels["all"], outcomes, "time", f"{strut}.force")
    over_time(outcomes[0].columns["time"], panels["all"])
    velocity, time = outcomes[0].columns[f"{strut}.velocity"], outcomes[0].columns["time"]
    for name, at in (("rebound", velocity.argmax()), ("compression", velocity.argmin())):
        axes = labelled(panels[name], "time [s]", f"{name} [N]")
        draw_laws(axes, outcomes, "time", f"{strut}.force")
        middle = float(time[at])
        axes.set_xlim(middle - ZOOM, middle + ZOOM)
        near = numpy.abs(time - middle) <= ZOOM
        forces = numpy.concatenate([outcome.columns[f"{strut}.force"][near] for outcome in outcomes])
        margin = 0.05 * numpy.ptp(forces)
        axes.set_ylim(forces.min() - margin, forces.max() + margin)
    legend_below(figure, panels["all"])
    save(figure, path)


def draw_friction(outcomes: Sequence[Outcome], strut: str, path: Path) -> None:
    """Friction of a strut over time and over its velocity (Figs. 9.28, 9.33, 9.34), and the loads of its contacts."""
    figure = Figure(figsize=(12, 9), layout="constrained")
    panels = figure.subplot_mosaic([["time", "time"], ["velocity", "normal"]], height_ratios=[1, 1.1])
    labelled(panels["time"], "time [s]", f"friction, {strut} [N]")
    labelled(panels["velocity"], "velocity of the strut [m/s]", f"friction, {strut} [N]")
    labelled(panels["normal"], "length of the strut [mm]", "normal forces [N]")
    draw_laws(panels["time"], outcomes, "time", f"{strut}.friction", skip_none=True)
    draw_laws(panels["velocity"], outcomes, f"{strut}.velocity", f"{strut}.friction", skip_none=True)
    over_time(outcomes[0].columns["time"], panels["time"])
    first = outcomes[-1].columns
    for contact, label, colour in ((1, "rod guide", RED), (2, "piston", BLUE)):
        normal = panels["normal"]
        normal.plot(1e3 * first[f"{strut}.length"], first[f"{strut}.normal_{contact}"], color=colour, label=label)
    panels["normal"].legend(frameon=False, title=outcomes[-1].law, labelcolor=GREY)
    legend_below(figure, panels["time"])
    save(figure, path)


def draw_study(
    car: Car, courses: Mapping[str, Manoeuvre], outcomes: Sequence[Outcome], strut: str, folder: Path
) -> dict[str, Path]:
    """All figures of a study; title and file of each."""
    figures = {"Springs with stops": folder / "springs.png"}
    draw_spring_curves(car, figures["Springs with stops"])
    for name, course in courses.items():
        done = [outcome for outcome in outcomes if outcome.course == name and not outcome.failure]
        if not done:
            continue
        if isinstance(course, LaneChange):
            figures[f"{name}: steering and path"] = folder / f"{name}_course.png"
            draw_course(done, course, folder / f"{name}_course.png")
        else:
            figures[f"{name}: posts"] = folder / f"{name}_posts.png"
            draw_posts(course, done[0], folder / f"{name}_posts.png")
        for title, file, draw in (
            (f"{name}: wheels, {done[-1].law}", "wheels", lambda path, done=done: draw_wheels(done[-1], path)),
            (f"{name}: force of {strut}", "force", lambda path, done=done: draw_forces(done, strut, path)),
            (f"{name}: friction of {strut}", "friction", lambda path, done=done: draw_friction(done, strut, path)),
        ):
            figures[title] = folder / f"{name}_{file}.png"
            draw(figures[title])
    return figures
