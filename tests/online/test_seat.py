"""What is known of the seat and of the knee's spring, against what the drops say."""

from dataclasses import replace

import numpy as np
import pytest

from exoid import online


@pytest.mark.parametrize("tilt", [4.0, -4.0])
def test_where_the_spring_rests_elsewhere_no_number_is_told(play, start, tilt):
    # Twenty times what a seat that looks level is tilted by: the ratios are then as wrong, by
    # dozens of their errors, however well the motion is followed.
    samples, leg, _ = play(4, 2, legs=lambda leg: [replace(leg, tilt=np.radians(tilt))] * 2)
    _, said = online.replay(start, samples)
    off = np.abs(said.ratios[-1] - [leg.gravity, leg.stiffness, leg.damping]) / said.errors[-1]
    assert off.max() > 10
    assert said.trust[-1] == online.Trust.UNEXPLAINED


def test_a_seat_as_level_as_it_looks_is_believed(play, start):
    # Two standard deviations: one recording in twenty is tilted more.
    samples, *_ = play(4, 2, legs=lambda leg: [replace(leg, tilt=np.radians(0.4))] * 2)
    _, said = online.replay(start, samples)
    assert not (said.trust == online.Trust.UNEXPLAINED).any()
