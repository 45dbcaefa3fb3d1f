"""FMUs of all models.

They hold the same library and the same licences: the wheel has their packed bytes once, and for each model the rest.
"""

from __future__ import annotations

import os
import sys
import tempfile
from importlib.resources import files
from pathlib import Path

from stribeck._stribeck import Refused, __version__
from stribeck.catalogue import Description, model


def fmu(name: str | Description, folder: str | os.PathLike[str] | None = None) -> Path:
    """Path of the FMU of a model: FMI 2.0, co-simulation and, if the model has it, Model Exchange.

    The file is written to `folder`, or to the user's cache (`STRIBECK_CACHE` if it is set), if it is not there. It has
    the same bytes as the one that `fmu-build pack` writes. Any number of processes may ask for it at once.
    """
    described = model(name)
    content = _content(described.name)
    folder = _cache() if folder is None else Path(folder)
    path = folder / f"{described.name}.fmu"
    if path.is_file() and path.read_bytes() == content:
        return path
    folder.mkdir(parents=True, exist_ok=True)
    # Written under another name first: whoever looks meanwhile never sees half a file.
    handle, temporary = tempfile.mkstemp(dir=folder, prefix=f".{described.name}-", suffix=".fmu")
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        Path(temporary).replace(path)
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise
    return path


def _content(name: str) -> bytes:
    here = files("stribeck.fmus")
    if not here.joinpath(f"{name}.0").is_file():
        raise Refused(f"this build of the package has no FMU of {name}")
    content = [here.joinpath(f"{name}.0").read_bytes()]
    for number, shared in enumerate(here.joinpath("order").read_text(encoding="utf-8").split(), 1):
        content += [here.joinpath(part).read_bytes() for part in (shared, f"{name}.{number}")]
    return b"".join(content)


def _cache() -> Path:
    if chosen := os.environ.get("STRIBECK_CACHE"):
        return Path(chosen)
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return base / "stribeck" / __version__
