"""The documentation site as a reader gets it: every link leads somewhere, nothing comes from elsewhere, and each model,
function of Python and function of C has its place."""

import json
import re
import shutil
import subprocess
from dataclasses import dataclass, field
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest
import stribeck

PROJECT = Path(__file__).resolve().parents[2]
SITE = PROJECT / "dist" / "site"
PAGES = sorted(SITE.rglob("*.html"))


@dataclass
class Page(HTMLParser):
    """Anchors of a page, its links, and what it loads."""

    anchors: set[str] = field(default_factory=set)
    links: list[str] = field(default_factory=list)
    loads: list[str] = field(default_factory=list)

    def __post_init__(self):
        super().__init__()

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name == "id":
                self.anchors.add(value)
            elif name == "href" and tag == "a":
                self.links.append(value)
            elif name in ("href", "src"):
                self.loads.append(value)


@cache
def parsed(path: Path) -> Page:
    page = Page()
    page.feed(path.read_text(encoding="utf-8"))
    return page


def test_every_link_leads_to_something_on_the_site():
    wrong, count = [], 0
    # The page for a browser has no links to the site.
    for path in PAGES:
        for link in parsed(path).links + parsed(path).loads:
            address = urlsplit(link)
            if address.scheme or not link:
                continue
            count += 1
            target = (path.parent / unquote(address.path)).resolve() if address.path else path
            if target.suffix == ".html" and address.fragment and target != SITE / "page.html":
                is_there = target.is_file() and unquote(address.fragment) in parsed(target).anchors
            else:
                is_there = target.is_file()
            if not is_there:
                wrong.append(f"{path.relative_to(SITE)}: {link}")
    assert not wrong, wrong[:10]
    assert count > 5000


def test_nothing_is_loaded_from_elsewhere():
    for path in PAGES:
        assert not [one for one in parsed(path).loads if urlsplit(one).scheme not in ("", "data")], path
    for style in SITE.rglob("*.css"):
        assert not re.search(r"url\(['\"]?(https?:)?//|@import", style.read_text(encoding="utf-8")), style


def test_every_model_has_a_page_with_equations_and_curves():
    for model in stribeck.models():
        page = (SITE / "models" / f"{model.name}.html").read_text(encoding="utf-8")
        assert "<math" in page, model.name
        assert "<svg" in page.split("<article", 1)[1], model.name
        for variable in model.variables:
            assert f"<code>{variable}</code>" in page, f"{model.name}: {variable}"


def test_every_function_of_python_and_c_is_described():
    python = parsed(SITE / "python_api.html").anchors
    for name in stribeck.__all__:
        assert f"stribeck.{name}" in python or name == "__version__", name
    header = (PROJECT / "include" / "stribeck.h").read_text(encoding="utf-8")
    names = set(re.findall(r"\b(stribeck_\w+)\(", re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)))
    assert len(names) > 25
    assert {f"c.{name}" for name in names} <= parsed(SITE / "c_api.html").anchors


def test_words_are_found_in_pages_docstrings_and_equations():
    """In the index that the search reads; words are cut to their stems there."""
    text = (SITE / "searchindex.js").read_text(encoding="utf-8")
    index = json.loads(text[text.index("(") + 1 : text.rindex(")")])

    def found(word):
        pages = index["terms"][word]
        return {index["docnames"][page] for page in (pages if isinstance(pages, list) else [pages])}

    assert "models/LuGre" in found("bristl")
    assert "docs/fmu" in found("enumer")
    assert {"python_api", "docs/python"} <= found("identifi")


def test_pages_in_a_browser_are_accessible_and_fit_a_phone():
    chromium, node = shutil.which("chromium"), shutil.which("node")
    if not chromium or not node or not (PROJECT / "web/node_modules/axe-core").is_dir():
        pytest.skip("needs chromium, node, and the packages of web (`npm ci --prefix web`)")
    command = [node, PROJECT / "tests/site/browser.mjs", SITE, chromium]
    done = subprocess.run(command, capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stdout + done.stderr
    print(done.stdout)
