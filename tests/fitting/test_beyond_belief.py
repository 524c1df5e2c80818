"""What a fit says that takes a recording for what nobody declares."""

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.fitting.result.mountings import made_up, off
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

USUAL = float(np.radians(0.2))


@pytest.mark.parametrize("field", ["tilt", "zero"])
def test_a_rest_beside_the_middle_may_be_dry_friction_or_a_sensor_that_drifts(field):
    why = off(field, -10 * USUAL, USUAL) + made_up(field, let_go=True, misses=True)
    assert "to be off by -2 deg, where 0.2 deg is usual" in why
    assert "dry friction lets a leg come to rest beside its middle" in why
    assert "the encoder or the gyro drifts" in why


def test_a_gyro_whose_bias_is_off_is_no_friction():
    why = off("gyro_bias", 10 * USUAL, USUAL) + made_up("gyro_bias", let_go=True, misses=False)
    assert why.endswith("off by 2 deg/s, where 0.2 deg/s is usual")


@pytest.mark.parametrize(("field", "let_go"), [("zero", False), ("clock", True)])
def test_what_is_far_off_may_only_make_up_for_what_a_model_misses(field, let_go):
    """Cycles come to rest where a muscle wants."""
    assert "make up for what the model misses" in made_up(field, let_go=let_go, misses=True)
    assert made_up(field, let_go=let_go, misses=False) == ""


def test_a_leg_on_its_side_is_a_rig_without_gravity_whose_spring_rests_anywhere():
    """phi'' = -(c / J) (phi - rest) - (d / J) phi' in closed form; the rest is no zero that is off,
    of which such a fit "did not follow".
    """
    spring, damping, rest, start = 18.4, 0.7, -0.94, -0.35
    time = np.arange(0.0, 6.0, 0.01)
    decay, turn = damping / 2, np.sqrt(spring - damping**2 / 4)
    swing = (np.cos(turn * time) + decay / turn * np.sin(turn * time)) * np.exp(-decay * time)
    noise = 8e-4 * np.random.default_rng(4).standard_normal(time.size)
    made = Segment(time, raw_angle=rest + (start - rest) * swing + noise)
    rig = Subject(kind="rig", gravity="none")
    found = fit(Recording((made,), rig, Protocol(kind="passive")), multistart=2)
    assert found.follows
    each = found.ratios["stiffness_over_inertia"]
    assert abs(each.value - spring) < 3 * each.standard_error
