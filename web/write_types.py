"""Writes the types of the page's questions and answers, as the library for this machine tells them."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "tests" / "python"))
from page import page_library

(Path(__file__).parent / "page" / "types.ts").write_text(page_library().types(), encoding="utf-8")
