"""The library behind the page, built for this machine."""

import ctypes
import json
import os
import sys
from pathlib import Path

import numpy as np

PROJECT = Path(__file__).resolve().parents[2]
NAMES = {"win32": "stribeck_page.dll", "darwin": "libstribeck_page.dylib"}


def page_library():
    """A function that puts a question; it returns the answer and its arrays."""
    folder = Path(os.environ.get("CARGO_TARGET_DIR", PROJECT / "target")) / "debug"
    library = ctypes.CDLL(str(folder / NAMES.get(sys.platform, "libstribeck_page.so")))
    library.stribeck_alloc.argtypes = [ctypes.c_size_t]
    library.stribeck_alloc.restype = ctypes.c_void_p
    library.stribeck_ask.restype = ctypes.c_size_t
    library.stribeck_answer.restype = ctypes.c_void_p

    library.stribeck_types.restype = ctypes.c_size_t

    def put(question):
        text = question if isinstance(question, bytes) else json.dumps(question).encode()
        ctypes.memmove(library.stribeck_alloc(len(text)), text, len(text))
        return taken(library.stribeck_ask())

    def taken(length):
        answer = ctypes.string_at(library.stribeck_answer(), length)
        end = 8 + int.from_bytes(answer[:4], "little")
        told = json.loads(answer[8:end])
        numbers = np.frombuffer(answer[end:])
        assert len(numbers) == sum(told["lengths"]) == int.from_bytes(answer[4:8], "little")
        return told["answer"], np.split(numbers, np.cumsum(told["lengths"])[:-1])

    put.types = lambda: taken(library.stribeck_types())[0]["text"]
    return put
