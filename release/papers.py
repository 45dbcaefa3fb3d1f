"""What goes with a release: notes, licences, how to cite it, its components."""

import hashlib
import json
import re
import shutil

from release.making import FMU_BUILD, PROJECT, STAGE, VERSION, MissingTool, Release, contents, run

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
        raise MissingTool(f"CHANGELOG.md has no section {VERSION}, or several")
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


def components(release: Release) -> None:
    """Licences of everything that is linked into something, and a list of all components and files."""
    found = {}
    for package in PACKAGES:
        folder = STAGE / "components"
        shutil.rmtree(folder, ignore_errors=True)
        run(*FMU_BUILD, "components", package, "--out", folder)
        for name, content in contents(folder, "licenses/*").items():
            release.add(f"licenses/{package}/{name.split('/')[1]}", content, f"licences of the {PACKAGES[package]}")
        listed = json.loads((folder / "sbom.cdx.json").read_text(encoding="utf-8"))["components"]
        found |= {component["bom-ref"]: component for component in listed}
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
