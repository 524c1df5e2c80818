"""A hand that lets go slowly: the fall that it led is left out, and the swings after it count."""

import numpy as np
import pytest

import exoid
from exoid import online
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from hands import ADULT as KNEE
from hands import Device, Hand, dropped
from reflexes import ADULT, measured, stretched

STARTS = (-0.3, -0.2, -0.35)  # rad


def followed(*segments):
    """What is said at the end of these drops, one after the other."""
    recording = Recording(segments, Subject(kind="leg"))
    model = online.Model(node=online.node_of(recording))
    begun = online.init(exoid.expected_leg(74.0, 1.78), model)
    return online.replay(begun, online.samples_of(recording), model)[1]


@pytest.mark.parametrize("fade", [0.35, 0.5])
@pytest.mark.parametrize("gyro", [3e-3, None])
def test_swings_count_after_a_fall_that_a_hand_led(fade, gyro):
    each = [
        dropped(
            hand=Hand(start, hold=1.0, fade=fade), device=Device(gyro=gyro), lasting=9.0, seed=seed
        )
        for seed, start in enumerate(STARTS)
    ]
    said = followed(*(recording.segments[0] for recording, _ in each))
    assert said.trust[-1] in (online.Trust.GOOD, online.Trust.ENOUGH)
    assert said.drops[-1] >= 2
    truth = np.array([KNEE.gravity, KNEE.stiffness, KNEE.damping])
    assert (np.abs(said.ratios[-1] - truth) < 4 * said.errors[-1]).all()


@pytest.mark.parametrize("gain", [2.0, 4.0])
def test_a_reflex_is_no_hand(gain):
    """It leaves the slow leg alone, and may act in every swing."""
    each = [stretched(ADULT, start, gain, 2.0, 0.03, 0.03, lasting=9.0) for start in STARTS]
    said = followed(*(measured(angle, 100) for angle in each))
    assert said.trust[-1] == online.Trust.UNEXPLAINED
