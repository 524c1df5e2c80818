"""A set that explains a recording is sure only where its near relatives were asked, and a zero
that is farther off than usual costs no more than any other cause.
"""

from dataclasses import replace

import numpy as np
import pytest
from found_by_hand import SAMPLES, explaining, found_of

from exoid.mismatch.conclude.unusual_zero import as_told, odder
from exoid.mismatch.search import several
from exoid.physics.terms.device.torque_bias import TorqueBias
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening
from exoid.physics.terms.tissue.slack_cubic_stiffness import SlackCubicStiffness

USUAL = np.radians(1.2)  # of an encoder's zero
TILTED = np.radians(7.0)  # a thigh, that an encoder's zero takes for its own


@pytest.mark.parametrize(
    ("left", "more", "asks"),
    [(1000.0, (), True), (1300.0, (), False), (1000.0, (TorqueBias,), False)],
)
def test_a_pair_that_leaves_only_noise_is_asked_for_its_relatives(left, more, asks, monkeypatch):
    """Of three causes `several` asked them before."""
    best, other = (
        explaining(left, EndRangeStiffening, cause, *more)
        for cause in (SlackCubicStiffness, CubicStiffness)
    )
    asked = []
    monkeypatch.setattr(several, "with_another", lambda *_: [best.candidate, other.candidate])
    monkeypatch.setattr(
        several, "simulated", lambda prepared, each, rival: asked.extend(each) or []
    )
    prepared = found_of([]).prepared
    prepared.samples, prepared.common = SAMPLES, ()
    several.relatives(prepared, [], [best], [])
    assert asked == ([other.candidate] if asks else [])


def test_another_cause_begins_where_a_set_without_the_first_one_ended(monkeypatch):
    """From where the pair had left the leg, a constant torque came behind a brake of no size."""
    begun = []
    monkeypatch.setattr(several, "along_the_motion", lambda *_: 0.0)
    monkeypatch.setattr(several, "beside", lambda prepared, usable, one: begun.append(one) or [])
    best = explaining(1000.0, EndRangeStiffening, SlackCubicStiffness)
    alone = explaining(1080.0, EndRangeStiffening)
    prepared = found_of([]).prepared
    prepared.samples, prepared.common = SAMPLES, ()
    several.with_another(prepared, [TorqueBias], best, [alone])
    assert alone.candidate in begun
    assert [one.terms for one in begun] == [(SlackCubicStiffness,), (EndRangeStiffening,)]


def tilted(one, angle):
    """The same with such a zero."""
    return replace(one, candidate=replace(one.candidate, zero=np.array([0.0, angle])))


def test_a_set_whose_zero_only_a_tilted_thigh_makes_pays_for_it_as_for_one_cause_more():
    """By what is usual of zeros 7 deg cost 34, and a cubic spring that is not there led."""
    best = explaining(1000.0, EndRangeStiffening, SlackCubicStiffness)
    true = tilted(explaining(1020.0, EndRangeStiffening, TorqueBias), TILTED)
    found = found_of([], [best, true])
    found.prepared.zero = USUAL
    assert found.evidence(best) > found.evidence(true)
    assert odder(found, best) is true
    paid = (TILTED / USUAL) ** 2
    price = found.yardstick.price(1)
    assert as_told(found, true) == pytest.approx(found.evidence(true) + paid - price)


@pytest.mark.parametrize(("zero", "left"), [(0.5 * USUAL, 1010.0), (TILTED, 1100.0)])
def test_the_best_stays_where_the_others_zero_is_usual_or_buys_too_little(zero, left):
    best = explaining(1000.0, EndRangeStiffening, SlackCubicStiffness)
    found = found_of([], [best, tilted(explaining(left, EndRangeStiffening, TorqueBias), zero)])
    found.prepared.zero = USUAL
    assert odder(found, best) is best
