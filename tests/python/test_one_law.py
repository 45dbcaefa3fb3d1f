"""C sources of the strut and its contact with one law: the bits of the library; other laws are refused."""

import ctypes
import os
import shutil
import subprocess
from functools import partial

import pytest
from c_sources import (
    FMU_BUILD,
    ROOT,
    WARNINGS,
    answer,
    begun,
    built,
    compiled,
    headers,
    library_at,
    make,
    motion,
    moved,
    needs_wasm,
    of_library,
    question,
    variables,
)
from fmpy import extract, read_model_description
from fmpy.validation import validate_fmu

from examples.fmpy import coupling

pytestmark = needs_wasm
COMPILER = next((name for name in ("gcc", "clang", "cc") if shutil.which(name)), "cc")
IS_LEFT_OUT = os.environ.get("STRIBECK_THOROUGH") != "1"
WHEN = pytest.mark.skipif(IS_LEFT_OUT, reason="compiles a library for each law: with STRIBECK_THOROUGH=1")
CHOSEN = [pytest.param(chosen, marks=WHEN) for chosen in [("ShockAbsorber", "LuGre"), ("GuideContact", "Karnopp")]]
OK, REFUSED_VALUE, BAD_BUFFER = 0, 4, 7
# They must live as long as an FMU may log.
LOGGERS = []
NONE = 1


def choice(model: str) -> tuple[ctypes.c_uint32, dict[str, int]]:
    """The reference of the variable that chooses a law, and the numbers of the laws."""
    described = read_model_description(str(ROOT / "modelDescription" / f"{model}.xml"), validate=False)
    variable = next(one for one in described.modelVariables if one.name == "friction.model")
    numbers = {item.name: int(item.value) for item in variable.declaredType.items}
    return ctypes.c_uint32(variable.valueReference), numbers


@pytest.fixture(scope="module", params=CHOSEN, ids="-".join)
def sources(request, tmp_path_factory):
    """Model, law, and the header of their sources."""
    model, law = request.param
    folder = tmp_path_factory.mktemp(model)
    make("sources", model, "--law", law, "--out", folder)
    return model, law, headers(folder)[model]


def test_one_law_has_the_bits_of_the_library(sources):
    model, law, header = sources
    rows = motion(model, 2000)
    expected = of_library(model, rows, values={"friction.model": choice(model)[1][law]})
    assert sum(len(line) == len(variables(model)[1]) for line in expected) > 1900, "hardly a step is refused"
    program = compiled(header, [COMPILER, *WARNINGS, "-O1"], "drive")
    assert answer([str(program)], question(model, rows)) == expected


