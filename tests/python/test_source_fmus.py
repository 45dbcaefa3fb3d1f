"""Source FMUs of all models, compiled by fmpy: the bits of those with a library, in both versions of FMI."""

import math
import os

import pytest
from c_sources import ROOT, begun, built, make, moved, needs_wasm, with_sources
from fmpy import extract
from fmpy.validation import validate_fmu

from examples.fmpy import coupling

IS_LEFT_OUT = os.environ.get("STRIBECK_THOROUGH") != "1"
WHEN = pytest.mark.skipif(IS_LEFT_OUT, reason="compiles two libraries for each model: with STRIBECK_THOROUGH=1")
pytestmark = needs_wasm
# A gas spring refuses most of the strokes of a random motion, and a refusal ends an FMU.
MODELS = [name for name in with_sources() if name != "GasSpring"]
# They must live as long as an FMU may log.
LOGGERS = []


@pytest.mark.parametrize("model", [pytest.param(name, marks=WHEN) for name in MODELS])
def test_an_fmu_of_sources_has_the_bits_of_that_with_a_library(model, tmp_path):
    make("pack", model, "--sources", "--out", tmp_path)
    for version, folder in (("2", ""), ("3", "fmi3")):
        packed = tmp_path / folder / f"{model}.fmu"
        assert validate_fmu(str(packed)) == []
        compiled = built(packed, tmp_path / f"compiled{version}")
        binary = extract(str(ROOT / "dist" / folder / f"{model}.fmu"), str(tmp_path / f"library{version}"))
        results = moved(begun(compiled), model)
        assert results == moved(begun(binary), model), f"FMI {version}"
        assert len(results) == 400
        assert all(math.isfinite(value) for row in results for value in row)
    # fmpy's formatting library passes all messages of the process to the last logger: to that of the other tests again.
    LOGGERS.append(coupling._callbacks())
