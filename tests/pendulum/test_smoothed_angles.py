"""What drops say of an angle that somebody has smoothed."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import butter, filtfilt

from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.sensors import Sensors
from swings import NOISE, Oscillator, drop

CAMERA = np.radians(0.3)


def smoothed(cutoff, noise=CAMERA, step=0.01, seed=0):
    """As motion capture is exported: Butterworth of second order, forwards and backwards."""
    made = drop(noise=noise, step=step, seed=seed)
    (segment,) = made.segments
    name = "raw_angle" if segment.raw_angle is not None else "angle"
    rate = 1 / np.median(np.diff(segment.time))
    angle = filtfilt(*butter(2, cutoff / (rate / 2)), getattr(segment, name))
    return replace(made, segments=(replace(segment, **{name: angle}),), sensors=Sensors())


def only(recording):
    (found,) = measure_drops(recording).drops
    assert found.reason is None
    return found


def errors(found):
    return [each.standard_error for each in found.measures.values() if each.value is not None]


def test_an_angle_as_a_sensor_gives_it_has_errors_and_no_note():
    found = only(replace(drop(noise=NOISE), sensors=Sensors()))
    assert found.note is None
    assert all(errors(found))


def test_errors_of_a_smoothed_angle_are_said_to_leave_out_what_the_filter_takes():
    found = only(smoothed(6.0))
    assert found.note is not None
    assert "alike over 0." in found.note
    assert all(errors(found))


@pytest.mark.parametrize("noise", [CAMERA, 0.0])
def test_where_a_filter_left_less_noise_than_sensors_have_no_error_is_told(noise):
    """A camera's drop through 3 Hz had a first swing 0.2 deg off, with an error of 0.001 deg."""
    found = only(smoothed(3.0, noise))
    assert found.note is not None
    assert found.note.startswith("no ±")
    assert errors(found) == [None] * len(errors(found))


def test_a_noise_that_is_declared_counts():
    quiet = replace(smoothed(3.0), sensors=Sensors(angle_noise=1e-5))
    found = only(quiet)
    assert all(errors(found))


@pytest.mark.parametrize("rate", [25.0, 30.0, 60.0])
def test_errors_of_a_smoothed_angle_hold_how_it_scatters(rate):
    """Of a smoothed camera of 30 Hz they were up to 20 times too small, and nothing was said."""
    leg, off = Oscillator(), []
    fastest = -leg.velocity(np.arctan2(leg.frequency, leg.decay) / leg.frequency)
    for seed in range(8):
        found = only(smoothed(6.0, step=1 / rate, seed=seed))
        assert found.note is not None
        for name, truth in (("period", leg.period), ("peak_flexion_velocity", fastest)):
            each = found.measures[name]
            assert each.value is not None
            assert each.standard_error is not None
            off.append((each.value - truth) / each.standard_error)
    assert np.sqrt(np.mean(np.square(off))) < 1.7  # of 16, once in 10^4
