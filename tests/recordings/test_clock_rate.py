"""A node whose clock is off is put on true time by the host's, or what that does is said."""

import numpy as np
import pytest
from exo_node import EPOCH, GYRO, Node, knee_angle, knee_velocity, write_log

from exoid.recordings.can.clock_rate import CRYSTALLESS, SURE, clock_rate
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.loading.can_log import read_can_log

COUNT_STEP = np.pi / 4096  # rad; half a count of the encoder
QUARTZ = 1e-4  # of the host: no node is known better
LIKELY = 3.0  # stated errors


def read(tmp_path, messages, **options):
    return read_can_log(write_log(tmp_path / "leg.blf", messages), **options)


def true_time(node: Node, ticks: int) -> np.ndarray:
    return np.arange(ticks) * 0.01 / node.skew


def stalled(messages, every: float, longest: float, seed: int):
    """A host that is now and then too busy to read: what came meanwhile is read at once."""
    rng = np.random.default_rng(seed)
    begins = np.arange(0, 100, every) + rng.uniform(0, every / 2, round(100 / every))
    ends = begins + rng.uniform(0, longest, begins.size)
    for each in messages:
        at = np.searchsorted(begins, each.timestamp - EPOCH) - 1
        if at >= 0:
            each.timestamp = max(each.timestamp, EPOCH + ends[at])
    return messages


@pytest.mark.parametrize("skew", [0.98, 0.9975, 1.0025, 1.02])
@pytest.mark.parametrize(("jitter", "stall"), [(0.0, 0.0), (0.0015, 0.0), (0.005, 0.3)])
def test_true_times_are_recovered_within_their_stated_error(tmp_path, skew, jitter, stall):
    node = Node(skew=skew, jitter=jitter)
    messages = stalled(node.messages(3000, seed=4), 2.0, stall, seed=5)
    recording, quality = read(tmp_path, messages)
    segment, stated = recording.segments[0], recording.sensors.clock_uncertainty
    true = true_time(node, 3000)
    assert quality.clock_rate.applied
    assert QUARTZ <= stated < 5e-4  # better by far than the percents that are corrected
    assert np.abs(segment.time - true).max() < LIKELY * stated * true[-1]
    assert quality.skew_ppm == pytest.approx((skew - 1) * 1e6, abs=LIKELY * stated * 1e6)
    # What encoder and gyro say belongs to these times: at 2.7 rad/s and 8 rad/s^2.
    late = LIKELY * stated * true[-1]
    assert np.abs(segment.raw_angle - knee_angle(segment.time)).max() < COUNT_STEP + 2.7 * late
    gyro = segment.raw_angular_velocity - knee_velocity(segment.time)
    assert np.abs(gyro).max() < GYRO + 8.1 * late


def test_stated_errors_cover_many_hosts():
    """Lengths, jitters and stalls as they come: all but a few hundredths within three errors."""
    rng = np.random.default_rng(6)
    found = []
    for _ in range(300):
        skew, seconds, jitter = (
            1 + rng.normal(0, 0.01),
            rng.uniform(3, 60),
            10 ** rng.uniform(-4, -2),
        )
        device = np.arange(0, seconds * skew, 0.01)
        busier = 1 + rng.uniform(0, 2) * (device > rng.uniform(0, device[-1]))
        host = device / skew + rng.exponential(jitter, device.size) * busier
        rate = clock_rate(device, np.maximum.accumulate(host))
        found.append(abs(rate.excess - (skew - 1)) / rate.error)
    assert np.mean(np.array(found) < LIKELY) > 0.97
    assert np.median(found) < 1  # as errors go


@pytest.mark.parametrize("step", [0.05, -0.02, 0.005])
@pytest.mark.parametrize("where", [0.2, 0.5, 0.7])
def test_a_host_whose_clock_is_set_does_not_pass_for_a_node_that_is_off(step, where):
    device = np.arange(0, 30, 0.01)
    host = device + np.random.default_rng(7).exponential(1e-3, device.size)
    rate = clock_rate(device, host + step * (device > where * 30))
    assert abs(rate.excess) < LIKELY * rate.error
    assert not rate.applied


@pytest.mark.parametrize(
    ("ticks", "jitter"),
    [
        (150, 0.001),  # shorter than any fit
        (300, 0.03),  # a host that reads a serial port now and then
    ],
)
def test_where_the_host_cannot_tell_times_stay_and_consequences_are_said(tmp_path, ticks, jitter):
    node = Node(skew=0.98, jitter=jitter)
    recording, quality = read(tmp_path, node.messages(ticks, seed=8))
    np.testing.assert_allclose(recording.segments[0].time, np.arange(ticks) * 0.01, atol=1e-9)
    stated = recording.sensors.clock_uncertainty
    rate = quality.clock_rate
    if rate is None:
        assert stated == CRYSTALLESS
    else:  # between what is usual and what the host hints at: it is 2 %
        assert CRYSTALLESS < stated < abs(rate.excess)
    (line,) = (each for each in quality.lines() if "m l g/J" in each)
    assert f"a rate told from angles and d/J are {100 * stated:.1f} % off" in line
    assert f"m l g/J and c/J {200 * stated:.1f} %; the gyro's rate is right" in line


