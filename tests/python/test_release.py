"""What a release is made from: facts about the crates, papers that must agree with the version, archives that depend on
their contents only."""

import json
import os
import re
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from io import BytesIO
from pathlib import Path
from types import SimpleNamespace

import pytest

import tasks
from examples.fmpy.coupling import PROJECT
from release import __main__ as command
from release import checks, crates, fmus, index, macos, made, making, papers, program, python_package, wheels
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


def test_a_release_without_its_part_of_the_changelog_is_an_error(monkeypatch):
    monkeypatch.setattr(papers, "VERSION", "9.9.9")
    with pytest.raises(SystemExit, match=r"no section 9\.9\.9"):
        papers.notes()


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


def test_a_file_that_is_named_like_a_folder_of_this_machine_is_not_in_it(monkeypatch, release):
    monkeypatch.setattr(making, "PROJECT", Path("/projects"))
    release.add("x/program", b"/crates/solver-1.0.0/src/projects.rs", "a program")
    checks.places(release.folder, release.folder)
    release.add("x/program", b"/projects/src/lib.rs", "a program")
    with pytest.raises(checks.Failed, match="program contains /projects/"):
        checks.places(release.folder, release.folder)


def test_missing_tools_are_all_named_and_without_a_folder_of_this_machine(monkeypatch):
    cure = f"Zig as linker: {PROJECT}{os.sep}.venv/bin/python -m pip install cargo-zigbuild ziglang"
    lines = [
        "linux64: all tools are here",
        "skipped: aarch64-linux, which lacks Rust's standard library for it: rustup target add aarch64",
        f"skipped: aarch64-linux, which lacks {cure}",
    ]
    monkeypatch.setattr(command, "run", lambda *_: "\n".join(lines))
    _, missing = command.platforms()
    told = missing["everything for aarch64-linux"]
    assert "rustup target add aarch64; Zig as linker: .venv/bin/python -m pip install" in told
    monkeypatch.setattr(program, "has_rust_for", lambda _: True)
    monkeypatch.setattr(program, "find_spec", lambda _: None)
    assert str(PROJECT) not in told + program.lacking("x86_64-unknown-linux-musl")


def test_a_folder_that_is_no_release_is_kept(release, tmp_path):
    release.add("x/a", b"a", "a file")
    with pytest.raises(SystemExit, match="no release: it has no SHA256SUMS"):
        command.emptied(release.folder)
    assert (release.folder / "x" / "a").read_bytes() == b"a"
    index.written(release)
    assert not command.emptied(release.folder).exists()
    with pytest.raises(SystemExit, match="no release"):
        command.emptied(release.add("x/a", b"a", "a file"))
    (tmp_path / "empty").mkdir()
    command.emptied(tmp_path / "empty")
    command.emptied(tmp_path / "absent")


def test_c_sources_are_fmus_of_both_versions(release, tmp_path, monkeypatch):
    """The commands of fmu-build write one file for each of those that they write."""

    def run(*words):
        folder = words[-1]
        for name in ("LuGre.fmu", "fmi3/LuGre.fmu") if "pack" in words else ("lugre.c",):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_bytes(name.encode())

    monkeypatch.setattr(fmus, "run", run)
    monkeypatch.setattr(fmus, "has_rust_for", lambda _: True)
    monkeypatch.setattr(fmus, "STAGE", tmp_path / "stage")
    fmus.sources(release)
    assert (release.folder / "fmi2-sources" / "LuGre.fmu").read_bytes() == b"LuGre.fmu"
    assert (release.folder / "fmi3-sources" / "LuGre.fmu").read_bytes() == b"fmi3/LuGre.fmu"
    with pytest.raises(checks.Failed, match="the archive has 1 sources"):
        checks.c_sources(release.folder, tmp_path)


def test_the_page_about_releases_names_every_folder_of_fmus():
    page = (PROJECT / "docs" / "release.md").read_text(encoding="utf-8")
    for kind in (*fmus.KINDS, *fmus.KINDS_OF_SOURCES):
        assert f"`{kind}`" in page, kind


