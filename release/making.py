"""A release while it is written: its folder, its platforms, and what is missing in it."""

import calendar
import gzip
import io
import os
import re
import subprocess
import sys
import tarfile
import time
import tomllib
import zipfile
from dataclasses import dataclass, field
from pathlib import Path

PROJECT = Path(__file__).resolve().parents[1]
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target"))
# What is written on the way.
STAGE = PROJECT / "out" / "release"
VERSION = tomllib.loads((PROJECT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
FMU_BUILD = ("cargo", "run", "--quiet", "--package", "fmu-build", "--")


class MissingTool(Exception):
    """Something cannot be made on this machine; the text says what it lacks."""


def run(*command: str | Path, folder: Path = PROJECT, **environment: str) -> str:
    """Runs a command and returns what it prints; a failure ends the program with its messages."""
    words = [str(word) for word in command]
    print("\n>", *words, flush=True)
    settings = {**os.environ, **environment}
    done = subprocess.run(words, cwd=folder, env=settings, stdout=subprocess.PIPE, encoding="utf-8")
    if done.returncode != 0:
        sys.exit(f"{done.stdout}\nexit code {done.returncode}: {' '.join(words)}")
    return done.stdout


def has_rust_for(target: str) -> bool:
    """Whether Rust's standard library for a target is here."""
    folder = Path(run("rustc", "--print", "target-libdir", "--target", target).strip())
    return any(folder.glob("libstd-*.rlib"))


def cargo_home() -> Path:
    """Where cargo keeps the sources of crates."""
    return Path(os.environ.get("CARGO_HOME", Path.home() / ".cargo"))


def foreign() -> list[bytes]:
    """What names of files begin with that only this machine has."""
    places = (PROJECT, cargo_home(), Path.home() / ".rustup")
    return [f"{place}{os.sep}".encode() for place in places]


def flags() -> str:
    """Flags for rustc, in cargo's encoding: nothing that is released holds a path of this machine."""
    names = {cargo_home() / "registry" / "src": "/crates", PROJECT: "/stribeck"}
    return "\x1f".join(f"--remap-path-prefix={path}={name}" for path, name in names.items())


def moment() -> int:
    """The date of everything in the release, in seconds since 1970: that of the FMUs."""
    given = os.environ.get("SOURCE_DATE_EPOCH")
    if given is not None:
        return int(given)
    source = (PROJECT / "fmu-build" / "src" / "project.rs").read_text(encoding="utf-8")
    date = re.search(r'RELEASED: &str = "([\d-]+)T([\d:]+)Z"', source)
    return int(calendar.timegm(time.strptime(f"{date[1]} {date[2]}", "%Y-%m-%d %H:%M:%S")))


@dataclass
class Release:
    """A release in the making."""

    folder: Path
    # Names of fmu-build for the platforms whose tools are here.
    platforms: list[str]
    # What could not be made, with the reason.
    missing: dict[str, str] = field(default_factory=dict)
    # What each file is, by its path in the folder.
    about: dict[str, str] = field(default_factory=dict)

    def add(self, path: str, content: bytes | Path, about: str) -> Path:
        """Writes a file and says what it is."""
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content if isinstance(content, bytes) else content.read_bytes())
        self.about[path] = about
        return file

    def archive(self, path: str, files: dict[str, bytes], about: str, programs: frozenset[str] = frozenset()) -> Path:
        """Writes files as one, in a folder of the archive's name; `programs` may be executed."""
        top = path.rsplit("/", 1)[-1].removesuffix(".zip").removesuffix(".tar.gz")
        pack = zipped if path.endswith(".zip") else tarred
        return self.add(path, pack({f"{top}/{name}": files[name] for name in sorted(files)}, programs), about)


def contents(folder: Path, pattern: str = "**/*") -> dict[str, bytes]:
    """All files below a folder, by their paths in it."""
    files = [path for path in sorted(folder.glob(pattern)) if path.is_file()]
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in files}


def may_run(name: str, programs: frozenset[str]) -> int:
    """The rights of a file in an archive."""
    return 0o755 if name.rsplit("/", 1)[-1] in programs else 0o644


def zipped(files: dict[str, bytes], programs: frozenset[str] = frozenset()) -> bytes:
    """A zip archive that depends on these files only."""
    memory = io.BytesIO()
    with zipfile.ZipFile(memory, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, time.gmtime(moment())[:6])
            entry.create_system, entry.external_attr = 3, (0o100000 | may_run(name, programs)) << 16
            # Archives of archives gain nothing.
            stored = name.endswith((".fmu", ".ssp"))
            entry.compress_type = zipfile.ZIP_STORED if stored else zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    return memory.getvalue()


def tarred(files: dict[str, bytes], programs: frozenset[str] = frozenset()) -> bytes:
    """A compressed tar archive that depends on these files only."""
    memory = io.BytesIO()
    with tarfile.open(fileobj=memory, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name, content in files.items():
            entry = tarfile.TarInfo(name)
            entry.size, entry.mtime, entry.mode = len(content), moment(), may_run(name, programs)
            archive.addfile(entry, io.BytesIO(content))
    return gzip.compress(memory.getvalue(), 9, mtime=0)
