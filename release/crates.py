"""The crates as cargo packs them for a registry."""

import io
import json
import tarfile

from release.making import TARGET, VERSION, Release, run, tarred

# The commit from which a crate was packed: not everybody who builds a release has the repository.
OF_REPOSITORY = ".cargo_vcs_info.json"


def names() -> list[str]:
    """The crates that a registry would take."""
    text = run("cargo", "metadata", "--format-version", "1", "--no-deps")
    return sorted(package["name"] for package in json.loads(text)["packages"] if package["publish"] != [])


def without_repository(packed: bytes) -> bytes:
    """A packed crate that depends on its sources only."""
    with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
        files = {entry.name: archive.extractfile(entry).read() for entry in archive if entry.isfile()}
    return tarred({name: files[name] for name in sorted(files) if not name.endswith(OF_REPOSITORY)})


def packed(release: Release) -> None:
    """Packs the crates of the library and of the workbench."""
    packages = names()
    words = [word for name in packages for word in ("--package", name)]
    run("cargo", "package", "--no-verify", "--allow-dirty", *words)
    for name in packages:
        file = TARGET / "package" / f"{name}-{VERSION}.crate"
        content = without_repository(file.read_bytes())
        release.add(f"crates/{file.name}", content, f"sources of the crate {name}")
