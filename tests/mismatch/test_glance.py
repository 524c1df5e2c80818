"""A glance at every further cause: what it says is what a closer look finds."""

import numpy as np
import pytest
from diagnosis_cases import FRICTION, Detent, session

from exoid.fitting.estimate import fit
from exoid.mismatch import prepare as preparing
from exoid.mismatch.prepare import prepare
from exoid.mismatch.screen import many_pinned
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.many_free import release
from exoid.mismatch.screen.optimise import bounded, settle_free
from exoid.mismatch.search.glance import beside_free, nearest
from exoid.mismatch.search.resample import steps
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from small_library import SMALL

LEFT = np.array([0.05])  # N m s^2/rad^2: a brake as nobody would build it


@pytest.fixture(scope="module")
def rough():
    """Drops with dry friction and a brake, and a small library."""
    patch = pytest.MonkeyPatch()
    patch.setattr(preparing, "library", lambda: SMALL)
    recordings = [("drops", session(FRICTION, QuadraticDrag(LEFT[0])))]
    yield prepare(fit(recordings), recordings, (Detent,))
    patch.undo()


def test_of_causes_that_are_linear_a_glance_says_what_is_left(rough):
    prepared, base = rough
    starts = [
        Hypothesis((term,), (value,), base.candidate.point)
        for term in (Detent, QuadraticDrag)
        for value in prepared.starts(term)
    ]
    motion = prepared.measured_motion
    for one in nearest(prepared, starts, 2):
        begin = next(each for each in starts if each.terms == one.terms)
        ((before, _), (after, _)) = many_pinned.evaluate(
            prepared, [(each, motion) for each in (begin, one)]
        )
        change = one.unknowns - begin.unknowns
        normal, gradient = before.total[:-1, :-1], before.total[:-1, -1]
        expected = before.square + 2 * gradient @ change + change @ normal @ change
        gain = before.square - expected
        assert gain > 0
        # A step is nearly linear in what acts during 10 ms of it.
        assert before.square - after.square == pytest.approx(gain, rel=0.03)


def test_the_nearest_are_as_many_as_asked_for_and_each_once(rough):
    prepared, base = rough
    starts = [
        Hypothesis((term,), (value,), base.candidate.point)
        for term in prepared.library
        for value in prepared.starts(term)
    ]
    found = nearest(prepared, starts, 3)
    assert len({one.terms for one in found}) == len(found) == 3
    assert nearest(prepared, [], 3) == []


def test_beside_a_leg_that_sticks_the_true_second_cause_is_the_first(rough):
    prepared, base = rough
    sticking = Hypothesis((CoulombFriction,), (np.array([0.1]),), base.candidate.point)
    known = settle_free(prepared, sticking)
    assert known.square > 1.5 * prepared.samples  # the brake is missing
    (expected, first), (second, _), *_ = beside_free(prepared, list(prepared.library), known)
    assert first.terms == (CoulombFriction, QuadraticDrag)
    assert first.values[1] == pytest.approx(LEFT, rel=0.5)  # what a first step finds of it
    assert second > 2 * expected
    # To first order: what the step promised is mostly kept.
    kept = known.square - release(prepared, first)[0].square
    assert kept > 0.5 * (known.square - expected)


def test_steps_of_many_are_those_of_each_within_bounds():
    random = np.random.default_rng(2)
    rows = random.normal(size=(50, 9, 6))
    normal, gradient = np.einsum("dki,dkj->dij", rows, rows), random.normal(size=(50, 6))
    normal[:, 3], normal[:, :, 3], gradient[:, 3] = 0.0, 0.0, 0.0  # nothing tells it
    bound = np.full(6, 0.1)
    each = [bounded(*one, 0.0, -bound, bound) for one in zip(normal, gradient, strict=True)]
    found = steps(normal, gradient, -bound, bound)
    np.testing.assert_allclose(found, each, rtol=1e-9, atol=1e-12)
    assert (np.abs(found) == 0.1).any(axis=1).sum() > 5  # some do run into one
