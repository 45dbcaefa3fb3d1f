#!/usr/bin/env python3
"""Writes the documentation site into dist/site/, from the pages, docstrings and comments that exist.

    python3 docs/site/build.py FMU_BUILD     the program fmu-build, which writes the pages of the models

`python3 tasks.py site` builds what this needs, and runs it. Sphinx reads copies of all pages in out/site, which lie
there as they do in the project, so that their links hold; a file of the project to which a page links can be
downloaded. A link to something that does not exist is an error.
"""

import html
import inspect
import re
import shutil
import subprocess
import sys
from pathlib import Path

import stribeck

ROOT = Path(__file__).resolve().parents[2]
HERE = ROOT / "docs" / "site"
SOURCE = ROOT / "out" / "site"
STATIC = ROOT / "out" / "site-static"
MODELS = ROOT / "out" / "site-models"
SITE = ROOT / "dist" / "site"
PAGES = ["*.md", "docs/*.md", "examples/*/README.md"]
LINK = re.compile(r"\]\(([^)#:\s]+)(?:#[^)]*)?\)")
# A comment on what follows it.
COMMENT = r"/\*\*((?:(?!\*/)[\s\S])*)\*/\s*"
# Selectors of the pages of models that the site's theme has rules for.
OF_THEME = re.compile(r"^(:root|body|header|h\d|a|footer|@media)")


def gather() -> None:
    """Copies all pages, and the files to which they link."""
    for page in [page for pattern in PAGES for page in sorted(ROOT.glob(pattern))]:
        copy(page)
        for target in LINK.findall(page.read_text(encoding="utf-8")):
            path = (page.parent / target).resolve()
            if path.is_file() and path.suffix != ".md":
                copy(path)
    shutil.copyfile(HERE / "index.md", SOURCE / "index.md")


def copy(path: Path) -> None:
    place = SOURCE / path.relative_to(ROOT)
    place.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(path, place)


def raw(text: str) -> str:
    """HTML within a page."""
    return f'```{{raw}} html\n<div class="model">\n{text.strip()}\n</div>\n```\n'


def page_of_model(name: str, summary: str, text: str, live: bool) -> str:
    """The page of a model for the site: that of its FMU, with headings that the site knows."""
    main = re.search(r"<main>\n(.*)</main>", text, re.DOTALL)[1]
    first, *others = re.split(r"<h2>(.*?)</h2>\n?", main)
    parts = [f"# {name}\n", f"{summary}.\n", raw(first)]
    if live:
        address = f"../page.html#v=1&amp;view=law&amp;law={name}"
        frame = f'<iframe title="{name} in the page" loading="lazy" src="{address}"></iframe>'
        parts.append(raw(f'<details class="live"><summary>Change its parameters</summary>{frame}</details>'))
    for title, content in zip(others[::2], others[1::2], strict=True):
        parts += [f"## {html.unescape(re.sub(r'<.*?>', '', title))}\n", raw(content)]
    return "\n".join(parts)


def write_models(program: str) -> None:
    """A page for each model, and the list of them by family."""
    subprocess.run([program, "pages", "--out", MODELS], check=True, stdout=subprocess.DEVNULL)
    page = ROOT / "dist" / "page.html"
    laws = {law.name for law in stribeck.laws()}
    families: dict[str, list[str]] = {}
    for model in stribeck.models():
        text = (MODELS / model.name / "documentation" / "index.html").read_text(encoding="utf-8")
        live = page.is_file() and model.name in laws
        write(f"models/{model.name}.md", page_of_model(model.name, model.summary, text, live))
        families.setdefault(model.family, []).append(model.name)
    lists = ["# Pages of the models\n", "Equations, curves, variables, presets, limits and sources of each model.\n"]
    for family, names in families.items():
        entries = "\n".join(f"models/{name}" for name in names)
        lists.append(f"```{{toctree}}\n:caption: {family}\n:maxdepth: 1\n\n{entries}\n```\n")
    write("laws.md", "\n".join(lists))


def model_css() -> str:
    """The rules for equations and diagrams of the pages in FMUs, for the same parts of the site's pages."""
    style = (ROOT / "fmu-build/src/page/style.css").read_text(encoding="utf-8")
    rules = re.findall(r"^([^\s@}][^{]*)(\{[^}]*\})", style, re.MULTILINE)
    kept = [(selector, body) for selector, body in rules if not OF_THEME.match(selector)]
    return "".join(
        f"{', '.join(f'.model {one.strip()}' for one in selector.split(','))} {body}\n" for selector, body in kept
    )


