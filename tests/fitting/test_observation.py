"""What a fit sees of a recording."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.data import observe as observing
from exoid.fitting.data.observe import bucket, observe
from exoid.fitting.data.pace import LONGEST_STEP
from exoid.fitting.data.segment import movement
from exoid.fitting.model.systematics import SOMEWHERE
from exoid.physics.leg import LegModel
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from fit_cases import BODY, NOISE, cycle_torque, exact, leg, one, state

TIME = np.arange(120) * 0.01
FAST = np.radians(20.0)


def dropped(time=TIME, **changes) -> Segment:
    segment = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), time)
    return replace(segment, **changes)


def one_row(recording, reading="1/T"):
    each = movement(recording, 0, "case")
    seen = observe([each], reading)
    return each, seen


def test_a_drop_is_clipped_at_its_ends_and_nowhere_between():
    """Of rest, drop and rest the drop remains, on its own clock."""
    still = np.full(40, -0.2)
    motion = dropped()
    angle = np.concatenate([still, motion.raw_angle, np.full(40, motion.raw_angle[-1])])
    velocity = np.concatenate([0 * still, motion.raw_angular_velocity, 0 * still])
    segment = Segment(np.arange(angle.size) * 0.01, raw_angle=angle, raw_angular_velocity=velocity)
    kept = movement(one(segment), 0, "drop")
    assert kept.segment.time[0] == 0
    # 120 samples move; what may be a hand's at the end is cut off with a margin of 0.15 s.
    assert 100 < kept.segment.time.size <= 121
    inner = kept.segment.raw_angular_velocity
    assert np.sum(np.abs(inner) < FAST) > 2  # the turning point below stays


def test_a_cycle_ends_with_its_period_and_keeps_the_clock_of_its_torque():
    """The rest in front is cut, and the clock starts within a sample of the first that is kept."""
    rest = np.full(100, -0.1)
    motion = exact(LegModel(leg(), cycle_torque()), state(-0.1), TIME)
    velocity = np.concatenate([0 * rest, motion.raw_angular_velocity])
    segment = Segment(
        np.arange(velocity.size) * 0.01,
        raw_angle=np.concatenate([rest, motion.raw_angle]),
        raw_angular_velocity=velocity,
    )
    each, seen = one_row(one(segment, "active", cycle_period=1.19))
    cut_away = 0.01 * each.extent.start
    assert cut_away == pytest.approx(1.0, abs=0.011)  # s of rest
    assert each.onset == pytest.approx(1.0 - cut_away, abs=0.01)
    assert each.segment.time[-1] - each.onset <= 1.19 + 1e-9
    shape = -np.abs(np.sin(2 * np.pi * (seen.time[0] - each.onset) / 1.19))
    inside = np.arange(seen.time.shape[1] - 1) < each.segment.time.size - 1
    assert (
        np.abs(seen.cycle.begin[0] - shape[:-1])[inside].max() < 1e-6
    )  # where it begins is measured


def test_a_gap_is_bridged_by_samples_that_weigh_nothing():
    kept = np.r_[0:50, 70:120]
    segment = dropped()
    broken = Segment(
        TIME[kept],
        raw_angle=segment.raw_angle[kept],
        raw_angular_velocity=segment.raw_angular_velocity[kept],
    )
    each, seen = one_row(one(broken))
    assert np.diff(seen.time[0]).max() <= LONGEST_STEP * (1 + 1e-9)
    assert np.sum(seen.angle_weight > 0) == each.segment.time.size
    rows = np.searchsorted(seen.time[0], each.segment.time)
    assert np.array_equal(seen.time[0][rows], each.segment.time)
    assert np.array_equal(seen.angle[0][rows], each.angle)


def test_rows_beyond_the_end_continue_the_clock_and_weigh_nothing(monkeypatch):
    monkeypatch.setattr(observing, "bucket", bucket)
    each, seen = one_row(one(dropped()))
    size = each.segment.time.size
    assert seen.time.shape[1] == bucket(size) > size
    assert np.all(np.diff(seen.time[0]) > 0)
    assert np.all(seen.angle_weight[0, size:] == 0)
    assert np.all(seen.velocity_weight[0, size:] == 0)
    assert np.all(seen.angle_weight[0, :size] == 1 / each.angle_noise)


def test_a_missing_sample_weighs_nothing():
    angle = dropped().raw_angle.copy()
    angle[[30, 31, 60]] = np.nan
    each, seen = one_row(one(dropped(raw_angle=angle)))
    assert np.isfinite(seen.angle).all()
    assert np.sum(seen.angle_weight > 0) == each.segment.time.size - 3
    assert np.sum(seen.velocity_weight > 0) == each.segment.time.size


def test_the_noise_is_what_the_sidecar_says_and_the_encoders_step():
    each = movement(one(dropped()), 0, "drop")
    assert each.angle_noise == pytest.approx(NOISE.angle_noise)
    stepped = replace(one(dropped()), sensors=replace(NOISE, encoder_counts=4096.0))
    step = 2 * np.pi / 4096
    expected = np.hypot(NOISE.angle_noise, step / np.sqrt(12))
    assert movement(stepped, 0, "drop").angle_noise == pytest.approx(expected)


def test_noise_that_nobody_declared_is_taken_from_the_data():
    """Third differences leave nothing of the motion; a spread of 2000 samples is known to 3 %."""
    time = np.arange(2000) * 0.005
    motion = exact(LegModel(leg(), NoTorque()), state(-0.2, -0.5), time)
    generator = np.random.default_rng(2)
    for noise in (1e-3, 5e-3):
        angle = motion.raw_angle + noise * generator.normal(size=time.size)
        recording = Recording(
            (Segment(time, raw_angle=angle),), BODY, Protocol(kind="passive"), Sensors()
        )
        found = movement(recording, 0, "drop")
        assert found.angle_noise == pytest.approx(noise, rel=0.1)
        assert found.velocity_noise == np.inf
        assert found.angular_velocity is None


def test_a_filtered_channel_is_fitted_only_where_no_raw_one_is():
    segment = dropped()
    both = replace(
        segment, angle=segment.raw_angle + 0.1, angular_velocity=segment.raw_angular_velocity
    )
    assert not movement(one(both), 0, "drop").filtered
    only = replace(both, raw_angle=None, raw_angular_velocity=None)
    each = movement(one(only), 0, "drop")
    assert each.filtered
    assert np.array_equal(each.angle, each.segment.angle)


def test_segments_of_different_length_share_one_shape(monkeypatch):
    monkeypatch.setattr(observing, "bucket", bucket)
    long, short = (movement(one(dropped(TIME[:n])), 0, "drop") for n in (120, 70))
    seen = observe([long, short], "1/T")
    assert seen.angle.shape == (2, bucket(long.segment.time.size))
    assert np.sum(seen.angle_weight[1] > 0) == short.segment.time.size


def test_what_cannot_be_fitted_is_refused_with_a_reason():
    still = Segment(TIME, raw_angle=np.full(120, -0.2))
    with pytest.raises(ValueError, match="no movement"):
        movement(one(still), 0, "case")
    with pytest.raises(ValueError, match="8 samples"):
        movement(one(dropped(TIME[:8])), 0, "case")
    with pytest.raises(ValueError, match="torque_nm"):
        movement(one(dropped(), "measured"), 0, "case")


def test_a_mass_at_an_unknown_place_is_estimated_with_its_recording():
    loaded = replace(BODY, added_mass=1.0)
    each = [
        movement(one(dropped()), 0, "bare"),
        movement(one(dropped(), subject=loaded), 0, "loaded", 1),
        movement(one(dropped(), subject=replace(loaded, added_mass_distance=0.4)), 0, "known", 2),
        movement(one(dropped(), subject=loaded), 0, "again", 2),
    ]
    assert [one.unplaced for one in each] == [False, True, False, True]
    seen = observe(each, "1/T")
    assert list(seen.owner) == [0, 1, 2, 2]  # one mounting for each recording
    assert list(seen.added_mass_distance) == [0.0, SOMEWHERE, 0.4, SOMEWHERE]
    assert list(seen.added_mass_moves) == [1.0, 1.0, 0.0, 1.0]  # a known place stays
