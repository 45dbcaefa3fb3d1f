"""Adds a law to a copy of the project: its file and one line. Everything that takes laws from the list must take it."""

import os
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "broken"))
from project_copy import ROOT, ProjectCopy

LAW = "spring_slider"
LINE = "    spring_slider::SpringSlider,\n"
# Whatever takes its laws from the list.
PYTEST = ["test_fmus", "test_model_description", "test_package", "test_exchange", "test_page", "test_identification"]


def main() -> None:
    copy = ProjectCopy("newcomer")
    law = copy.root / "src" / "friction" / f"{LAW}.rs"
    law.write_text((ROOT / "tests" / "newcomer" / f"{LAW}.rs").read_text(encoding="utf-8"), encoding="utf-8")
    listed = law.with_name("mod.rs")
    text = listed.read_text(encoding="utf-8")
    # The list is the first one that ends in the file.
    head, tail = text.split("\n}\n", 1)
    listed.write_text(f"{head}\n{LINE}}}\n{tail}", encoding="utf-8")

    # The packages are those of the project.
    (copy.root / ".venv").symlink_to(ROOT / ".venv", target_is_directory=True)
    environment = {**os.environ, "CARGO_TARGET_DIR": str(copy.out / "target")}

    def run(*words: str | Path) -> None:
        print(f"\n> {' '.join(map(str, words))}", flush=True)
        if subprocess.run(words, cwd=copy.root, env=environment).returncode != 0:
            sys.exit(f"the law of tests/newcomer is not taken by: {' '.join(map(str, words))}")

    run("cargo", "run", "--package", "fmu-build", "--", "generate")
    run("cargo", "test", "--workspace")
    run("cargo", "build", "--workspace")
    run(sys.executable, "-c", "import tasks; tasks.pack(); tasks.package()")
    tests = [f"tests/python/{name}.py" for name in PYTEST]
    run(sys.executable, "-m", "pytest", "-q", *tests, "tests/newcomer")
    print(
        "figure: a law of 2 files is taken by contract tests, strut, FMU, pages, Python and identification", flush=True
    )


main()
