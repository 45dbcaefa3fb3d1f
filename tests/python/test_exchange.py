"""Model Exchange: every FMU that supports it gives a solver the same results as its own steps, with few events."""

import math

import fmpy
import numpy
import pytest
from exchange import System, integrate, open_part
from fmpy import simulate_fmu

from examples.fmpy.coupling import FMUS, friction_models_in, models_in, path_of

DESCRIPTIONS = {model: fmpy.read_model_description(str(path_of(model))) for model in models_in(FMUS)}
MODELS = [model for model, description in DESCRIPTIONS.items() if description.modelExchange]

# Variation of inputs about their start values, by unit.
SWING = {"1": 0.1, "m/s": 2e-3, "m": 2e-3, "N": 0.5, "m/s2": 0.0, "rad": 0.02, "rad/s": 0.1}
SWING |= {"W": 10.0, "K": 5.0, "N.m": 0.1, "V": 0.5}
PIECES, PIECE, STEP = 20, 0.01, 1e-3

# Advice on the communication step, which a solver does not have.
ADVICE = {"dforce_dlength", "dforce_dvelocity", "step_limit"}


def real_inputs(model: str) -> list:
    """The continuous inputs of a model."""
    return [v for v in DESCRIPTIONS[model].modelVariables if v.causality == "input" and v.type == "Real"]


def admitted(variable, change: float) -> float:
    """A value so far from the start value, on the other side of it if it would be below the minimum."""
    start = float(variable.start)
    return start - change if variable.min is not None and start + change < float(variable.min) else start + change


def staircase(model: str) -> numpy.ndarray | None:
    """Inputs that are held for a while and then jump, in both directions: both kinds of FMU see the same."""
    inputs = real_inputs(model)
    if not inputs:
        return None
    rows = []
    for piece in range(PIECES):
        values = [admitted(v, SWING[v.unit] * math.sin(2.3 * piece + at + 0.5)) for at, v in enumerate(inputs)]
        rows += [(piece * PIECE, *values), ((piece + 1) * PIECE, *values)]
    return numpy.array(rows, dtype=[("time", float)] + [(v.name, float) for v in inputs])


def simulate(model: str, kind: str, log=None, **options) -> numpy.ndarray:
    """A run of all outputs."""
    variables = DESCRIPTIONS[model].modelVariables
    outputs = [v.name for v in variables if v.type == "Real" and v.causality == "output" and v.name not in ADVICE]
    return simulate_fmu(
        str(path_of(model)),
        output=outputs,
        fmi_type=kind,
        record_events=False,
        fmi_call_logger=log,
        **options,
    )


def names_of(model: str, causality: str) -> set[str]:
    """Names of the variables that are an `input`, `output`, `local`, ..."""
    return {v.name for v in DESCRIPTIONS[model].modelVariables if v.causality == causality}


def test_models_support_it_unless_they_remember_what_no_solver_integrates():
    """Delays, random bonds, elements that slip: memory without derivatives, which is in local variables."""
    assert set(MODELS) >= {"LuGre", "LuGrePlanar", "Dahl", "ElastoPlastic", "BlimanSorine", "Coulomb", "BrownMcPhee"}
    assert set(MODELS) >= {"BeltRig", "QuarterCar", "FourPostCar", "DoubleTrackCar", "ShockAbsorber", "HydraulicDamper"}
    assert len(MODELS) >= 43
    for model, description in DESCRIPTIONS.items():
        states = {v.derivative.name for v in description.modelVariables if v.derivative is not None}
        if model in MODELS:
            assert len(states) == description.numberOfContinuousStates, model
        else:
            assert not states, model
            assert names_of(model, "local"), model


# A body that the usual inputs move: one of 95 kg travels less than a micrometre under 0.5 N, a ten-thousandth of the
# nominal value to which a solver is accurate.
HEAVY, MOVED = 10.0, 1.0


def masses(model: str) -> dict[str, float]:
    """A smaller mass for a heavy body."""
    variables = DESCRIPTIONS[model].modelVariables
    return {v.name: MOVED for v in variables if v.name == "mass" and float(v.start) > HEAVY}


def check_against_steps(model: str, signals: numpy.ndarray | None, **options) -> None:
    """Integrates a model over pieces of held inputs and compares it with its own steps."""
    options |= {"stop_time": PIECES * PIECE, "input": signals, "output_interval": STEP}
    options["start_values"] = masses(model) | options.get("start_values", {})
    stepped = simulate(model, "CoSimulation", step_size=STEP, **options)
    solved = simulate(model, "ModelExchange", relative_tolerance=1e-10, **options)
    assert len(solved) == len(stepped) == round(PIECES * PIECE / STEP) + 1
    # At a jump one shows the value before it, and the other the value after.
    between = numpy.arange(len(stepped)) % round(PIECE / STEP) != 0
    for name in stepped.dtype.names[1:]:
        size = numpy.abs(stepped[name]).max()
        assert numpy.abs(solved[name] - stepped[name])[between].max() <= 1e-5 * size, name


