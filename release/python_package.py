"""The Python package: wheels, sources, and a recipe for conda."""

import hashlib
import io
import re
import shutil
import sys
import tarfile
from string import Template

from release import wheels
from release.making import PROJECT, STAGE, VERSION, Release, moment, run, tarred

RECIPE = PROJECT / "release" / "recipe.yaml"
# A crate that the workspace puts in the place of one of the registry. Maturin packs those only that are asked for.
CLOCK = "web/clock"
LAST_MEMBER = '"ssp"]'
# Benches, whose files are not packed: a manifest must not name them.
BENCH = re.compile(r"\[\[bench\]\]\n(\w+ = .+\n)+\n?")


def built(release: Release) -> None:
    """Builds the wheels for the platforms of a release."""
    written = STAGE / "wheels"
    shutil.rmtree(written, ignore_errors=True)
    wheels.main(written, *release.platforms)
    for wheel in sorted(written.glob("*.whl")):
        release.add(f"python/{wheel.name}", wheel, "Python package, with the FMUs of its platform")


def completed(packed: bytes) -> bytes:
    """Packed sources with the crate that replaces one of the registry, and without the names of benches."""
    with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
        files = {entry.name: archive.extractfile(entry).read() for entry in archive if entry.isfile()}
    top = f"stribeck-{VERSION}"
    manifest = files[f"{top}/Cargo.toml"].decode()
    if manifest.count(LAST_MEMBER) != 1:
        sys.exit(f"the members of the workspace in the packed sources do not end with {LAST_MEMBER}")
    more = f'{LAST_MEMBER[:-1]}, "{CLOCK}"]'
    files[f"{top}/Cargo.toml"] = BENCH.sub("", manifest.replace(LAST_MEMBER, more)).encode()
    for path in sorted((PROJECT / CLOCK).rglob("*")):
        if path.is_file():
            files[f"{top}/{path.relative_to(PROJECT).as_posix()}"] = path.read_bytes()
    return tarred({name: files[name] for name in sorted(files)})


def sources(release: Release) -> None:
    """Packs the sources of the package, and writes the recipe that builds them."""
    written = STAGE / "sdist"
    shutil.rmtree(written, ignore_errors=True)
    maturin = [sys.executable, "-m", "maturin", "sdist", "--manifest-path", "python/Cargo.toml", "--out", written]
    run(*maturin, SOURCE_DATE_EPOCH=str(moment()))
    (packed,) = written.glob("*.tar.gz")
    content = completed(packed.read_bytes())
    release.add(f"python/{packed.name}", content, "sources of the Python package, without FMUs, built by maturin")
    blanks = {"version": VERSION, "sha256": hashlib.sha256(content).hexdigest()}
    recipe = Template(RECIPE.read_text(encoding="utf-8")).substitute(blanks)
    release.add("conda/recipe.yaml", recipe.encode(), "recipe for rattler-build, which builds the sources beside it")
