"""A Formula Student car in exudyn or MuJoCo, whose four struts feel the side loads of their joints.

    python -m examples.car.car rest                             what the wheels and struts carry
    python -m examples.car.car kinematics --rack -0.02 0 0.02   camber, steer and motion ratio over travel and rack
    python -m examples.car.car drive --test four-post           with and without friction; writes <out>_<test>.csv, .png
    python -m examples.car.car drive --test step-steer --law Dahl --set friction.scale=2 --with angle=0.3
    python -m examples.car.car limit --law LuGre                highest speed that passes the cones of ISO 3888-2
    python -m examples.car.car accuracy                         smaller steps, balance of energy, exudyn against MuJoCo
    python -m examples.car.car design --code mujoco             seat of the spring, seals and overlap
    python -m examples.car.car mount                            rubber mounts in the struts, and none
    python -m examples.car.car pressure --pressures 80e3 100e3  inflation pressures of the tyres, side by side
    python -m examples.car.car study                            lane change and four-post with every law, side by side

The car is described in stribeck_fs.toml; --car reads another file of the same form. Needs the packages
stribeck, exudyn and mujoco. --code mujoco runs the same car in MuJoCo.
"""

import argparse
import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy

from examples.car.car_accuracy import report_accuracy
from examples.car.car_description import CAR, CORNERS, Car, CarError, read_car
from examples.car.car_design import report_designs
from examples.car.car_figures import draw_kinematics, draw_study
from examples.car.car_mount import report_mounts
from examples.car.car_page import write_page
from examples.car.car_pressure import TYRE, report_pressures
from examples.car.car_rest import imbalance, settle
from examples.car.car_ride import EXUDYN, MUJOCO, Run, columns_with_units, simulate
from examples.car.car_stand import COLUMNS as STAND_COLUMNS
from examples.car.car_stand import Stand
from examples.car.car_struts import READINGS, open_struts, parameters_of
from examples.car.car_study import (
    SLOW,
    STUDIED,
    Case,
    contacts_of,
    courses_of,
    figures_of,
    laws_of,
    printed,
    run_study,
    table_of,
)
from examples.car.car_tyres import read_tyre
from examples.car.exudyn_car import ExudynCar
from examples.car.manoeuvres import MANOEUVRES, manoeuvre
from examples.fmpy.coupling import FMUS, add_settable, main, positive, write_csv
from examples.multibody.friction_pictures import Quantity, draw_runs
from examples.multibody.hosted_strut import Wrench

DEGREES = 180.0 / numpy.pi


