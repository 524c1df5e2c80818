"""Laws of friction that stopped in a crease, begun again where another one came to."""

import numpy as np
import pytest
from diagnosis_cases import FRICTION, session

from exoid.fitting.estimate import fit
from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.many_free import release
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.exchange import exchanged
from exoid.mismatch.search.found import Found
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.stribeck_friction import StribeckFriction
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag


@pytest.fixture(scope="module")
def stopped():
    """Drops with dry friction and a brake: Coulomb's law settled, Stribeck's, which holds all of
    it, where its search has not begun, and a brake that holds nothing.
    """
    recordings = [("drops", session(FRICTION, QuadraticDrag(np.array(0.05))))]
    prepared, base = prepare(fit(recordings), recordings, ())

    def start(term, *values):
        return Hypothesis((term,), (np.array(values),), base.candidate.point)

    settled = settle_free(prepared, start(CoulombFriction, 0.1))
    early, brake = start(StribeckFriction, 0.4, 0.5, 1.0), start(QuadraticDrag, 0.01)
    left = [Optimum(one, *release(prepared, one)) for one in (early, brake)]
    singles, measure = [settled, *left], yardstick(prepared, settled)
    return Found(prepared, base, base.candidate, singles, [], [], [], measure)


def of(found, term):
    return next(one for one in found.singles if one.candidate.terms == (term,))


def test_a_law_leaves_no_more_than_the_one_that_it_holds(stopped):
    found = exchanged(stopped)
    coulomb = of(found, CoulombFriction)
    assert of(stopped, StribeckFriction).square > 2 * coulomb.square
    # A hundredth is what a search takes for no fall any more.
    assert of(found, StribeckFriction).square < 1.01 * coulomb.square
    assert coulomb.square <= of(stopped, CoulombFriction).square


def test_what_holds_nothing_stays_as_it_was(stopped):
    assert of(exchanged(stopped), QuadraticDrag) is of(stopped, QuadraticDrag)
