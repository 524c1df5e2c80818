"""What panel and page say of a board: what is open, what does not fit, and what is on the leg."""

from dataclasses import replace

import pytest

from exoid.cli.live.page.state import now
from exoid.cli.live.panel import bar
from exoid.cli.live.result import lines
from exoid.cli.live.saying import leaning, words
from exoid.cli.live.saying.movements import all_drops
from exoid.cli.live.session import Session
from exoid.cli.live.watched import Watched
from exoid.cli.live.weighing import UNMARKED, Weighing
from exoid.online.model.trust import Phase, Trust
from exoid.recordings.declared.subject import Subject
from exoid.recordings.live.log_file import Unkept
from exoid.watching.beside.goals import goal_of
from exoid.watching.beside.movement import Movement
from exoid.watching.beside.next_movement import Advice
from exoid.watching.beside.refinement import Refined
from exoid.watching.board import Board, Ended
from exoid.watching.estimate.gyro_off import GyroOff
from exoid.watching.estimate.left_out import STRAYED, LeftOut
from exoid.watching.estimate.load import Mass
from exoid.watching.estimate.moment import Moment, Quantity
from exoid.watching.estimate.switch import Switch

NAMES = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
KNOWN = tuple(Quantity(name, 27.3, 0.05, "1/s^2") for name in NAMES)


def board_of(trust, *goals) -> Board:
    """With advice and a fit that agrees."""
    board = Board([goal_of(each, (*NAMES, "inertia")) for each in goals], state="following")
    board.show(Moment(1.0, -1.0, 0.0, Phase.DONE, trust, 1, KNOWN, KNOWN))
    board.advice = Advice(Movement(-0.5), NAMES[0], 0.05, 0.03, "1/s^2")
    board.refined = Refined(1, {}, {NAMES[0]: 0.5}, agrees=True)
    return board


def test_what_a_slack_spring_leaves_open_is_said_of_what_is_believed_alone():
    board = board_of(Trust.GOOD)
    assert leaning.if_slack(board) == ""
    assert board.refined is not None
    board.refined = replace(board.refined, if_slack={NAMES[0]: 1.234, "inertia": 0.1})
    said = "± 1.2 1/s^2 more of gravity over inertia"
    assert leaning.open_if_slack(board) == said
    whole = f"{said}, where the knee's spring is slack elsewhere than at full extension"
    assert lines(board)[-2] == whole  # before what to do next
    assert now(board)["fit"].endswith(f"; {whole}")
    failing = board_of(Trust.UNEXPLAINED)
    failing.refined = board.refined
    assert leaning.if_slack(failing) == ""


def test_what_the_stream_leaves_open_for_a_slack_spring_is_said_before_any_fit_is_made():
    board = board_of(Trust.GOOD)
    gravity = replace(KNOWN[0], if_slack=2.34)
    board.refined = None
    board.show(replace(board.moment, ratios=(gravity, *KNOWN[1:])))
    assert leaning.settled(board) == "± 2.3 1/s^2 more of gravity over inertia"
    assert "± 2.3 1/s^2 more of gravity over inertia, where" in lines(board)[-2]
    board.show(replace(board.moment, phase=Phase.MOVING))
    assert leaning.settled(board) == ""
    assert leaning.if_slack(board)
    board.show(replace(board.moment, phase=Phase.WAITING, drops=0))
    assert leaning.if_slack(board) == ""  # nothing was seen of it


@pytest.mark.parametrize("trust", [Trust.GOOD, Trust.ENOUGH])
def test_while_a_goal_is_open_nothing_is_called_enough(trust):
    board = board_of(trust, "gravity_over_inertia=1%", "inertia=2%")
    assert words.trust(board) == "not enough yet: inertia=2% is still open"
    assert words.trust(board_of(trust)) == trust.words
    assert words.trust(board_of(trust, "gravity_over_inertia=1%")) == trust.words


def test_a_goal_that_nobody_knows_yet_has_a_row_and_every_goal_its_number():
    board = board_of(Trust.ENOUGH, "gravity_over_inertia=1%", "inertia=2%")
    rows = {each["name"]: each for each in now(board)["rows"]}
    assert rows["inertia"]["value"] == "-"
    assert (rows["inertia"]["goal"], rows["inertia"]["wanted"]) == (0.0, "± 2 %")
    assert rows["gravity over inertia"]["wanted"] == "± 1 %"
    assert bar(board, "inertia").endswith("± 2 %")
    assert bar(board, "gravity_over_inertia").startswith("━━━━━━━━")


def test_where_the_model_fails_the_advice_is_to_find_out_why():
    board = board_of(Trust.UNEXPLAINED)
    assert "exoid diagnose" in words.advice(board)
    assert "--with TERM" in words.advice(board)
    assert "deg" not in words.advice(board)
    assert words.batch(board) == ""
    assert now(board)["rows"] == []
    sure = board_of(Trust.GOOD)
    assert words.advice(sure).startswith("let it drop from")
    assert "agrees" in words.batch(sure)


@pytest.mark.parametrize(
    ("off", "said"),
    [
        (GyroOff(0.87, 0.0), "the gyro shows a rate 13 % less than the encoder's. Check"),
        (GyroOff(1.0, 0.015), "the gyro shows the leg 15 ms later. Check"),
        (None, "as where a hand lets go slowly or a muscle leads the leg"),
    ],
)
def test_where_every_movement_strays_in_its_first_fall_a_gyro_is_named_or_both_left_open(off, said):
    board = board_of(Trust.UNEXPLAINED)
    board.movements = (LeftOut(1.9, 1.6, STRAYED, falling=True, gyro=off),)
    assert said in words.advice(board)


