"""Averaging, clipping and splitting against signals whose answer is known in closed form."""

from dataclasses import replace

import jax.numpy as jnp
import numpy as np
import pytest

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import (
    best_velocity,
    classify,
    clip,
    moving_average,
    stays,
    torque_frequencies,
)
from exoid.recordings.splitting.split import measure_period, split

STEP = 0.01  # s


def cycle(period, step=STEP, low=-np.pi / 2):
    """A raised cosine from 0 down to `low` and back."""
    time = np.arange(0, period + step / 2, step)
    return low / 2 * (1 - np.cos(2 * np.pi * time / period))


def drop(start, duration=6.0, step=STEP):
    """A released leg: a damped swing about -72 deg, natural frequency 5.7 rad/s."""
    time = np.arange(0, duration, step)
    rest = np.radians(-72)
    swing = np.exp(-0.9 * time) * (np.cos(5.7 * time) + 0.9 / 5.7 * np.sin(5.7 * time))
    return rest + (start - rest) * swing


def lift(start, end, step=STEP):
    return start + (end - start) / 2 * (1 - np.cos(np.pi * np.arange(0, 1, step)))


def hold(angle, duration=1.5):
    return np.full(round(duration / STEP), angle)


def log_of(parts, noise=0.0):
    """A continuous log of the parts, and the start and end [s] of each."""
    angle = np.concatenate(parts)
    edges = np.cumsum([0, *map(len, parts)]) * STEP
    angle = angle + np.random.default_rng(0).normal(0, noise, angle.size)
    return Segment(time=np.arange(angle.size) * STEP, raw_angle=angle), edges


@pytest.mark.parametrize("seed", range(6))
def test_a_leg_that_stays_where_it_is_makes_no_movement_of_any_kind(seed):
    """A knee that is locked: what noise makes of its ends is neither a cycle nor a drop."""
    angle = np.radians(-41) + np.random.default_rng(seed).normal(0, 3e-3, 4000)
    locked = Segment(time=np.arange(4000) * STEP, raw_angle=angle)
    assert classify(locked) is None
    assert stays(locked)
    swings = Segment(time=np.arange(600) * STEP, raw_angle=drop(np.radians(-68)))
    assert classify(swings) == "passive"
    assert not stays(swings)


@pytest.fixture(scope="module")
def session():
    """Two drops with the lift between them, then three cycles; rests everywhere."""
    up, down = -0.3, np.radians(-72)
    parts = [hold(up), drop(up), hold(down), lift(down, 0.0), hold(0.0), drop(0.0), hold(down)]
    parts += [lift(down, 0.0), hold(0.0), cycle(1.8), hold(0.0), cycle(3.0), hold(0.0)]
    parts += [cycle(5.0), hold(0.0)]
    return log_of(parts, noise=6e-4)


@pytest.mark.parametrize("array", [np.asarray, jnp.asarray])
def test_the_moving_average_is_the_sum_of_equation_3(array):
    samples = np.random.default_rng(0).normal(size=50)
    expected = [np.mean(samples[i : i + 7]) for i in range(44)]
    np.testing.assert_allclose(moving_average(array(samples), 7), expected, rtol=1e-5)


def test_a_window_of_one_sample_changes_nothing():
    samples = np.random.default_rng(0).normal(size=20)
    np.testing.assert_array_equal(moving_average(samples, 1), samples)


@pytest.mark.parametrize(
    ("period", "window", "fundamental", "third"),
    [(1.8, 10, 0.995, 0.955), (1.8, 20, 0.980, 0.827), (1.8, 50, 0.878, 0.191)],
)
def test_the_moving_average_takes_from_each_harmonic_what_a_window_must(
    period, window, fundamental, third
):
    time = np.arange(0, 5 * period, STEP)
    for harmonic, gain in ((1, fundamental), (3, third)):
        tone = np.exp(2j * np.pi * harmonic * time / period)
        averaged = moving_average(tone, window) / tone[: time.size - window + 1]
        np.testing.assert_allclose(abs(averaged), gain, atol=6e-4)


