"""A bar that a spring pulls from above its axis, made by SciPy: it swings as under less gravity."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

GRAVITY, DAMPING, ABOVE = 25.0, 0.06, 7.0  # 1/s^2, 1/s; 1/s^2, k h r / J of the spring


def swung(start: float, seed: int) -> Segment:
    """The spring of rate k hangs h above the axis, and pulls at r along the bar: its length d is
    h^2 + r^2 - 2 h r sin(phi), squared, and its energy k d^2 / 2.
    """

    def slope(_, state):
        angle, speed = state
        return speed, (ABOVE - GRAVITY) * np.cos(angle) - DAMPING * speed

    time, random = np.arange(0.0, 5.0, 0.01), np.random.default_rng(seed)
    found = solve_ivp(slope, (0.0, 5.0), (start, 0.0), t_eval=time, rtol=1e-9, atol=1e-9).y
    return Segment(
        time,
        raw_angle=found[0] + 6e-4 * random.standard_normal(time.size),
        raw_angular_velocity=found[1] + 3e-3 * random.standard_normal(time.size),
    )


def test_a_spring_from_above_a_rigs_axis_is_said_to_look_like_less_gravity():
    sensors = Sensors(angle_noise=6e-4, velocity_noise=3e-3)
    drops = (swung(-0.3, 0), swung(-0.8, 1))
    recording = Recording(drops, Subject(kind="rig"), Protocol(kind="passive"), sensors)
    found = fit(recording, multistart=2)
    assert found.follows
    told = found.ratios["gravity_over_inertia"]
    assert told.value == pytest.approx(GRAVITY - ABOVE, abs=4 * told.standard_error)
    assert told.standard_error < ABOVE / 4
    assert any("m l g holds that pull, too, and no motion parts them" in n for n in found.notes)
    assert "no motion parts them" in StiffnessRestAngle.explanation
