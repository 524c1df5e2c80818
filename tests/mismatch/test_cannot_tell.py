"""When the right answer is that this recording cannot tell."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.data.observe import observe
from exoid.fitting.data.segment import movement
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.mismatch.conclude.false_alarm import Chance
from exoid.mismatch.conclude.verdict.cannot_tell import chance, faint, luck, unlike_a_leg, vague
from exoid.mismatch.conclude.verdict.segments.in_few_segments import alone_in, why
from exoid.mismatch.novel.dictionary import dictionary
from exoid.mismatch.novel.formula import Formula
from exoid.recordings.declared.subject import Subject
from exoid.twin.motion import Movement
from fit_cases import recorded


@pytest.mark.parametrize(
    ("share", "causes", "doubted"),
    [
        (None, 1, False),
        (0.96, 3, False),
        (0.52, 1, False),
        (0.52, 3, True),
        (0.04, 1, True),
        (0.0, 2, True),
    ],
)
def test_what_other_segments_would_contradict_is_not_asserted(share, causes, doubted):
    assert bool(chance(share, causes)) == doubted


@pytest.mark.parametrize(
    ("usual", "claimed", "doubted"),
    [(-20.0, 5.0, False), (30.0, 100.0, True), (30.0, 5000.0, False), (30.0, 0.0, False)],
)
def test_what_chance_makes_nearly_as_clear_is_not_asserted(usual, claimed, doubted):
    said = luck(Chance(0.01, usual, claimed))
    assert bool(said) == doubted
    assert all("chance makes some cause clear in one of twenty" in one for one in said)
    assert all(f"only {claimed / usual:.2g} times as clear (10 would do)" in one for one in said)


@pytest.mark.parametrize(
    ("starts", "alone"),
    [
        ((-10.0, -12.0, -40.0), []),
        ((-12.0, -10.0, -40.0), []),  # by 2 deg no one goes farther
        ((-10.0, -25.0, -40.0), ["goes farther", "moves faster"]),
    ],
)
def test_a_segment_that_goes_beyond_the_others_may_show_what_they_cannot(starts, alone):
    session = recorded(*(Movement(np.radians(start), 2.3) for start in starts))
    seen = observe([movement(session, k, str(k)) for k in range(3)], "1/T")
    assert alone_in(seen, 0, [1, 2]) == alone
    assert ("physics of the leg acts in all of them" in why(alone)) is (not alone)
    assert ("goes farther and moves faster than the others" in why(alone)) is bool(alone)
    loaded = replace(seen, added_mass=np.array([2.0, 0.0, 0.0]))
    assert alone_in(loaded, 0, [1, 2]) == ["carries another mass"]
    assert alone_in(loaded, 1, [0, 2]) == alone_in(seen, 1, [2])


def test_no_two_causes_are_claimed_where_hardly_more_than_noise_is_missing():
    """As of a sensor that lags on the skin by 0.05 deg, of noise of 0.04 deg."""
    assert "take 2 causes at once" in faint(1.9, 2)[0]
    assert faint(1.9, 1) == faint(5.0, 2) == []


def test_a_formula_that_explains_less_than_half_is_no_claim():
    """As a ripple and an event beside dry friction, of a pendulum that a motor swings."""
    steady = Formula((next(iter(dictionary())),), np.array([1.0]), 0.44, 0.0)
    assert "only 44% of the variance" in vague(steady)[0]
    assert vague(replace(steady, explained=0.6)) == vague(None) == []


def test_what_leaves_no_human_leg_is_no_claim():
    """As stiffening ends and a cube in the place of a cubic spring that is slack at 46 deg."""
    belief = believe(Subject(kind="leg", body_mass=75.0, height=1.78))
    expected = 26.8  # 1/s^2, m l g / J of a person of this size

    def told(value: float | None, error: float | None = 0.4):
        return Estimate("m l g / J", "gravity", "1/s^2", value, error)

    assert "no leg" in unlike_a_leg(belief, told(19.1), told(17.9))[0]
    assert "no leg" in unlike_a_leg(belief, told(19.1), told(17.9, None))[0]  # on its limit
    odd = unlike_a_leg(belief, told(19.1, 0.0), told(17.9, 0.0))[0]
    assert "nearer, and a sampling rate 1.18 ± 0.02 times the one they have would" in odd
    assert "sampling rate" not in unlike_a_leg(belief, told(expected), told(17.9))[0]
    others = [
        (17.9, 19.1, 0.4),  # it was no leg before, and less of one
        (19.1, 19.0, 0.4),  # nor is it one by chance, as with a gyro's scale
        (expected, 25.0, 0.4),  # as scattered as people are
        (19.1, 17.9, 3.0),  # it may be one: the recording hardly tells
        (19.1, None, None),
    ]
    for before, after, error in others:
        assert unlike_a_leg(belief, told(before), told(after, error)) == []
    assert unlike_a_leg(believe(Subject(kind="leg")), told(19.1), told(17.9)) == []
