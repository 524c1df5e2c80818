"""What is said of a board's numbers: whose leg it is, and what no drop tells."""

from dataclasses import replace
from math import nan

import pytest

from exoid.cli.live.result import lines
from exoid.cli.live.saying import leaning
from exoid.online.model.trust import Phase, Trust
from exoid.watching.board import Board, Ended
from exoid.watching.estimate.moment import Misplaced, Moment, Quantity, Unlike

KNOWN = (Quantity("gravity_over_inertia", 38.3, 0.4, "1/s^2"),)
MOMENT = Moment(9.0, -1.2, 0.1, Phase.DONE, Trust.GOOD, 1, KNOWN, KNOWN)


def board_of(moment: Moment) -> Board:
    board = Board(movements=(Ended(0.0, moment, 8.0),), state="ended")
    board.show(moment)
    return board


@pytest.mark.parametrize(("turning", "clock"), [(0.1, "encoder and gyro"), (nan, "a camera's")])
def test_of_a_gyro_is_spoken_where_there_is_one(turning, clock):
    said = leaning.allowance(board_of(replace(MOMENT, angular_velocity=turning)))
    assert clock in said
    assert ("gyro" in said) == (turning == turning)


def test_a_leg_that_is_none_of_its_body_is_said_to_be_beside_its_numbers():
    board = board_of(replace(MOMENT, unlike=Unlike(0.256, 0.199, 0.007)))
    (said,) = (each for each in lines(board) if "J / (m l)" in each)
    assert "0.256 m, and 0.199 ± 0.007 m is expected" in said
    assert "Check body mass" in said
    failing = board_of(replace(board.ended[0].moment, trust=Trust.UNEXPLAINED))
    assert leaning.unlike(failing) == ""
    assert leaning.unlike(board_of(MOMENT)) == ""


def test_a_mass_that_does_not_hang_where_it_is_declared_is_told_beside_the_numbers():
    inertia = Quantity("inertia", 0.57, 0.04, "kg m^2")
    off = replace(MOMENT, misplaced=Misplaced(0.4, 0.374, strange=False), others=(inertia,))
    (said,) = (each for each in lines(board_of(off)) if "added mass" in each)
    assert "hardly agrees with how the leg moves: it acts as one at 0.374 m" in said
    assert "± of J, and of what goes with it, holds" in said
    far = replace(off, misplaced=Misplaced(0.4, 0.33, strange=True), others=())
    said = leaning.misplaced(board_of(far))
    assert "does not agree with" in said
    assert "is not told" in said
    assert leaning.misplaced(board_of(replace(off, trust=Trust.UNEXPLAINED))) == ""
    assert leaning.misplaced(board_of(MOMENT)) == ""
