"""The four-post package in several masters: the same exchange scheme must give the same numbers."""

import platform
import shutil
import sys

import numpy
import pytest
from fmpy.ssp.simulation import simulate_ssp
from fmpy.ssp.ssd import read_ssd
from masters import MASTERS, run_fmpy, run_jacobi, unpacked, variants

from examples.fmpy.coupling import CouplingError

HEAVE, PITCH = "car.heave", "car.pitch"
CAR = [HEAVE, PITCH, "car.roll", "car.fl.length", "car.rr.velocity", "car.rl.wheel_velocity"]
WATCHED = [*CAR, "strut_fl.force", "strut_rr.force_friction"]
VARIANTS = ["SystemStructure", "firm", "soft", "without_friction"]
STEP, STEPS = 1e-3, 1500

NEEDS_BINARIES = pytest.mark.skipif(
    sys.platform != "linux" or platform.machine() != "x86_64", reason="Ecos and libcosim need Linux on x86-64"
)


@pytest.fixture(scope="module")
def package():
    from examples.fmpy.coupling import FMUS

    path = FMUS / "FourPost.ssp"
    assert path.is_file(), f"no {path}: run `python3 tasks.py pack`"
    return path


@pytest.fixture(scope="module")
def plain(package):
    """The plain script, by variant."""
    return {variant: run_jacobi(package, variant, STEP, STEPS, WATCHED) for variant in VARIANTS}


@pytest.mark.parametrize("variant", VARIANTS)
def test_descriptions_and_parameter_sets_conform_to_the_schemas(package, tmp_path, variant):
    """FMPy checks files against the schemas when it reads them."""
    assert variants(package) == VARIANTS
    with unpacked(package, variant) as system:
        description = read_ssd(shutil.make_archive(str(tmp_path / variant), "zip", system.folder))
    assert description.name == "FourPost"
    assert len(description.system.elements) == 6
    assert len(description.system.connections) == 20


@NEEDS_BINARIES
@pytest.mark.parametrize("variant", VARIANTS)
@pytest.mark.parametrize("master", ["ecos", "libcosim"])
def test_masters_of_the_same_scheme_agree(package, plain, master, variant):
    # Ecos shows the forces after the exchange, so only the car can be compared, on which all forces act.
    record = MASTERS[master](package, variant, STEP, STEPS, CAR)
    for name in CAR:
        assert numpy.abs(record[name] - plain[variant][name]).max() < 1e-9, name


@pytest.mark.parametrize("variant", VARIANTS)
def test_the_runner_of_fmpy_agrees_far_within_the_error_of_the_coupling(package, plain, variant):
    """Half the step shows the size of that error. The runner differs only in the first exchange."""
    runner = run_fmpy(package, variant, STEP, STEPS, CAR)
    fine = run_jacobi(package, variant, STEP / 2.0, 2 * STEPS, CAR)
    for name in CAR:
        error = numpy.abs(plain[variant][name] - fine[name][1::2]).max()
        assert numpy.abs(runner[name] - plain[variant][name]).max() < 1e-3 * error + 1e-12, name


def test_the_runner_of_fmpy_runs_the_package_as_it_is(package):
    """It first sets every input to 0, including a strut's length; then the car rides on its struts."""
    record = simulate_ssp(str(package), stop_time=1.5, step_size=STEP)
    assert len(record) > 1400
    for name in CAR:
        assert numpy.isfinite(record[name]).all(), name
    for corner in ("fl", "fr", "rl", "rr"):
        length = record[f"car.{corner}.length"]
        assert 0.145 < length.min() < length.max() < 0.2, corner
        assert record[f"strut_{corner}.force"][100:].min() > 0.0, corner


def test_each_variant_has_its_damper(plain):
    """With less damping the body moves farther from the posts; without friction there is no friction force."""
    travel = {variant: numpy.ptp(record["car.fl.length"]) for variant, record in plain.items()}
    assert travel["soft"] > 1.2 * travel["firm"]
    assert travel["without_friction"] > 1.02 * travel["SystemStructure"]
    friction = {variant: numpy.abs(record["strut_rr.force_friction"]).max() for variant, record in plain.items()}
    assert friction["without_friction"] == 0.0
    assert friction["firm"] > 1.2 * friction["SystemStructure"] > 0.0


def test_rear_springs_belong_to_the_rest_position(package):
    """With posts at rest nothing moves: the struts carry the static load of the host."""
    rest = run_jacobi(package, "without_friction", STEP, 100, [HEAVE, PITCH, "strut_fl.force", "strut_rl.force"])
    # The posts begin to move at once; in the first millisecond by 3 um.
    assert rest["strut_fl.force"][0] == pytest.approx(1325.2555, abs=0.01)
    assert rest["strut_rl.force"][50] == pytest.approx(1100.2555, abs=25.0)


def test_unknown_variants_are_rejected_by_name(package):
    with pytest.raises(CouplingError, match="has no variant 'hard'; there are SystemStructure, firm, soft"):
        run_jacobi(package, "hard", STEP, 1, WATCHED)
