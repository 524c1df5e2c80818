"""How far a fit moves with what no recording tells of it."""

import numpy as np
import pytest

from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.result.estimates.moved import Moved, moved_with

REST, GRAVITY, DAMPING = np.eye(3)
VARIANCE, TOGETHER = 0.04, 0.03  # of the rest angle, and of it with gravity


def known():
    covariance = np.array([[VARIANCE, TOGETHER, 0.0], [TOGETHER, 0.09, 0.0], [0.0, 0.0, 0.01]])
    none = np.zeros((0, 3))
    return Information(np.linalg.inv(covariance), np.zeros((3, 3)), none)


def test_what_goes_with_a_quantity_that_is_off_is_off_as_far_as_it_goes_with_it():
    size = 0.5
    off = Moved({"reflex_form": moved_with(REST[None], np.array([size]), known())}).off
    assert off(REST) == pytest.approx(size)
    assert off(GRAVITY) == pytest.approx(size * TOGETHER / VARIANCE, rel=0.01)
    assert off(DAMPING) == pytest.approx(0.0, abs=1e-12)


def test_a_quantity_that_is_held_moves_nothing():
    held = Information(np.eye(3), np.zeros((3, 3)), REST[None])
    assert not moved_with(REST[None], np.array([0.5]), held).any()
