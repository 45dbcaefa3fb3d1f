"""The page docs/creep.md and its picture, from the rows of docs/creep.csv."""

from collections.abc import Iterable
from pathlib import Path

from matplotlib.figure import Figure

from examples.fmpy.pictures import BLUE, GREY, RED, labelled, save
from examples.multibody.creep.slope import DURATION, GRAVITY, LOADS, MASS, MU, SETTLED, SLIDING_LOAD, STEP
from examples.multibody.creep.table import OWN, Row

INTRODUCTION = f"""\
# Creep under a load below the static level

A block on a slope, pulled with 0.5, 0.9 and 0.99 of the static level of friction, should stay where it is. This page
measures how far it moves in a minute with laws of this project and with the friction of MuJoCo, exudyn, Drake and
Bullet. [creep.csv](creep.csv) has all digits. One command measures and writes all of it again:

```sh
.venv/bin/python -m pip install drake pybullet    # a simulator that is missing keeps its rows, with their date
PYTHONPATH=out/package .venv/bin/python -m examples.multibody.creep    # after `make test`, which fills out/package
```

- Mass {MASS:g} kg, gravity {GRAVITY:g} m/s2, coefficient of friction {MU:g}, static and kinetic, since most
  simulators have one. The slope has the angle $alpha$ with $tan(alpha) = {MU:g} r$, so that gravity pulls with $r$
  times the level.
- Step {1e3 * STEP:g} ms, fixed, for all simulators; the workbench chooses its own. Start at rest, touching the slope,
  without load in contacts and bristles; in exudyn contacts carry the weight of the block from the start. Drift is the
  displacement down the slope from {SETTLED:g} s to {SETTLED + DURATION:g} s; the first second, in which contacts and
  bristles take up the load, is left out, and is in creep.csv.
- Contacts: a box of 0.44 m by 0.44 m by 0.1 m with four spherical feet (radius 20 mm, 0.4 m apart, centre of mass
  70 mm above the slope) is free in space; the wide stance keeps it from tilting. The four contact points are the same
  in every simulator.
- Joints, and laws of this project: the body slides along one axis and cannot turn; the normal force is that of the
  slope.
- Chosen as well: in Bullet no damping of linear, angular and joint motion, and a plane with the coefficient 1 under
  feet with the level; in exudyn contacts of 1e5 N/m and 100 N.s/m; in MuJoCo no torsional and rolling friction.
  Everything else that is not named has the default of the simulator.
- The level is the same everywhere: with {SLIDING_LOAD:g} times the level every block slides from rest, in the first
  second {{least:.2f}} to {{most:.2f}} times as far as one with Coulomb friction.
"""

OF_LAWS = """
## Laws of this project

Drift in mm. In the workbench the equations are solved to a tolerance of 1e-10
([slope.toml](../examples/multibody/creep/slope.toml)). In MuJoCo and exudyn each law is an FMU: at the beginning of a
step it gets the velocity, is stepped, and its force is held. Laws without memory get `mass` = 1 kg, and the pull of
gravity as `external_force`. Stiffness and widths are the start values of the laws. The row "closed form" is the
speed at which the curve of the law carries the load (that of `Specker` by bisection), times 60 s.

"""

OF_SIMULATORS = """
## Friction of the simulators

Drift in mm; one below 0 is up the slope.

![Drift of the block in a minute](creep.png)

"""

