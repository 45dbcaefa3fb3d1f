#!/usr/bin/env python3
"""Takes packed FMUs apart for the wheel: what each has before and after the packed library, and the library once.

python3 python/fmus.py dist python/stribeck/fmus
"""

import struct
import sys
import zipfile
from pathlib import Path

# Fixed part of a local header in a ZIP archive; the lengths of the name and of the extra field are at its end.
HEADER = 30
LENGTHS = struct.Struct("<HH")


def parts(fmu: Path) -> tuple[bytes, bytes, bytes]:
    """Bytes before the packed library of an FMU, the library, and the bytes after it."""
    content = fmu.read_bytes()
    with zipfile.ZipFile(fmu) as archive:
        (entry,) = (one for one in archive.infolist() if one.filename.startswith("binaries/"))
    name, extra = LENGTHS.unpack_from(content, entry.header_offset + HEADER - LENGTHS.size)
    begin = entry.header_offset + HEADER + name + extra
    end = begin + entry.compress_size
    return content[:begin], content[begin:end], content[end:]


def main(source: Path, target: Path) -> None:
    """Writes the parts of all FMUs in a folder to another one."""
    libraries = set()
    for old in [*target.glob("*.head"), *target.glob("*.tail"), target / "library"]:
        old.unlink(missing_ok=True)
    for fmu in sorted(source.glob("*.fmu")):
        head, library, tail = parts(fmu)
        libraries.add(library)
        (target / f"{fmu.stem}.head").write_bytes(head)
        (target / f"{fmu.stem}.tail").write_bytes(tail)
    if len(libraries) != 1:
        sys.exit(f"{source}: {len(libraries)} libraries instead of one")
    (target / "library").write_bytes(libraries.pop())


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
