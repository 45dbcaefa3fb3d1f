"""The report of a study: one HTML file, with tables and figures inside, in the style of the workbench's reports."""

import base64
import html
from collections.abc import Mapping, Sequence
from pathlib import Path

from examples.fmpy.coupling import PROJECT

STYLE = PROJECT / "lab" / "plot" / "src" / "report" / "style.css"


def write_page(
    path: Path, title: str, facts: Sequence[str], tables: Mapping[str, list[list[str]]], figures: Mapping[str, Path]
) -> None:
    """Writes the file; it needs nothing beside it."""
    parts = [f"<h1>{html.escape(title)}</h1>", *(f"<p>{html.escape(fact)}</p>" for fact in facts)]
    for heading, rows in tables.items():
        parts += [f"<h2>{html.escape(heading)}</h2>", _table(rows)]
    for heading, picture in figures.items():
        data = base64.b64encode(picture.read_bytes()).decode("ascii")
        shown = html.escape(heading)
        image = f'<img alt="{shown}" src="data:image/png;base64,{data}" style="max-width:100%">'
        parts.append(f"<h2>{shown}</h2>\n<figure>{image}</figure>")
    style = STYLE.read_text(encoding="utf-8")
    head = f'<meta charset="utf-8">\n<title>{html.escape(title)}</title>\n<style>\n{style}</style>'
    path.parent.mkdir(parents=True, exist_ok=True)
    body = "\n".join(parts)
    path.write_text(f'<!doctype html>\n<html lang="en">\n{head}\n<body>\n{body}\n</body>\n</html>\n', encoding="utf-8")


def _table(rows: Sequence[Sequence[str]]) -> str:
    """A table whose first row is its head, with numbers to the right; a short row tells why a run failed."""
    first, *others = rows[0]
    head = f"<th>{html.escape(first)}</th>" + "".join(f'<th class="number">{html.escape(cell)}</th>' for cell in others)
    lines = [f"<tr>{head}</tr>"]
    for law, *cells in rows[1:]:
        shown = [html.escape(cell) for cell in cells]
        if len(cells) < len(others):
            lines.append(
                f'<tr class="failed"><td>{html.escape(law)}</td><td colspan="{len(others)}">{shown[0]}</td></tr>'
            )
        else:
            numbers = "".join(f'<td class="number">{cell}</td>' for cell in shown)
            lines.append(f"<tr><td>{html.escape(law)}</td>{numbers}</tr>")
    return '<div class="wide"><table>\n' + "\n".join(lines) + "\n</table></div>"
