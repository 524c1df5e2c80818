"""Drops of two bodies that SciPy moved, with play between leg and frame and without."""

import pytest

from exoid.mismatch.missing_physics import diagnose
from two_bodies import Frame, Leg, Session, recorded

pytestmark = pytest.mark.proof

ADULT, CHILD = Leg(), Leg(0.30, 8.5, 1.2, 0.15)
FROM_REST = Session()
AT_ONCE = Session(rate=200.0, hold=0.0, lasting=4.0, starts=(-0.05, -0.3, -0.6, -0.9))
PLAYING = {
    "it falls": (ADULT, Frame(), FROM_REST),
    "it sticks": (CHILD, Frame(0.0175, 0.010, 0.3, 0.15, 0.03, 400.0, 0.7), FROM_REST),
    "it is heavy": (CHILD, Frame(0.0262, 0.02, 1.0, 0.1, 0.05, 1200.0, 0.8), AT_ONCE),
}
TIGHT = {
    "nothing": (ADULT, Frame(0.0, 0.012, 0.6, 0.0, 0.02, 3000.0, 0.8), FROM_REST),
    "dry friction": (
        Leg(friction=0.15),
        Frame(0.0, 0.012, 0.6, 0.0, 0.02, 3000.0, 0.8),
        FROM_REST,
    ),
}


@pytest.mark.parametrize("name", PLAYING)
def test_play_is_named_and_as_wide_as_it_is(name):
    leg, frame, how = PLAYING[name]
    found = diagnose(recorded(leg, frame, how), multistart=8)
    assert (found.verdict, found.selected) == ("mismatch", ["backlash"])
    width = {each.name: each for each in found.parameters}["backlash.half_play"]
    # Four deviations, and what friction that gives way by 10 urad blurs.
    assert width.standard_error is not None
    assert abs(width.value - frame.half_play) < 4 * width.standard_error + 2e-4


@pytest.mark.parametrize("name", TIGHT)
def test_no_play_is_seen_where_none_is(name):
    found = diagnose(recorded(*TIGHT[name]), multistart=8)
    assert not any("backlash" in each for each in found.selected)
    assert found.verdict == ("none" if name == "nothing" else "mismatch")
