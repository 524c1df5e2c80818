"""Whole sessions of many people."""

from collections.abc import Iterator

import numpy as np
from benchmarks.closed_loop.carrying import NOTHING, SHARES
from benchmarks.closed_loop.learners import ByHost, Known, Learner
from benchmarks.closed_loop.measure import Gravity, Outcome, bounds, effort, gravity_error
from benchmarks.closed_loop.node import TICK
from benchmarks.closed_loop.plant import STEP, Motor
from benchmarks.closed_loop.rig import Body, draw_body, draw_frame
from benchmarks.closed_loop.script import MOST_DROPS, Case, Learned, Script
from benchmarks.closed_loop.sensors import draw_faults

OTHER = 0.4  # by which the next leg has more mass and inertia, or less
Errors = dict[str, Gravity]  # by the movement's name
GAIN = 0.02  # by which a motor's torque is off


def draw_case(rng: np.random.Generator, friction: float) -> Case:
    """Somebody in a frame with dry friction of up to so much [N m]."""
    motor = Motor(gain=1 + GAIN * rng.standard_normal())
    frame = draw_frame(rng, friction)
    return Case(draw_body(rng), frame, motor, draw_faults(rng), OTHER * rng.choice([-1, 1]))


def play(rng: np.random.Generator, case: Case, learner: type[Learner]) -> tuple[Script, Outcome]:
    """One session: what happened, and its figures."""
    script = Script(rng, case, learner(case.body, case.frame))
    loop, gravity = script.session, {}
    first = whole(script, case.body, gravity, "")
    if loop.learner.knows:
        script.move("frame", NOTHING, loop.learner.leg())
    false_alarm = script.find_out(1) is not None
    script.seat_next()
    carry(script, case.next_body, gravity, "unnoticed", loop.learner.leg())
    found = script.find_out(MOST_DROPS)
    loop.learner = loop.learner.anew(case.next_body)
    second = whole(script, case.next_body, gravity, " again")
    table = loop.log.table
    efforts = {one.name: effort(table, one) for one in script.moved}
    limits = bounds(table, case, TICK, STEP)
    return script, Outcome(case, first, false_alarm, found, second, efforts, gravity, limits)


def whole(script: Script, body: Body, gravity: Errors, again: str) -> Learned:
    """A leg is learned, moves with the motor off, and is carried."""
    loop = script.session
    learned = script.learn()
    script.move("off" + again, NOTHING, None)
    carry(script, body, gravity, "anatomy" + again, loop.learner.leg())
    if isinstance(loop.learner, ByHost):
        carry(script, body, gravity, "weighed" + again, script.weigh(body))
    return learned


def carry(script: Script, body: Body, gravity: Errors, name: str, known: Known | None) -> None:
    """A leg that is known moves while the motor carries it; how wrong that is goes to `gravity`."""
    if known is not None and script.session.learner.knows:
        gravity[name] = gravity_error(known, script.case, body)
        script.move(name, SHARES, known)


def session(
    number: int, seed: int, friction: float, learner: type[Learner]
) -> tuple[Script, Outcome]:
    """Of the person of that number."""
    rng = np.random.default_rng([seed, number])
    return play(rng, draw_case(rng, friction), learner)


def outcomes(people: int, seed: int, friction: float, learner: type[Learner]) -> Iterator[Outcome]:
    """Of one person after the other."""
    for number in range(people):
        yield session(number, seed, friction, learner)[1]