@pytest.mark.parametrize("model", MODELS)
def test_a_solver_finds_what_the_steps_find(model):
    check_against_steps(model, staircase(model))


@pytest.mark.parametrize("law", [model for model in MODELS if "stuck" in names_of(model, "local")])
def test_the_strut_remembers_sticking_where_no_solver_reaches(law):
    types = {t.name: t for t in DESCRIPTIONS["ShockAbsorber"].typeDefinitions}
    number = next(item.value for item in types["FrictionModel"].items if item.name == law)
    check_against_steps("ShockAbsorber", staircase("ShockAbsorber"), start_values={"friction.model": number})


@pytest.mark.parametrize("model", [m for m in MODELS if any(v.name == "normal_force" for v in real_inputs(m))])
def test_bristles_are_released_while_there_is_no_load(model):
    signals = staircase(model)
    signals["normal_force"] = [0.0 if piece % 3 == 2 else 9.81 for piece in range(PIECES) for _ in range(2)]
    for name in {"velocity", "velocity_x", "velocity_y"} & set(signals.dtype.names):
        signals[name] *= [float(piece % 3 == 0) for piece in range(PIECES) for _ in range(2)]
    check_against_steps(model, signals)


def has_phases(model: str) -> bool:
    """Whether it is a friction law with a jump or a kink at certain velocities."""
    return "phase" in {v.name for v in DESCRIPTIONS[model].modelVariables}


def reversing(model: str) -> numpy.ndarray:
    """Two periods of a velocity that passes every kink of the laws, other inputs at their start values."""
    inputs = real_inputs(model)
    time = numpy.linspace(0.0, 2.0, 401)
    columns = [
        0.02 * numpy.sin(2.0 * numpy.pi * time + 0.4) if v.name == "velocity" else float(v.start) for v in inputs
    ]
    rows = numpy.zeros(len(time), dtype=[("time", float)] + [(v.name, float) for v in inputs])
    rows["time"] = time
    for variable, column in zip(inputs, columns, strict=True):
        rows[variable.name] = column
    return rows


def sign_changes(model: str, signals: numpy.ndarray) -> int:
    """Number of sign changes of the event indicators on a fine grid, counted without a solver."""
    with open_part(model) as part:
        count = 0

        def signs(time: float) -> list[bool]:
            for name in signals.dtype.names[1:]:
                part.set(name, float(numpy.interp(time, signals["time"], signals[name])))
            return list(part.event_indicators() > 0.0)

        signs(0.0)
        part.at_event()
        before = signs(0.0)
        for time in numpy.linspace(0.0, 2.0, 8001):
            if signs(time) != before:
                count += 1
                part.at_event()
                before = signs(time)
        return count


def has_a_bristle(model: str) -> bool:
    """Whether it is a friction law with a deflection."""
    return "bristle_deflection" in names_of(model, "local")


@pytest.mark.parametrize("model", [model for model in MODELS if has_phases(model) and not has_a_bristle(model)])
def test_a_reversing_velocity_has_no_more_events_than_kinks(model):
    signals, calls = reversing(model), []
    simulate(model, "ModelExchange", log=calls.append, stop_time=2.0, input=signals, output_interval=1e-2)
    events = sum("fmi2EnterEventMode" in call for call in calls)
    crossings = sign_changes(model, signals)
    assert crossings <= events <= 2 * crossings


# The benchmark of the thesis: mass, stiffness, velocity of the belt, static and kinetic level.
MASS, STIFFNESS, BELT, STATIC, KINETIC = 1.0, 2.0, 0.1, 0.1 * 1.5 * 9.81, 0.1 * 9.81
RUN = 40.0


def breakaways_and_captures() -> list[float]:
    """Times of slip and stick in closed form, for a contact with two levels that starts at rest on the belt."""
    frequency = math.sqrt(STIFFNESS / MASS)
    sticking = 2.0 * (STATIC - KINETIC) / (STIFFNESS * BELT)
    slipping = 2.0 / frequency * (math.pi - math.atan((STATIC - KINETIC) * frequency / (STIFFNESS * BELT)))
    instants, time = [], STATIC / (STIFFNESS * BELT)
    while time < RUN:
        instants += [time, time + slipping]
        time += slipping + sticking
    return [instant for instant in instants if instant < RUN]


def jumps_at_rest(law: str) -> bool:
    """Whether it has its level at 1 um/s already, so that a contact must be held at rest. Regularised laws have much
    more at 100 um/s."""
    if not has_phases(law):
        return False
    with open_part(law) as part:

        def force(velocity: float) -> float:
            part.set("velocity", velocity)
            part.at_event()
            return part.get("friction_force")

        return force(1e-6) > 0.5 * force(1e-4)


# Laws of a sliding velocity along a line.
LAWS = [model for model in friction_models_in(FMUS) if model in MODELS]
# Those that hold a load at rest: by themselves, or because they remember that they stick.
HOLDING = [law for law in LAWS if "stuck" in names_of(law, "local") or jumps_at_rest(law)]


def has_branches(law: str) -> bool:
    """Whether a balance of forces can decide between two branches of a law."""
    return "acceleration_source" in names_of(law, "parameter")


