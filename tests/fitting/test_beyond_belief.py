"""What a fit says that takes a recording for what nobody declares."""

import numpy as np
import pytest

from exoid.fitting.result.mountings import off

USUAL = float(np.radians(0.2))


@pytest.mark.parametrize("field", ["tilt", "zero"])
def test_a_rest_beside_the_middle_may_be_dry_friction(field):
    why = off(field, -10 * USUAL, USUAL)
    assert "to be off by -2 deg, where 0.2 deg is usual" in why
    assert "dry friction lets a leg come to rest beside its middle" in why


def test_a_gyro_whose_bias_is_off_is_no_friction():
    why = off("gyro_bias", 10 * USUAL, USUAL)
    assert why.endswith("off by 2 deg/s, where 0.2 deg/s is usual")