def test_a_missing_sample_spoils_only_the_windows_that_hold_it():
    samples = np.ones(30)
    samples[12] = np.nan
    assert np.flatnonzero(np.isnan(moving_average(samples, 5))).tolist() == [8, 9, 10, 11, 12]


def test_a_window_longer_than_the_record_is_refused():
    with pytest.raises(ValueError, match="window between 1 and 4"):
        moving_average(np.zeros(4), 5)


def test_clipping_keeps_the_turn_and_both_directions():
    angle = np.concatenate([hold(0.0), cycle(3.0), hold(0.0)])
    velocity = np.gradient(angle, STEP)
    kept = clip(velocity)
    limit = np.radians(20)
    assert abs(velocity[kept.start]) > limit >= abs(velocity[kept.start - 1])
    assert abs(velocity[kept.stop - 1]) > limit >= abs(velocity[kept.stop])
    assert (abs(velocity[kept]) < limit).any()  # the turn at the bottom is still there
    assert velocity[kept].min() < -limit
    assert velocity[kept].max() > limit


def test_clipping_a_still_leg_is_refused():
    with pytest.raises(ValueError, match="no sample moves faster than 20 deg/s"):
        clip(np.zeros(50))


def test_equation_4_has_two_readings():
    assert torque_frequencies(2.0) == {"1/T": 0.5, "2/T": 1.0}


def test_a_continuous_log_splits_into_its_drops_and_cycles(session):
    log, edges = session
    found = split(Recording((log,)))
    assert found.protocol.kind == ("passive", "passive", "active", "active", "active")
    fast = np.abs(best_velocity(log)) > np.radians(5)
    for segment, part in zip(found.segments, [1, 5, 9, 11, 13], strict=True):
        at = np.flatnonzero(log.raw_angle == segment.raw_angle[0])[0]  # noise makes it unique
        assert segment.time[0] == 0
        assert np.flatnonzero(fast[at:])[0] * STEP == pytest.approx(0.5, abs=0.03)  # kept rest
        assert log.time[at] + 0.5 == pytest.approx(edges[part], abs=0.08)


def test_the_period_of_a_cycle_is_measured_from_onset_to_return(session):
    log, _ = session
    periods = split(Recording((log,))).protocol.cycle_period
    assert np.isnan(periods[:2]).all()
    # Of a 12-bit angle alone, either end is found to about 10 ms.
    np.testing.assert_allclose(periods[2:], (1.8, 3.0, 5.0), atol=0.03)


def test_a_filtered_velocity_gives_the_same_split_as_the_raw_angle(session):
    log, _ = session
    filtered = replace(log, angle=log.raw_angle, angular_velocity=best_velocity(log))
    one, other = split(Recording((log,))), split(Recording((filtered,)))
    for a, b in zip(one.segments, other.segments, strict=True):
        assert abs(a.time.size - b.time.size) <= 2


