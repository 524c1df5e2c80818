"""What is known of the seat and of the knee's spring, against what the drops say."""

from dataclasses import replace

import numpy as np
import pytest

from exoid import online


@pytest.mark.parametrize("tilt", [4.0, -4.0])
def test_where_the_spring_rests_elsewhere_no_number_is_told(play, start, sure, tilt):
    # Twenty times what the seat is tilted by, as declared: the ratios are then as wrong, by dozens
    # of their errors, however well the motion is followed.
    samples, leg, _ = play(4, 2, legs=lambda leg: [replace(leg, tilt=np.radians(tilt))] * 2)
    _, said = online.replay(start, samples, sure)
    assert off(said, leg).max() > 10
    assert said.trust[-1] == online.Trust.UNEXPLAINED


@pytest.mark.parametrize("slant", [4.0, -2.0])
def test_a_foot_that_puts_the_mass_beside_the_line_is_in_the_errors(play, start, slant):
    samples, leg, _ = play(4, 2, legs=lambda leg: [replace(leg, tilt=np.radians(slant))] * 2)
    _, said = online.replay(start, samples)
    assert off(said, leg).max() < 3
    assert not (said.trust == online.Trust.UNEXPLAINED).any()


def test_a_spring_that_rests_where_no_foot_puts_the_mass_is_no_leg_that_is_told(play, start):
    samples, *_ = play(4, 2, legs=lambda leg: [replace(leg, tilt=np.radians(20.0))] * 2)
    _, said = online.replay(start, samples)
    assert said.trust[-1] == online.Trust.UNEXPLAINED


def test_a_clock_that_may_be_what_encoder_and_gyro_disagree_by_is_in_the_errors(play, start, sure):
    samples, leg, _ = play(4, 2)
    fast = replace(samples, time=samples.time * 1.015)
    _, said = online.replay(start, fast)
    assert off(said, leg).max() < 3
    _, trusting = online.replay(start, fast, sure)
    assert off(trusting, leg).max() > 10


@pytest.mark.parametrize("rate", [0.93, 1.1])
def test_a_clock_that_is_far_off_is_in_the_errors_as_one_that_is_a_little(play, start, rate):
    samples, leg, _ = play(4, 2)
    _, said = online.replay(start, replace(samples, time=samples.time * rate))
    assert off(said, leg).max() < 2.5


def off(said, leg) -> np.ndarray:
    """How many of their errors the ratios are off."""
    return np.abs(said.ratios[-1] - [leg.gravity, leg.stiffness, leg.damping]) / said.errors[-1]


def test_a_seat_as_level_as_it_looks_is_believed(play, start):
    # Two standard deviations: one recording in twenty is tilted more.
    samples, *_ = play(4, 2, legs=lambda leg: [replace(leg, tilt=np.radians(0.4))] * 2)
    _, said = online.replay(start, samples)
    assert not (said.trust == online.Trust.UNEXPLAINED).any()
