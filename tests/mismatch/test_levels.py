"""A search from a low level and one from a high level end in the same minimum: the true one."""

import numpy as np
import pytest
from test_moved_by_scipy import Rubbing, Stopped, session

from exoid.fitting.estimate import fit
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.optimise import polished, settle
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.hard_stop import FAR, HardStop

pytestmark = pytest.mark.proof

STOP = np.radians(-85.0)


def ready(knee):
    recordings = [("drops", session(knee))]
    prepared, base = prepare(fit(recordings, multistart=8), recordings, ())

    def ended(term, *values):
        # Along the measured motion first, as a search goes: Eq. 9 may have ended in a false valley.
        start = Hypothesis((term,), (np.array(values),), base.candidate.point)
        (led,) = settle(prepared, [start])
        return polished(prepared, led.candidate)

    return prepared, ended


def test_dry_friction_from_a_tenth_and_from_ten_times_its_level():
    knee = Rubbing()
    prepared, ended = ready(knee)
    found = [ended(CoulombFriction, level) for level in (0.03, 0.3, 3.0)]
    # Nothing that a gyro of 5 mrad/s would see tells the ends apart, and they reach the noise, but
    # that SciPy's friction passes through zero within 5 mrad/s.
    squares = np.array([one.square for one in found])
    assert np.ptp(squares) < 0.02 * prepared.samples
    assert squares.max() < 1.35 * prepared.samples
    for one in found:
        inertia = np.exp(prepared.coordinates(one.candidate).shared.log_inertia)
        assert one.candidate.values[0][0] / inertia == pytest.approx(knee.friction, rel=0.02)


@pytest.mark.parametrize("contact", [0.01, 0.03, 0.1])
def test_a_stop_from_a_hard_and_from_a_soft_one(contact):
    prepared, ended = ready(Stopped(angle=STOP))
    lowest = prepared.range[0]
    found = ended(HardStop, contact, FAR[0], lowest + 0.03, 0.3)
    assert found.square < 1.05 * prepared.samples
    time, _, angle, ratio = found.candidate.values[0]
    assert time == pytest.approx(0.03, rel=0.01)  # the contact's spring and damper of SciPy's stop
    seen = angle + found.candidate.zero[1]  # by the encoder, whose zero a leg on its way may move
    assert seen == pytest.approx(STOP, abs=np.radians(0.1))
    assert ratio == pytest.approx(0.5, abs=0.01)