def open_law(law: str):
    """A law on a free body: a balance of forces, choice 2, decides between branches."""
    return open_part(law, **({"acceleration_source": 2} if has_branches(law) else {}))


@pytest.mark.parametrize("law", HOLDING)
def test_a_contact_that_is_held_returns_the_force_that_pulls_at_it(law):
    """By less than the level of every law."""
    pull = 0.05 * KINETIC
    with open_law(law) as part:
        part.set("velocity", 0.0)
        part.set("external_force", pull)
        part.at_event()
        assert part.get("friction_force") == pull


def most_events(law: str) -> int:
    """Twice those of two levels; with branches a slip has three parts: faster, steady, slower. Elements slip one after
    another and stick together."""
    elements = [v for v in DESCRIPTIONS[law].modelVariables if v.name == "element_count"]
    parts = int(elements[0].start) + 1 if elements else 3 if has_branches(law) else 2
    return parts * len(breakaways_and_captures())


def on_the_belt(law: str, method: str, tolerance: float):
    """A friction law on the belt, all integrated by one solver."""
    with open_part("BeltRig") as rig, open_law(law) as friction:
        links = [(rig, "velocity", friction, "velocity")]
        if "external_force" in friction.references:
            links.append((rig, "external_force", friction, "external_force"))
        links.append((friction, "friction_force", rig, "friction_force"))
        times = numpy.linspace(0.0, RUN, 2001)
        return times, integrate(System([rig, friction], links), times, method, tolerance)


def test_stick_and_slip_on_the_belt_are_events_at_the_times_of_the_closed_form():
    expected = breakaways_and_captures()
    _, run = on_the_belt("CoulombStiction", "DOP853", 1e-10)
    assert len(expected) >= 6
    assert len(expected) <= len(run.events) <= 2 * len(expected)
    for instant in expected:
        assert min(abs(event - instant) for event in run.events) < 1e-6, instant


@pytest.mark.parametrize("tolerance", [1e-3, 1e-5])
@pytest.mark.parametrize("method", ["RK45", "BDF", "Radau", "LSODA"])
def test_a_coarse_solver_finds_the_same_events(method, tolerance):
    expected = breakaways_and_captures()
    _, run = on_the_belt("CoulombStiction", method, tolerance)
    print(f"figure: {method}, tolerance {tolerance:g}: {len(run.events)} events, {len(expected)} in closed form")
    assert len(run.events) == len(expected)
    # The tolerance is that of a step, and the errors of some hundred steps add up in a multistep method.
    for instant in expected:
        assert min(abs(event - instant) for event in run.events) < 100.0 * tolerance, instant


@pytest.mark.parametrize("tolerance", [1e-3, 1e-5])
@pytest.mark.parametrize("method", ["RK45", "BDF", "LSODA"])
@pytest.mark.parametrize("law", HOLDING)
def test_a_coarse_solver_does_not_chatter(law, method, tolerance):
    _, run = on_the_belt(law, method, tolerance)
    assert 1 <= len(run.events) <= most_events(law), run.events


def has_a_phase_or_a_bristle(law: str) -> bool:
    """Whether it is a law without memory, or one whose only memory of the motion is a deflection."""
    return has_phases(law) or has_a_bristle(law)


@pytest.mark.parametrize("law", [law for law in LAWS if has_a_phase_or_a_bristle(law)])
def test_a_contact_on_the_belt_does_not_chatter(law):
    _, run = on_the_belt(law, "LSODA", 1e-8)
    # Laws without event indicators on the way request the events at which `sticking` changes.
    assert 1 <= len(run.events) <= most_events(law), run.events


@pytest.mark.parametrize("model", MODELS)
def test_directional_derivatives_of_derivatives_are_those_of_central_differences(model):
    description = DESCRIPTIONS[model]
    rates = [v for v in description.modelVariables if v.derivative is not None]
    knowns = [v.name for v in real_inputs(model)] + [v.derivative.name for v in rates]
    values = {v.name: float(v.start) + 0.3 * SWING.get(v.unit, 0.0) for v in real_inputs(model)}
    with open_part(model) as part:
        for name, value in values.items():
            part.set(name, value)
        start, states = part.x, [v.derivative.name for v in rates]

        def rates_at(known: str, shift: float) -> numpy.ndarray:
            x = start.copy()
            if known in values:
                part.set(known, values[known] + shift)
            else:
                x[states.index(known)] += shift
            part.x = x
            found = part.rates()
            part.x = start
            for name, value in values.items():
                part.set(name, value)
            return found

        for known in knowns:
            size = abs(values.get(known, 0.0)) or 1e-4
            shift = 1e-5 * size
            difference = (rates_at(known, shift) - rates_at(known, -shift)) / (2.0 * shift)
            exact = numpy.array([part.directional(v.name, known) for v in rates])
            scale = numpy.maximum(numpy.abs(exact), 1e-9 * numpy.abs(part.rates()) / shift)
            assert (numpy.abs(difference - exact) <= 1e-4 * scale + 1e-9).all(), known
