"""A fit with a model that was found in the same recordings begins where that ended."""

from types import SimpleNamespace

import numpy as np
import pytest

from exoid.cli.inputs.near import near
from fit_cases import leg


def saved(*hashes, **settings):
    """What of a saved result says where it ended, and in what."""
    result = SimpleNamespace(leg=leg(), torque_amplitude=None)
    sources = [{"sha256": each} for each in hashes]
    return SimpleNamespace(result=result, recordings=sources, settings=settings)


def test_it_begins_at_the_leg_that_was_found():
    row = near(saved("a", "b"), ["b", "a"], {})["near"]
    assert row == pytest.approx(np.array([4.5, 0.42, 0.26, 0.33, 2.6, 0.0]))


def test_other_recordings_have_a_leg_of_their_own():
    assert near(saved("a"), ["b"], {}) == {}
    assert near(saved("a"), ["a", "b"], {}) == {}
    assert near(saved("a"), ["a"], {"flip": "all"}) == {}
    assert "near" in near(saved("a", flip="all"), ["a"], {"flip": "all"})
