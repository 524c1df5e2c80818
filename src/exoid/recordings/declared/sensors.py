"""What is known of the sensors, and how a file differs from exoid's convention."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from exoid.recordings.declared.entry import check_words, extra, ranged, text

FLIPS = ("angle", "gyro", "all")  # channels whose sign is the other one
ZEROS = ("extended", "hanging", "unknown")  # what the encoder calls 0
FILTERS = ("3 states", "4 states")  # of the node: of the motion; and of the gyro's bias


@dataclass(frozen=True)
class Sensors:
    """What is known of the sensors. An uncertainty is one standard deviation, None where not told.

    `flip`, `zero` and `angle_zero` say how a file differs from exoid's convention; `load` mends its
    samples accordingly and clears them (`recordings/conventions/mounting.py`).

    >>> exoid.Sensors(encoder_counts=4096.0).angle_noise is None  # not told
    True
    """

    encoder_counts: float | None = ranged("encoder_counts", "counts per turn", 16.0, 2.0**26)
    angle_noise: float | None = ranged("angle_noise_rad", "rad", 1e-9, 1.0)
    velocity_noise: float | None = ranged("velocity_noise_rad_s", "rad/s", 1e-9, 10.0)
    gyro_range: float | None = ranged("gyro_range_dps", "deg/s", 10.0, 20000.0)
    sample_rate: float | None = ranged("sample_rate_hz", "Hz", 1.0, 20000.0)
    flip: str | None = text("flip", FLIPS)
    zero: str | None = text("zero", ZEROS)
    angle_zero: float | None = ranged("angle_zero_rad", "rad", -7.0, 7.0)
    angle_zero_uncertainty: float | None = ranged("angle_zero_uncertainty_rad", "rad", 0.0, 3.2)
    gyro_scale_uncertainty: float | None = ranged("gyro_scale_uncertainty", "of 1", 0.0, 0.5)
    clock_uncertainty: float | None = ranged("clock_uncertainty", "of 1", 0.0, 0.5)
    torque_zero_uncertainty: float | None = ranged("torque_zero_uncertainty_nm", "N m", 0.0, 1e3)
    torque_gain_uncertainty: float | None = ranged("torque_gain_uncertainty", "of 1", 0.0, 0.5)
    device: str | None = text("device")
    filter: str | None = text("filter", FILTERS)
    filter_step: float | None = ranged("filter_step_s", "s", 1e-5, 1.0)
    extra_keys: Mapping[str, Any] = extra()

    def __post_init__(self):
        check_words(self)