def arguments() -> argparse.Namespace:
    """Reads the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--car", type=Path, default=CAR, help="description of the car (default: stribeck_fs.toml)")
    tasks = parser.add_subparsers(dest="task", required=True)
    tasks.add_parser("rest", help="the car at rest on its wheels")
    _add_kinematics(tasks)
    drive, study = _add_drive(tasks), _add_study(tasks)
    limit = tasks.add_parser("limit", help="the highest speed that passes the cones")
    accuracy, design, mount = _add_reports(tasks)
    pressure = _add_pressure(tasks)
    for task in (drive, limit, accuracy, design, mount, pressure):
        task.add_argument("--law", default="LuGre", help="friction law of the struts (default: LuGre)")
    for task in (study, accuracy, design, mount, pressure):
        task.add_argument("--jobs", type=int, default=2, help="runs at a time (default: 2)")
    for task in (drive, study):
        task.add_argument("--strut", choices=CORNERS, default="fl", help="the strut in the figures (default: fl)")
    for task in (drive, limit, design, mount, pressure, study):
        task.add_argument("--code", choices=(EXUDYN, MUJOCO), default=EXUDYN, help="simulator (default: exudyn)")
        task.add_argument("--step", type=positive, default=1e-3, help="step in s (default: 1e-3)")
    for task in (drive, limit, accuracy, design, mount, pressure, study):
        _add_settings(task)
    return parser.parse_args()


def _add_kinematics(tasks) -> None:
    """The suspension on a stand."""
    stand = tasks.add_parser("kinematics", help="the suspension on a stand")
    stand.add_argument("--corner", choices=CORNERS, default="fl")
    stand.add_argument(
        "--rack", type=float, nargs="+", default=[0.0], metavar="M", help="travels of the rack to the left, in m"
    )
    stand.add_argument("--points", type=int, default=21)
    stand.add_argument("--out", default="out/car_kinematics", help="table, without extension")


def _add_drive(tasks) -> argparse.ArgumentParser:
    """A manoeuvre."""
    drive = tasks.add_parser("drive", help="a manoeuvre, with and without friction")
    drive.add_argument("--test", choices=sorted(MANOEUVRES), default="four-post")
    drive.add_argument("--through", choices=("package", "fmu", "c"), default="package", help="what computes the struts")
    drive.add_argument("--fmus", type=Path, default=FMUS, help="folder of the FMUs (default: dist)")
    drive.add_argument("--out", default="out/car", help="result files, without extension (default: out/car)")
    return drive


def _add_study(tasks) -> argparse.ArgumentParser:
    """Manoeuvres with every law."""
    study = tasks.add_parser("study", help="every law in the lane change and on the posts")
    study.add_argument("--test", choices=STUDIED, action="append", help="only this one; repeatable")
    study.add_argument("--laws", metavar="A,B,...", help="only these laws (default: every law of the struts)")
    study.add_argument("--out", default="out/car_study", help="folder of the results (default: out/car_study)")
    return study


def _add_reports(tasks) -> tuple[argparse.ArgumentParser, ...]:
    """The tasks that print the tables of docs/car.md."""
    accuracy = tasks.add_parser("accuracy", help="smaller steps, the balance of energy, and both codes")
    accuracy.add_argument("--test", choices=sorted(MANOEUVRES), default="lane-change")
    accuracy.add_argument(
        "--steps", type=positive, nargs="+", default=[1e-3, 5e-4, 2.5e-4], metavar="S", help="in s, the longest first"
    )
    design = tasks.add_parser("design", help="seat of the spring, seals and overlap")
    return accuracy, design, tasks.add_parser("mount", help="rubber mounts in the struts, and none")


def _add_pressure(tasks) -> argparse.ArgumentParser:
    """Inflation pressures of the tyres."""
    pressure = tasks.add_parser("pressure", help="inflation pressures of the tyres, side by side")
    pressure.add_argument(
        "--pressures", type=positive, nargs="+", default=[80e3, 100e3], metavar="PA", help="in Pa (default: 80e3 100e3)"
    )
    pressure.add_argument(
        "--tyre", type=Path, default=TYRE, help="tyre of Magic Formula 6.1 or 6.2 (default: formula_student_61.tir)"
    )
    return pressure


def _add_settings(task: argparse.ArgumentParser) -> None:
    """The options of all tasks in which the car moves."""
    add_settable(task, "--set", "parameter of the ShockAbsorber")
    add_settable(task, "--with", "number of the manoeuvre", dest="changes")


def show_rest(car: Car) -> None:
    """Prints what wheels and struts carry."""
    model = ExudynCar(car)
    bodies, constraints, redundant = model.mobility()
    free = 6 * bodies - constraints
    print(f"{car.name}: {bodies} bodies, {constraints} independent constraints, {redundant} redundant; {free} free")
    parameters = parameters_of(car, "None", {})
    rest = settle(model, read_tyre(car), parameters)
    print("corner  wheel load [N]  strut [mm]  force [N]  side force m, n [N]  side moment m, n [N.m]  contacts [N]")
    with open_struts(parameters, rest.lengths) as struts:
        for name in CORNERS:
            w = Wrench.in_rod_eye(*model.reaction(name), rest.lengths[name])
            struts[name].advance(rest.lengths[name], 0.0, 1e-3, w)
            contacts = (struts[name].seen[READINGS.index(f"normal_{at}")] for at in (1, 2))
            print(
                f"{name:6} {rest.loads[name]:15.3f} {1e3 * rest.lengths[name]:11.3f} {rest.forces[name]:10.3f}"
                f" {w.force_m:9.4f} {w.force_n:9.4f} {w.moment_m:12.5f} {w.moment_n:9.5f}"
                + "".join(f" {load:8.3f}" for load in contacts)
            )
    print(f"weight {car.mass * car.gravity:.3f} N, less the loads {imbalance(car, rest):.1e} N")


def show_kinematics(car: Car, options: argparse.Namespace) -> None:
    """Writes and draws the motion of a wheel over the stroke of its strut."""
    if options.points < 2:
        raise CarError(f"points = {options.points}: must be at least 2")
    corner = car.corners[options.corner]
    extended, stroke = (float(corner.strut[f"geom.{name}"]) for name in ("length_extended", "stroke"))
    lengths = numpy.linspace(extended - 1e-3, extended - 0.8 * stroke, options.points)
    stand = Stand(car)
    tables = {f"rack {1e3 * rack:g} mm": stand.sweep(options.corner, lengths, rack) for rack in options.rack}
    table = {name: numpy.concatenate([one[name] for one in tables.values()]) for name in STAND_COLUMNS}
    path, picture = Path(f"{options.out}.csv"), Path(f"{options.out}.png")
    write_csv(path, {f"{name} [{STAND_COLUMNS[name]}]": values for name, values in table.items()})
    print("rack [mm]  strut [mm]  travel [mm]  camber [deg]  steer [deg]  motion ratio")
    for length, rack, travel, camber, steer, ratio in zip(*(table[name] for name in STAND_COLUMNS), strict=True):
        inwards = -corner.side * DEGREES * camber
        shown = f"{1e3 * rack:9.2f} {1e3 * length:11.3f} {1e3 * travel:12.3f}"
        print(f"{shown} {inwards:13.4f} {DEGREES * steer:12.4f} {ratio:13.4f}")
    draw_kinematics(f"{car.name}, {options.corner}", tables, corner.side, picture)
    print(f"{path}\n{picture}")


def show_drive(car: Car, options: argparse.Namespace) -> None:
    """Runs a manoeuvre, writes the tables and draws a picture."""
    course = courses_of([options.test], car, numbers(options))[options.test]
    runs = {}
    for law in dict.fromkeys((options.law, "None")):
        run = simulate(
            car, course, law, dict(options.set), options.step, options.through, options.fmus, code=options.code
        )
        table = Path(f"{options.out}_{options.test}_{law}.csv")
        write_csv(table, columns_with_units(run))
        print(f"{law}: {summary(run)}\n{table}")
        runs["without friction" if law == "None" else law] = run.columns
    strut = options.strut
    friction = Quantity(f"{strut}.friction", f"friction force, {strut} [N]")
    rows = [
        Quantity("heave", "heave [mm]", 1e3),
        Quantity(
            "pitch" if course.speed == 0.0 else "roll", "pitch [deg]" if course.speed == 0.0 else "roll [deg]", DEGREES
        ),
        friction,
        Quantity(f"{strut}.load", f"tyre load, {strut} [N]"),
    ]
    loops = [
        (Quantity(f"{strut}.velocity", f"velocity of the strut, {strut} [m/s]"), friction),
        (Quantity(f"{strut}.length", f"length of the strut, {strut} [mm]", 1e3), friction),
    ]
    picture = Path(f"{options.out}_{options.test}.png")
    draw_runs(f"{car.name}, {options.test}", runs, rows, loops, picture)
    print(picture)


def show_limit(car: Car, options: argparse.Namespace) -> None:
    """Halves the range of speeds until the highest one that passes is known within 0.1 m/s."""
    passing, failing = 0.0, 0.0
    speed = 18.0
    while failing == 0.0 or failing - passing > 0.1:
        course = manoeuvre("lane-change", **{"width": car.width, **numbers(options), "speed": speed})
        try:
            run = simulate(car, course, options.law, dict(options.set), options.step, code=options.code)
            clear = figures_of(run, course)["clearance"]
        except CarError:
            # Turned around on the road.
            clear = -math.inf
        print(f"{3.6 * speed:7.2f} km/h: {'passes' if clear > 0.0 else 'hits a cone'}, clearance {clear:.3f} m")
        passing, failing = (speed, failing) if clear > 0.0 else (passing, speed)
        if passing == 0.0 and speed < 5.0:
            raise CarError("the car passes at no speed from 5 m/s on")
        speed = 0.5 * (passing + failing) if passing and failing else speed + 2.0 if passing else speed - 2.0
    print(f"highest speed that passes: {3.6 * passing:.1f} km/h")


def show_accuracy(car: Car, options: argparse.Namespace) -> None:
    """Prints what smaller steps and the other code change, and the balance of energy."""
    course = courses_of([options.test], car, numbers(options))[options.test]
    changes = dict(options.set)
    print(report_accuracy(options.car, course, options.law, changes, options.steps, jobs_of(options)))


def show_design(car: Car, options: argparse.Namespace) -> None:
    """Prints what a few changes of the struts do."""
    courses = courses_of(STUDIED, car, numbers(options))
    changes, jobs = dict(options.set), jobs_of(options)
    print(report_designs(options.car, courses, options.law, changes, options.step, options.code, jobs))


def show_mounts(car: Car, options: argparse.Namespace) -> None:
    """Prints what rubber mounts in the struts do."""
    posts = courses_of(["four-post"], car, numbers(options))["four-post"]
    changes, jobs = dict(options.set), jobs_of(options)
    print(report_mounts(options.car, posts, options.law, changes, options.step, options.code, jobs))


def show_pressures(car: Car, options: argparse.Namespace) -> None:
    """Prints what inflation pressures do; a speed is that of the lane change, as the car stands on the posts."""
    courses = courses_of(STUDIED, car, numbers(options))
    courses["four-post"] = replace(courses["four-post"], speed=0.0)
    changes, jobs = dict(options.set), jobs_of(options)
    print(
        report_pressures(
            *(options.car, options.tyre, options.pressures, courses),
            *(options.law, changes, options.step, options.code, jobs),
        )
    )


def jobs_of(options: argparse.Namespace) -> int:
    """How many runs at a time."""
    if options.jobs < 1:
        raise CarError(f"jobs = {options.jobs}: must be at least 1")
    return options.jobs


def show_study(car: Car, options: argparse.Namespace) -> None:
    """Runs every law, prints the tables, draws the figures, writes the report."""
    jobs = jobs_of(options)
    laws, folder = laws_of(options.laws), Path(options.out)
    courses = courses_of(options.test or STUDIED, car, numbers(options))
    changes = dict(options.set)
    cases = [
        Case(options.car, course, law, changes, options.step, folder / f"{name}_{law}.csv", options.code)
        for name, course in courses.items()
        for law in laws
    ]
    order = {(case.course.name, case.law): at for at, case in enumerate(cases)}
    outcomes = sorted(run_study(cases, jobs), key=lambda outcome: order[outcome.course, outcome.law])
    if all(outcome.failure for outcome in outcomes):
        raise CarError(outcomes[0].failure)
    tables = {name: table_of(outcomes, name) for name in courses}
    for name, rows in tables.items():
        print(f"\n{name}\n{printed(rows)}")
    tables["contacts of the struts"] = contacts_of(car, changes)
    figures = draw_study(car, courses, outcomes, options.strut, folder)
    facts = [
        f"{car.name} in {options.code}, step {options.step:g} s; strut in the figures: {options.strut}.",
        "Run times are processor times of whole runs; relative: to the run without friction. Evaluations are steps of "
        "all struts; iterations are those of the integrator, to which the forces of the struts are given per step.",
        "Tyre load: standard deviation, mean square of all four. Slow: part of the time with a strut below "
        f"{1e3 * SLOW:g} mm/s. Path: largest distance of the front axle from its path without friction.",
    ]
    report = folder / "report.html"
    write_page(report, f"{car.name}: friction laws in the struts", facts, tables, figures)
    print(f"\n{folder}: tables and figures\n{report}")


def numbers(options: argparse.Namespace) -> dict[str, float]:
    """The numbers of a manoeuvre from the command line."""
    return {name: number(name, value) for name, value in options.changes}


def number(name: str, value: object) -> float:
    """A number of a manoeuvre from the command line."""
    try:
        return float(value)
    except ValueError:
        raise CarError(f"{name} = '{value}': must be a number") from None


def summary(run: Run) -> str:
    """The figures of a run."""
    roll, pitch = (numpy.abs(DEGREES * (run[name] - run[name][0])).max() for name in ("roll", "pitch"))
    friction = max(numpy.abs(run[f"{name}.friction"]).max() for name in CORNERS)
    left = DEGREES * (run["roll"][-1] - run["roll"][0])
    return (
        f"largest roll {roll:.3f} degrees, {left:.4f} at the end, pitch {pitch:.3f}, friction {friction:.1f} N; "
        f"{run.iterations} iterations in {run.seconds:.1f} s"
    )


def program() -> None:
    """Does what the command line asks for."""
    options = arguments()
    car = read_car(options.car)
    if options.task == "rest":
        show_rest(car)
    elif options.task == "kinematics":
        show_kinematics(car, options)
    elif options.task == "limit":
        show_limit(car, options)
    elif options.task == "accuracy":
        show_accuracy(car, options)
    elif options.task == "design":
        show_design(car, options)
    elif options.task == "mount":
        show_mounts(car, options)
    elif options.task == "pressure":
        show_pressures(car, options)
    elif options.task == "study":
        show_study(car, options)
    else:
        show_drive(car, options)


if __name__ == "__main__":
    sys.exit(main(program))
