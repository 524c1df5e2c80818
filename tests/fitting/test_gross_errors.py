"""What is suspected of seats and clocks, where hardly anything tells of them."""

import numpy as np

from exoid.fitting.multistart.gross_errors import variances


def test_what_two_unknowns_share_to_the_last_digit_has_a_covariance():
    """A robot's joint, moved for a minute, is told in 1e12 typical steps; a clock in its own."""
    shared = np.array([1e6, 1e6, 0.0])
    found = variances(np.outer(shared, shared) + np.diag([0.0, 0.0, 4.0]))
    assert np.isfinite(found).all()
    assert np.isclose(found[2, 2], 1 / 4, rtol=1e-8)  # it owes nothing to the others
    assert found[0, 0] > 1e-4  # their sum is told within 1e-6, and neither of them
