"""What goes with a release: notes, licences, how to cite it, its components."""

import hashlib
import json
import re
import shutil
import sys

from release import fmus, program, wheels
from release.making import FMU_BUILD, PROJECT, STAGE, VERSION, Release, contents, run

# Packages whose crates are in something that is released, and what that is.
PACKAGES = {
    "libstribeck": "library for C, library in the FMUs",
    "stribeck-cli": "program",
    "stribeck-python": "Python package",
    "stribeck-page": "page",
}
# Packages of npm that are in the page; build.mjs writes their licences into it.
OF_PAGE = ("uplot", "fzstd")


def notes() -> str:
    """The part of the changelog about this version."""
    text = (PROJECT / "CHANGELOG.md").read_text(encoding="utf-8")
    parts = re.split(r"^## ", text, flags=re.MULTILINE)
    found = [part for part in parts if part.split("\n", 1)[0].split()[:1] == [VERSION]]
    if len(found) != 1:
        sys.exit(f"CHANGELOG.md has no section {VERSION}, or several")
    return f"# Stribeck {found[0].rstrip()}\n"


def written(release: Release) -> None:
    """Writes the papers that need no tool."""
    release.add("RELEASE_NOTES.md", notes().encode(), "what is in this version, and what has changed")
    for name, about in {
        "CITATION.cff": "how to cite Stribeck",
        "codemeta.json": "the same, and more, for programs (CodeMeta)",
        "LICENSE-MIT": "licence of Stribeck, at your option",
        "LICENSE-APACHE": "licence of Stribeck, at your option",
    }.items():
        release.add(name, PROJECT / name, about)


def of_npm(name: str) -> dict:
    """A package of npm as a component."""
    lock = json.loads((PROJECT / "web" / "package-lock.json").read_text(encoding="utf-8"))
    package = lock["packages"][f"node_modules/{name}"]
    return {
        "type": "library",
        "bom-ref": f"{name} {package['version']}",
        "name": name,
        "version": package["version"],
        "licenses": [{"expression": package["license"]}],
        "purl": f"pkg:npm/{name}@{package['version']}",
    }


def of_file(release: Release, path: str) -> dict:
    """A file of the release as a component."""
    content = (release.folder / path).read_bytes()
    hashed = {"alg": "SHA-256", "content": hashlib.sha256(content).hexdigest()}
    return {"type": "file", "bom-ref": path, "name": path, "description": release.about[path], "hashes": [hashed]}


def targets(package: str, platforms: list[str]) -> list[str]:
    """Rust's names of the targets that a package is built for; empty for this machine, built with its own tools."""
    if package == "stribeck-page":
        return [fmus.WASM]
    if package == "stribeck-cli":
        known = [target for platform in platforms for target in program.KINDS.get(platform, {})]
        return [target for target in dict.fromkeys(known) if program.lacking(target) is None]
    return list(dict.fromkeys(target for platform in platforms for target in wheels.PLATFORMS[platform][1]))


def joined(licences: dict[str, dict[str, bytes]]) -> dict[str, bytes]:
    """The files of several targets: once where all that have such a file agree, else in a folder of each target."""
    kinds: dict[str, set[bytes]] = {}
    for files in licences.values():
        for name, content in files.items():
            kinds.setdefault(name, set()).add(content)
    return {
        name if len(kinds[name]) == 1 else f"{target or 'host'}/{name}": content
        for target, files in licences.items()
        for name, content in files.items()
    }


def components(release: Release) -> None:
    """Licences of everything that is linked into something, and a list of all components and files."""
    found = {}
    for package, about in PACKAGES.items():
        licences = {}
        for target in targets(package, release.platforms):
            folder = STAGE / "components"
            shutil.rmtree(folder, ignore_errors=True)
            run(*FMU_BUILD, "components", package, *(["--target", target] if target else []), "--out", folder)
            licences[target] = contents(folder / "licenses")
            listed = json.loads((folder / "sbom.cdx.json").read_text(encoding="utf-8"))["components"]
            found |= {component["bom-ref"]: component for component in listed}
        for name, content in joined(licences).items():
            release.add(f"licenses/{package}/{name}", content, f"licences of the {about}")
    for name in OF_PAGE:
        component = of_npm(name)
        found[component["bom-ref"]] = component
    sbom = {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {
            "component": {"type": "application", "bom-ref": "release", "name": "stribeck", "version": VERSION}
        },
        "components": [found[name] for name in sorted(found)]
        + [of_file(release, path) for path in sorted(release.about)],
    }
    content = json.dumps(sbom, indent=2, ensure_ascii=False) + "\n"
    release.add("sbom.cdx.json", content.encode(), "all files of the release and all components in them, CycloneDX 1.5")
