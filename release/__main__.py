"""Writes a release and tests it: `python3 -m release`, as `python3 tasks.py release` does.

--only NAME ... makes some parts only; --unchecked leaves the tests out. By itself, after `python3 tasks.py setup`:

    .venv/bin/python -m release --only sdk program
"""

import argparse
import os
import shutil
import sys
from collections.abc import Callable
from pathlib import Path

from release import checks, crates, fmus, index, kit, page, papers, program, python_package
from release.making import FMU_BUILD, PROJECT, MissingTool, Release, run

PARTS: dict[str, list[Callable[[Release], None]]] = {
    "fmus": [fmus.binaries],
    "sources": [fmus.sources],
    "sdk": [kit.kits],
    "page": [page.written],
    "program": [program.programs],
    "wheels": [python_package.built],
    "sdist": [python_package.sources],
    "crates": [crates.packed],
    "papers": [papers.written, papers.components],
}

OUT = PROJECT / "dist" / "release"


def platforms() -> tuple[list[str], dict[str, str]]:
    """The platforms whose tools are here, and what the others lack. Where this machine's platform lacks the tools for
    older systems, it is built as it is."""
    ready, lacks = [], {}
    for line in run(*FMU_BUILD, "platforms").splitlines():
        if line.endswith(": all tools are here"):
            ready.append(line.partition(":")[0])
        elif line.startswith("skipped: "):
            name, _, why = line.removeprefix("skipped: ").partition(", which lacks ")
            # The list of a release names no folder of this machine.
            lacks.setdefault(f"everything for {name}", []).append(why.replace(f"{PROJECT}{os.sep}", ""))
    own = "linux64" if sys.platform == "linux" else "host"
    if own not in ready:
        ready.insert(0, "host")
    return ready, {name: "; ".join(tools) for name, tools in lacks.items()}


def emptied(folder: Path) -> Path:
    """The folder of a release, without what an earlier one has left in it. What looks like no release is kept."""
    if folder.exists():
        is_release = folder.resolve() == OUT.resolve() or (folder / "SHA256SUMS").is_file()
        if not folder.is_dir() or (any(folder.iterdir()) and not is_release):
            sys.exit(f"{folder} is there, and no release: it has no SHA256SUMS; name another folder, or remove it")
        shutil.rmtree(folder)
    return folder


def main() -> int:
    parser = argparse.ArgumentParser(prog="python3 -m release", description=__doc__)
    parser.add_argument("--only", nargs="+", choices=PARTS, default=list(PARTS), help="parts to make")
    parser.add_argument("--out", type=Path, default=OUT, help="folder of the release, written anew")
    parser.add_argument("--unchecked", action="store_true", help="do not test the release")
    asked = parser.parse_args()
    release = Release(emptied(asked.out), *platforms())
    release.missing |= {name: "left out by --only" for name in PARTS if name not in asked.only}
    for name in (name for name in PARTS if name in asked.only):
        for part in PARTS[name]:
            try:
                part(release)
            except MissingTool as lack:
                release.missing[name] = str(lack)
    index.written(release)
    print(f"\nfigure: {len(release.about)} files in {release.folder}, for {', '.join(release.platforms)}")
    for name, why in sorted(release.missing.items()):
        print(f"figure: MISSING {name}: {why}")
    return 0 if asked.unchecked else checks.main(release)


if __name__ == "__main__":
    sys.exit(main())
