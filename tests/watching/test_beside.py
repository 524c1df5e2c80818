"""What goes on beside a stream: advice, the batch fit, and the thread that follows."""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import Future, ProcessPoolExecutor
from dataclasses import replace
from math import radians
from multiprocessing import get_context
from threading import get_ident

import pytest
from bundled_session import SUBJECT, until

from exoid.fitting.solve.cores.second_process import unheard
from exoid.online.model.trust import Phase, Trust
from exoid.watching.beside.coach import Coach
from exoid.watching.beside.goals import goal_of
from exoid.watching.beside.next_movement import Advice, Wish, advise
from exoid.watching.beside.refinement import BACKGROUND, Refinement, prepare
from exoid.watching.board import MOST, Board
from exoid.watching.estimate.leg import Leg, LegDrop
from exoid.watching.estimate.load import Load, Mass
from exoid.watching.estimate.moment import Moment
from exoid.watching.follower import Company, Follower

INERTIA = (goal_of("inertia=2%", ["inertia"]),)


def advised(after: float) -> Advice:
    """An answer to a question asked then [s]."""
    return Advice(None, "damping", before=after, after=after, unit="N m s/rad")


@pytest.fixture(scope="session")
def first(told):
    """The first drop of the session, a bare one."""
    return next(each for each in told if isinstance(each, LegDrop))


def test_the_next_drop_is_from_where_it_tells_most(person, first):
    found = advise(first.beliefs, Wish(person), first.mass, first.moment.time)
    assert found.movement is not None
    # The largest swing tells most, and nothing on the leg tells more of ratios than the leg alone.
    assert found.movement.hold == radians(-10)
    assert found.movement.mass == Mass()
    assert found.after < 0.9 * found.before


def test_an_inertia_asks_for_a_weight(person, first):
    found = advise(first.beliefs, Wish(person, INERTIA), first.mass, first.moment.time)
    assert found.movement is not None
    assert found.movement.mass.weight > 0
    assert found.name == "inertia"
    assert found.after < 0.3 * found.before


def test_a_weight_near_the_knee_is_asked_for_where_damping_under_a_load_is_not_known(person, told):
    """At the ankle it says no more of J; there it changes m l g / J by 7 %."""
    subject = replace(
        SUBJECT, damping_under_load_uncertainty=None, stiffness_under_load_uncertainty=None
    )
    *_, last = (each for each in told if isinstance(each, LegDrop))
    wish = Wish(replace(person, subject=subject), INERTIA)
    found = advise(last.beliefs, wish, last.mass, last.moment.time)
    assert found.movement is not None
    assert found.movement.mass == Mass(1.0, 0.18)  # half of g / (m l g / J)
    assert found.after < 0.6 * found.before


def test_at_the_end_of_a_stream_what_to_do_next_is_asked_anew_amid_a_movement(person, first):
    coach = Coach(Wish(person))
    company = Company(Leg(person, Load()), coach)
    coach.waiting = None
    company.ask_anew(replace(first.moment, phase=Phase.DONE))
    assert coach.waiting is None
    company.ask_anew(replace(first.moment, phase=Phase.MOVING))
    assert coach.waiting is not None
    assert coach.waiting[2] == first.moment.time
    company.close()


def test_what_is_foretold_of_a_drop_is_about_what_it_brings(person, readings):
    """The second drop of the session is like the first: its errors were foreseen within a third."""
    leg = Leg(person, Load())
    one, two = [each for each in leg.take(until(readings, 27.0)) if isinstance(each, LegDrop)]
    found = advise(one.beliefs, Wish(person), one.mass, one.moment.time)
    came = {each.name: each.error for each in two.moment.ratios}[found.name]
    assert came == pytest.approx(found.after, rel=0.35)


def test_no_advice_from_before_the_last_drop_is_shown(person, first, monkeypatch):
    monkeypatch.setattr("exoid.watching.beside.coach.advise", lambda *given: advised(given[-1]))
    coach = Coach(Wish(person))
    coach.ask(first.beliefs, Mass(), 1.0)
    while coach.busy:
        coach.look()
    assert coach.latest == advised(1.0)
    coach.ask(first.beliefs, Mass(), 2.0)
    assert coach.latest is None
    while coach.busy:
        coach.look()
    assert coach.latest == advised(2.0)
    coach.close()


def test_a_coach_answers_the_last_question_alone(person, first, monkeypatch):
    asked = []
    monkeypatch.setattr(
        "exoid.watching.beside.coach.advise",
        lambda *given: asked.append(given[-1]) or advised(given[-1]),
    )
    coach = Coach(Wish(person))
    for after in (1.0, 2.0, 3.0):
        coach.ask(first.beliefs, Mass(), after)
    while coach.busy:
        coach.look()
    assert (asked, coach.latest) == ([3.0], advised(3.0))
    coach.ask(first.beliefs, Mass(), 4.0)
    coach.close()
    coach.look()
    assert asked == [3.0]


