"""Encoder against gyro, before any dynamics."""

from dataclasses import replace

import equinox as eqx
import numpy as np
import pytest
from scipy.signal import butter, lfilter, lfilter_zi

from exoid.fitting.data.observe import observe
from exoid.fitting.data.segment import movement
from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.sensors.compare import compare
from exoid.mismatch.sensors.consistency import consistency, segment
from exoid.mismatch.sensors.faults import USUAL
from exoid.mismatch.sensors.strikes import strikes
from fit_cases import DROP, recorded
from legs import drop, fall, recording

TRUE = {"gyro_scale": -0.128, "gyro_bias": 0.01, "sensor_skew": 0.006}


def seen(seed=0):
    session = recorded(DROP, DROP, seed=seed)
    return observe([movement(session, k, str(k)) for k in range(2)], "1/T")


def spoiled(observation, scale=0.0, bias=0.0, delay=0.0):
    """The observation as a wrong gyro would have shown it."""
    rows = [
        (1 + scale) * np.interp(time - delay, time, rate) + bias
        for time, rate in zip(observation.time, observation.angular_velocity, strict=True)
    ]
    return eqx.tree_at(lambda o: o.angular_velocity, observation, np.stack(rows))


@pytest.mark.parametrize("name", TRUE)
def test_what_the_gyro_does_wrong_is_measured(name):
    wrong = {"gyro_scale": "scale", "gyro_bias": "bias", "sensor_skew": "delay"}[name]
    found = consistency(spoiled(seen(), **{wrong: TRUE[name]}), Yardstick)
    each = {error.name: error for error in found.errors}
    for other, error in each.items():
        # The interpolation that delays the gyro here smooths its noise: a percent of the delay.
        true = TRUE[name] if other == name else 0.0
        assert abs(error.value - true) < 5 * error.standard_error + 0.01 * abs(true)
    assert each[name].clear


@pytest.mark.parametrize("corner", [4.0, 6.0, 12.0])  # Hz
def test_a_gyro_behind_a_slow_filter_is_late_by_its_group_delay(corner):
    """The leg's own 0.9 Hz is well below, where the filter is a delay of sqrt(2) / (2 pi f), f
    warped by the bilinear transform.
    """
    observation = seen()
    time, rates = np.asarray(observation.time), np.asarray(observation.angular_velocity)
    rate = 1 / np.median(np.diff(time[0]))
    low = butter(2, corner, fs=rate)
    smooth = np.stack([lfilter(*low, row, zi=lfilter_zi(*low) * row[0])[0] for row in rates])
    slow = eqx.tree_at(lambda o: o.angular_velocity, observation, smooth)
    drops = [segment(slow, number) for number in range(2)]
    scale, bias, skew = compare(drops, [strikes(*each) for each in drops], USUAL).values
    assert skew == pytest.approx(np.sqrt(0.5) / rate / np.tan(np.pi * corner / rate), rel=0.02)
    assert abs(scale) < 0.02  # second order in the delay: (2 pi 0.9 Hz * 0.056 s)^4 / 8
    assert abs(bias) < 0.01


def test_sound_sensors_are_called_sound():
    found = [error for seed in range(6) for error in consistency(seen(seed), Yardstick).errors]
    assert not any(error.clear for error in found)


def test_the_errors_scatter_as_they_say():
    # 18 values: their mean square is 1 within 0.7 (two standard deviations).
    scores = [
        e.value / e.standard_error
        for seed in range(6)
        for e in consistency(seen(seed), Yardstick).errors
    ]
    assert 0.3 < np.mean(np.square(scores)) < 1.9


def test_without_a_gyro_nothing_is_said_of_it():
    observation = seen()
    blind = eqx.tree_at(
        lambda o: o.velocity_weight, observation, np.zeros_like(observation.velocity_weight)
    )
    assert consistency(blind, Yardstick).errors == []


def test_samples_of_a_buffer_that_is_emptied_at_once_are_compared():
    """Every tenth waits for the next, and both are stamped 10 us apart."""
    observation = seen()
    time = np.array(observation.time)
    time[:, 5:-1:10] = time[:, 6::10] - 1e-5
    found = consistency(eqx.tree_at(lambda o: o.time, observation, time), Yardstick)
    for number, reference in enumerate(found.references):
        rows = slice(0, reference.angle.size)
        measured = observation.angle_weight[number][rows] > 0
        off = reference.angle - observation.angle[number][rows]
        assert np.abs(off[measured]).max() < 0.1  # rad: 10 ms at 5 rad/s, and noise


