"""The Python examples in README.md and on the pages of docs/: they run and print the output shown on the page."""

import csv
import itertools
import re
from dataclasses import dataclass
from pathlib import Path

import numpy
import pytest
import stribeck
from scipy.integrate import solve_ivp

from docs.site.build import PAGES as PAGES_OF_SITE
from examples.fmpy.coupling import PROJECT

BLOCK = re.compile(r"^```(?P<language>\w*)\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Example:
    """A piece of Python, its first line, and its output as shown on the page."""

    code: str
    line: int
    printed: str


def examples(page: str) -> list[Example]:
    """The Python blocks of a page; a block of text directly after one is its output."""
    found, blocks = [], list(BLOCK.finditer(page))
    for block, following in itertools.zip_longest(blocks, blocks[1:]):
        if block["language"] != "python":
            continue
        is_answer = following and following["language"] == "text" and not page[block.end() : following.start()].strip()
        line = page.count("\n", 0, block.start("text"))
        found.append(Example(block["text"], line, following["text"] if is_answer else ""))
    return found


README = PROJECT / "README.md"
DOCS = sorted((PROJECT / "docs").glob("*.md"))
PAGES = [page for page in (README, *DOCS) if examples(page.read_text(encoding="utf-8"))]


def test_some_pages_have_examples():
    assert README in PAGES
    assert set(PAGES) & set(DOCS)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_examples_of_a_page_run_one_after_the_other(page: Path, capsys, monkeypatch):
    monkeypatch.chdir(PROJECT)
    names = {}
    for example in examples(page.read_text(encoding="utf-8")):
        # Empty lines before it, so that a traceback names the line of the page.
        exec(compile("\n" * example.line + example.code, page, "exec"), names)
        assert capsys.readouterr().out == example.printed


def test_pictures_and_neighbours_of_a_page_exist():
    for page in (README, *DOCS):
        for target in re.findall(r"\]\(([^)#:]+)[)#]", page.read_text(encoding="utf-8")):
            assert (page.parent / target).exists(), f"{page.name}: {target}"


def test_every_page_has_its_place_in_the_lists_of_the_site():
    """Sphinx, which only `tasks.py site` runs, fails for a page in no list, and for an entry without a page."""
    index = (PROJECT / "docs" / "site" / "index.md").read_text(encoding="utf-8")
    blocks = [block["text"] for block in re.finditer(r"^```\{toctree\}\n(?P<text>.*?)^```$", index, re.M | re.S)]
    lines = [line for block in blocks for line in block.splitlines() if line and not line.startswith(":")]
    entries = sorted(re.sub(r".*<(.*)>", r"\1", line) for line in lines)
    copied = [path for pattern in PAGES_OF_SITE for path in PROJECT.glob(pattern)]
    pages = [path.relative_to(PROJECT).with_suffix("").as_posix() for path in copied]
    written = ["laws", "python_api", "c_api"]
    assert entries == sorted(pages + written)


THESIS = PROJECT / "docs" / "thesis.md"

# An equation of the thesis, and a range of them.
EQUATION = r"\(([2-9])\.([1-9]\d*)\)"
EQUATIONS = rf"{EQUATION} to {EQUATION}"


def equations_of(text: str) -> set[tuple[int, int]]:
    """The equations that a text names, those within its ranges included."""
    found = {(int(chapter), int(number)) for chapter, number in re.findall(EQUATION, text)}
    for chapter, first, _, last in re.findall(EQUATIONS, text):
        found |= {(int(chapter), number) for number in range(int(first), int(last) + 1)}
    return found


def test_the_page_of_the_thesis_names_every_law_and_equation():
    page = THESIS.read_text(encoding="utf-8")
    laws = [path for path in (PROJECT / "src/friction").glob("*.rs") if path.stem != "mod"]
    assert len(laws) >= 35
    for law in laws:
        assert f"](../src/friction/{law.name})" in page, law.name
    for source in (*laws, *(PROJECT / "src/host").glob("*.rs")):
        text = source.read_text(encoding="utf-8")
        if "Novais" not in text:
            continue
        cited = equations_of("\n".join(line for line in text.splitlines() if line.lstrip().startswith("///")))
        assert cited <= equations_of(page), source.name


def test_the_commands_of_the_page_of_the_thesis_name_what_exists():
    page = THESIS.read_text(encoding="utf-8")
    commands = re.findall(r"`((?:stribeck|python) [^`]*)`", page)
    assert len(commands) > 20
    programs = "".join(path.read_text(encoding="utf-8") for path in (PROJECT / "examples").glob("*/*.py"))
    models = {path.stem for path in (PROJECT / "modelDescription").glob("*.xml")} | {"None"}
    for command in commands:
        for path in re.findall(r"(?:examples|lab|src)/\S+", command):
            assert (PROJECT / path).exists(), command
        for module in re.findall(r"-m (examples\.\S+)", command):
            assert (PROJECT / f"{module.replace('.', '/')}.py").exists(), command
        for system in re.findall(r"--system (\S+)", command):
            assert (PROJECT / "lab/solve/src/system/built_in" / f"{system}.toml").exists(), command
        for names in re.findall(r"(?:--laws?|--model|stribeck show) ((?:\w+ ?)+)", command):
            assert set(names.split()) <= models, command
        for option in re.findall(r"--[a-z-]+", command) if command.startswith("python") else ():
            assert f'"{option}"' in programs, f"{command}: {option}"


def test_the_page_of_the_benchmark_has_every_law_and_solver():
    """As `stribeck bench thesis --work-precision --out docs` writes it; a law or a solver that is new is missing."""
    page = (PROJECT / "docs/benchmark.md").read_text(encoding="utf-8")
    with (PROJECT / "docs/benchmark.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    laws = {str(law) for law in stribeck.laws()}
    solvers = set(stribeck.solvers()) - {"auto", "co-simulation"}
    assert {(row["law"], row["solver"]) for row in rows} == set(itertools.product(laws, solvers))
    assert "not measured" not in page
    for law in laws:
        assert f"| {law} | " in page, law
    assert {len({row["tolerance"] for row in rows if row["law"] == law}) for law in laws} == {9}
    drawn = {path.name for path in (PROJECT / "docs/work-precision").iterdir()}
    assert drawn == set(re.findall(r"\(work-precision/([^)]*)\)", page))


def test_the_loop_in_fmpy_is_that_of_the_equations_of_lugre():
    """dz/dt = v - sigma_0 |v| z / g(v) and its work, integrated by Radau to 1e-9."""
    level, excess, scale = 0.12 * 20.0, 0.03 * 20.0, 1e-3
    sigma_0, sigma_1, sigma_2 = 1e5, 1e5**0.5, 0.1

    def velocity(t):
        return 0.01 * numpy.sin(2.0 * numpy.pi * t)

    def force(t, state, rate):
        return sigma_0 * state[0] + sigma_1 * rate + sigma_2 * velocity(t)

    def rates(t, state):
        v = velocity(t)
        rate = v - sigma_0 * abs(v) / (level + excess * numpy.exp(-((v / scale) ** 2))) * state[0]
        return [rate, force(t, state, rate) * v]

    samples = numpy.linspace(0.0, 1.0, 1001)
    solved = solve_ivp(rates, (0.0, 1.0), [0.0, 0.0], "Radau", samples, rtol=1e-9, atol=1e-14)
    forces = [force(t, state, rates(t, state)[0]) for t, state in zip(solved.t, solved.y.T, strict=True)]
    loop = next(
        one for one in examples((PROJECT / "docs" / "fmu.md").read_text(encoding="utf-8")) if "simulate_fmu" in one.code
    )
    printed = loop.printed
    numbers = [float(number) for number in re.findall(r"-?\d+\.\d+", printed)]
    assert numbers == pytest.approx([min(forces), max(forces), solved.y[1, -1], solved.y[1, -1]], rel=5e-3)
