"""The program `stribeck` for each platform, with completions, manual pages and licences."""

import shutil
import sys
from importlib.util import find_spec

from release import macos
from release.making import FMU_BUILD, STAGE, TARGET, VERSION, Release, contents, flags, foreign, has_rust_for, run

# For each platform of fmu-build: Rust's names of the targets, and flags for rustc. On Linux the program is static and
# runs with any C library; Rust's own linker needs no compiler of the other processor, and no SDK of Apple.
STATIC = ["-Clinker=rust-lld"]
LINUX = {"x86_64-unknown-linux-musl": STATIC}
KINDS = {
    "host": LINUX if sys.platform == "linux" else {},
    "linux64": LINUX,
    "aarch64-linux": {"aarch64-unknown-linux-musl": STATIC},
    "win64": {"x86_64-pc-windows-gnu": ["-Clink-arg=-Wl,--no-insert-timestamp"]},
    "darwin64": {"aarch64-apple-darwin": macos.FLAGS, "x86_64-apple-darwin": macos.FLAGS},
}
SHELLS = {"bash": "stribeck.bash", "zsh": "_stribeck", "fish": "stribeck.fish", "powershell": "stribeck.ps1"}


def lacking(target: str) -> str | None:
    """A tool that this machine lacks to build for a target, as the command that installs it."""
    if not has_rust_for(target):
        return f"rustup target add {target}"
    # The licence of musl and the functions of macOS come with Zig.
    if "windows" not in target and find_spec("ziglang") is None:
        return ".venv/bin/python -m pip install -r requirements-platforms.txt"
    return None


def build(target: str, linked: list[str]) -> bytes:
    """The program for a target, linked with these flags."""
    environment = macos.sdk(STAGE / "macos") if "apple" in target else {}
    run(
        *("cargo", "build", "--release", "--locked", "--package", "stribeck-cli", "--target", target),
        # Other flags would build everything again each time.
        CARGO_TARGET_DIR=str(TARGET / "program"),
        CARGO_ENCODED_RUSTFLAGS="\x1f".join([flags(), *linked]),
        **environment,
    )
    name = "stribeck.exe" if "windows" in target else "stribeck"
    program = (TARGET / "program" / target / "release" / name).read_bytes()
    for place in foreign():
        if place in program:
            sys.exit(f"the program for {target} contains the path {place.decode()}")
    return program


def papers(target: str) -> dict[str, bytes]:
    """Licences and components of the program for a target."""
    folder = STAGE / "components"
    shutil.rmtree(folder, ignore_errors=True)
    run(*FMU_BUILD, "components", "stribeck-cli", "--target", target, "--out", folder)
    return contents(folder)


def shells() -> dict[str, bytes]:
    """Completions and manual pages, as the program for this machine writes them."""
    cargo = ["cargo", "run", "--quiet", "--package", "stribeck-cli", "--"]
    files = {f"completions/{name}": run(*cargo, "completions", shell).encode() for shell, name in SHELLS.items()}
    folder = STAGE / "man"
    shutil.rmtree(folder, ignore_errors=True)
    run(*cargo, "manual", "--out", folder)
    return files | {f"man/man1/{name}": page for name, page in contents(folder).items()}


def programs(release: Release) -> None:
    """Writes an archive for each target."""
    shared = shells()
    if "page.html" in release.about:
        # Where `stribeck page` looks for it.
        shared["page.html"] = (release.folder / "page.html").read_bytes()
    for platform in release.platforms:
        if not KINDS.get(platform):
            release.missing[f"program for {platform}"] = (
                "cargo build --release --package stribeck-cli, on such a machine"
            )
        for target, linked in KINDS.get(platform, {}).items():
            lack = lacking(target)
            if lack is not None:
                release.missing[f"program for {target}"] = lack
                continue
            program = {"stribeck.exe" if "windows" in target else "stribeck": build(target, linked)}
            ending = "zip" if "windows" in target else "tar.gz"
            path = f"program/stribeck-{VERSION}-{target}.{ending}"
            files = program | shared | papers(target)
            release.archive(path, files, f"the program stribeck for {target}", frozenset(program))
