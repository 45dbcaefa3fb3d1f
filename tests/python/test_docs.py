"""The Python examples in the pages of docs/: they run, and print what the page says."""

import itertools
import re
from dataclasses import dataclass
from pathlib import Path

import pytest
from coupling import PROJECT

BLOCK = re.compile(r"^```(?P<language>\w*)\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Example:
    """A piece of Python, where it begins, and what the page says that it prints."""

    code: str
    line: int
    printed: str


def examples(page: str) -> list[Example]:
    """The Python blocks of a page; a block of text directly after one is what it prints."""
    found, blocks = [], list(BLOCK.finditer(page))
    for block, following in itertools.zip_longest(blocks, blocks[1:]):
        if block["language"] != "python":
            continue
        is_answer = following and following["language"] == "text" and not page[block.end() : following.start()].strip()
        line = page.count("\n", 0, block.start("text"))
        found.append(Example(block["text"], line, following["text"] if is_answer else ""))
    return found


PAGES = [page for page in sorted((PROJECT / "docs").glob("*.md")) if examples(page.read_text(encoding="utf-8"))]


def test_some_page_has_examples():
    assert PAGES


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_examples_of_a_page_run_one_after_the_other(page: Path, capsys):
    names = {}
    for example in examples(page.read_text(encoding="utf-8")):
        # Empty lines before it, so that a traceback names the line of the page.
        exec(compile("\n" * example.line + example.code, page, "exec"), names)
        assert capsys.readouterr().out == example.printed


def test_pictures_and_neighbours_of_a_page_exist():
    for page in (PROJECT / "docs").glob("*.md"):
        for target in re.findall(r"\]\(([^)#:]+)[)#]", page.read_text(encoding="utf-8")):
            assert (page.parent / target).exists(), f"{page.name}: {target}"