EXPLANATION = """
## What trades creep against stiffness

- **MuJoCo** makes friction a soft constraint (chapter "Computation" of its documentation): the body moves at the speed
  at which the reference acceleration of the constraint gives the force. For `frictionloss` of a joint that is
  $v = f (1 - d) d_max t / (2 d m)$ with the time constant $t$ of `solreffriction` and the impedances $d$ and $d_max$ of
  `solimpfriction`. The rows of the joint are within {mujoco} of it. In contacts each foot has a part of the force, and
  an elliptic cone divides the speed by `impratio`. A smaller $t$ (not below two steps), $d$ nearer to 1 and a larger
  `impratio` stiffen the constraint; `noslip_iterations` solves friction once more without softness.
- **exudyn** with `frictionProportionalZone` has a straight line through rest: $v = r v_zone$. The rows are within
  {exudyn} of it. A smaller zone is stiffer; at 1e-4 m/s the iterations do not always converge at this step. The
  bristles of `CoordinateSpringDamperExt` hold if `stickingDamping` damps their oscillation.
- **Drake** has a regularised law for "lagged" and "similar", $v = v_s r / sqrt(1 - r^2)$, and another one for "tamsi",
  $v = v_s (1 - sqrt(1 - r))$, with the tolerance $v_s$; both were found from the rows, which are within {drake}
  of them. At 1e-6 m/s ("lagged") the block creeps faster than the formula says. A smaller `stiction_tolerance` makes
  the problem stiffer. "sap" has none: its regularisation follows from mass and step (Castro, Permenter, Han, "An
  unconstrained convex formulation of compliant contact", IEEE Transactions on Robotics 39, 2023, 1301-1320).
- **Bullet** has no velocity of regularisation; how far its iterations go decides. `solverResidualThreshold` = 0 and
  more `numSolverIterations` bring drift down, at the cost of time; more iterations alone change nothing here, since the
  threshold ends them before. `frictionAnchor` adds a spring. A motor with a limit of force holds a joint.
- **Laws of this project**: `CoulombStiction` and `Karnopp` with `mass` hold the load from the first step if they get
  it as `external_force`; otherwise the block creeps at $v = h f_e / m$ with the step $h$, and a `mass` of half or one
  and a half times the right one changes nothing as long as the load is given. `LuGre` and
  `ElastoPlastic` hold it once their bristles have taken it up; since it comes suddenly, the block first moves by up to
  {settled} mm. `Dahl` has no damping: the block swings on its bristles, and creeps as long as it does, in exudyn for
  the whole minute: its integrator takes the force of the beginning of a step as that of the end, which feeds the swing.
  `Threlfall`, `Andersson` and `Specker` creep as their closed form says. A smaller `transition_velocity` or
  `peak_velocity`, or a larger `transition_slope`, slows creep and makes the curve steeper; with `mass` the step is not
  limited by that.

Chrono is not on this page. It could not be installed with pip: `projectchrono` 0.0.0 reserves the name for a package to
come, and `pychrono` 1.1.0 is another program. PyChrono comes through conda, which is left out here.

The load is constant: under one that swings below the level `Dahl` and `LuGre` drift as well, see their pages.

## Versions

"""


def millimetres(row: Row | None) -> str:
    """Drift in mm with three digits."""
    if row is None:
        return ""
    return "did not converge" if row.drift is None else shown(row.drift)


def shown(metres: float) -> str:
    """A length in mm with three digits."""
    return f"{1e3 * metres:.3g}" if metres else "0"


def line(*cells: str) -> str:
    """A line of a table."""
    return f"| {' | '.join(cells)} |\n"


def heading(*names: str) -> str:
    """The first lines of a table."""
    return line(*names, *(f"{load:g}" for load in LOADS)) + line(*["---"] * len(names), *["---:"] * len(LOADS))


def grouped(rows: Iterable[Row]) -> dict[tuple[str, str, str], dict[float, Row]]:
    """Rows of the same case, by load."""
    found: dict[tuple[str, str, str], dict[float, Row]] = {}
    for row in rows:
        found.setdefault((row.simulator, row.friction, row.options), {})[row.load] = row
    return found


