"""Files and functions of Python and of the page are as short as those of Rust, which tests/rooms.rs holds."""

import ast
import re
from pathlib import Path

from page import PROJECT

LONGEST_FILE = 700
LONGEST_FUNCTION = 45
FOLDERS = ["python", "release", "docs", "examples", "tests", "benches", "fuzz", "web/page", "web/tests"]
# The head of a function or method of TypeScript that has a body of lines.
WORDS = r"(?:export |private |protected |static |async |function |get |set )*"
HEAD = re.compile(rf"^( *){WORDS}(\w+) *(?:<[^>]*>)?\(.*\{{$")
STATEMENTS = {"if", "for", "while", "switch", "catch"}


def files(ending: str) -> list[Path]:
    found = [path for folder in FOLDERS for path in (PROJECT / folder).rglob(f"*{ending}")]
    return [*found, PROJECT / "tasks.py"] if ending == ".py" else found


def of_python(path: Path):
    """Names and lengths of functions, the text that describes them aside."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            told = node.body[0] if ast.get_docstring(node) is not None else None
            described = told.end_lineno - told.lineno + 1 if told else 0
            yield node.name, node.end_lineno - node.lineno + 1 - described


def of_typescript(path: Path):
    lines = path.read_text(encoding="utf-8").split("\n")
    for at, line in enumerate(lines):
        head = HEAD.match(line)
        if head and head[2] not in STATEMENTS:
            end = next(end for end in range(at, len(lines)) if lines[end].startswith(f"{head[1]}}}"))
            yield head[2], end - at + 1


def test_files_and_functions_are_short():
    long, count = [], 0
    for ending, functions in ((".py", of_python), (".ts", of_typescript)):
        for path in files(ending):
            length = len(path.read_text(encoding="utf-8").splitlines())
            if length > LONGEST_FILE and path.name != "types.ts":
                long.append(f"{path.name}: {length} lines")
            for name, lines in functions(path):
                count += 1
                if lines > LONGEST_FUNCTION:
                    long.append(f"{path.name}: {name} has {lines} lines")
    assert not long, long
    assert count > 1500, f"only {count} functions were found"


def test_a_long_function_is_found(tmp_path):
    body = "  x();\n" * 50
    (tmp_path / "a.ts").write_text(f"export async function f(x: number): void {{\n{body}}}\n")
    (tmp_path / "a.py").write_text('def f():\n    """Text."""\n' + "    x()\n" * 50)
    assert list(of_typescript(tmp_path / "a.ts")) == [("f", 52)]
    assert list(of_python(tmp_path / "a.py")) == [("f", 51)]
