"""The channels of Motion-BIDS that exoid's columns are."""

from dataclasses import dataclass

from exoid.recordings.columns import UNITS

LATENCY = "latency"  # s since the first sample, over all segments


@dataclass(frozen=True)
class Channel:
    """A row of `_channels.tsv` but for its name: type, axis, and what it is in words.

    The axis that the knee turns about is y, x goes along the shank, as the node's own axes do.
    """

    type: str
    component: str
    description: str


CHANNELS = {
    LATENCY: Channel("LATENCY", "n/a", "time since the first sample"),
    "time_s": Channel("MISC", "n/a", "time since the segment began"),
    "raw_angle_rad": Channel("JNTANG", "n/a", "knee angle before any filter; 0 extended"),
    "angle_rad": Channel("JNTANG", "n/a", "knee angle of a filter; 0 extended"),
    "raw_velocity_rad_s": Channel("GYRO", "y", "gyro before any filter; extension positive"),
    "velocity_rad_s": Channel("GYRO", "y", "angular velocity of a filter; extension positive"),
    "acceleration_rad_s2": Channel("ANGACCEL", "y", "angular acceleration of a filter"),
    "raw_acceleration_x_m_s2": Channel("ACCEL", "x", "accelerometer along the shank"),
    "raw_acceleration_z_m_s2": Channel("ACCEL", "z", "accelerometer across the shank"),
    "torque_nm": Channel("MISC", "n/a", "measured torque; extension positive"),
}
UNKNOWN = Channel("MISC", "n/a", "kept as its file had it")
OWN_UNITS = {LATENCY: "s", **UNITS}
