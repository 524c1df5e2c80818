"""What recordings own beside the leg, as reports name it."""

from exoid.fitting.model.systematics import OWNED
from exoid.fitting.solve.problem import Problem

MOUNTING = {  # name: symbol, title, unit
    "added_mass_distance": ("r", "distance of the added mass from the knee", "m"),
    "added_mass": ("m_a", "added mass", "kg"),
    "added_mass_gyration": ("k", "radius of gyration of the added mass about its centre", "m"),
    "zero": ("zero", "what the encoder shows with the knee extended", "rad"),
    "tilt": ("tilt", "tilt of the thigh beyond the declared angle", "rad"),
    "gyro_scale": ("scale", "gyro scale, less 1", "1"),
    "gyro_bias": ("bias", "gyro bias", "rad/s"),
    "clock": ("clock", "true seconds in a recorded one, less 1", "1"),
    "torque_zero": ("tau_0", "what the torque sensor shows where no torque acts", "N m"),
    "torque_gain": ("gain", "torque that is shown over the one that acts, less 1", "1"),
    "damping_under_load": ("d_a / d - 1", "damping beside the added mass, over d, less 1", "1"),
    "stiffness_under_load": ("c_a / c - 1", "stiffness beside the same, over c, less 1", "1"),
    "distance_apart": ("log r_2 / r_1", "distances of several masses, beyond the declared", "1"),
    "extent_apart": ("k_2^2 - k_1^2", "their squared radii of gyration, apart", "m^2"),
}
FIELDS = dict(zip(("log_distance", "log_added", "extent"), list(MOUNTING)[:3], strict=True)) | {
    name: name for name in OWNED[3:]
}  # of a Mounting: as it is called outside


def in_no_unit(problem: Problem, field: str) -> bool:
    """Is it the zero of a torque whose gain nobody knows?"""
    return field == "torque_zero" and not problem.gain_known
