"""What is suspected of seats and clocks, where hardly anything tells of them."""

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.fitting.multistart.rare import variances
from exoid.recordings.declared.sensors import Sensors
from legs import ADULT, CHILD, drop, recording


def test_what_two_unknowns_share_to_the_last_digit_has_a_covariance():
    """A robot's joint, moved for a minute, is told in 1e12 typical steps; a clock in its own."""
    shared = np.array([1e6, 1e6, 0.0])
    found = variances(np.outer(shared, shared) + np.diag([0.0, 0.0, 4.0]))
    assert np.isfinite(found).all()
    assert np.isclose(found[2, 2], 1 / 4, rtol=1e-8)  # it owes nothing to the others
    assert found[0, 0] > 1e-4  # their sum is told within 1e-6, and neither of them


@pytest.mark.parametrize("leg", [ADULT, CHILD])
@pytest.mark.parametrize("seed", range(3))
def test_a_foot_that_puts_the_centre_of_mass_beside_the_line_of_the_leg_is_in_the_errors(leg, seed):
    """By 3 deg, as a foot does; one drop before a 12-bit encoder may take that for its zero."""
    noise = 5e-4
    made = drop(leg, -0.3, gyro=False, seed=seed, noise=(noise, 0.0), thigh=np.radians(3.0))
    found = fit(recording(made, sensors=Sensors(angle_noise=noise)), multistart=2)
    for name, true in zip(("gravity_over_inertia", "stiffness_over_inertia"), leg, strict=False):
        each = found.ratios[name]
        assert each.value is not None
        assert each.standard_error is not None
        assert abs(each.value - true) < 3 * each.standard_error
