"""What was done to the data is done to the simulation: the choice of the chain, and its limits."""

from dataclasses import replace

import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.data.conditioning import SETTLING_SAMPLES, conditioned
from exoid.fitting.data.conditioning_chain import MovingAverage, Raw, SteadyKalman
from exoid.fitting.data.segment import movement
from exoid.physics.leg import LegModel
from exoid.physics.state import LegState
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.sensors import FILTERS, Sensors
from exoid.recordings.filter import kalman
from exoid.recordings.filter.constants import DESIGNS
from exoid.recordings.measured.segment import Segment
from fit_cases import exact, leg, one, state

STEP = 0.01
TIME = np.arange(200) * STEP


def drop(time=TIME) -> Segment:
    return exact(LegModel(leg(), NoTorque()), state(-0.2, -0.8), time)


def filtered(segment: Segment, velocity: bool = True) -> Segment:
    """The same samples, said to have passed the firmware's filter."""
    rate = segment.raw_angular_velocity if velocity else None
    return Segment(segment.time, angle=segment.raw_angle, angular_velocity=rate)


def moved(segment: Segment, name: str = "0"):
    return movement(one(segment), 0, name)


def test_raw_channels_are_fitted_as_they_are():
    each = moved(drop())
    chain, (after,) = conditioned([each], 1)
    assert chain == Raw()
    assert after is each


def test_filtered_channels_are_met_by_the_same_filter_once_it_has_settled():
    chain, (after,) = conditioned([moved(filtered(drop()))], 1)
    assert chain == SteadyKalman(STEP, "3 states")  # of a file that does not say
    assert np.isnan(after.angle[:SETTLING_SAMPLES]).all()
    assert np.isfinite(after.angle[SETTLING_SAMPLES:]).all()
    assert np.isnan(after.angular_velocity).sum() == SETTLING_SAMPLES


def test_a_filtered_angle_without_its_velocity_is_fitted_as_it_is():
    chain, _ = conditioned([moved(filtered(drop(), velocity=False))], 1)
    assert chain == Raw()


@pytest.mark.parametrize("window", [2, 5, 50])
def test_every_mean_is_that_of_the_window_that_ends_at_its_sample(window):
    each = moved(drop())
    chain, (after,) = conditioned([each], window)
    assert chain == MovingAverage(window)
    assert np.isnan(after.angle[: window - 1]).all()
    for at in (window - 1, 100, each.angle.size - 1):
        mean = each.angle[at - window + 1 : at + 1].mean()
        assert after.angle[at] == pytest.approx(mean, abs=1e-14)  # rounding of a sum
    assert after.angular_velocity.size == each.angular_velocity.size


def test_a_window_longer_than_a_swing_is_refused():
    with pytest.raises(ValueError, match=r"segment 3: a moving average over 51 .* at most 50"):
        conditioned([moved(drop(), "3")], 51)


def test_smoothing_what_was_filtered_already_is_refused():
    with pytest.raises(ValueError, match="raw_angle_rad is missing"):
        conditioned([moved(filtered(drop()))], 3)


@pytest.mark.parametrize("window", [1, 3])
def test_uneven_sampling_is_refused_where_samples_are_counted(window):
    uneven = drop(np.cumsum(np.random.default_rng(0).uniform(0.006, 0.014, 200)))
    segment = uneven if window > 1 else filtered(uneven)
    with pytest.raises(ValueError, match="segment 2 is not sampled evenly"):
        conditioned([moved(segment, "2")], window)


def test_sampling_slower_than_the_simulations_step_is_refused_for_a_filter():
    with pytest.raises(ValueError, match="at 50 Hz or more"):
        conditioned([moved(filtered(drop(np.arange(100) * 0.025)))], 1)


def test_filtered_segments_of_different_sample_times_are_refused():
    slow = drop(np.arange(120) * 0.02)
    with pytest.raises(ValueError, match=r"every 0\.01 s and every 0\.02 s"):
        conditioned([moved(filtered(drop())), moved(filtered(slow))], 1)