class Law:
    """An instance of the sources of a model."""

    def __init__(self, header, name):
        out = header.with_suffix(".so")
        command = [COMPILER, *WARNINGS, "-O0", "-shared", "-fPIC", str(header.with_suffix(".c")), "-o", str(out), "-lm"]
        subprocess.run(command, check=True)
        self.library, self.name, self.instance = ctypes.CDLL(str(out)), name, ctypes.c_void_p()
        text = header.read_text(encoding="ascii")
        size = int(text.split(f"#define {name.upper()}_MEMORY ")[1].split("u")[0])
        self.memory = (ctypes.c_double * (size // 8 + 1))()
        assert self.library[f"{name}_create"](self.memory, ctypes.byref(self.instance)) == OK

    def call(self, function: str, *arguments) -> int:
        return self.library[f"{self.name}_{function}"](self.instance, *arguments)

    def get(self, variable) -> float:
        value = ctypes.c_double()
        assert self.call("get", variable, ctypes.byref(value)) == OK
        return value.value


def state_of_library(model: str, number: int):
    """A saved state of the library, with the law of this number."""
    library, instance = library_at(), ctypes.c_void_p()
    library.stribeck_state_size.restype = ctypes.c_size_t
    assert library.stribeck_create(model.encode(), ctypes.byref(instance)) == OK
    assert library.stribeck_set(instance, choice(model)[0], ctypes.c_double(number)) == OK
    state = ctypes.create_string_buffer(library.stribeck_state_size(instance))
    assert library.stribeck_save(instance, state, ctypes.c_size_t(len(state))) == OK
    library.stribeck_free(instance)
    return state


def test_other_laws_are_refused(sources):
    """By a setting, and in a state of the library; reset and presets choose the only law, or none."""
    model, name, header = sources
    variable, numbers = choice(model)
    law = Law(header, header.stem)
    assert f"default {name})" in header.read_text(encoding="ascii")
    assert law.get(variable) == numbers[name]
    for other, number in numbers.items():
        state = state_of_library(model, number)
        restored = law.call("restore", state, ctypes.c_size_t(len(state)))
        refused = law.call("set", variable, ctypes.c_double(number))
        expected = (OK, OK) if other in (name, "None") else (REFUSED_VALUE, BAD_BUFFER)
        assert (refused, restored) == expected, other
    for value in (0.0, 1.5, len(numbers) + 1.0, float("nan")):
        assert law.call("set", variable, ctypes.c_double(value)) == REFUSED_VALUE
    assert law.call("set", variable, ctypes.c_double(NONE)) == OK
    assert law.call("reset") == OK
    assert law.get(variable) == numbers[name]
    if model == "ShockAbsorber":
        # The fifth preset is that without friction.
        for preset, chosen in ((4, NONE), (3, numbers[name])):
            assert law.call("apply_preset", ctypes.c_uint32(preset)) == OK
            assert law.get(variable) == chosen
    assert law.call("step", ctypes.c_double(1e-3)) == OK


@pytest.fixture(scope="module", params=CHOSEN, ids="-".join)
def fmus(request, tmp_path_factory):
    """Model, law, and for each version of FMI the folder of its FMU, compiled by fmpy."""
    model, law = request.param
    folder = tmp_path_factory.mktemp(f"fmus of {model}")
    make("pack", model, "--sources", "--law", law, "--out", folder)
    packed = [folder / f"{model}.fmu", folder / "fmi3" / f"{model}.fmu"]
    assert [validate_fmu(str(path)) for path in packed] == [[], []]
    yield model, law, [built(path, folder / f"{at}") for at, path in enumerate(packed, 2)]
    # fmpy's formatting library passes all messages of the process to the last logger: to that of the other tests again.
    LOGGERS.append(coupling._callbacks())


def hears(said: list[str], *about) -> None:
    """A logger: the message is its last argument."""
    said.append(about[-1].decode())


def test_fmus_with_one_law_do_what_those_with_a_library_do_with_it(fmus, tmp_path):
    model, law, folders = fmus
    variable, numbers = choice(model)
    expected = None
    for folder, library in zip(folders, ("", "fmi3"), strict=True):
        binary = extract(str(ROOT / "dist" / library / f"{model}.fmu"), str(tmp_path / f"library{library}"))
        results = moved(begun(binary, [(variable.value, numbers[law])]), model)
        assert moved(begun(folder), model) == results
        assert results == (expected or results), "both versions alike"
        assert results != moved(begun(binary, [(variable.value, NONE)]), model), "the law matters"
        expected = results


def test_fmus_with_one_law_begin_with_it_and_refuse_others(fmus):
    model, law, folders = fmus
    variable, numbers = choice(model)
    for folder in folders:
        described = read_model_description(str(folder))
        chosen = next(one for one in described.modelVariables if one.name == "friction.model")
        assert int(chosen.start) == numbers[law]
        assert {item.name: int(item.value) for item in chosen.declaredType.items} == {"None": NONE, law: numbers[law]}
        assert law in described.description
        said = []
        hear = partial(hears, said)
        LOGGERS.append(hear)
        other, name = next((number, name) for name, number in numbers.items() if name not in ("None", law))
        with pytest.raises(Exception, match="failed with status"):
            begun(folder, [(variable.value, other)], hear)
        text = f"friction.model = {other} ({name}): must be 1 (None) or {numbers[law]} ({law})"
        assert any(text in message for message in said), said
        begun(folder, [(variable.value, NONE)]).freeInstance()


@pytest.mark.parametrize("command", [["sources"], ["pack", "--sources"]], ids=" ".join)
@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["ShockAbsorber"], "with one of Coulomb, CoulombStiction"),
        (["GuideContact", "--law", "Lugre"], "--law Lugre: must be one of Coulomb, CoulombStiction"),
        (["GuideContact", "--law", "None"], "--law None: must be one of Coulomb"),
        (["LuGre", "--law", "LuGre"], "LuGre: --law LuGre: it has no choice of law"),
        (["--law", "LuGre"], "required arguments were not provided"),
    ],
)
def test_a_missing_or_wrong_law_is_named(command, arguments, complaint, tmp_path):
    command = [str(FMU_BUILD), "--project", str(ROOT), *command, *arguments, "--out", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode != 0
    assert complaint in done.stderr
    assert not list(tmp_path.iterdir())
