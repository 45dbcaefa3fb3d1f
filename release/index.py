"""The page that lists a release, and its checksums."""

import hashlib
from html import escape

from release.making import VERSION, Release

STYLE = """body { font: 1rem/1.5 sans-serif; margin: 2rem auto; max-width: 60rem; padding: 0 1rem }
table { border-collapse: collapse; width: 100% } td { border-top: 1px solid #ccc; padding: 0.2rem 0.6rem 0.2rem 0 }
td:nth-child(2) { text-align: right; white-space: nowrap } td:first-child { overflow-wrap: anywhere }
@media (prefers-color-scheme: dark) { body { background: #111; color: #eee } a { color: #9cf } }"""
# Folders of many files are folded up: each of these files is also in an archive.
LONGEST_OPEN = 12


def size(count: int) -> str:
    """A number of bytes for people."""
    return f"{count / 1e6:.1f} MB" if count >= 1e5 else f"{count / 1e3:.1f} kB"


def row(release: Release, path: str) -> str:
    """The line of a file."""
    link = f'<a href="{escape(path)}">{escape(path.rsplit("/", 1)[-1])}</a>'
    bytes_of = size((release.folder / path).stat().st_size)
    return f"<tr><td>{link}</td><td>{bytes_of}</td><td>{escape(release.about[path])}</td></tr>"


def section(release: Release, folder: str, paths: list[str]) -> str:
    """The files of a folder."""
    table = "<table>\n" + "\n".join(row(release, path) for path in paths) + "\n</table>"
    title = escape(folder or f"Stribeck {VERSION}")
    if len(paths) > LONGEST_OPEN:
        return f"<details><summary><b>{title}</b>, {len(paths)} files</summary>\n{table}\n</details>"
    return table if not folder else f"<h2>{title}</h2>\n{table}"


def html(release: Release) -> str:
    """The page."""
    folders: dict[str, list[str]] = {}
    for path in sorted(release.about):
        folders.setdefault(path.rpartition("/")[0], []).append(path)
    sections = "\n".join(section(release, folder, folders[folder]) for folder in sorted(folders))
    lacking = [f"<li>{escape(name)}: {escape(why)}</li>" for name, why in sorted(release.missing.items())]
    missing = f"<h2>Missing here</h2>\n<p>Not made:</p>\n<ul>{''.join(lacking)}</ul>" if lacking else ""
    return f"""<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Stribeck {VERSION}</title>
<style>
{STYLE}
</style>
<h1>Stribeck {VERSION}</h1>
<p>Friction force models and a telescopic shock absorber. <a href="SHA256SUMS">SHA256SUMS</a> has the checksums of all
files: <code>sha256sum --check SHA256SUMS</code></p>
{sections}
{missing}
</html>
"""


def written(release: Release) -> None:
    """Writes page and checksums."""
    release.add("index.html", html(release).encode(), "this list")
    sums = (
        f"{hashlib.sha256((release.folder / path).read_bytes()).hexdigest()}  {path}\n"
        for path in sorted(release.about)
    )
    (release.folder / "SHA256SUMS").write_text("".join(sums), encoding="utf-8", newline="\n")