def test_a_filter_is_simulated_by_the_clock_it_reckoned_with():
    """Times were corrected by 2 % since; the node took its steps for 10 ms."""
    slow = filtered(drop(TIME * 1.02))
    declared = replace(one(slow), sensors=Sensors(filter_step=STEP))
    chain, _ = conditioned([movement(declared, 0, "0")], 1)
    assert chain == SteadyKalman(STEP)
    chain, _ = conditioned([moved(slow)], 1)
    assert chain == SteadyKalman(0.0102)


def passed(chain, angle, rate):
    """Angle and velocity that come out of a chain."""
    readings = [LegState(*map(jnp.asarray, now)) for now in zip(angle, rate, strict=True)]
    memory, shown = chain.begin(readings[0]), []
    for now in readings:
        memory, out = chain.push(memory, now)
        shown.append([float(out.angle), float(out.angular_velocity)])
    return np.array(shown)


def swing_after(rest: int, scale: float):
    """Readings of a leg that is held still for so many samples and then let go."""
    swing = exact(LegModel(leg(), NoTorque()), state(-0.2, 0.0), TIME)
    held = np.full(rest, swing.raw_angle[0]), np.zeros(rest)
    pairs = zip(held, (swing.raw_angle, scale * swing.raw_angular_velocity), strict=True)
    return [np.concatenate(pair) for pair in pairs]


def sent_by_node(angle, rate, name):
    steps = np.full(angle.size - 1, STEP)
    return np.asarray(kalman.filter(steps, angle, rate, DESIGNS[name]).state)[:, :2]


@pytest.mark.parametrize(("name", "other"), [FILTERS, FILTERS[::-1]])
@pytest.mark.parametrize("bias", [0.0, 0.05])
def test_what_the_simulation_passes_is_what_the_node_did(name, other, bias):
    """Of a log that began 20 s before the movement, so that the node has learned its gyro's bias.

    A filter that knows of no bias leaves it in the velocity, and lets it pull at the angle. One
    that estimates a bias takes what the gyro's scale is off, here 3 %, for a little of one.
    """
    rest = 2000
    angle, rate = swing_after(rest, 1.03)
    sent = sent_by_node(angle, rate + bias, name)[rest:]
    said = 0.0 if name == "4 states" else bias  # what is left of it in the log

    def off(design):
        shown = passed(SteadyKalman(STEP, design), angle[rest:], rate[rest:] + said)
        return np.abs(shown - sent)[SETTLING_SAMPLES:].max(axis=0)

    # An eighth of the encoder's last bit, which the bias has left at the angle of three states, and
    # a twentieth of the gyro's.
    assert (off(name) < (2e-4, 6e-5)).all(), off(name)
    assert off(other)[1] > 10 * 6e-5


@pytest.mark.parametrize(("rest", "most"), [(150, 5e-3), (300, 2e-3), (500, 5e-4)])
def test_what_the_node_still_learns_of_a_bias_is_lost_within_5_seconds(rest, most):
    """The simulation passes a settled filter. One that began so many samples before takes more of a
    gyro's scale, here 1 % off, for bias; one sample of the gyro has 2.5e-3 rad/s of noise.
    """
    angle, rate = swing_after(rest, 1.01)
    sent = sent_by_node(angle, rate + 0.05, "4 states")[rest:]
    shown = passed(SteadyKalman(STEP, "4 states"), angle[rest:], rate[rest:])
    off = np.abs(shown - sent)[SETTLING_SAMPLES:, 1].max()
    assert most / 4 < off < most


def test_a_recording_says_which_filter_it_went_through():
    declared = replace(one(filtered(drop())), sensors=Sensors(filter="4 states"))
    chain, _ = conditioned([movement(declared, 0, "0")], 1)
    assert chain == SteadyKalman(STEP, "4 states")


def test_movements_of_two_filters_are_refused():
    declared = replace(one(filtered(drop())), sensors=Sensors(filter="4 states"))
    with pytest.raises(ValueError, match="filters of 3 states and of 4 states"):
        conditioned([movement(declared, 0, "0"), moved(filtered(drop()))], 1)
