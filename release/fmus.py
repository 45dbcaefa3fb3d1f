"""FMUs, single and together; C sources; the four-post rig as SSP."""

import shutil

from release.making import FMU_BUILD, STAGE, VERSION, MissingTool, Release, contents, has_rust_for, run

# From which C sources are made.
WASM = "wasm32-unknown-unknown"
# Below the folder of packed FMUs, those that each archive has, and what they are.
KINDS = {
    "fmi2": (".", "FMUs of FMI 2.0"),
    "fmi3": ("fmi3", "FMUs of FMI 3.0"),
    "fmi2-plain": ("plain", "FMUs of FMI 2.0 for hosts that know Real variables only"),
    "fmi2-aarch64-linux": ("aarch64-linux", "FMUs of FMI 2.0 for Linux on ARM, which has no folder of its own in them"),
    "fmi2-plain-aarch64-linux": ("aarch64-linux/plain", "the same with Real variables only"),
}
# The same of those with C sources in place of libraries.
KINDS_OF_SOURCES = {
    "fmi2-sources": (".", "FMUs of FMI 2.0 as C sources"),
    "fmi3-sources": ("fmi3", "FMUs of FMI 3.0 as C sources"),
}


def for_platforms(release: Release) -> list[str]:
    """Arguments of fmu-build for the platforms of a release."""
    return [word for platform in release.platforms for word in ("--platform", platform)]


def binaries(release: Release) -> None:
    """FMUs with libraries of all platforms, and the rig."""
    packed = STAGE / "fmus"
    shutil.rmtree(packed, ignore_errors=True)
    run(*FMU_BUILD, "pack", "--plain", *for_platforms(release), "--out", packed)
    run(*FMU_BUILD, "ssp", *for_platforms(release), "--out", packed)
    for kind, (below, about) in KINDS.items():
        found = contents(packed / below, "*.fmu")
        if found:
            add(release, kind, found, about)
    for name, content in contents(packed, "**/*.ssp").items():
        release.add(f"ssp/{name}", content, "four-post rig with its FMUs, SSP 1.0")


def add(release: Release, kind: str, fmus: dict[str, bytes], about: str) -> None:
    """Adds FMUs, single and as one archive."""
    release.archive(f"stribeck-{VERSION}-{kind}.zip", fmus, f"all {len(fmus)} {about}")
    for name, content in fmus.items():
        release.add(f"{kind}/{name}", content, about)


def sources(release: Release) -> None:
    """FMUs with C sources in place of libraries, and C sources for controllers."""
    if not has_rust_for(WASM):
        raise MissingTool(f"rustup target add {WASM}")
    packed = STAGE / "sources"
    shutil.rmtree(packed, ignore_errors=True)
    run(*FMU_BUILD, "pack", "--sources", "--out", packed / "fmus")
    run(*FMU_BUILD, "sources", "--out", packed / "c")
    for kind, (below, about) in KINDS_OF_SOURCES.items():
        add(release, kind, contents(packed / "fmus" / below, "*.fmu"), about)
    about = "laws as C99 for controllers, without memory of their own"
    release.archive(f"stribeck-{VERSION}-c-sources.zip", contents(packed / "c"), about)
