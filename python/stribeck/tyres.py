"""Forces and moments of rolling tyres."""

from __future__ import annotations

import os
from pathlib import Path
from typing import NamedTuple

from stribeck import _stribeck


class TyreWrench(NamedTuple):
    """Forces in N and moments in N.m of the road on a tyre, at the contact point, in the axes of the wheel."""

    force_x: float
    force_y: float
    moment_x: float
    moment_y: float
    moment_z: float


class Tyre:
    """A tyre from a tyre property file (`.tir`) with coefficients of the Magic Formula 5.2, 6.1 or 6.2, that of
    `DoubleTrackCar`.

    `radius` is the one without load, `stiffness` and `damping` are vertical, or None if the file does not give them.
    `pressure` is the inflation pressure of the file in Pa, or None for version 5.2, which has none. `notes` lists what
    had to be assumed because the file does not say it, `unused` the keys that change no force, each with what it is
    for, and `ignored` those that would change forces by effects which are not modelled, such as turn slip. Raises
    `stribeck.Refused` for a file that makes no sense.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._tyre = _stribeck.Tyre(Path(path))
        self.radius, self.stiffness, self.damping = self._tyre.vertical()
        self.pressure = self._tyre.pressure()
        self.notes = self._tyre.notes()
        self.unused = self._tyre.unused()
        self.ignored = self._tyre.ignored()

    def wrench(
        self,
        load: float,
        *,
        longitudinal_slip: float = 0.0,
        side_slip: float = 0.0,
        camber: float = 0.0,
        speed: float = 0.0,
        pressure: float | None = None,
        left: bool = True,
    ) -> TyreWrench:
        """Forces and moments in steady state. Axes of ISO 8855: x forward, y left, z up. The side slip, in rad, is
        positive if the contact point moves to the left, the slip if the tyre drives, the camber, in rad, if the top
        leans to the right. The inflation pressure, in Pa, is that of the file unless it is given. A right tyre is the
        mirror image of a left one."""
        return TyreWrench(*self._tyre.wrench(left, (load, longitudinal_slip, side_slip, camber, speed), pressure))
