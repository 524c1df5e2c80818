"""What a filter did to the motion is measured from both channels, and said where it matters."""

import re
from dataclasses import replace

import numpy as np
import pytest
from exo_node import GYRO, Node, knee_angle, knee_velocity, write_log

from exoid.recordings.filter import kalman
from exoid.recordings.filter.effect import MATTERS, filter_effect
from exoid.recordings.loading.can_log import read_can_log
from exoid.recordings.measured.segment import Segment

TIME = np.arange(3000) * 0.01
COUNT = 2 * np.pi / 4096  # rad
CLOSE = 5e-5  # s; noise of 3 counts over a rate of 6 rad/s^2 rms, 3000 samples: 1e-5, five times


def recorded(lag=0.0, gain=1.0, **changes) -> Segment:
    """A leg's swing by encoder and gyro, and `lag` seconds late by a filter."""
    generator = np.random.default_rng(0)
    measured = Segment(
        TIME,
        angle=gain * knee_angle(TIME - lag),
        angular_velocity=gain * knee_velocity(TIME - lag),
        raw_angle=np.rint(knee_angle(TIME) / COUNT) * COUNT,
        raw_angular_velocity=knee_velocity(TIME) + generator.normal(0, 3 * GYRO, TIME.size),
    )
    return replace(measured, **changes)


@pytest.mark.parametrize("lag", [-0.004, 0.0, 0.0007, 0.02, 0.15])
@pytest.mark.parametrize("gain", [1.0, 0.9])
def test_lag_and_gain_of_both_channels_are_found(lag, gain):
    found = filter_effect(recorded(lag, gain)).channels
    assert [each.channel for each in found] == ["angle", "angular_velocity"]
    for each in found:
        assert each.lag == pytest.approx(lag, abs=CLOSE)
        assert each.gain == pytest.approx(gain, rel=1e-3)


def test_the_group_delay_of_a_low_pass_is_found():
    smoothing = 0.7  # of a first-order low pass: its delay at low frequency is a / (1 - a) samples
    slow = knee_angle(TIME)
    for at in range(1, TIME.size):
        slow[at] = smoothing * slow[at - 1] + (1 - smoothing) * slow[at]
    angle = filter_effect(recorded(angle=slow)).channels[0]
    assert angle.lag == pytest.approx(0.01 * smoothing / (1 - smoothing), rel=5e-3)


def test_the_nodes_own_filter_is_late_by_less_than_a_tenth_of_a_millisecond():
    raw = recorded()
    state = kalman.filter(np.diff(TIME), raw.raw_angle, raw.raw_angular_velocity).state
    found = filter_effect(
        replace(raw, angle=np.array(state[:, 0]), angular_velocity=np.array(state[:, 1]))
    )
    assert found.lag < 1e-4
    assert found.lag * found.speed < MATTERS


def test_a_raw_angle_is_fitted_so_nobody_is_warned():
    (line,) = filter_effect(recorded(0.02)).lines()
    assert line.startswith("the node's filter, against the raw samples: angle 20.0")
    assert "rate 20.0" in line


@pytest.mark.parametrize(("lag", "warned"), [(0.02, True), (0.001, True), (0.0001, False)])
def test_a_filtered_angle_that_is_fitted_late_is_named_in_degrees(lag, warned):
    lines = filter_effect(recorded(lag, raw_angle=None)).lines()
    assert len(lines) == 1 + warned
    if warned:
        told = re.search(r"([\d.]+) ms off, that is ([\d.]+) deg at 155 deg/s", lines[1])
        assert float(told[1]) == pytest.approx(lag * 1e3, abs=0.1)
        assert float(told[2]) == pytest.approx(np.degrees(lag * 2.7), abs=0.02)


def test_without_any_raw_sample_the_lag_is_said_to_be_unknown(tmp_path):
    heard = [m for m in Node().messages(700) if m.arbitration_id != 0x102]
    _, quality = read_can_log(write_log(tmp_path / "leg.blf", heard))
    (line,) = (line for line in quality.lines() if "filter" in line)
    assert "how late its filter makes it cannot be told" in line


@pytest.mark.parametrize("angle", [np.full(TIME.size, -1.5), -1.0 + 0.3 * TIME / TIME[-1]])
def test_a_motion_that_cannot_tell_a_lag_tells_none(angle):
    still = recorded(angle=angle, raw_angle=angle)
    assert [each.channel for each in filter_effect(still).channels] in ([], ["angular_velocity"])


def test_a_log_reports_what_its_filter_did(tmp_path):
    _, quality = read_can_log(write_log(tmp_path / "leg.blf", Node().messages(700)))
    assert any(line.startswith("the node's filter") for line in quality.lines())
