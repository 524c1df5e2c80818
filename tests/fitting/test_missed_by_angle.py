"""What a model misses of the angle alone, where a gyro that is late hides it; made by SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

GRAVITY, DAMPING, SHARP = 24.0, 0.05, 0.01  # 1/s^2, 1/s; rad/s, over which friction turns


def swung(start: float, seed: int, friction: float, late: float) -> Segment:
    """A bar with dry friction [of m l g], the gyro `late` [s]."""

    def slope(_, state):
        angle, speed = state
        held = friction * GRAVITY * np.tanh(speed / SHARP)
        return speed, -GRAVITY * np.cos(angle) - DAMPING * speed - held

    time, random = np.arange(0.0, 5.0, 0.01), np.random.default_rng(seed)
    found = solve_ivp(
        slope, (0.0, 5.0), (start, 0.0), method="LSODA", dense_output=True, rtol=1e-8, atol=1e-9
    ).sol
    rate = np.where(time < late, 0.0, found(np.maximum(time - late, 0.0))[1])
    return Segment(
        time,
        raw_angle=found(time)[0] + 6e-4 * random.standard_normal(time.size),
        raw_angular_velocity=rate + 3e-3 * random.standard_normal(time.size),
    )


@pytest.mark.parametrize("friction", [0.015, 0.0])
def test_a_late_gyro_hides_no_dry_friction(friction):
    """With the friction d / J comes out three times as large as it is."""
    drops = [swung(start, seed, friction, 0.009) for seed, start in enumerate((-0.3, -0.7))]
    rig, sensors = (
        Subject(kind="rig", spring="none"),
        Sensors(angle_noise=6e-4, velocity_noise=3e-3),
    )
    found = fit(Recording((*drops,), rig, Protocol(kind="passive"), sensors), multistart=2)
    assert found.follows
    said = " ".join(found.notes)
    assert "ms later than the encoder" in said
    assert ("the angle by itself is more than its noise" in said) == (friction > 0)
    assert ("no error bar of a model that misses something is complete" in said) == (friction > 0)