@pytest.mark.parametrize("late", [(0.006, 0.006), (0.004, -0.009), (0.0, 0.003)])
def test_delays_that_differ_are_told_of_each_segment(late):
    """The gyro's times of two drops, moved; where both are moved alike, one delay is told."""
    observation = seen()
    rows = zip(observation.time, observation.angular_velocity, late, strict=True)
    moved = np.stack([np.interp(time - by, time, rate) for time, rate, by in rows])
    moved = eqx.tree_at(lambda o: o.angular_velocity, observation, moved)
    (skew,) = (one for one in consistency(moved, Yardstick).errors if one.name == "sensor_skew")
    assert [one.number for one in skew.own] == ([] if len({*late}) == 1 else [0, 1])
    for one in skew.own:  # what interpolation smooths of the noise: as in the tests above
        assert abs(one.value - late[one.number]) < 5 * one.standard_error + 1e-4


def test_recordings_may_each_have_their_own_delay():
    """As two loggers: a model has a delay of each, and nothing differs that it does not have."""
    observation = seen()
    shift = np.array([0.004, -0.009])[:, None]
    rows = zip(
        observation.time - shift, observation.time, observation.angular_velocity, strict=True
    )
    late = np.stack([np.interp(*row) for row in rows])
    both = eqx.tree_at(lambda o: o.angular_velocity, observation, late)
    both = eqx.tree_at(lambda o: o.owner, both, np.array([0, 1]))
    assert not any(one.own for one in consistency(both, Yardstick).errors)


def sunk(observation, by):
    """An encoder of the knee, of whose drops the thigh sinks so far [rad] as they begin."""
    angles = [
        angle + each / 2 * (1 + np.tanh((time - 0.3) / 0.2))
        for time, angle, each in zip(observation.time, observation.angle, by, strict=True)
    ]
    return eqx.tree_at(lambda o: o.angle, observation, np.stack(angles))


@pytest.mark.parametrize("by", [(0.03, 0.07), (0.07, 0.035)])
def test_a_thigh_that_sinks_is_no_clock_that_differs_from_drop_to_drop(by):
    """The gyro shows how fast the leg turns in space. By all of a drop it seems late by its own."""
    assert not any(one.own for one in consistency(sunk(seen(), by), Yardstick).errors)


def test_a_thigh_that_rocks_is_no_clock_either():
    """3 deg at the leg's own pace, and no less as the swing becomes smaller."""
    rocked = seen()
    angles = np.stack(
        [
            angle + 0.05 * np.sin(5.6 * time + phase)
            for time, angle, phase in zip(rocked.time, rocked.angle, (0.0, 0.0), strict=True)
        ]
    )
    rocked = eqx.tree_at(lambda o: o.angle, rocked, angles)
    errors = {one.name: one for one in consistency(rocked, Yardstick).errors}
    assert not any(one.own for one in errors.values())
    larger, smaller = errors["sensor_skew"].by_size
    assert abs(smaller) > 1.25 * abs(larger)


def test_a_delay_is_as_long_in_small_swings():
    for late in (0.006, -0.02):
        assert not any(
            one.by_size for one in consistency(spoiled(seen(), delay=late), Yardstick).errors
        )


@pytest.mark.parametrize("late", [0.005, 0.006, 0.008])
def test_a_delay_is_as_long_in_the_first_fall_of_a_leg_that_hardly_swings(late):
    """Its larger half ends in full flight: a sample that the gyro's shift leaves without a rate
    was taken there for a leg at rest.
    """
    falls = [fall((26.0, 4.0, 2.3), start=start) for start in (-0.45, -0.2, -0.3)]
    shown = [drop((26.0, 4.0, 2.3), start=fell[1][0], seed=seed) for seed, fell in enumerate(falls)]
    delayed = [
        replace(
            each,
            raw_angular_velocity=each.raw_angular_velocity
            - velocity
            + np.interp(time - late, time, velocity),
        )
        for each, (time, _, velocity) in zip(shown, falls, strict=True)
    ]
    session = recording(*delayed)
    observation = observe([movement(session, k, str(k)) for k in range(3)], "1/T")
    errors = {one.name: one for one in consistency(observation, Yardstick).errors}
    assert errors["sensor_skew"].value == pytest.approx(late, rel=0.02)
    assert not errors["sensor_skew"].by_size


def test_a_clock_that_differs_from_drop_to_drop_is_told():
    observation = seen()
    shift = np.array([0.002, 0.0035])[:, None]
    rows = zip(
        observation.time - shift, observation.time, observation.angular_velocity, strict=True
    )
    late = eqx.tree_at(
        lambda o: o.angular_velocity, observation, np.stack([np.interp(*row) for row in rows])
    )
    (own,) = (one.own for one in consistency(late, Yardstick).errors if one.own)
    for each, true in zip(own, (0.002, 0.0035), strict=True):
        assert abs(each.value - true) < 5 * each.standard_error + 0.02 * true
