#!/usr/bin/env python3
"""Makes dyno.csv and dyno_soft.csv: records of two dampers on a dynamometer, for `stribeck damper`.

    python -m examples.dampers.make_dyno [folder]

The data are computed, not measured, but have the features of measured data. Both dampers are driven through strokes of
20 mm to both sides of the middle, one cycle at each of three speeds; spring and side load are absent.

    dyno.csv        damper table of the shock absorber's defaults, 25 N of friction; positive in extension
    dyno_soft.csv   six tenths of that damping, 12 N of friction, as written by a dynamometer that counts compression
                    positive and records the force of the damper on the machine; semicolons and decimal commas

`stribeck damper` turns them into firm.csv and soft.csv, the dampers of the four-post rig.

Friction is a LuGre model with 1.2 times the level before sliding, the gas spring that of the shock absorber's defaults,
the load cell has noise of 1 N. All sizes are chosen. The seeds are fixed, so the files are the same each time.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy

DAMPERS = Path(__file__).resolve().parent

SPEEDS = [-1.0, -0.5, -0.25, -0.1, -0.05, 0.0, 0.05, 0.1, 0.25, 0.5, 1.0]  # m/s, positive in extension
RESISTANCE = [-1150.0, -700.0, -430.0, -210.0, -110.0, 0.0, 180.0, 340.0, 640.0, 950.0, 1500.0]  # N

AMPLITUDE = 0.020  # m
PEAKS = [0.05, 0.25, 1.0]  # highest speed of each cycle, m/s
SAMPLES = 400  # per turn
SUBSTEPS = 20  # steps of the bristle per sample
NOISE = 1.0  # N

BRISTLE = 1e5  # N/m
STATIC = 1.2  # level before sliding, in terms of that in sliding
STRIBECK = 1e-3  # m/s


@dataclass(frozen=True)
class Recording:
    """A damper and the format of its dynamometer."""

    name: str
    damping: float
    friction: float
    compression_positive: bool
    seed: int


RECORDINGS = [
    Recording("dyno.csv", damping=1.0, friction=25.0, compression_positive=False, seed=1886),
    Recording("dyno_soft.csv", damping=0.6, friction=12.0, compression_positive=True, seed=1902),
]


def gas_force(displacement: numpy.ndarray) -> numpy.ndarray:
    """Force of the gas on the rod: 10 bar in 30 cm3, rod of 14 mm, n = 1.2, in the middle of a travel of 55 mm."""
    area = 0.25 * numpy.pi * 0.014**2
    volume = 3e-5 - area * (0.0275 - displacement)
    return area * (1e6 * (3e-5 / volume) ** 1.2 - 101325.0)


def bristle_force(velocity: numpy.ndarray, step: float, level: float, deflection: float) -> tuple[numpy.ndarray, float]:
    """Force of a LuGre bristle without damping, for velocities that are held over each step."""
    forces = numpy.empty(len(velocity))
    for at, v in enumerate(velocity):
        limit = level * (1.0 + (STATIC - 1.0) * numpy.exp(-((v / STRIBECK) ** 2))) / BRISTLE
        end = numpy.copysign(limit, v)
        deflection = end + (deflection - end) * numpy.exp(-abs(v) * step / limit)
        forces[at] = BRISTLE * deflection
    return forces, deflection


def record(recording: Recording) -> dict[str, numpy.ndarray]:
    """The channels in this project's signs: positive in extension, force as resistance."""
    random = numpy.random.default_rng(recording.seed)
    # The machine has made some cycles before: the bristle is bent as at the end of a compression.
    deflection = -recording.friction / BRISTLE
    turns = []
    for peak in PEAKS:
        angle = 2.0 * numpy.pi * (numpy.arange(SAMPLES * SUBSTEPS) + 0.5) / (SAMPLES * SUBSTEPS)
        frequency = peak / AMPLITUDE
        step = 2.0 * numpy.pi / frequency / (SAMPLES * SUBSTEPS)
        friction, deflection = bristle_force(peak * numpy.sin(angle), step, recording.friction, deflection)
        turns.append(numpy.stack([peak * numpy.sin(angle), -AMPLITUDE * numpy.cos(angle), friction])[:, ::SUBSTEPS])
    velocity, displacement, friction = numpy.concatenate(turns, axis=1)
    damping = recording.damping * numpy.interp(velocity, SPEEDS, RESISTANCE)
    noise = random.normal(0.0, NOISE, len(velocity))
    resistance = damping + friction - gas_force(displacement) + noise
    warming = 24.0 + 4.0 * numpy.linspace(0.0, 1.0, len(velocity)) ** 2
    return {"velocity": velocity, "displacement": displacement, "resistance": resistance, "temperature": warming}


def text_of(recording: Recording) -> str:
    """The text of the file."""
    channels = record(recording)
    # With either sign, a resistance has the sign of the velocity; the second machine records its opposite.
    sign = -1.0 if recording.compression_positive else 1.0
    columns = [
        sign * 1e3 * channels["velocity"],
        sign * 1e3 * channels["displacement"],
        channels["resistance"],
        channels["temperature"],
    ]
    separator, decimal = (";", ",") if recording.compression_positive else (",", ".")
    heading = [
        "# Synthetic: computed by make_dyno.py, not measured.",
        f"# Damping {recording.damping:g} times the shock absorber's default, friction {recording.friction:g} N.",
        separator.join(["velocity [mm/s]", "displacement [mm]", "force [N]", "temperature [degC]"]),
    ]
    # Adding 0 turns a negative zero, which would be printed as -0.0, into zero.
    table = zip(*columns, strict=True)
    rows = (separator.join(f"{round(value, 2) + 0.0:.2f}".replace(".", decimal) for value in row) for row in table)
    return "\n".join([*heading, *rows]) + "\n"


def write_recordings(folder: Path) -> None:
    """Writes the files, always with the same line ends."""
    for recording in RECORDINGS:
        (folder / recording.name).write_text(text_of(recording), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    write_recordings(Path(sys.argv[1]) if len(sys.argv) > 1 else DAMPERS)
