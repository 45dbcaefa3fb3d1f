"""Settings of Sphinx for the documentation site."""

import re
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

project = "Stribeck"
author = "The Stribeck authors"
project_copyright = author
release = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]

extensions = ["myst_parser", "sphinx.ext.autodoc"]
# Anchors as in links of the pages of docs.
myst_heading_anchors = 4
# Docstrings and comments of the header write code between single backticks.
default_role = "code"
autodoc_member_order = "bysource"
autodoc_typehints = "description"

html_theme = "furo"
html_title = f"Stribeck {release}"
html_static_path = [str(Path(__file__).parent / "static"), str(ROOT / "out" / "site-static")]
html_css_files = ["site.css", "model.css"]
html_copy_source = False
# A browser does not let a page from a disk read others for it.
html_show_search_summary = False
html_show_sphinx = False

# A line of options, as in the docstring of `identify`.
OPTION = re.compile(r"^`\w+`: ")


def listed(*event):
    """Makes a list of a docstring's lines of options; each of them is one item."""
    lines = event[-1]
    lines[:] = [f"* {line}" if OPTION.match(line) else line for line in lines]


def setup(app):
    app.connect("autodoc-process-docstring", listed)
