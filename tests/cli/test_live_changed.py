"""What is said of a leg that is another one from a drop on, or carries something else."""

from dataclasses import replace

import pytest

from exoid.cli.live.page.state import now
from exoid.cli.live.result import lines
from exoid.cli.live.saying.changes import last_change
from exoid.cli.live.saying.movements import all_drops, changed
from exoid.online.model.trust import Phase, Trust
from exoid.watching.board import Board, Ended
from exoid.watching.estimate.left_out import STRAYED, LeftOut
from exoid.watching.estimate.moment import Change, Moment, Quantity

GRAVITY, DAMPING = "gravity_over_inertia", "damping_over_inertia"


def of(gravity: float, damping: float) -> tuple[Quantity, ...]:
    return Quantity(GRAVITY, gravity, 0.03, "1/s^2"), Quantity(DAMPING, damping, 0.002, "1/s")


def drop(number: int, begun: float, change: Change | None = None, known=None) -> Ended:
    at, known = begun + 9.0, known or of(27.4, 0.845)
    moment = Moment(at, -1.3, 0.0, Phase.DONE, Trust.ENOUGH, number, known, known, begun=begun)
    return Ended(0.0, replace(moment, change=change), begun + 8.0)


@pytest.fixture
def board():
    """Two drops of a leg, and two of it with a mass."""
    first, second = drop(1, 1.0), drop(2, 11.0)
    found = Change(21.0, 2, second.moment.ratios, another=True)
    third, fourth = drop(1, 21.0, found, of(27.43, 0.718)), drop(2, 31.0, None, of(27.43, 0.718))
    board = Board(movements=(first, second, third, fourth), state="ended")
    board.show(fourth.moment)
    return board


def test_numbers_are_said_to_be_others_where_they_are_by_how_much_and_since_when(board):
    said = changed(board.movements[2])
    assert said.startswith("30.0 s, from 21.0 s on this is another leg, or it carries something")
    assert "damping over inertia 0.8450 ± 0.0020 before, 0.7180 ± 0.0020 1/s since" in said
    assert "(15 % less)" in said
    assert "gravity" not in said  # one standard error apart
    assert "these rest on 1 drop, those before on 2 drops: follow and fit two legs apart" in said
    assert [changed(board.movements[at]) for at in (0, 1, 3)] == [""] * 3


def test_it_stays_beside_the_numbers_with_the_drops_on_which_they_rest(board):
    assert all_drops(board) == "2 drops so far"
    said = last_change(board)
    assert "these rest on 2 drops, those before on 2 drops" in said
    assert said in lines(board)
    assert now(board)["fit"].startswith("from 21.0 s on this is another leg")


def test_what_differs_by_less_than_legs_do_is_not_called_another_leg(board):
    moment = board.movements[2].moment
    said = changed(Ended(0.0, replace(moment, change=replace(moment.change, another=False)), 29.0))
    assert "from 21.0 s on the leg, or what it carries, is not what it was: " in said


def test_of_several_changes_the_last_is_told_with_their_count(board):
    back = drop(1, 41.0, Change(41.0, 2, of(27.43, 0.718)))
    board.movements = (*board.movements, back)
    assert last_change(board).startswith("from 41.0 s on ")
    assert last_change(board).endswith("; it is the last of 2 such changes")


def test_nothing_is_said_of_a_drop_that_was_taken_back_or_that_nobody_can_believe(board):
    left = LeftOut(31.0, 21.0, STRAYED, falling=False)
    assert last_change(replace(board, movements=(*board.movements[:3], left))) == ""
    third = board.movements[2]
    strange = replace(third, moment=replace(third.moment, trust=Trust.UNEXPLAINED))
    assert changed(strange) == ""


def test_a_movement_that_goes_on_as_another_leg_is_said_to_rest_on_no_drop_yet(board):
    moment = board.movements[2].moment
    board.movements = board.movements[:2]
    board.show(replace(moment, phase=Phase.MOVING, trust=Trust.CHANGED, drops=0))
    assert "these rest on a movement that has not ended, those before on 2 drops" in last_change(
        board
    )