def table_of_laws(rows: list[Row]) -> str:
    """Drift of each law in closed form, in the workbench and in the simulators."""
    cases = grouped(row for row in rows if row.kind == "law")
    text = heading("law", "in")
    for law in dict.fromkeys(friction for _, friction, _ in cases):
        of_law = {simulator: by_load for (simulator, friction, _), by_load in cases.items() if friction == law}
        name = "`{}`".format(law.replace(" without ", "` without `"))
        expected = [next(iter(of_law.values()))[load].expected for load in LOADS]
        if None not in expected:
            text += line(name, "closed form", *map(shown, expected))
        for simulator, by_load in of_law.items():
            where = "workbench" if simulator == OWN else simulator
            text += line(name, where, *(millimetres(by_load.get(load)) for load in LOADS))
    return text


def table_of_simulators(rows: list[Row]) -> str:
    """Drift with the friction of the simulators."""
    text = heading("simulator", "friction of", "options")
    for (simulator, friction, options), by_load in grouped(row for row in rows if row.kind == "own").items():
        text += line(simulator, friction, options, *(millimetres(by_load.get(load)) for load in LOADS))
    return text


def table_of_versions(rows: list[Row]) -> str:
    """Version of each simulator, and when its rows were measured."""
    text = line("program", "version", "measured") + line("---", "---", "---")
    for simulator, version, measured in dict.fromkeys((row.simulator, row.version, row.measured) for row in rows):
        text += line(simulator, version, measured)
    return text


def agreement(rows: list[Row]) -> dict[str, str]:
    """Figures for the explanation: the largest difference of each simulator from its formulas, and the largest way on
    which bristles take up the load."""
    found = {}
    for simulator in ("MuJoCo", "exudyn", "Drake"):
        errors = [
            abs(row.drift / row.expected - 1.0)
            for row in rows
            if row.kind == "own" and row.simulator == simulator and None not in (row.drift, row.expected)
        ]
        found[simulator.lower()] = f"{max(100.0 * max(errors), 0.01):.1g} %" if errors else "(not measured)"
    moved = [row.settled for row in rows if row.kind == "law" and row.friction in ("LuGre", "ElastoPlastic")]
    return {**found, "settled": f"{1e3 * max(moved):.1f}"}


SHORTEST = 1e-12  # m: shorter drifts are drawn there


def draw(rows: list[Row], path: Path) -> None:
    """Drift of every case, on a logarithmic axis."""
    cases = grouped(row for row in rows if row.kind == "own" or row.simulator == "MuJoCo")
    names = [
        f"law {friction}, in {simulator}" if by_load[LOADS[0]].kind == "law" else f"{simulator}, {friction}: {options}"
        for (simulator, friction, options), by_load in cases.items()
    ]
    figure = Figure(figsize=(12, 0.26 * len(cases) + 1.2), layout="constrained")
    axes = labelled(figure.subplots(), f"drift in {DURATION:g} s [m]; at the left end: {SHORTEST:g} m or less", "")
    for load, colour, size in zip(LOADS, (GREY, BLUE, RED), (60, 30, 12), strict=True):
        drifts = [by_load[load].drift for by_load in cases.values()]
        at = [(abs(value), place) for place, value in enumerate(drifts) if value is not None]
        values, places = zip(*at, strict=True)
        axes.scatter(
            [max(value, SHORTEST) for value in values], places, s=size, color=colour, label=f"{load:g} of the level"
        )
    axes.set_xscale("log")
    axes.set_yticks(range(len(names)), [name.replace("`", "") for name in names], fontsize=8)
    axes.set_ylim(len(names) - 0.5, -0.5)
    figure.legend(loc="outside upper right", ncols=len(LOADS), frameon=False)
    save(figure, path)


def write_page(rows: list[Row], path: Path) -> None:
    """Writes the page."""
    explanation = EXPLANATION.format(**agreement(rows))
    distances = [row.sliding for row in rows if row.sliding is not None]
    introduction = INTRODUCTION.format(least=min(distances), most=max(distances))
    text = introduction + OF_LAWS + table_of_laws(rows) + OF_SIMULATORS + table_of_simulators(rows)
    path.write_text(text + explanation + table_of_versions(rows), encoding="utf-8", newline="\n")
