"""A recording goes into the estimator as its samples."""

from dataclasses import replace

import numpy as np
import pytest

import exoid
from exoid import online
from fit_cases import DROP, LOADED, recorded


def test_the_segments_of_a_recording_follow_each_other_with_their_masses():
    recording = recorded(DROP, LOADED)
    samples = online.samples_of(recording)
    sizes = [each.time.size for each in recording.segments]
    assert (np.diff(samples.time) > 0).all()
    assert samples.time[sizes[0]] - samples.time[sizes[0] - 1] == pytest.approx(1.0)
    assert np.array_equal(samples.angle[: sizes[0]], recording.segments[0].best_angle)
    assert [samples.added_mass[0], samples.added_mass[-1]] == [0.0, 1.0]
    assert samples.added_mass_distance[-1] == pytest.approx(0.4)
    belief, said = online.replay(online.init(exoid.expected_leg(74.0, 1.78)), samples)
    assert said.trust.shape == samples.time.shape
    assert np.isfinite(online.estimates(belief)["inertia"].value)


def test_a_mass_whose_place_nobody_knows_is_refused():
    recording = recorded(DROP, LOADED)
    subject = replace(recording.subject, added_mass_distance=None)
    with pytest.raises(ValueError, match="nobody says where the mass of 1 kg of segment 1 sits"):
        online.samples_of(replace(recording, subject=subject))
