#!/usr/bin/env python3
"""Builds the Python package for Linux, Windows and macOS on one Linux machine, each with the FMUs of its platform.

python3 -m release.wheels FOLDER [PLATFORM ...]
"""

import os
import shutil
import sys
from pathlib import Path

from release import macos
from release.making import FMU_BUILD, PROJECT, TARGET, flags, run

# Linked by Zig, which knows the functions of old versions of glibc and those of macOS.
MANYLINUX = ["--zig", "--compatibility", "manylinux2014"]
# For each platform of `fmu-build pack`: the folder of its FMUs below that of the others; Rust's names of the targets
# that get a wheel, and how these are linked.
PLATFORMS = {
    "linux64": (".", {"x86_64-unknown-linux-gnu": MANYLINUX}),
    "win64": (".", {"x86_64-pc-windows-gnu": []}),
    "aarch64-linux": ("aarch64-linux", {"aarch64-unknown-linux-gnu": MANYLINUX}),
    "darwin64": (".", {"aarch64-apple-darwin": ["--zig"], "x86_64-apple-darwin": ["--zig"]}),
    # This machine, with its own tools: not for older systems.
    "host": (".", {"": []}),
}
# What the FMUs of a platform become in the package.
PARTS = "python/stribeck/fmus"


def build(target: str, linked: list[str], out: Path) -> None:
    """Builds the wheel for a target, with the list of its components; for this machine if it has no name."""
    of_target = ["--target", target] if target else []
    listed = PROJECT / "out" / "wheels" / "components"
    shutil.rmtree(listed, ignore_errors=True)
    run(*FMU_BUILD, "components", "stribeck-python", *of_target, "--out", listed)
    run(
        *(sys.executable, "-m", "maturin", "build", "--release", *of_target, *linked),
        *("--manifest-path", "python/Cargo.toml", "--out", out, "--sbom-include", listed / "sbom.cdx.json"),
        # Other flags would build everything again each time.
        CARGO_TARGET_DIR=str(TARGET / "wheels"),
        CARGO_ENCODED_RUSTFLAGS=flags(),
        MACOSX_DEPLOYMENT_TARGET=macos.OLDEST,
        # The programs of this environment, Zig among them.
        PATH=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
    )


def main(out: Path, *platforms: str) -> None:
    """Builds the wheels for these platforms, or for all but this machine."""
    try:
        for platform in platforms or (name for name in PLATFORMS if name != "host"):
            below, targets = PLATFORMS[platform]
            packed = PROJECT / "out" / "wheels" / platform
            run(*FMU_BUILD, "pack", "--platform", platform, "--strict", "--out", packed)
            run(sys.executable, "python/fmus.py", packed / below, PARTS)
            for target, linked in targets.items():
                build(target, linked, out)
    finally:
        # A package that is built later must not get the FMUs of another platform.
        run(sys.executable, "python/fmus.py", PARTS)


if __name__ == "__main__":
    main(Path(sys.argv[1]), *sys.argv[2:])
