"""The extension module: plain data in, plain data out."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

__version__: str

Numbers = NDArray[np.float64]

class Refused(ValueError): ...

class Instance:
    def __init__(self, model: str, preset: str | None) -> None: ...
    @property
    def time(self) -> float: ...
    def set(self, values: list[tuple[str, float]]) -> None: ...
    def get(self, name: str) -> float: ...
    def step(self, dt: float, slopes: list[tuple[str, float]]) -> None: ...
    def reset(self) -> None: ...
    def warning(self) -> str | None: ...

def names() -> list[tuple[str, str, str]]: ...
def describe(name: str) -> dict[str, Any]: ...
def follow(
    model: str,
    *,
    preset: str | None,
    parameters: list[tuple[str, Numbers]],
    inputs: list[tuple[str, Numbers]],
    dt: float,
    times: Numbers | None,
    held: bool,
    results: list[str],
    runs: int,
    samples: int,
    threads_asked: int | None,
) -> list[Numbers]: ...
def settle(
    model: str,
    *,
    preset: str | None,
    parameters: list[tuple[str, Numbers]],
    inputs: list[tuple[str, Numbers]],
    results: list[str],
    points: int,
    threads_asked: int | None,
) -> list[Numbers]: ...
def make_study(
    study: str | dict[str, Any], folder: str, *, shard: str, threads_asked: int | None
) -> tuple[int, int, int]: ...
def merge_study(study: str | dict[str, Any], folder: str) -> Path: ...
def systems() -> list[tuple[str, str]]: ...
def solvers() -> list[tuple[str, str]]: ...
def solve(entries: dict[str, Any]) -> list[dict[str, Any]]: ...
