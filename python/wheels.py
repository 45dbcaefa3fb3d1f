#!/usr/bin/env python3
"""Builds the Python package for Linux, Windows and macOS on one Linux machine, each with the FMUs of its platform.

python3 python/wheels.py FOLDER [PLATFORM ...]
"""

import os
import subprocess
import sys
from pathlib import Path

import fmus

PROJECT = Path(__file__).resolve().parents[1]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target"))

# Linked by Zig, which knows the functions of old versions of glibc and those of macOS.
MANYLINUX = ["--zig", "--compatibility", "manylinux2014"]
# For each platform of `fmu-build pack`: the folder of its FMUs below that of the others; Rust's names of the targets
# that get a wheel, and how these are linked.
PLATFORMS = {
    "linux64": (".", {"x86_64-unknown-linux-gnu": MANYLINUX}),
    "win64": (".", {"x86_64-pc-windows-gnu": []}),
    "aarch64-linux": ("aarch64-linux", {"aarch64-unknown-linux-gnu": MANYLINUX}),
    "darwin64": (".", {"aarch64-apple-darwin": ["--zig"], "x86_64-apple-darwin": ["--zig"]}),
}
OLDEST_MACOS = "11.0"


def run(*command: str | Path, **environment: str) -> None:
    """Runs a command in the project's folder; a failure ends the program."""
    words = [str(word) for word in command]
    print("\n>", *words, flush=True)
    subprocess.run(words, cwd=PROJECT, env={**os.environ, **environment}, check=True)


def flags() -> str:
    """Flags for rustc, in cargo's encoding: no wheel holds a path of this machine."""
    home = Path(os.environ.get("CARGO_HOME", Path.home() / ".cargo"))
    names = {home / "registry" / "src": "/crates", PROJECT: "/stribeck"}
    return "\x1f".join(f"--remap-path-prefix={path}={name}" for path, name in names.items())


def build(target: str, linked: list[str], out: Path) -> None:
    """Builds the wheel for a target."""
    run(
        *(sys.executable, "-m", "maturin", "build", "--release", "--target", target, *linked),
        *("--manifest-path", "python/Cargo.toml", "--out", out),
        # Other flags would build everything again each time.
        CARGO_TARGET_DIR=str(TARGET / "wheels"),
        CARGO_ENCODED_RUSTFLAGS=flags(),
        MACOSX_DEPLOYMENT_TARGET=OLDEST_MACOS,
        # The programs of this environment, Zig among them.
        PATH=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
    )


def main(out: Path, *platforms: str) -> None:
    """Builds the wheels for these platforms, or for all."""
    for platform in platforms or PLATFORMS:
        below, targets = PLATFORMS[platform]
        packed = PROJECT / "out" / "wheels" / platform
        fmu_build = ["cargo", "run", "--package", "fmu-build", "--"]
        run(*fmu_build, "pack", "--platform", platform, "--strict", "--out", packed)
        fmus.main(packed / below, PROJECT / "python" / "stribeck" / "fmus")
        for target, linked in targets.items():
            build(target, linked, out)


if __name__ == "__main__":
    main(Path(sys.argv[1]), *sys.argv[2:])