def test_a_log_without_host_times_says_what_a_clock_may_do(tmp_path):
    node = Node().messages(700)
    for each in node:
        each.timestamp = 0.0
    recording, quality = read(tmp_path, node)
    assert recording.sensors.clock_uncertainty == CRYSTALLESS
    assert any("cannot be told" in line for line in quality.lines())


def test_a_clock_that_is_as_right_as_can_be_told_is_left_alone(tmp_path):
    recording, quality = read(tmp_path, Node().messages(3000))
    np.testing.assert_allclose(recording.segments[0].time, np.arange(3000) * 0.01, atol=1e-9)
    assert not quality.clock_rate.applied
    assert recording.sensors.clock_uncertainty == pytest.approx(QUARTZ, rel=0.3)


def test_without_the_time_frame_the_counters_are_put_on_true_time_too(tmp_path):
    node = Node(skew=1.02)
    heard = [each for each in node.messages(3000) if each.arbitration_id != 0x100]
    recording, _ = read(tmp_path, heard)
    stated = recording.sensors.clock_uncertainty
    true = true_time(node, 3000)
    assert np.abs(recording.segments[0].time - true).max() < LIKELY * stated * true[-1]


def test_a_restart_of_a_node_that_is_off_keeps_its_true_place(tmp_path):
    first = Node(skew=0.98, first_counter=7)
    messages = first.messages(1500)
    messages += Node(skew=0.98, device_start=0.5).messages(700, begin=20.0, seed=1)
    recording, quality = read(tmp_path, messages)
    assert quality.resets[0] == pytest.approx(20.0, abs=0.004)  # host jitter of 1.5 ms
    ends = 20.0 + 6.99 / 0.98
    assert recording.segments[0].time[-1] == pytest.approx(ends, abs=0.004 + 7 * LIKELY * QUARTZ)


def test_marks_made_by_the_nodes_seconds_move_with_its_times(tmp_path):
    marks = Protocol(kind="passive", segment_start=(5.0, 12.0), segment_end=(10.0, 25.0))
    recording, _ = read(tmp_path, Node(skew=0.98).messages(3000), protocol=marks)
    moved = recording.protocol
    assert moved.segment_start == pytest.approx((5 / 0.98, 12 / 0.98), rel=5e-4)
    assert moved.segment_end == pytest.approx((10 / 0.98, 25 / 0.98), rel=5e-4)


def test_what_is_declared_of_the_clock_stands_and_the_filters_step_is_the_nodes(tmp_path):
    known = Sensors(clock_uncertainty=0.0, encoder_counts=4096.0)
    recording, _ = read(tmp_path, Node(skew=0.98).messages(3000), sensors=known)
    assert recording.sensors.clock_uncertainty == 0.0
    assert recording.sensors.filter_step == 0.01
    recording, _ = read(tmp_path, Node(skew=0.98).messages(3000))
    assert recording.sensors.sample_rate == pytest.approx(98, rel=1e-3)


def test_the_report_says_what_was_corrected_and_what_the_filter_did_not_know(tmp_path):
    _, quality = read(tmp_path, Node(skew=0.98).messages(3000))
    (line,) = (each for each in quality.lines() if "times are corrected" in each)
    assert line.startswith("the node's clock runs -2.00 % against")
    assert "its acceleration is +2.04 % off as it was sent" in line


def test_a_host_that_jitters_more_than_a_log_can_average_is_not_believed():
    device = np.arange(0, 4, 0.01)
    late = np.random.default_rng(9).exponential(0.05, device.size)
    rate = clock_rate(device, np.maximum.accumulate(device + late))
    assert rate is None or rate.error > SURE


@pytest.mark.parametrize("pace", [0.1, 0.5, 3.0])
def test_a_log_that_was_played_back_at_another_pace_keeps_the_nodes_times(tmp_path, pace):
    messages = Node().messages(1000, seed=8)
    for each in messages:
        each.timestamp = EPOCH + (each.timestamp - EPOCH) / pace
    recording, quality = read(tmp_path, messages)
    assert quality.clock_rate is None  # no node is so far off
    np.testing.assert_allclose(recording.segments[0].time, np.arange(1000) * 0.01, atol=1e-9)
    assert recording.sensors.clock_uncertainty == CRYSTALLESS
