"""The kit for C and C++ of each platform."""

import shutil

from release.making import FMU_BUILD, STAGE, VERSION, Release, contents, run


def kits(release: Release) -> None:
    """Writes a kit for each platform."""
    for platform in release.platforms:
        written = STAGE / "sdk"
        shutil.rmtree(written, ignore_errors=True)
        run(*FMU_BUILD, "sdk", "--platform", platform, "--out", written)
        (folder,) = written.iterdir()
        ending = "zip" if folder.name == "win64" else "tar.gz"
        about = f"header, shared and static library, CMake, pkg-config, examples for C and C++ on {folder.name}"
        name = f"sdk/stribeck-{VERSION}-sdk-{folder.name}.{ending}"
        release.archive(name, contents(folder), about, frozenset({"libstribeck.so", "libstribeck.dylib"}))
