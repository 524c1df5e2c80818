"""What limits a number most."""

from exoid.fitting.result.estimates.estimate import Estimate

WORTH = 0.3  # of a variance, from which on a systematic is named
WORDS = {
    "zero": "the encoder's zero",
    "tilt": "the seat's tilt, or a foot before the leg's line,",
    "gyro_scale": "the gyro's scale",
    "gyro_bias": "the gyro's bias",
    "clock": "the clock",
    "torque_zero": "the torque sensor's zero",
    "torque_gain": "the torque sensor's gain",
    "reflex_form": "that a reflex may have another form than the term",
    "damping_under_load": "how well damping stays the same under load",
    "stiffness_under_load": "how well stiffness stays the same under load",
    "added_mass": "the weight of the added mass",
    "added_mass_distance": "the distance of the added mass",
    "added_mass_gyration": "the extent of the added mass",
    "distance_apart": "where several masses of one recording sit, each by itself,",
    "extent_apart": "the extent of several masses of one recording, each by itself,",
}


def chief(each: Estimate) -> tuple[str, float] | None:
    """What limits a number most, and its part of the variance; None where nothing stands out."""
    shares = each.limited_by or {}
    name = max(shares, key=shares.__getitem__, default=None)
    return (name, shares[name]) if name is not None and shares[name] >= WORTH else None
