"""What a release is made from: facts about the crates, papers that must agree with the version, archives that depend on
their contents only."""

import json
import re
import subprocess
import tarfile
import tomllib
import zipfile
from io import BytesIO

import pytest

from examples.fmpy.coupling import PROJECT
from release import checks, crates, index, made, making, papers
from release.making import Release

WORKSPACE = tomllib.loads((PROJECT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]
VERSION = WORKSPACE["package"]["version"]
# Those of crates.io that the crates may use.
CATEGORIES = {
    *("api-bindings", "command-line-utilities", "encoding", "mathematics", "parser-implementations"),
    *("science", "simulation", "visualization"),
}


@pytest.fixture(scope="module")
def packages() -> dict[str, dict]:
    """The crates that a registry would take."""
    command = ["cargo", "metadata", "--format-version", "1", "--no-deps", "--offline"]
    text = subprocess.run(command, cwd=PROJECT, check=True, capture_output=True, encoding="utf-8").stdout
    all_of_them = {package["name"]: package for package in json.loads(text)["packages"]}
    return {name: all_of_them[name] for name in crates.names()}


def test_crates_say_what_a_registry_shows(packages):
    wanted = {"stribeck", "stribeck-cli", "stribeck-ffi", "stribeck-fit", "stribeck-plot", "stribeck-solve"}
    assert wanted <= set(packages)
    for name, package in packages.items():
        assert package["publish"] == ["crates-io"], name
        assert len(package["description"]) > 20, name
        assert 1 <= len(package["keywords"]) <= 5, name
        assert all(re.fullmatch(r"[a-z][\w-]{0,19}", word) for word in package["keywords"]), name
        assert package["categories"], name
        assert set(package["categories"]) <= CATEGORIES, name
        assert package["metadata"]["docs"]["rs"] == {"all-features": True}, name
        assert package["license"] == WORKSPACE["package"]["license"], name
        folder = (PROJECT / package["manifest_path"]).parent
        assert (folder / package["readme"]).read_text(encoding="utf-8").startswith("# "), name


def test_crates_need_only_what_a_registry_has_or_takes(packages):
    for name, package in packages.items():
        for needed in package["dependencies"]:
            if needed.get("path") and needed["kind"] != "dev":
                assert needed["name"] in packages, f"{name} needs {needed['name']}"
                assert needed["req"] == f"^{VERSION}", f"{name} needs {needed['name']} {needed['req']}"


def test_crates_are_packed_with_their_papers_and_without_tests_of_others(packages):
    words = [word for name in packages for word in ("--package", name)]
    command = ["cargo", "package", "--list", "--allow-dirty", "--offline", *words]
    text = subprocess.run(command, cwd=PROJECT, check=True, capture_output=True, encoding="utf-8").stdout
    names = text.splitlines()
    for paper in ("README.md", "LICENSE-MIT", "LICENSE-APACHE", "Cargo.toml"):
        assert names.count(paper) == len(packages), paper
    assert names.count("src/lib.rs") + names.count("src/main.rs") == len(packages)
    assert not [name for name in names if name.endswith((".fmu", ".png", ".so"))]


def test_papers_name_this_version_and_its_date():
    date = re.search(r'RELEASED: &str = "([\d-]+)T', (PROJECT / "fmu-build/src/project.rs").read_text(encoding="utf-8"))
    citation = (PROJECT / "CITATION.cff").read_text(encoding="utf-8")
    assert f"\nversion: {VERSION}\n" in citation
    assert f'\ndate-released: "{date[1]}"\n' in citation
    meta = json.loads((PROJECT / "codemeta.json").read_text(encoding="utf-8"))
    assert (meta["version"], meta["datePublished"]) == (VERSION, date[1])
    named = [name.rsplit("/", 1)[-1] for name in meta["license"]]
    assert " OR ".join(named) == WORKSPACE["package"]["license"]
    assert re.search(r"^license:\n  - MIT\n  - Apache-2.0\n", citation, re.MULTILINE)


def test_notes_of_a_release_are_its_part_of_the_changelog():
    notes = papers.notes()
    assert notes.startswith(f"# Stribeck {VERSION}\n")
    assert "\n## " not in notes


FILES = {"b/text.txt": b"text\n" * 100, "a": b"\x00\x01", "stribeck": b"program"}


@pytest.fixture
def release(tmp_path) -> Release:
    return Release(tmp_path / "release", ["host"], {"everything for win64": "a linker"})


@pytest.mark.parametrize("ending", ["zip", "tar.gz"])
def test_archives_depend_on_their_contents_only(release, ending, monkeypatch):
    once = release.archive(f"x/kit-1.{ending}", FILES, "a kit", frozenset({"stribeck"})).read_bytes()
    monkeypatch.setattr(making.time, "time", lambda: 0.0)
    assert (
        release.archive(f"x/kit-1.{ending}", dict(reversed(FILES.items())), "", frozenset({"stribeck"})).read_bytes()
        == once
    )
    assert dict(made.within(f"kit-1.{ending}", once)) == {f"kit-1/{name}": FILES[name] for name in FILES}
    if ending == "zip":
        with zipfile.ZipFile(BytesIO(once)) as archive:
            rights = {entry.filename: entry.external_attr >> 16 & 0o777 for entry in archive.infolist()}
            dates = {entry.date_time[:3] for entry in archive.infolist()}
    else:
        with tarfile.open(fileobj=BytesIO(once)) as archive:
            rights = {entry.name: entry.mode for entry in archive}
            dates = {making.time.gmtime(entry.mtime)[:3] for entry in archive}
    assert rights == {"kit-1/a": 0o644, "kit-1/b/text.txt": 0o644, "kit-1/stribeck": 0o755}
    assert dates == {making.time.gmtime(making.moment())[:3]}


def test_the_list_names_every_file_and_what_is_missing(release):
    release.archive("x/kit-1.zip", FILES, "a kit <for C>")
    index.written(release)
    page = (release.folder / "index.html").read_text(encoding="utf-8")
    assert '<a href="x/kit-1.zip">kit-1.zip</a>' in page
    assert "a kit &lt;for C&gt;" in page
    assert "everything for win64: a linker" in page
    assert checks.sums(release.folder, release.folder) == "2 files"


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda folder: (folder / "x" / "kit-1.zip").write_bytes(b""), "another checksum"),
        (lambda folder: (folder / "x" / "kit-1.zip").unlink(), "a checksum or there"),
        (lambda folder: (folder / "more").write_bytes(b""), "a checksum or there"),
    ],
)
def test_files_that_differ_from_their_checksums_are_found(release, spoil, fault):
    release.archive("x/kit-1.zip", FILES, "a kit")
    index.written(release)
    spoil(release.folder)
    with pytest.raises(checks.Failed, match=fault):
        checks.sums(release.folder, release.folder)


@pytest.mark.parametrize("ending", ["zip", "tar.gz"])
def test_paths_of_the_build_machine_are_found_within_archives(release, ending):
    inner = making.zipped({"library.so": b"..." + str(PROJECT).encode() + b"/src/lib.rs"})
    release.archive(f"x/kit-1.{ending}", {"a.fmu": inner}, "a kit")
    with pytest.raises(checks.Failed, match=rf"kit-1.{ending}: library.so contains"):
        checks.places(release.folder, release.folder)
