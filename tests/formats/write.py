"""Writes measurements as MDF 4 and MAT 5 with asammdf and scipy, and what these programs read back as tables; of the
files with which scipy tests itself, written by MATLAB 4 to 8, what scipy reads.

python tests/formats/write.py FOLDER
"""

import re
import shutil
import sys
import zlib
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import scipy.io
from asammdf import MDF, Signal
from scipy.io.matlab import MatlabFunction, MatlabObject, MatlabOpaque, MatReadError

FOLDER = Path(sys.argv[1])


def table(name: str, columns: list[tuple[str, np.ndarray]]) -> None:
    """Columns under their headings; repr of a float is read back with the same bits."""
    longest = max(len(values) for _, values in columns)
    rows = [
        ",".join(repr(float(values[row])) if row < len(values) else "" for _, values in columns)
        for row in range(longest)
    ]
    heading = ",".join(name for name, _ in columns)
    (FOLDER / name).write_text("\n".join([heading, *rows]) + "\n", encoding="utf-8")


def mdf(name: str, compression: int) -> None:
    """Two groups with clocks of their own: integers with a linear conversion, floats of both sizes, a text."""
    random = np.random.default_rng(1)
    force_time = np.arange(2000) * 1e-3
    camera_time = np.arange(210) * 1e-2 - 0.05
    conversion = {"a": 0.25, "b": -1000.0}
    force = [
        Signal(
            random.integers(0, 8000, 2000).astype(np.int16), force_time, name="Kraft", unit="N", conversion=conversion
        ),
        Signal(random.normal(20.0, 0.1, 2000), force_time, name="normal_force", unit="kN"),
        Signal(random.normal(20.0, 0.1, 2000).astype(np.float32), force_time, name="temperature", unit="degC"),
        Signal(np.array([b"on", b"off"] * 1000), force_time, name="state", encoding="utf-8"),
    ]
    camera = [Signal(random.normal(0.0, 1.0, 210), camera_time, name="displacement", unit="mm")]
    with MDF(version="4.10") as file:
        file.append(force)
        file.append(camera)
        file.save(FOLDER / name, overwrite=True, compression=compression)
    with MDF(FOLDER / name) as file:
        for group, signals in enumerate((force, camera)):
            read = [file.get(signal.name) for signal in signals if signal.name != "state"]
            columns = [("time", read[0].timestamps), *((signal.name, signal.samples) for signal in read)]
            table(f"{name}-{group}.csv", columns)


def mat(name: str, compressed: bool) -> None:
    """Vectors of several types and directions; what is not a vector is left out by the reader."""
    random = np.random.default_rng(2)
    columns = {
        "time": np.arange(500) * 1e-3,
        "force": random.normal(0.0, 3.0, 500),
        "counts": random.integers(-5, 5, 500).astype(np.int16),
        "single": random.normal(0.0, 3.0, 500).astype(np.float32),
        "short": random.normal(0.0, 3.0, 100),
        "switch": random.integers(0, 2, 500).astype(np.uint8),
    }
    others = {"matrix": random.normal(0.0, 1.0, (3, 4)), "text": "rig", "scalar": 3.0, "rig": {"mass": 2.0}}
    columns["force"] = columns["force"].reshape(-1, 1)
    scipy.io.savemat(FOLDER / name, {**columns, **others}, do_compression=compressed)
    read = scipy.io.loadmat(FOLDER / name)
    table(f"{name}-0.csv", [(key, read[key].ravel()) for key in columns])


def vectors(name: str, path: str, value: np.ndarray) -> Iterator[tuple[str, str, np.ndarray]]:
    """The real vectors in a value, with their names and places; elements are counted from 1."""
    if isinstance(value, (MatlabOpaque, MatlabFunction, MatlabObject)) or not isinstance(value, np.ndarray):
        return
    elements = list(enumerate(value.ravel(order="F"), start=1))
    if value.dtype.names:
        for number, element in elements:
            at = "" if len(elements) == 1 else f"({number})"
            for field in value.dtype.names:
                # scipy numbers fields of the same name.
                plain = re.sub(r"^_\d+_", "", field)
                yield from vectors(plain, f"{path}{at}.{plain}", element[field])
    elif value.dtype == object:
        for number, element in elements:
            yield from vectors(f"{name}{{{number}}}", f"{path}{{{number}}}", element)
    elif value.dtype.kind in "buif" and value.size == max(value.shape) > 1:
        yield name, path, value.ravel().astype(float)


def of_matlab(file: Path, folder: Path) -> None:
    """What scipy reads from a file of MATLAB; an empty table if nothing."""
    shutil.copy(file, folder)
    try:
        read = scipy.io.loadmat(file)
    except (ValueError, TypeError, NotImplementedError, zlib.error, MatReadError) as error:
        print(f"{file.name}: scipy: {error}")
        read = {}
    found = [one for name, value in read.items() if not name.startswith("__") for one in vectors(name, name, value)]
    counts = Counter(name.lower() for name, _, _ in found)
    columns = [(name if counts[name.lower()] == 1 else path, values) for name, path, values in found]
    if columns:
        table(f"{folder.name}/{file.name}-0.csv", columns)


FOLDER.mkdir(parents=True, exist_ok=True)
for number, compression in enumerate((0, 1, 2)):
    mdf(f"rig{number}.mf4", compression)
for number, compressed in enumerate((False, True)):
    mat(f"rig{number}.mat", compressed)
matlab = FOLDER / "matlab"
shutil.rmtree(matlab, ignore_errors=True)
matlab.mkdir()
for file in sorted((Path(scipy.io.__file__).parent / "matlab" / "tests" / "data").glob("*.mat")):
    of_matlab(file, matlab)
