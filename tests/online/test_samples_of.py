"""A recording goes into the estimator as its samples."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import butter, filtfilt

import exoid
from exoid import online
from exoid.online.movement.begin import ROWS
from exoid.online.movement.watch import REST
from exoid.online.recorded import is_smoothed
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import DROP, LOADED, recorded
from hands import Device, dropped
from reflexes import ADULT, START, measured, swung, thrown


@pytest.mark.parametrize("rate", [200, 250, 300, 400, 600, 1000])
def test_what_is_remembered_of_a_recording_of_any_rate_shows_a_leg_at_rest(rate):
    """A release is seen where it was still for half a second."""
    segment = Segment(np.arange(2 * rate) / rate, raw_angle=np.zeros(2 * rate))
    samples = online.samples_of(Recording((segment,), Subject(kind="leg")))
    assert np.diff(samples.time).min() * (ROWS - 1) > REST


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


@pytest.mark.parametrize("rate", [30, 50, 60, 100])
def test_an_angle_that_was_smoothed_is_told_from_one_that_was_measured(rate):
    """At 6 Hz, to and fro, as motion capture does; by the camera's own noise it is not."""
    seen = thrown(ADULT, 0.0, rate)
    smooth = filtfilt(*butter(2, 6.0, fs=rate), seen.raw_angle)
    each = [
        Recording((Segment(seen.time, raw_angle=angle),), Subject(kind="leg"))
        for angle in (seen.raw_angle, smooth)
    ]
    assert list(map(is_smoothed, each)) == [False, True]


@pytest.mark.parametrize("rate", [100, 300, 500, 1000])
@pytest.mark.parametrize("counts", [2**12, 2**14])
def test_the_steps_of_an_encoder_are_no_filter_at_any_rate(rate, counts):
    """Three samples of 2 ms are followed as one, whose error is less than that of any of them."""
    step = 2 * np.pi / counts
    true = measured(swung(ADULT, 0.0, START, 0.0, 0.0)[0], rate, noise=0.0)
    segment = replace(true, raw_angle=step * np.round(true.best_angle / step))
    sensors = Sensors(encoder_counts=float(counts))
    assert not is_smoothed(Recording((segment,), Subject(kind="leg"), sensors=sensors))


@pytest.mark.parametrize("rate", [100.0, 300.0, 400.0, 600.0])
def test_a_drop_is_seen_at_any_rate(rate):
    recording, _ = dropped(device=Device(rate=rate))
    model = online.Model(node=online.node_of(recording))
    _, said = online.replay(
        online.init(exoid.expected_leg(74.0, 1.78), model), online.samples_of(recording), model
    )
    assert said.phase[-1] == online.Phase.MOVING


def test_a_few_samples_tell_no_noise():
    """A movement that is advised by them would promise the numbers of a sensor that has none."""
    still = np.random.default_rng(0).normal(-0.2, 7e-4, 4)  # as four rows may look alike
    segment = Segment(np.arange(4) / 100, raw_angle=still, raw_angular_velocity=np.zeros(4))
    node = online.node_of(Recording((segment,), Subject(kind="leg")))
    usual = online.Node()
    assert (node.angle_noise, node.velocity_noise) == (usual.angle_noise, usual.velocity_noise)