def test_missing_samples_and_an_uneven_clock_do_not_change_what_is_found(session):
    log, _ = session
    rng = np.random.default_rng(1)
    kept = np.sort(rng.choice(log.time.size, log.time.size * 9 // 10, replace=False))
    angle = log.raw_angle[kept].copy()
    angle[rng.choice(kept.size, 40, replace=False)] = np.nan
    uneven = Segment(time=log.time[kept], raw_angle=angle)
    assert split(Recording((uneven,))).protocol.kind == split(Recording((log,))).protocol.kind


def test_marks_say_where_the_segments_are(session):
    log, edges = session
    marks = {"segment_start": (edges[1], edges[9]), "segment_end": (edges[2], edges[10])}
    protocol = Protocol(kind=("passive", "active"), cycle_period=(np.nan, 1.8), **marks)
    subject = Subject(added_mass=(1.0, 0.0), added_mass_distance=(0.4, np.nan))
    found = split(Recording((log,), subject=subject, protocol=protocol))
    assert len(found.segments) == 2
    for segment, start, end in zip(found.segments, *marks.values(), strict=True):
        inside = (log.time >= start) & (log.time <= end)
        np.testing.assert_array_equal(segment.raw_angle, log.raw_angle[inside])
        assert segment.time[0] == 0
    assert found.cycle_period(0) is None
    assert found.cycle_period(1) == 1.8
    assert (found.added_mass(0), found.added_mass(1)) == (1.0, 0.0)
    assert found.added_mass_distance(1) is None
    assert split(found) is found


def test_a_mark_outside_the_log_is_refused(session):
    log, _ = session
    protocol = Protocol(segment_start=(1.0, 500.0), segment_end=(3.0, 510.0))
    with pytest.raises(ValueError, match="segment 1 is marked from 500 to 510 s"):
        split(Recording((log,), protocol=protocol))


def test_a_log_without_movement_is_refused():
    log, _ = log_of([hold(0.0, 3.0)], noise=6e-4)
    with pytest.raises(ValueError, match="no movement was found"):
        split(Recording((log,)))


def test_a_leg_that_only_goes_up_is_neither_drop_nor_cycle():
    log, _ = log_of([hold(-1.2), lift(-1.2, 0.0), hold(0.0)])
    assert classify(log) is None


def test_a_still_segment_has_no_period():
    log, _ = log_of([hold(0.0, 3.0)])
    assert np.isnan(measure_period(log, Sensors()))


@pytest.mark.parametrize("noise", [1e-3, 0.01])
def test_a_drop_with_the_lift_after_it_is_no_voluntary_movement(noise):
    time = np.arange(0, 6, 0.01)
    swing = -1.4 + 1.2 * np.exp(-0.4 * time) * np.cos(6.2 * time)
    lifted = np.clip(time - 4.5, 0, 1) * (-0.25 - swing[450])
    angle = np.where(time < 4.5, swing, swing[450] + lifted)
    angle = angle + noise * np.random.default_rng(0).normal(size=time.size)
    assert classify(Segment(time, raw_angle=angle)) == "passive"
    voluntary = -1.4 + 0.6 * (1 - np.cos(2 * np.pi * np.minimum(time, 2) / 2))
    assert classify(Segment(time, raw_angle=voluntary)) == "active"


def test_a_drop_that_is_hardly_damped_is_one_although_it_ends_near_its_start():
    time = np.arange(0, 6, 0.01)
    swing = -1.3 + 1.1 * np.exp(-0.13 * time) * np.cos(5.8 * time)  # each 0.93 of the last
    through = time < 1.0 + 2 * np.pi / 5.8 * 4  # ends in its fifth swing upwards
    assert classify(Segment(time[through], raw_angle=swing[through])) == "passive"
    again = -0.5 + 0.5 * np.cos(2 * np.pi * time / 1.5)  # four cycles of a muscle that tires
    tired = again * (1 - 0.05 * np.floor(time / 1.5))
    assert classify(Segment(time, raw_angle=tired)) == "active"


@pytest.mark.parametrize("begin", [0.3, 0.8, 1.3])
@pytest.mark.parametrize("lasting", [0.3, 0.6])
def test_a_drop_with_a_hole_and_the_lift_after_it_is_no_voluntary_movement(begin, lasting):
    time = np.arange(0, 9, 0.01)
    swing = -1.4 + 1.2 * np.exp(-0.3 * time) * np.cos(5.5 * time)
    lifted = np.clip(time - 7.5, 0, 1) * (-0.2 - swing[750])
    angle = np.where(time < 7.5, swing, swing[750] + lifted)
    hole = (time > begin) & (time < begin + lasting)
    assert classify(Segment(time, raw_angle=np.where(hole, np.nan, angle))) == "passive"
    assert classify(Segment(time[~hole], raw_angle=angle[~hole])) == "passive"


@pytest.mark.parametrize("begin", [0.5, 2.0, 3.2])
def test_voluntary_cycles_stay_voluntary_whatever_hole_they_have(begin):
    """Each less far than the one before, but all from one angle, as no free leg swings."""
    time = np.arange(0, 8, 0.01)
    far = 1.0 * 0.8 ** np.floor(time / 2)
    angle = -1.4 + far * (1 - np.cos(np.pi * time)) / 2
    angle = angle + 1e-3 * np.random.default_rng(0).normal(size=time.size)
    hole = (time > begin) & (time < begin + 0.6)
    assert classify(Segment(time, raw_angle=np.where(hole, np.nan, angle))) == "active"
