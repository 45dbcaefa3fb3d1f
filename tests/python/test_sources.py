"""C sources of the laws, for controllers and as FMUs: the same bits as the library, whatever the compiler does."""

import os
import shutil
import subprocess

import pytest
from c_sources import (
    DRIVER,
    ROOT,
    WARNINGS,
    answer,
    built,
    compiled,
    headers,
    make,
    motion,
    needs_wasm,
    of_library,
    question,
    variables,
    with_parameters,
    with_sources,
)
from fmpy import extract, instantiate_fmu, read_model_description
from fmpy.validation import validate_fmu

from examples.fmpy import coupling

pytestmark = needs_wasm

COMPILERS = [name for name in ("gcc", "clang", "cc") if shutil.which(name)]
# Otherwise a bristle, a law with its own memory, and one that sticks.
ALL = os.environ.get("STRIBECK_THOROUGH") == "1"
MODELS = with_sources() if ALL else ["LuGre", "MaxwellSlip", "Karnopp"]
WITH_32_BITS = ["gcc", "-m32", "-msse2", "-mfpmath=sse"]


def ways() -> list[list[str]]:
    """Compilers with how they optimise: two, or all that are here, the most telling ones first."""
    if not ALL:
        return [[COMPILERS[0], optimised] for optimised in ("-O0", "-O3")]
    found = [[name, optimised] for optimised in ("-O2", "-O0", "-O3") for name in ("gcc", "clang") if name in COMPILERS]
    return [*found[:2], [*WITH_32_BITS, "-O2"], *found[2:]] if "gcc" in COMPILERS else found


@pytest.fixture(scope="module")
def sources(tmp_path_factory):
    """The folder with the sources of a model, and of those asked for before. They are made when they are needed."""
    folder = tmp_path_factory.mktemp("sources")

    def of(model):
        if model not in headers(folder):
            make("sources", model, "--out", folder)
        return folder

    return of


@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("way", ways(), ids=" ".join)
def test_sources_have_the_bits_of_the_library(sources, way, model):
    rows = motion(model, 2000)
    expected = of_library(model, rows)
    assert sum(len(line) == len(variables(model)[1]) for line in expected) > 1900, "hardly a step is refused"
    program = compiled(headers(sources(model))[model], [*way[:-1], *WARNINGS, way[-1]], f"drive{''.join(way)}")
    assert answer([str(program)], question(model, rows)) == expected
    if ALL:
        answered = 0
        for seed in range(20):
            changed = with_parameters(model, rows[:100], seed)
            expected = of_library(model, changed)
            assert answer([str(program)], question(model, changed)) == expected, seed
            # A step that is refused answers with a status, of a digit.
            answered += sum(len(line[0]) > 1 for line in expected)
        print(f"{model}, {' '.join(way)}: {answered} of 2000 steps with drawn parameters are accepted")


def test_sources_hold_no_data_that_nothing_reads(sources):
    """What a panic says, and the files that it names, are read by nobody."""
    source = headers(sources("LuGre"))["LuGre"].with_suffix(".c").read_text()
    numbers = source.partition("u8 data[] = {")[2].partition("}")[0].replace("\n", "").split(",")
    data = bytes(int(number) for number in numbers if number.strip())
    assert b"stribeck_velocity" in data
    for text in (b"assertion", b"/rustc/", b".rs", b"slice"):
        assert text not in data, text


def test_sources_refuse_other_arithmetic_and_bad_values(sources):
    """An example, with the statuses of its refusals."""
    sources = sources("LuGre")
    program = sources / "refusals"
    text = DRIVER.with_name("refusals.c")
    command = [COMPILERS[0], *WARNINGS, f"-I{sources}", text, sources / "lugre.c"]
    subprocess.run([*map(str, command), "-lm", "-o", str(program)], check=True)
    done = subprocess.run([str(program)], capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, "all refusals as documented\n")
    fast = [COMPILERS[0], "-std=c99", "-ffast-math", "-c", "-o", sources / "fast.o", sources / "lugre.c"]
    done = subprocess.run(list(map(str, fast)), capture_output=True, text=True)
    assert done.returncode != 0
    assert "no -ffast-math" in done.stderr


# They must live as long as an FMU may log.
LOGGERS = []


class Fmu:
    """An FMU with a logger."""

    def __init__(self, folder):
        self.description = read_model_description(str(folder))
        self.folder, self.said = folder, []

    def start(self):
        def heard(_environment, _name, status, category, message):
            self.said.append((status, category, message))

        self.said.clear()
        self.fmu = instantiate_fmu(str(self.folder), self.description, "CoSimulation", logger=heard)
        self.fmu.setupExperiment(startTime=0.0)
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()
        return self.fmu

    def reference(self, name):
        return next(one.valueReference for one in self.description.modelVariables if one.name == name)


@pytest.fixture(scope="module")
def both(tmp_path_factory):
    """The FMU with a library, and that with C sources, which fmpy has compiled."""
    folder = tmp_path_factory.mktemp("fmus")
    make("pack", "LuGre", "--sources", "--out", folder)
    assert (folder / "LuGre.fmu").stat().st_size < 400_000
    assert validate_fmu(str(folder / "LuGre.fmu")) == []
    library = extract(str(ROOT / "dist" / "LuGre.fmu"), str(folder / "library"))
    yield Fmu(library), Fmu(built(folder / "LuGre.fmu", folder / "sources"))
    # fmpy's formatting library passes all messages of the process to the last logger: to that of the other tests again.
    LOGGERS.append(coupling._callbacks())


def test_an_fmu_of_sources_does_what_that_with_a_library_does(both):
    runs = []
    for one in both:
        fmu = one.start()
        names = ["velocity", "normal_force"]
        inputs = [one.reference(name) for name in names]
        outputs = [variable.valueReference for variable in variables("LuGre")[1]]
        results, time = [], 0.0
        for step, (dt, values) in enumerate(motion("LuGre", 400)):
            fmu.setReal(inputs, values[: len(inputs)])
            if step % 3 == 0:
                fmu.setRealInputDerivatives(inputs[:1], [1], [0.01 * values[0]])
            fmu.doStep(time, dt)
            time += dt
            results.append(fmu.getReal([one.reference("time"), *outputs]))
            results.append(fmu.getRealOutputDerivatives([one.reference("friction_force")], [1]))
            results.append(fmu.getDirectionalDerivative([one.reference("friction_force")], inputs, [1.0, 0.5]))
        state = fmu.getFMUState()
        bytes_of_state = bytes(fmu.serializeFMUState(state))
        fmu.doStep(time, 1e-3)
        after = fmu.getReal(outputs)
        fmu.setFMUState(state)
        fmu.doStep(time, 1e-3)
        assert fmu.getReal(outputs) == after
        fmu.freeFMUState(state)
        runs.append((results, bytes_of_state, after))
        fmu.freeInstance()
    assert runs[0] == runs[1]


def test_refusals_of_an_fmu_of_sources_are_those_of_the_library(both):
    told = []
    for one in both:
        fmu = one.start()
        for refused in (
            lambda fmu, one: fmu.setReal([one.reference("mu_k")], [-1.0]),
            lambda fmu, one: fmu.setReal([one.reference("velocity")], [float("nan")]),
            lambda fmu, _: fmu.getReal([7]),
        ):
            with pytest.raises(Exception, match="failed with status"):
                refused(fmu, one)
        told.append(list(one.said))
        fmu.reset()
        fmu.freeInstance()
    assert told[0] == told[1]
    assert len(told[0]) == 3
