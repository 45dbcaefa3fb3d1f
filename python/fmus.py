#!/usr/bin/env python3
"""Takes packed FMUs apart for the wheel: what they share once, and what each has between that.

python3 python/fmus.py dist python/stribeck/fmus
python3 python/fmus.py python/stribeck/fmus         removes what the first command has written
"""

import struct
import sys
import zipfile
from pathlib import Path

# Fixed part of a local header in a ZIP archive; the lengths of the name and of the extra field are at its end.
HEADER = 30
LENGTHS = struct.Struct("<HH")


def parts(fmu: Path) -> list[tuple[str, bytes]]:
    """Name and bytes of each part of an FMU, from its beginning to its end: `library`, the packed library, twice for
    Linux on ARM; `licenses`, all of them; and, without a name, what is around these."""
    content = fmu.read_bytes()
    found, end = [], 0

    def add(name: str, begin: int, after: int) -> None:
        nonlocal end
        found.extend([("", content[end:begin]), (name, content[begin:after])])
        end = after

    with zipfile.ZipFile(fmu) as archive:
        entries = archive.infolist()
    licenses = []
    for entry in entries:
        name, extra = LENGTHS.unpack_from(content, entry.header_offset + HEADER - LENGTHS.size)
        begin = entry.header_offset + HEADER + name + extra
        if entry.filename.startswith("binaries/"):
            add("library", begin, begin + entry.compress_size)
        if entry.filename.startswith("documentation/licenses/"):
            licenses += [entry.header_offset, begin + entry.compress_size]
    add("licenses", licenses[0], licenses[-1])
    return [*found, ("", content[end:])]


def clear(target: Path) -> None:
    """Removes the parts in a folder."""
    for old in target.iterdir():
        if old.suffix.removeprefix(".").isdigit() or old.name in ("library", "licenses", "order"):
            old.unlink()


def main(source: Path, target: Path) -> None:
    """Writes the parts of all FMUs in a folder to another one: those of one FMU as `LuGre.0`, `LuGre.1` and so on, the
    shared ones under their names, and in `order` these names, one between each two of the former."""
    shared, orders = {}, set()
    clear(target)
    for fmu in sorted(source.glob("*.fmu")):
        found = parts(fmu)
        for number, (_, part) in enumerate(found[::2]):
            (target / f"{fmu.stem}.{number}").write_bytes(part)
        orders.add(" ".join(name for name, _ in found[1::2]))
        for name, part in found[1::2]:
            if shared.setdefault(name, part) != part:
                sys.exit(f"{fmu}: another {name} than that of the FMUs before; pack all of them, and for one platform")
    for name, part in shared.items():
        (target / name).write_bytes(part)
    if len(orders) != 1:
        sys.exit(f"{source}: no FMUs, or of different kinds")
    (target / "order").write_text(orders.pop(), encoding="utf-8")


if __name__ == "__main__":
    folders = [Path(word) for word in sys.argv[1:]]
    if len(folders) == 1:
        clear(*folders)
    else:
        main(*folders)
