"""A leg that trembles is said to, by its fit and by its diagnosis; by SciPy."""

import numpy as np
from scipy.integrate import solve_ivp

import exoid
from exoid.mismatch.missing_physics import diagnose

TIME = 0.01 * np.arange(700)
FREQUENCY, TORQUE = 6.0, 2.0  # Hz, rad/s^2


def trembling(start: float, phase: float) -> exoid.Segment:
    """A drop from `start` [rad] after 0.5 s, by an encoder and a gyro."""

    def slope(time, state):
        angle, rate = state
        tone = TORQUE * np.sin(2 * np.pi * FREQUENCY * time + phase)
        return rate, -26.5 * np.cos(angle) - 3.2 * angle - 0.85 * rate + tone

    exact = {"rtol": 1e-9, "atol": 1e-10, "dense_output": True}
    angle, rate = solve_ivp(slope, (0.0, 7.0), [start, 0.0], **exact).sol(
        np.maximum(TIME - 0.5, 0.0)
    )
    random = np.random.default_rng(int(100 * phase))
    return exoid.Segment(
        TIME,
        raw_angle=angle + np.radians(0.05) * random.normal(size=TIME.size),
        raw_angular_velocity=np.where(TIME < 0.5, 0.0, rate)
        + np.radians(0.17) * random.normal(size=TIME.size),
    )


def test_a_tremor_is_named_and_nothing_is_said_to_be_missing_or_not_beside_it():
    """Its size is known to 5 %, and the ratios hold within three of their errors."""
    body = exoid.Subject(kind="leg", body_mass=75.0, height=1.78)
    drops = (trembling(-0.3, 1.0), trembling(-0.7, 2.2))
    recording = exoid.Recording(drops, body, exoid.Protocol(kind="passive"))
    found = diagnose(recording, multistart=1)
    assert found.verdict == "cannot_tell"
    size = np.degrees(TORQUE / ((2 * np.pi * FREQUENCY) ** 2 - 29.0))
    told = f"a tone of 6 Hz moves the leg, by {size:.2g}"
    assert found.reasons[0].startswith(told[:-1])
    assert "tremor" in found.reasons[0]
    assert "was not sought" in found.reasons[1]
    said = " ".join(found.before.notes)
    assert told[:-1] in said
    for word in ("smoothed", "hum", "white"):
        assert word not in said
    gravity = found.before.ratios["gravity_over_inertia"]
    assert gravity.value is not None
    assert gravity.standard_error is not None
    assert abs(gravity.value - 26.5) < 3 * gravity.standard_error
