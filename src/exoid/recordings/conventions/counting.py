"""How the sensors of a file are told to count: what makes exoid's angle of theirs, in words too."""

import numpy as np

from exoid.recordings.declared.sensors import Sensors

ANGLES = ("raw_angle", "angle")
RATES = ("raw_angular_velocity", "angular_velocity", "angular_acceleration")
FLIPPED = {"angle": ANGLES, "gyro": RATES, "all": (*ANGLES, *RATES, "applied_torque")}
HANGING = -np.pi / 2  # rad, the plumb line


def counting(told: Sensors) -> tuple[float, float]:
    """Sign, and what is then added [rad], that make exoid's angle of that of a file."""
    sign = -1.0 if "angle" in FLIPPED.get(told.flip or "", ()) else 1.0
    return sign, HANGING if told.zero == "hanging" else -sign * (told.angle_zero or 0.0)


def answers(told: Sensors) -> str:
    """What was told of the angle's sign and zero, in the words in which it is told."""
    said = [f'flip="{told.flip}"'] if told.flip in ("angle", "all") else []
    said += ['zero="hanging"'] if told.zero == "hanging" else []
    zero = told.angle_zero
    said += [] if zero is None else [f"angle_zero_deg = {np.degrees(zero):.4g} in [sensors]"]
    return " and ".join(said)