def test_where_another_drop_would_hardly_change_a_thing_none_is_asked_for():
    assert words.advice(board_of(Trust.ENOUGH)) == ""
    assert words.advice(board_of(Trust.ENOUGH, "inertia=2%")).startswith("let it drop from")


def test_where_no_drop_narrows_large_errors_nothing_is_said_to_be_learning():
    board = board_of(Trust.LEARNING)
    assert words.trust(board).startswith("learning")
    board.advice = replace(board.advice, movement=None)
    assert words.trust(board) == words.AS_FAR
    assert words.advice(board) == ""  # it is said already
    board.advice = replace(board.advice, before=0.5)  # of an error that is no longer shown
    assert words.trust(board).startswith("learning")


def test_a_drop_that_moves_as_a_recording_ends_is_told_beside_those_that_ended():
    board = board_of(Trust.ENOUGH)
    assert all_drops(board) == "0 drops so far"
    board.show(Moment(2.0, -1.0, 0.0, Phase.MOVING, Trust.ENOUGH, 1, KNOWN, KNOWN))
    assert all_drops(board) == "0 drops, and one that still moved at the end"


def test_where_a_stream_held_no_drop_it_is_said_when_one_is_seen():
    assert "still for half a second" in words.unseen(board_of(Trust.WAITING))
    assert words.unseen(board_of(Trust.ENOUGH)) == ""


def test_where_what_began_was_no_drop_it_is_said_when_that_was():
    board = board_of(Trust.WAITING)
    board.show(replace(board.moment, begun=2.1))
    assert words.unseen(board).startswith("no drop counted: what began last at 2.1 s")
    assert "half a second" not in words.unseen(board)


@pytest.mark.parametrize(
    ("error", "holds"), [(0.046, True), (0.055, True), (0.044, False), (5.0, False)]
)
def test_advice_holds_as_long_as_its_error_is_the_one_that_is_shown(error, holds):
    """It is of 0.05, of which a tenth less is worth a drop."""
    board = board_of(Trust.GOOD)
    known = tuple(replace(each, error=error) for each in KNOWN)
    board.show(replace(board.moment, phase=Phase.MOVING, ratios=known))
    said = "let it drop from -29 deg: error of gravity over inertia 0.05 → 0.03 1/s^2"
    assert words.advice(board) == (said if holds else "")
    board.show(replace(board.moment, ratios=()))  # nobody knows it yet
    assert words.advice(board) == said


def test_a_leg_at_rest_is_asked_to_drop_while_that_is_worth_it_and_the_file_goes_on():
    def doing(trust, over=""):
        board = board_of(trust)
        board.show(replace(board.moment, phase=Phase.WAITING))
        board.over = over
        return words.doing(board)

    assert doing(Trust.GOOD) == "at rest: let it drop"
    assert doing(Trust.ENOUGH) == doing(Trust.UNEXPLAINED) == "at rest"
    assert doing(Trust.GOOD, "the file is over") == "the file is over"


class Screen:
    def __init__(self):
        self.board, self.said = Board(), []

    def tell(self, sentence):
        self.said.append(sentence)

    def show(self, line):
        pass


@pytest.fixture
def weighed():
    """A session whose leg has 1.5 kg on it, what switches that, and what was said."""
    screen = Screen()
    watched = Watched(lambda: None, screen, ())
    session = Session(Unkept(), Subject(added_mass=1.5, added_mass_distance=0.4), watched, None)
    switch = Switch(Mass(1.5, 0.4))
    yield session, Weighing(switch, session, watched), screen
    watched.end(patient=lambda: False)


def test_a_key_takes_the_weight_off_and_the_sidecar_says_of_which_segments(weighed):
    session, weighing, screen = weighed
    session.marks.closed = [("passive", 1.0, 5.0)]
    assert (session.loaded().added_mass, session.loaded().added_mass_distance) == (1.5, 0.4)
    weighing.logged.turn(7.0)
    session.marks.closed.append(("passive", 8.0, 12.0))
    said = session.loaded()
    assert (said.added_mass, said.added_mass_distance) == ((1.5, 0.0), (0.4, 0.0))
    session.marks.closed.clear()
    session.keys["w"]()
    assert not weighing.switch.on
    assert words.weight(screen.board) == "1.5 kg at 0.4 m off"
    assert screen.said == ["weight: 1.5 kg at 0.4 m off."]


def test_without_marks_nobody_can_say_when_a_weight_was_on(weighed):
    session, _, screen = weighed
    session.marking = False
    assert session.loaded().added_mass == 1.5
    session.keys["w"]()
    assert session.loaded().added_mass is None
    assert screen.said[-1].endswith(UNMARKED)


@pytest.mark.parametrize(("strayed", "counted"), [(1, 2), (2, 1), (3, 0)])
def test_how_many_movements_strayed_is_counted_and_what_the_others_told_stays_said(
    strayed, counted
):
    board = board_of(Trust.UNEXPLAINED)
    falls = [LeftOut(9.0 + at, 8.0 + at, STRAYED, falling=True) for at in range(strayed)]
    drops = [
        Ended(0.0, replace(board_of(Trust.GOOD).moment, drops=1 + at, begun=float(at)), 7.0)
        for at in range(counted)
    ]
    board.movements = (*drops, *falls)
    said = words.next_movement(board)
    whole = f"{strayed} of {strayed + counted} movements" if counted else "every movement"
    assert said.startswith(f"{whole} strayed in the first fall")
    assert ("gravity over inertia 27.300 ± 0.050 1/s^2" in said) == bool(counted)
