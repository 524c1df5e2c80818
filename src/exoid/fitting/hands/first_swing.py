"""What keeps a drop back in its first swing: a hand from its release on, or what a fast leg meets?

A hand that lets go slowly, or leads the leg, carries it from the release on, and is off it once it
is fastest. A stretch reflex begins a moment after the leg has become fast, and acts as it turns.
Energy tells the two apart, of which neither the time of the release nor its shape is asked.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from exoid.fitting.data.guide import GUIDE_WIDTH
from exoid.fitting.data.movement import KeptBack, Movement, smoothed_motion
from exoid.fitting.hands.thrust import Thrust, by_law, pushed_by, thrust
from exoid.fitting.misfit.equation import equation
from exoid.fitting.misfit.residual import sensor_map
from exoid.fitting.model.coordinates import Unknowns, of_owner, take
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.problem import Problem
from exoid.physics.ratios import Ratios
from exoid.recordings.motion.thresholds import CLEAR, SWAY, TRAVEL
from exoid.recordings.signal.condition import reversals

TURNS = 2  # after the bottom: the least that tells how a leg swings by itself
SLOW = 0.5  # of its greatest speed, up to which a leg is slow: a fifth of a second
CARRIED = 0.3  # of the energy of a fall that a hand takes while the leg is slow: 0.37 and more of
# hands that let go over 0.25 s and more or lead, 0.21 at most of legs that are let go at once
BRAKED = 0.15  # of the energy of the fastest leg that is gone as it turns, and not by Eq. 9: 0.29
# and more of reflexes that no fit of all follows, 0.08 at most of legs that a hand has left


@dataclass(frozen=True)
class FirstSwing:
    """What is missing of a drop's energy as it falls, by the leg that swings afterwards."""

    carried: float  # share of what the fall gave, while the leg is slow
    braked: float  # share of what it had at its greatest speed, as it turns
    speed: float  # rad/s, the greatest


def bottom(each: Movement) -> int:
    """The sample at which a drop first turns around; 0 where too few turns follow."""
    return turn_of(each, 0)


def swung_back(each: Movement) -> int:
    """The sample at which it turns again, where the muscle that a fast leg trips is slack; that of
    its first turn where too few follow.
    """
    return turn_of(each, 1) or bottom(each)


def turn_of(each: Movement, number: int) -> int:
    """The sample of this turn of a drop; 0 where too few follow."""
    if each.extent is None or each.kind != "passive":
        return 0
    smooth, _ = smoothed_motion(each, GUIDE_WIDTH)
    clear = CLEAR * each.angle_noise
    turns = reversals(smooth, max(SWAY, clear))[number:]
    if not turns or len(reversals(smooth[turns[0] :], max(TRAVEL, clear))) < TURNS:
        return 0
    return turns[0]


def fastest(each: Movement) -> int:
    """The sample at which a drop is fastest on its way to the bottom."""
    first = bottom(each)
    speed = np.abs(smoothed_motion(each, GUIDE_WIDTH)[1])
    return int(np.argmax(speed[: first + 1])) if first else 0


def kept_back_by(
    whole: Sequence[Movement], problem: Problem, ended: SearchResult
) -> list[KeptBack]:
    """What keeps each of these drops back, by the leg of a fit of what follows their first swings;
    unknown where that has more than Eq. 9. What a filter does to a release looks as a hand does.
    """
    if problem.terms:
        return ["unknown"] * len(whole)
    drops = [number for number, each in enumerate(whole) if bottom(each)]
    swings = [first_swing(whole[number], problem, ended, number) for number in drops]
    by = by_energy(swings, blurred=any(map(is_blurred, whole)))
    if by != "neither":
        return [by] * len(whole)
    return pushed_by([thrust_of(each, problem, ended, k) for k, each in enumerate(whole)])


def thrust_of(each: Movement, problem: Problem, ended: SearchResult, number: int) -> Thrust | None:
    """The largest impulse that its first swing misses; None of what is no drop."""
    left_out = problem.movements[number].slow
    if not left_out:
        return None
    leg, zero = leg_of(problem, ended, number)
    return thrust(each, leg, zero, int(np.searchsorted(each.segment.time, left_out)))


def is_blurred(each: Movement) -> bool:
    """Did its angle go through a filter?"""
    return bool(each.noise.alike_over or each.noise.hidden)


def by_energy(drops: Sequence[FirstSwing], *, blurred: bool = False) -> KeptBack:
    """A hand leaves a leg before it is fastest; a filter that has `blurred` a release looks alike.
    What a speed trips leaves a slow leg alone, and it trips it in every drop that is as fast. Where
    no energy is missing it is neither.
    """
    braked = [each.speed for each in drops if each.braked > BRAKED]
    others = [each.speed for each in drops if each.braked <= BRAKED]
    carried = any(each.carried > CARRIED for each in drops)
    if not braked and blurred:
        return "filtered"
    if not braked:
        return "hand" if carried else "neither"
    return "unknown" if carried or max(others, default=0.0) >= min(braked) else "speed"


def leg_of(problem: Problem, ended: SearchResult, number: int) -> tuple[Ratios, float]:
    """The leg of a fit as a segment has it, and its encoder's zero [rad]."""
    seen, point = take(problem.observation, number), ended.point
    own = of_owner(point.mounting, seen.owner)
    eq = equation(Unknowns(point.shared, own, take(point.own, number)), seen, problem.free)
    return eq.ratios, float(sensor_map(own)[0])


def first_swing(each: Movement, problem: Problem, ended: SearchResult, number: int) -> FirstSwing:
    """Energy over the inertia, and what Eq. 9 takes and gives along the measured motion."""
    leg, zero = leg_of(problem, ended, number)
    shown, rate = smoothed_motion(each, GUIDE_WIDTH)
    angle = shown - zero
    power = by_law(angle, rate, leg) * rate
    given = np.concatenate([[0.0], np.cumsum(power[1:] * np.diff(each.segment.time))])
    energy, turn, top = rate**2 / 2, bottom(each), fastest(each)
    slow = int(np.argmax(np.abs(rate) >= SLOW * abs(rate[top])))
    return FirstSwing(
        carried=1 - float(energy[slow] / given[slow]) if given[slow] > 0 else 0.0,
        braked=float((energy[top] + given[turn] - given[top]) / energy[top]),
        speed=float(abs(rate[top])),
    )
