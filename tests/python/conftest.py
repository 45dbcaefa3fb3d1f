"""Fixtures of the tests: the packed FMUs, which must belong to the sources, and runs on the belt, computed once."""

import functools
import os
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

import pytest
from belt import BeltRun, run_belt
from page import page_library

from examples.fmpy.coupling import FMUS, PROJECT

# Where the examples find FMUs of the Python package: not in the cache of whoever runs them.
os.environ["STRIBECK_CACHE"] = str(PROJECT / "out" / "cache")

DESCRIPTIONS = PROJECT / "modelDescription"


def guids_of_sources() -> dict[str, str]:
    """Guid of each model in the committed descriptions."""
    return {path.stem: ElementTree.parse(path).getroot().get("guid") for path in DESCRIPTIONS.glob("*.xml")}


def guids_of_fmus(folder: Path, attribute: str) -> dict[str, str]:
    """Guid of each FMU in a folder, by the attribute of its version of FMI."""
    guids = {}
    for path in folder.glob("*.fmu"):
        with zipfile.ZipFile(path) as archive:
            guids[path.stem] = ElementTree.fromstring(archive.read("modelDescription.xml")).get(attribute)
    return guids


def pytest_sessionstart() -> None:
    """Fails if FMUs are missing or belong to other sources."""
    wanted = guids_of_sources()
    if not wanted:
        pytest.exit(f"no model descriptions in {DESCRIPTIONS}: run `cargo run -p fmu-build -- generate`", returncode=1)
    for folder, attribute in [(FMUS, "guid"), (FMUS / "fmi3", "instantiationToken")]:
        found = guids_of_fmus(folder, attribute)
        stale = sorted(model for model in wanted | found if wanted.get(model) != found.get(model))
        if stale:
            pytest.exit(
                f"missing or outdated in {folder}: {', '.join(stale)}; run `python3 tasks.py pack`", returncode=1
            )


def pytest_terminal_summary(terminalreporter) -> None:
    """The summary of a run for `tasks.py trust`."""
    counts = [
        f"{len(terminalreporter.stats.get(word, []))} {word}" for word in ("passed", "skipped", "failed", "error")
    ]
    terminalreporter.write_line(f"figure: {', '.join(counts)}")


@pytest.fixture(scope="session")
def ask():
    """Puts a question of the page."""
    return page_library()


@functools.cache
def _cached_run(model: str, step: float, time: float, exchange: str, parameters: tuple) -> BeltRun:
    return run_belt(FMUS, model, step, time, exchange, dict(parameters))


@pytest.fixture(scope="session")
def belt():
    """A run on the belt."""

    def run(model: str, step=1e-3, time=40.0, exchange="sequential", **parameters) -> BeltRun:
        return _cached_run(model, step, time, exchange, tuple(parameters.items()))

    return run


@pytest.fixture
def dist() -> Path:
    """The folder of the FMUs."""
    return FMUS
