#!/usr/bin/env python3
"""Makes motion.csv: the records of a reciprocating friction rig, for replay.py.

    python -m examples.fmpy.make_motion [file]

The data are computed, not measured, but have the features of measured data:

    motion         a crank of 5 mm (stroke 10 mm) and a rod of 20 mm, so that the strokes are not sinusoidal; ten turns
                   at 1 Hz, from rest to rest, with a motor whose speed varies by 1 % four times per turn
    position       an encoder with steps of 1 um
    velocity       the difference quotient of the encoder, smoothed over 6 ms, as an evaluation would do it
    normal force   50 N from a pneumatic cylinder: 1.5 % ripple at 2.3 Hz, 0.6 % with the stroke, noise of 0.15 N

Sampled at 1 kHz. All sizes are chosen. The seed is fixed, so the file is the same each time.
"""

import sys
from pathlib import Path

import numpy

MOTION = Path(__file__).resolve().parent / "motion.csv"

RATE = 1000  # samples per second
TURNS = 10
RAMP = 0.5  # time to reach full speed, and to stop, s
CRANK = 5e-3  # crank radius, m
ROD = 20e-3  # length of the connecting rod, m
ENCODER_STEP = 1e-6  # m
SMOOTHING = 6e-3  # width of the window, s
LOAD = 50.0  # N
SEED = 1947


def crank_angle(time: numpy.ndarray) -> numpy.ndarray:
    """Angle of the crank: one turn per second, with linear ramps of the speed at both ends."""
    end = TURNS + RAMP
    speed = numpy.clip(numpy.minimum(time, end - time) / RAMP, 0.0, 1.0)
    turns = numpy.concatenate(([0.0], numpy.cumsum(0.5 * (speed[1:] + speed[:-1]) * numpy.diff(time))))
    angle = 2.0 * numpy.pi * turns
    return angle + 0.01 / 4.0 * numpy.sin(4.0 * angle)


def slider_position(angle: numpy.ndarray) -> numpy.ndarray:
    """Position of the slider of a crank mechanism, from one dead centre (0) to the other."""
    return CRANK * (1.0 - numpy.cos(angle)) + ROD - numpy.sqrt(ROD**2 - (CRANK * numpy.sin(angle)) ** 2)


def smoothed_velocity(position: numpy.ndarray) -> numpy.ndarray:
    """Difference quotient, smoothed by a Hann window that does not shift the signal in time."""
    window = numpy.hanning(round(SMOOTHING * RATE) + 1)
    window /= window.sum()
    margin = len(window) // 2
    quotient = numpy.gradient(position) * RATE
    return numpy.convolve(numpy.pad(quotient, margin, mode="edge"), window, mode="valid")


def normal_force(time: numpy.ndarray, position: numpy.ndarray, random: numpy.random.Generator) -> numpy.ndarray:
    """Force of the pneumatic cylinder."""
    ripple = 0.015 * numpy.sin(2.0 * numpy.pi * 2.3 * time + 0.4)
    tilt = 0.006 * (position / CRANK - 1.0)
    return LOAD * (1.0 + ripple + tilt) + random.normal(0.0, 0.15, len(time))


def motion() -> dict[str, numpy.ndarray]:
    """The recorded channels, under headings with their units."""
    random = numpy.random.default_rng(SEED)
    time = numpy.arange(round((TURNS + RAMP) * RATE) + 1) / RATE
    true_position = slider_position(crank_angle(time))
    position = numpy.round(true_position / ENCODER_STEP) * ENCODER_STEP
    return {
        "time [s]": time,
        "position [m]": position,
        "velocity [m/s]": smoothed_velocity(position),
        "normal_force [N]": normal_force(time, true_position, random),
    }


def write_motion(path: Path) -> None:
    """Writes the file with as many decimals as the instruments have, always with the same line ends."""
    channels = motion()
    decimals = (3, 6, 6, 3)
    # Adding 0 turns a negative zero, which would be printed as -0.000, into zero.
    columns = [numpy.round(channel, digits) + 0.0 for channel, digits in zip(channels.values(), decimals, strict=True)]
    with path.open("w", encoding="utf-8", newline="\n") as file:
        form = [f"%.{digits}f" for digits in decimals]
        numpy.savetxt(file, numpy.column_stack(columns), form, ",", header=",".join(channels), comments="")


if __name__ == "__main__":
    write_motion(Path(sys.argv[1]) if len(sys.argv) > 1 else MOTION)
