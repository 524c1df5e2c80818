"""A muscle that answers the first swings alone, as of a spastic leg: no hand lets go slowly."""

import numpy as np
import pytest

from exoid.mismatch.missing_physics import diagnose
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

pytestmark = pytest.mark.proof

GRAVITY, STIFFNESS, DAMPING = 35.2, 12.5, 1.25  # 1/s^2, 1/s^2, 1/s, of a child's leg over J
GAIN, THRESHOLD, DELAY = 3.5, 2.0, 0.045  # 1/s, rad/s, s
STEP, EVERY = 1e-4, 100  # s, and of how many steps a sample is written
HELD, SECONDS = 1.0, 9.0  # s
NOISE, GYRO_NOISE = np.radians(0.03), 0.005  # rad, rad/s


def drop(start: float, rng: np.random.Generator) -> Segment:
    """A drop from an angle [rad], let go at once; by small steps, the delay as it is."""
    angle, rate, rates, motion = start, 0.0, [], []
    late = round(DELAY / STEP)
    for number in range(round(SECONDS / STEP)):
        if number % EVERY == 0:
            motion.append((angle, rate))
        rates.append(rate)
        before = rates[number - late] if number >= late else 0.0
        push = GAIN * max(0.0, -before - THRESHOLD)
        pull = -GRAVITY * np.cos(angle) - STIFFNESS * angle - DAMPING * rate + push
        rate += STEP * pull
        angle += STEP * rate
    still = np.tile([start, 0.0], (round(HELD / STEP / EVERY), 1))
    shown = np.concatenate([still, motion])
    shown += rng.normal(size=shown.shape) * [NOISE, GYRO_NOISE]
    time = np.arange(len(shown)) * STEP * EVERY
    return Segment(time, raw_angle=shown[:, 0], raw_angular_velocity=shown[:, 1])


def test_a_reflex_of_the_first_swings_is_among_what_they_may_be():
    rng = np.random.default_rng(5)
    recording = Recording(
        tuple(drop(np.radians(start), rng) for start in (-5.0, 0.0, -10.0)),
        Subject(kind="leg", body_mass=25.0, height=1.25),
        Protocol(kind="passive"),
        Sensors(angle_noise=float(NOISE), velocity_noise=GYRO_NOISE),
    )
    found = diagnose(recording, multistart=8)
    told = {*found.selected, *(name for each in found.suspected for name in each.terms)}
    assert "stretch_reflex" in told
    assert set(found.selected) <= {"stretch_reflex"}
    gravity = found.fit.ratios["gravity_over_inertia"]
    assert abs(gravity.value - GRAVITY) < 3 * gravity.standard_error