def test_the_linker_gets_the_functions_of_macos(monkeypatch, tmp_path):
    listed = """--- !tapi-tbd
targets:         [ x86_64-macos, x86_64-maccatalyst, arm64e-macos,
                   arm64e.x1-macos ]
exports:
  - targets:         [ arm64e-macos, arm64e-maccatalyst ]
    symbols:         [ _free, _malloc ]
  - targets:         [ arm64e.x1-maccatalyst ]
    symbols:         [ _exp ]
"""
    zig = tmp_path / "zig"
    (zig / "lib" / "libc" / "darwin").mkdir(parents=True)
    (zig / "lib" / "libc" / "darwin" / "libSystem.tbd").write_text(listed, encoding="utf-8")
    monkeypatch.setattr(macos, "find_spec", lambda _: SimpleNamespace(submodule_search_locations=[str(zig)]))
    settings = macos.sdk(tmp_path / "sdk")
    assert settings == {"SDKROOT": str(tmp_path / "sdk"), "MACOSX_DEPLOYMENT_TARGET": "11.0"}
    for name in ("libSystem", "libc", "libm"):
        text = (tmp_path / "sdk" / "usr" / "lib" / f"{name}.tbd").read_text(encoding="utf-8")
        assert [line for line in text.splitlines() if "targets" in line] == [
            "targets:         [ x86_64-macos, arm64-macos ]",
            "  - targets:         [ arm64-macos ]",
            "  - targets:         [  ]",
        ]
        assert "[ _free, _malloc ]" in text


def test_components_are_those_of_all_targets(monkeypatch):
    monkeypatch.setattr(program, "lacking", lambda target: "a tool" if "aarch64" in target else None)
    platforms = ["host", "linux64", "aarch64-linux", "win64", "darwin64"]
    library = {"", "x86_64-unknown-linux-gnu", "aarch64-unknown-linux-gnu", "x86_64-pc-windows-gnu"}
    library |= {"x86_64-apple-darwin", "aarch64-apple-darwin"}
    for package in ("libstribeck", "stribeck-python"):
        assert set(papers.targets(package, platforms)) == library
    of_programs = {"x86_64-unknown-linux-musl", "x86_64-pc-windows-gnu", "x86_64-apple-darwin"}
    assert set(papers.targets("stribeck-cli", platforms)) == of_programs
    assert papers.targets("stribeck-page", ["host"]) == ["wasm32-unknown-unknown"]


def test_licences_that_differ_between_targets_are_all_kept():
    files = {"": {"a": b"1", "b": b"1"}, "windows": {"a": b"1", "b": b"2", "c": b"3"}}
    assert papers.joined(files) == {"a": b"1", "host/b": b"1", "windows/b": b"2", "c": b"3"}


def test_parts_of_fmus_do_not_stay_in_the_package(tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr(wheels, "run", lambda *words, **_: asked.append([str(word) for word in words]))

    def fail(*_):
        raise SystemExit("no linker")

    monkeypatch.setattr(wheels, "build", fail)
    with pytest.raises(SystemExit, match="no linker"):
        wheels.main(tmp_path, "win64")
    assert asked[-1][1:] == ["python/fmus.py", "python/stribeck/fmus"]
    for name in ("LuGre.0", "LuGre.1", "library", "licenses", "order", "__init__.py"):
        (tmp_path / name).touch()
    subprocess.run([sys.executable, *asked[-1][1:-1], tmp_path], cwd=PROJECT, check=True)
    assert [path.name for path in tmp_path.iterdir()] == ["__init__.py"]


def test_the_tour_of_a_wheel_runs(capsys):
    exec(compile(checks.TOUR, "TOUR", "exec"), {})
    assert "LuGre.fmu" in capsys.readouterr().out


@pytest.mark.parametrize("library", [{}, {"licenses": []}])
def test_a_component_without_a_licence_is_found(release, tmp_path, library):
    listed = [{"type": "library", "name": "bare", **library}]
    text = json.dumps({"bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1, "components": listed})
    release.add("sbom.cdx.json", text.encode(), "a list")
    with pytest.raises(checks.Failed, match=r"without a licence: \['bare'\]"):
        checks.components(release.folder, tmp_path)


def test_a_wheel_that_cannot_be_installed_fails_its_check_only(release, tmp_path, monkeypatch):
    tag = {"linux": "manylinux_2_17_x86_64", "darwin": "macosx_11_0_arm64"}.get(sys.platform, "win_amd64")
    release.add(f"python/stribeck-1-py3-none-{tag}.whl", b"no archive", "a wheel")
    monkeypatch.setattr(checks, "environment", lambda _: sys.executable)
    with pytest.raises(checks.Failed, match="pip"):
        checks.wheel(release.folder, tmp_path)


def test_packed_sources_name_no_bench_that_is_not_packed():
    manifest = (PROJECT / "Cargo.toml").read_text(encoding="utf-8")
    whole, kept = tomllib.loads(manifest), tomllib.loads(python_package.BENCH.sub("", manifest))
    assert whole.pop("bench")
    assert kept == whole


def test_tasks_install_what_the_programs_of_all_platforms_are_built_for() -> None:
    built = {target for kind in program.KINDS.values() for target in kind}
    assert built <= set(tasks.TARGETS)
