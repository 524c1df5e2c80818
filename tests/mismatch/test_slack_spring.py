"""A diagnosis holds in ± that nobody knows where a knee's spring is slack; legs by SciPy."""

from functools import partial

import pytest

from exoid.fitting.result.estimates.estimate import RIVALS
from exoid.fitting.result.mountings import numbers_at
from exoid.fitting.result.remarks.zero.leaning import BENT
from exoid.fitting.result.remarks.zero.slack_angle import leaning
from exoid.mismatch.missing_physics import diagnose
from exoid.recordings.declared.sensors import Sensors
from legs import ADULT, BODY, drop, recording

LOUD = (0.015, 0.0)  # rad; no gyro


@pytest.fixture(scope="module")
def bent():
    """It looks like Eq. 9 to its sensors, and its ratios are those of another leg."""
    made = drop(slack=-BENT, noise=LOUD, gyro=False)
    return diagnose(recording(made, sensors=Sensors(angle_noise=LOUD[0]), subject=BODY))


@pytest.mark.parametrize(
    ("name", "true"), [("gravity_over_inertia", ADULT[0]), ("stiffness_over_inertia", ADULT[1])]
)
def test_the_error_holds_the_leg_where_nothing_is_seen_to_be_missing(bent, name, true):
    assert bent.verdict == "none"
    found = bent.fit.ratios[name]
    off = abs(found.value - true)
    assert off < 2 * found.standard_error
    alone = found.standard_error * (1 - found.limited_by[RIVALS]) ** 0.5
    assert off > 4 * alone  # by which Eq. 9 alone would have been wrong


@pytest.mark.parametrize("name", ["inertia", "damping", "stiffness"])
def test_so_do_the_errors_of_what_goes_with_them(bent, name):
    """By anatomy J is the greater, the less m l g / J is."""
    found = bent.fit.parameters[name]
    slack = found.standard_error * found.limited_by[RIVALS] ** 0.5
    basis = bent.fit.basis
    numbers = partial(numbers_at, basis.problem)
    leans = leaning(basis.problem, basis.ended, basis.information.open, numbers)
    assert slack >= 0.99 * leans.spread[name] > 0.1 * found.value
    assert found.if_slack is None  # ± has it


def test_it_is_said_what_the_error_holds(bent):
    assert "a spring that is slack up to 30 deg from full extension" in " ".join(bent.reasons)
