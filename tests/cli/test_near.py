"""A fit with a model that was found in the same recordings begins where that ended."""

from hashlib import sha256
from types import SimpleNamespace

import numpy as np
import pytest

from exoid.cli.inputs.near import near
from fit_cases import leg


@pytest.fixture
def path(tmp_path):
    path = tmp_path / "a.csv"
    path.write_bytes(b"time_s,raw_angle_rad\n")
    return path


def saved(path, **settings):
    """What of a saved result says where it ended, and in what."""
    result = SimpleNamespace(leg=leg(), torque_amplitude=None)
    source = {"sha256": sha256(path.read_bytes()).hexdigest()}
    return SimpleNamespace(result=result, recordings=[source], settings=settings)


def test_it_begins_at_the_leg_that_was_found(path):
    row = near(saved(path), [path], {})["near"]
    assert row == pytest.approx(np.array([4.5, 0.42, 0.26, 0.33, 2.6, 0.0]))


def test_other_recordings_have_a_leg_of_their_own(path, tmp_path):
    found, other = saved(path), tmp_path / "b.csv"
    other.write_bytes(b"time_s,angle_rad\n")
    assert near(found, [other], {}) == {}
    assert near(found, [path, other], {}) == {}
    assert near(found, [path], {"flip": "all"}) == {}
    assert "near" in near(saved(path, flip="all"), [path], {"flip": "all"})