def write_python() -> None:
    """What the package exports, from its docstrings."""
    kinds: dict[str, list[str]] = {"function": [], "class": [], "exception": []}
    for name in stribeck.__all__:
        item = getattr(stribeck, name)
        if inspect.isclass(item):
            kind = "exception" if issubclass(item, Exception) else "class"
        elif callable(item):
            kind = "function"
        else:
            continue
        kinds[kind].append(name)
    lines = [*heading("Python API", "="), ".. automodule:: stribeck", "   :no-members:", ""]
    plural = {"function": "Functions", "class": "Classes", "exception": "Exceptions"}
    for kind, names in kinds.items():
        lines += heading(plural[kind], "-")
        for name in names:
            lines += [f".. auto{kind}:: stribeck.{name}"]
            lines += [] if kind == "function" else ["   :members:"]
            lines += [""]
    write("python_api.rst", "\n".join(lines))


def write_c() -> None:
    """Types and functions of the header, from their comments. The variables of the models are on their pages."""
    header = (ROOT / "include/stribeck.h").read_text(encoding="utf-8")
    lines = [*heading("C API", "="), *opening(header), *heading("Types", "-")]
    opaque = rf"{COMMENT}typedef struct (stribeck_\w+) stribeck_\w+;"
    for comment, name in re.findall(opaque, header):
        lines += [f".. c:struct:: {name}", "", *told(comment), ""]
    for comment, kind, body, name in re.findall(
        rf"{COMMENT}typedef (enum|struct) {{([^}}]*)}} (stribeck_\w+);", header
    ):
        lines += [f".. c:{kind}:: {name}", "", *told(comment), ""]
        role = {"enum": "enumerator", "struct": "member"}[kind]
        for inner, member in re.findall(rf"{COMMENT}\s*([^,;=/]*)[^,;/]*[,;]", body):
            lines += [f"   .. c:{role}:: {member.strip()}", "", *told(inner, "      "), ""]
    lines += heading("Functions", "-")
    for comment, declared in re.findall(rf"{COMMENT}([a-z][^;{{}}/#]*?\bstribeck_\w+\([^;]*?\));", header):
        lines += [f".. c:function:: {' '.join(declared.split())}", "", *told(comment), ""]
    write("c_api.rst", "\n".join(lines))


def opening(header: str) -> list[str]:
    """The first comment of the header: paragraphs, of which some begin with a word on a margin, and an example."""
    text = re.sub(r"^ \* ?", "", re.match(r"/\*(.*?)\*/", header, re.DOTALL)[1], flags=re.MULTILINE)
    prose, example = text.split("Example, without status checks:\n")
    prose = re.sub(r"^(\w+) {2,}", r"\n**\1**: ", prose.replace("_", r"\_"), flags=re.MULTILINE)
    return [
        *map(str.strip, prose.split("\n")),
        "An example, without status checks:",
        "",
        ".. code-block:: c",
        *example.split("\n"),
    ]


def told(comment: str, indent: str = "   ") -> list[str]:
    """The lines of a comment, indented."""
    return [f"{indent}{re.sub(r'^ *[*] ?', '', line).strip()}" for line in comment.strip().split("\n")]


def heading(text: str, line: str) -> list[str]:
    return [text, line * len(text), ""]


def write(name: str, text: str) -> None:
    path = SOURCE / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


# What the theme leaves to be said to a reader who listens, or uses a keyboard.
ACCESSIBLE = {
    '<p class="caption" role="heading">': '<p class="caption" role="heading" aria-level="2">',
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="Pages">',
    '<aside class="toc-drawer': '<aside aria-label="This page" class="toc-drawer',
    "<pre>": '<pre tabindex="0">',
    '<div class="wide">': '<div class="wide" tabindex="0">',
    '<div class="table-wrapper': '<div tabindex="0" class="table-wrapper',
    '<th class="head"><p></p></th>': "<td></td>",
}


def make_accessible() -> None:
    """Labels, levels of headings, and a place in the order of the keyboard for what scrolls by itself."""
    for path in SITE.rglob("*.html"):
        text = path.read_text(encoding="utf-8")
        for before, after in ACCESSIBLE.items():
            text = text.replace(before, after)
        path.write_text(text, encoding="utf-8")


def main() -> None:
    for folder in (SOURCE, STATIC, MODELS, SITE):
        shutil.rmtree(folder, ignore_errors=True)
    SOURCE.mkdir(parents=True)
    STATIC.mkdir(parents=True)
    gather()
    write_models(sys.argv[1])
    (STATIC / "model.css").write_text(model_css(), encoding="utf-8")
    write_python()
    write_c()
    sphinx = [sys.executable, "-m", "sphinx", "--fail-on-warning", "--keep-going", "--quiet", "-c", HERE, SOURCE, SITE]
    subprocess.run(sphinx, check=True)
    make_accessible()
    page = ROOT / "dist" / "page.html"
    if page.is_file():
        shutil.copyfile(page, SITE / "page.html")
    count = len(list(SITE.rglob("*.html")))
    print(f"{SITE.relative_to(ROOT) / 'index.html'}: {count} pages; opens from a disk or a server")


if __name__ == "__main__":
    main()