class Pool:
    """In the place of another process: what is handed to it is done when it is told to be."""

    def __init__(self):
        self.handed = []
        self._processes = {}

    def submit(self, work, *given):
        self.handed.append((given, Future()))
        return self.handed[-1][1]

    def shutdown(self, **_):
        self.handed.clear()


def test_drops_are_fitted_all_together_the_newest_set_after_the_one_that_runs(person, told):
    drops = [each for each in told if isinstance(each, LegDrop)]
    refinement = Refinement(SUBJECT, person.model)
    refinement.process = pool = Pool()
    for each in drops[:1]:
        refinement.add(each)
    refinement.look()
    for each in drops[1:]:
        refinement.add(each)
        refinement.look()
    assert [len(given[0]) for given, _ in pool.handed] == [1]
    pool.handed[0][1].set_exception(ValueError("it is of no use"))
    refinement.look()
    assert refinement.failed == "it is of no use"


@pytest.mark.skipif(not hasattr(signal, "pthread_sigmask"), reason="signals cannot be blocked here")
def test_a_process_that_starts_hears_no_interrupt_and_its_starter_hears_it_afterwards():
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        pytest.skip("these tests run in the background, where nothing hears an interrupt")
    asleep = [sys.executable, "-c", "import time; time.sleep(1)"]
    with unheard():
        deaf = subprocess.Popen(asleep)
    hearing = subprocess.Popen(asleep, stderr=subprocess.DEVNULL)
    for each in (deaf, hearing):
        each.send_signal(signal.SIGINT)
    assert deaf.wait() == 0
    assert hearing.wait() != 0
    done = []

    def interrupted() -> None:
        with unheard():
            signal.pthread_kill(get_ident(), signal.SIGINT)
            done.append("all of it")

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert done == ["all of it"]


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="cores cannot be chosen here")
def test_a_fit_leaves_a_core_to_the_stream_and_is_nice():
    own, niceness = os.sched_getaffinity(0), os.nice(0)
    with ProcessPoolExecutor(1, get_context("spawn"), prepare) as pool:
        taken = pool.submit(os.sched_getaffinity, 0).result()
        assert pool.submit(os.nice, 0).result() == min(niceness + BACKGROUND, 19)
    assert taken < own if len(own) > 1 else taken == own
    assert os.sched_getaffinity(0) == own


def test_the_batch_fit_agrees_with_what_is_told_of_the_same_drops(person, first):
    from exoid.online.batch import refine
    from exoid.watching.beside.refinement import beside

    fitted = refine([first.segment], SUBJECT, person.model)
    found = beside(first, fitted, 1)
    assert found.agrees
    assert max(map(abs, found.apart.values())) < 2.0  # both saw the same samples
    leaning = {name: each.if_slack for name, each in fitted.ratios.items() if each.if_slack}
    assert leaning == {name: more for name, more in found.if_slack.items() if name in leaning}
    assert leaning  # a drop whose zero nobody vouches for does not tell where a spring is slack


def followed(person, readings, **options):
    board, seen = Board(**options), []
    follower = Follower(lambda: Company(Leg(person, Load())), board, [seen.append])
    for at in range(0, len(readings), 100):
        follower.give(readings[at : at + 100])
    follower.end()
    return board, seen


def test_a_follower_tells_every_moment_in_order_and_stops_at_the_goal(person, readings):
    goals = (goal_of("gravity_over_inertia=1%", ["gravity_over_inertia"]),)
    board, seen = followed(person, until(readings, 20.0), goals=goals)
    assert board.reached
    assert [each.time for each in seen] == sorted(each.time for each in seen)
    assert 11.0 < seen[-1].time < 13.0  # with the end of the first drop
    assert board.moment is seen[-1]
    assert len(board.ended) == 1


def test_the_drop_whose_last_sample_reaches_the_goal_counts_and_nothing_after_it(
    person, readings, first, monkeypatch
):
    goals = (goal_of("gravity_over_inertia=100", ["gravity_over_inertia"]),)
    board, seen = Board(goals), []
    after = replace(first.moment, time=first.moment.time + 0.1)
    monkeypatch.setattr(Leg, "take", lambda *_: iter([first.moment, first, after]))
    follower = Follower(lambda: Company(Leg(person, Load())), board, [seen.append])
    follower.give(readings[:1])
    follower.give(readings[1:2])
    follower.end()
    assert board.reached
    assert seen == [first.moment]
    assert len(board.ended) == 1


def test_an_estimator_that_fails_is_told_and_holds_nobody_up(person, readings):
    def fails():
        raise ValueError("no such leg")

    board = Board()
    follower = Follower(fails, board, most=1)
    begin = time.monotonic()
    for at in range(0, 1000, 100):
        follower.give(readings[at : at + 100])
    follower.end()
    assert time.monotonic() - begin < 5.0
    assert (board.state, str(board.fault)) == ("failed", "no such leg")


def test_a_history_does_not_grow_for_ever(told):
    board, moments = Board(), [each for each in told if isinstance(each, Moment)]
    for each in moments * 3:
        board.show(each)
    assert len(board.history) <= MOST
    assert board.history[-1] is moments[-1]
    assert moments[-1].trust is Trust.ENOUGH
