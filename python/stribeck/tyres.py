"""Forces, moments and radii of rolling tyres."""

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


class TyreRadii(NamedTuple):
    """Radii in m of a tyre under load: of the rolling tyre without load, of the centre of the wheel above the road in
    the plane of the wheel, and the effective rolling radius, or None if the file has neither DREFF nor FREFF; and the
    vertical deflection in m, without camber the difference of the first two."""

    free_radius: float
    loaded_radius: float
    effective_radius: float | None
    deflection: float


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

    def radii(
        self,
        load: float,
        *,
        longitudinal_slip: float = 0.0,
        side_slip: float = 0.0,
        camber: float = 0.0,
        speed: float = 0.0,
        pressure: float | None = None,
        left: bool = True,
    ) -> TyreRadii:
        """Radii under a load in N, in the state of `wrench` and with its forces, after Magic Formula 6.1 and 6.2.
        Raises `stribeck.Refused` for a load that no deflection carries, and if the file gives no vertical stiffness."""
        return TyreRadii(*self._tyre.radii(left, (load, longitudinal_slip, side_slip, camber, speed), pressure))

    def load(
        self,
        loaded_radius: float,
        *,
        force_x: float = 0.0,
        force_y: float = 0.0,
        camber: float = 0.0,
        spin: float = 0.0,
        pressure: float | None = None,
        left: bool = True,
    ) -> float:
        """Load in N for a loaded radius in m: the inverse of `radii`, with the forces of the road in N and the spin of
        the wheel in rad/s. It is 0 where the tyre does not touch the road."""
        return self._tyre.load(left, (loaded_radius, force_x, force_y, camber, spin), pressure)
