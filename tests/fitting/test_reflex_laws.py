"""A reflex that follows another law than the term of the library, which is a row of lags."""

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.physics.terms.muscle.stretch_reflex import StretchReflex
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from hands import Knee
from reflexes import stretched

KNEE = Knee(27.5, 6.0, 1.1)
NOISE = np.radians(0.025)  # as the counts of an encoder make it


def session(delay):
    draw, drops = np.random.default_rng(3), []
    for start in np.radians([-8.0, -22.0, -38.0]):
        angle = stretched(KNEE, start, 4.0, 1.8, delay)[::10]
        time = 0.01 * np.arange(angle.size)
        seen = angle + draw.normal(0, NOISE, angle.size)
        drops.append(Segment(time, raw_angle=seen))
    body = Subject(kind="leg", body_mass=70.0, height=1.75)
    return Recording(tuple(drops), body, Protocol(kind="passive"))


@pytest.mark.parametrize("delay", [0.04, 0.06])
def test_one_of_a_pure_delay_is_followed_to_the_noise(delay):
    found = fit(session(delay), terms=(StretchReflex,), multistart=8)
    assert found.angle_rmse < 1.05 * NOISE
    gain = found.terms["stretch_reflex"]["gain_over_inertia"]
    assert gain.value == pytest.approx(4.0, rel=0.05)
    each = [
        (found.ratios["gravity_over_inertia"], KNEE.gravity),
        (found.ratios["stiffness_over_inertia"], KNEE.stiffness),
        (found.ratios["damping_over_inertia"], KNEE.damping),
    ]
    for one, truth in each:
        assert abs(one.value - truth) < 3 * one.standard_error


@pytest.mark.slow
def test_where_the_spring_is_slack_holds_as_well_as_the_form_of_the_reflex_is_known():
    """Least squares know nothing of that: by them it is 3.3 errors off."""
    slack = np.radians(-20.0)
    draw, drops = np.random.default_rng(3), []
    for start in np.radians([-8.0, -22.0, -38.0]):
        angle = stretched(KNEE, start, 4.0, 1.2, 0.06, slack=slack)[::10]
        seen = angle + draw.normal(0, NOISE, angle.size)
        drops.append(Segment(0.01 * np.arange(angle.size), raw_angle=seen))
    body = Subject(kind="leg", body_mass=70.0, height=1.75)
    made = Recording(tuple(drops), body, Protocol(kind="passive"))
    found = fit(made, terms=(StretchReflex, StiffnessRestAngle), multistart=2)
    rest = found.terms["stiffness_rest_angle"]["rest_angle"]
    each = [(rest, slack), (found.ratios["gravity_over_inertia"], KNEE.gravity)]
    for one, truth in each:
        assert abs(one.value - truth) < 2.5 * one.standard_error


@pytest.mark.slow
def test_a_strong_one_does_not_make_its_first_second_all_there_is():
    """Eq. 9 can explain the jerk of the first second by a leg that flies away in the next ones."""
    knee, draw, drops = Knee(27.04, 8.11, 1.486), np.random.default_rng(0), []
    for start in np.radians([-8.0387, -8.9, -9.0, -6.0, -11.0]):
        angle = stretched(knee, start, 14.86, 1.2, 0.055, rise=0.035, lasting=9.0)[::10]
        seen = angle + draw.normal(0, 2 * NOISE, angle.size)
        drops.append(Segment(0.01 * np.arange(angle.size), raw_angle=seen))
    body = Subject(kind="leg", body_mass=68.0, height=1.7)
    found = fit(Recording(tuple(drops), body, Protocol(kind="passive")), multistart=8)
    assert found.follows
    ratio = found.ratios["gravity_over_inertia"]
    assert abs(ratio.value - knee.gravity) < 3 * ratio.standard_error
    assert "stretch reflex" in " ".join(found.notes)
