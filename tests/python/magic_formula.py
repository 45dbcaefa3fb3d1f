"""Lateral force of a tyre: the Magic Formula 5.2 for pure side slip without camber, symmetric part, and relaxation."""

import math
from dataclasses import dataclass


@dataclass(frozen=True)
class LateralTyre:
    """Coefficients with their names in tyre files; those of a racing tyre, from TUM's Open-Car-Dynamics (Apache-2.0).

    Slip angles are positive when the wheel moves to the left of its heading; the force then points to the right.
    Source of the formula: H. B. Pacejka, "Tyre and Vehicle Dynamics", 2nd edition (2006), section 4.3.2.
    """

    fnomin: float = 3000.0
    pcy1: float = 1.5
    pdy1: float = 1.2
    pdy2: float = -0.09
    pey1: float = 0.1
    pey2: float = -1.2
    pky1: float = -75.5
    pky2: float = 4.65
    pky4: float = 2.0
    relaxation_length: float = 0.2

    def force(self, slip: float, load: float) -> float:
        """Lateral force at a slip angle in rad and a vertical load in N."""
        if load <= 0.0:
            return 0.0
        excess = (load - self.fnomin) / self.fnomin
        peak = load * (self.pdy1 + self.pdy2 * excess)
        stiffness = self.pky1 * self.fnomin * math.sin(self.pky4 * math.atan(load / (self.pky2 * self.fnomin)))
        b = stiffness / (self.pcy1 * peak)
        e = min(1.0, self.pey1 + self.pey2 * excess)
        return peak * math.sin(self.pcy1 * math.atan(b * slip - e * (b * slip - math.atan(b * slip))))

    def relaxed(self, slip: float, target: float, distance: float) -> float:
        """The slip angle of the carcass after the wheel has rolled a distance at a slip angle `target`."""
        return target + (slip - target) * math.exp(-distance / self.relaxation_length)
