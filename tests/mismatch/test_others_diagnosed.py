"""Recordings as others make them, in which a diagnosis had once been sure of a wrong name."""

import pytest
from benchmarks.others.write import make

from exoid.mismatch.missing_physics import diagnose
from exoid.recordings.loading.load import load

pytestmark = pytest.mark.proof


def diagnosed(seed: int, number: int, folder):
    return diagnose(load(make(seed, number, folder, 1)).recording)


def test_a_magnet_off_the_centre_is_none_that_errs_twice_per_turn(tmp_path):
    """Among the sensors both are as good; with a zero far off the second stood alone."""
    found = diagnosed(260, 92, tmp_path)
    assert "encoder_second_harmonic" not in found.selected
    assert any("encoder_eccentricity" in each for each in found.equivalent)
