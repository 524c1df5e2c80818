"""A leg that becomes another one amid a stream: from which drop on, and what was known before."""

import numpy as np
import pytest
from test_left_out import APART, HELD, followed, stream

from exoid.online.model.trust import Phase, Trust
from exoid.online.outlook import Outlook
from exoid.watching.board import Board, Ended
from exoid.watching.estimate.known import Changes
from exoid.watching.estimate.left_out import STRAYED, LeftOut
from exoid.watching.estimate.leg import LegDrop
from exoid.watching.estimate.moment import Moment
from legs import ADULT, drop

STARTS = (-0.2, -0.4, -0.3, -0.25)  # rad
LIKELY = 4.0  # standard errors
PHASE = Phase.DONE, Trust.GOOD
SLIGHTLY = (27.1, 5.35, 0.8)  # ratios as of `ADULT`: none is 3 % of the first off
ANOTHER = (25.7, 4.5, 0.8)


def drops_of(person, *legs) -> tuple[list[Moment], list[LegDrop]]:
    each = zip(legs, STARTS, strict=False)
    swings = [drop(leg, at, seed=k, duration=13.0) for k, (leg, at) in enumerate(each)]
    moments, drops, _ = followed(person, stream(*swings))
    return moments, drops


@pytest.mark.parametrize(("other", "another"), [(SLIGHTLY, False), (ANOTHER, True)])
def test_a_change_is_told_with_the_first_drop_of_the_other_leg(person, other, another):
    moments, drops = drops_of(person, ADULT, ADULT, other, other)
    assert [each.moment.drops for each in drops] == [1, 2, 1, 2]  # on which the numbers rest
    assert [each.moment.change is None for each in drops] == [True, True, False, True]
    found = drops[2].moment.change
    assert found is not None
    assert (found.drops, found.another) == (2, another)
    assert found.since == pytest.approx(2 * APART + HELD, abs=0.3)
    for was, now, before, since in zip(found.before, moments[-1].ratios, ADULT, other, strict=True):
        assert abs(was.value - before) < LIKELY * was.error, was
        assert abs(now.value - since) < LIKELY * now.error, now


def test_of_the_same_leg_no_change_is_told(person):
    moments, drops = drops_of(person, *[ADULT] * 4)
    assert [each.moment.drops for each in drops] == [1, 2, 3, 4]
    assert all(each.change is None for each in (*moments, *(drop.moment for drop in drops)))


def test_another_leg_is_told_while_its_first_drop_goes_on(person):
    swings = [drop(leg, -0.3, seed=k, duration=13.0) for k, leg in enumerate((ADULT, ANOTHER))]
    cut = [each for each in stream(*swings) if each.time < APART + 6.0]
    moments, drops, _ = followed(person, cut)
    assert len(drops) == 1
    found = moments[-1].change
    assert found is not None
    assert (moments[-1].drops, found.drops, found.another) == (0, 1, True)


def test_numbers_rest_on_those_before_where_the_drop_that_changed_them_is_taken_back():
    def ended(number: int, begun: float) -> Ended:
        moment = Moment(begun + 8.0, -1.3, 0.0, *PHASE, number, (), (), begun=begun)
        return Ended(0.0, moment, begun + 7.0)

    board = Board(movements=(ended(1, 2.0), ended(2, 18.0), ended(1, 34.0)))
    assert [each.moment.begun for each in board.ended] == [34.0]
    board.movements = (*board.movements, LeftOut(44.0, 34.0, STRAYED, falling=False))
    assert [each.moment.begun for each in board.ended] == [2.0, 18.0]


def test_a_change_is_told_once_its_numbers_can_be_believed():
    def said(trust: Trust, rests: int) -> Outlook:
        number = np.zeros(1)
        counts = (np.array([int(each)]) for each in (trust, Phase.DONE, rests, rests))
        numbers = [np.ones((1, 3))] * 3  # ratios, their errors, and more if slack
        return Outlook(*counts, *numbers, *[number + 30.0] * 2, *[number] * 2, number.astype(int))

    changes = Changes()
    changes.look(said(Trust.GOOD, 3), 1)
    assert changes.counted(said(Trust.UNEXPLAINED, 1), 0) is None
    changes.look(said(Trust.UNEXPLAINED, 1), 1)
    found = changes.counted(said(Trust.GOOD, 2), 0)
    assert found is not None
    assert (found.since, found.drops) == (30.0, 3)
    assert changes.counted(said(Trust.GOOD, 3), 0) is None
    changes.counted(said(Trust.UNEXPLAINED, 1), 0)
    changes.taken_back()
    assert changes.counted(said(Trust.GOOD, 3), 0) is None
    segment_ends = said(Trust.FAULTY, 1)  # a pause that was foreseen is no fault
    assert changes.counted(segment_ends, 0) is not None
