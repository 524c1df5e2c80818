"""What the bundled session was simulated with, and what is known of it beforehand."""

import numpy as np

from exoid.recordings.declared.subject import Subject
from exoid.watching.estimate.load import Mass

# What the bundled session was simulated with.
TRUTH = {
    "gravity_over_inertia": 4.5 * 0.26 * 9.80665 / 0.42,
    "stiffness_over_inertia": 2.6 / 0.42,
    "damping_over_inertia": 0.33 / 0.42,
    "inertia": 0.42,
}
LIKELY = 4.0  # standard errors, beyond which one draw in 16 000 lies
LOADED = 41.0, 57.0  # s, in which 1 kg is at the ankle
WEIGHT = Mass(1.0, 0.4)
SUBJECT = Subject(
    kind="leg",
    body_mass=74.0,
    height=1.78,
    added_mass_gyration=0.0,
    damping_under_load_uncertainty=0.0,
    stiffness_under_load_uncertainty=0.0,
)


def until(readings, time):
    return [each for each in readings if each.time < time]


def nan_equal(one, other) -> bool:
    return bool(np.array_equal(np.array(one), np.array(other), equal_nan=True))
