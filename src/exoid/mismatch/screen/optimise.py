"""Bring candidates to their best: Levenberg-Marquardt within bounds, all of them together."""

from dataclasses import replace
from functools import partial

import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.screen import along_motion, many_pinned
from exoid.mismatch.screen.hypothesis import HARDER, Hypothesis, Linear, Optimum
from exoid.mismatch.screen.many_free import release
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.term import Term, busy, holds

ROUNDS, FEWER_ROUNDS = 60, 12  # of steps at most
GLANCES = 2  # steps along the motion of what costs most, and shows itself only running free
HEAT = 3  # rounds of all starts; from then on the best start of the same terms
LONG = 25  # rounds, from which on only what still falls goes on, as along a narrow valley
FALLING, LAST = 0.9, 10  # to what share of itself a sum of squares must fall in how many rounds
EARLY, FAR, FAST = 12, 3.0, 0.6  # rounds, times a rival's square, share in half as many rounds
EASIER = 0.1  # of its damping the next step has, where one did not fail
HASTE = 4.0  # times the same with every one that fails in a row
CAREFUL = 1e-2  # damping beyond which a small step says little
AHEAD = 50  # steps like the next one, in which it must reach a rival, or rests
STEADY = 1e-2  # expected gain of a sum of squares below which a candidate rests
NEARLY = 0.5  # the same while it is pinned, for it goes on running free
FLAT = 1e-6  # relative curvature below which no place nearby is looked for
WEAK = 1e-9  # relative curvature of what nothing tells
FLOOR = 1.3  # mean square over the noise at which no other basin is looked for
USUAL = 1.6  # standard deviations of a sum of squares
SHARES = (0.03, 0.3)  # of the gyro's weight, in which it comes in
HOPS = 8  # places nearby to begin from, a round
HOP_ROUNDS = 6  # of steps, by which it shows whether one leads down
HOP = 0.03  # geometric mean of the shares of its square by which a parabola would rise there
HOP_SPREAD = 2.0  # decades that these shares spread over
LOWER = 0.99  # to what share of itself a square must fall to go on
PASSES = 4  # in which bounds that a step runs into are found


def settle(
    prepared: PreparedRecording, candidates: list[Hypothesis], *, rounds: int = FEWER_ROUNDS
) -> list[Optimum]:
    """Fit every candidate to the data, along the motion that it reads from the sensors.

    Where a baseline may have drifted off, tethers lead the candidates, and the last one stays: what
    a torque explains shows before it is lost in what the motion has drifted since.
    """
    ended = [(one, prepared.measured_motion) for one in candidates]
    most = [GLANCES if any(busy(term) for term, _ in one.asked) else rounds for one in candidates]
    found = []
    for tether in prepared.tethers or (0.0,):
        evaluate = partial(many_pinned.evaluate, tether=tether)
        found = descend(prepared, ended, evaluate, most, NEARLY)
        ended = [(one.candidate, one.motion) for one in found]
    return found


def settle_free(
    prepared: PreparedRecording,
    candidate: Hypothesis,
    observation: Observation | None = None,
    *,
    rounds: int = ROUNDS,
    rival: float = np.inf,
) -> Optimum:
    """Fit a candidate to the observation, running free; `rival` is what another one leaves."""

    def evaluate(prepared, tried):
        return [release(prepared, one, observation) for one, _ in tried]

    return descend(prepared, [(candidate, None)], evaluate, [rounds], STEADY, rival)[0]


def polished(prepared: PreparedRecording, start: Hypothesis, rival: float = np.inf) -> Optimum:
    """Running free from a start; `rival` is what another candidate leaves.

    Where a gyro's reading jumps, every sample beside a jump is a wall: the encoder leads past them,
    and the gyro comes in by and by.
    """
    if strikes(start):
        start = settle_free(prepared, start, by_encoder(prepared), rival=rival).candidate
        for share in SHARES if np.any(prepared.seen.velocity_weight) else ():
            eased = by_encoder(prepared, share)
            start = settle_free(prepared, start, eased, rounds=FEWER_ROUNDS).candidate
    found = settle_free(prepared, start, rival=rival)
    alone = len(start.terms) - len(prepared.common) == 1
    return hopped(prepared, found) if alone and found.square < FAR * rival else found


def enough(prepared: PreparedRecording, square: float) -> bool:
    """Is what is left no more than noise by chance is in one of twenty recordings?"""
    return bool(square < prepared.samples + USUAL * np.sqrt(2 * prepared.samples))


def strikes(candidate: Hypothesis) -> bool:
    """Does one of its terms make what the sensors show jump?"""
    return any(term.jumps for term in candidate.terms)


def by_encoder(prepared: PreparedRecording, share: float = 0.0) -> Observation:
    """What was seen, with this share of the gyro's weight."""
    seen = prepared.seen
    return replace(seen, velocity_weight=share * seen.velocity_weight)


def hopped(prepared: PreparedRecording, at: Optimum) -> Optimum:
    """The best of the basins nearby where a term holds the leg, while noise is not reached.

    A leg that sticks one step later jumps: its sum of squares has creases, in which a search that
    goes down stands still (basin hopping: Wales & Doye, J. Phys. Chem. A 101, 1997).
    """
    random, creased = np.random.default_rng(0), any(map(holds, at.candidate.terms))
    while creased and at.square > FLOOR * prepared.samples:
        starts = [nearby(prepared, at, random) for _ in range(HOPS)]
        ends = side_by_side(lambda one: settle_free(prepared, one, rounds=HOP_ROUNDS), starts)
        best = min(ends, key=lambda one: one.square if np.isfinite(one.square) else np.inf)
        if not best.square < LOWER * at.square:
            break
        at = settle_free(prepared, best.candidate)
    return at


def nearby(prepared: PreparedRecording, at: Optimum, random: np.random.Generator) -> Hypothesis:
    """A place on an ellipsoid around an optimum, on which a parabola would be alike everywhere."""
    normal, unknowns = at.products.total[:-1, :-1], at.candidate.unknowns
    size = np.sqrt(np.diag(normal))
    unit = np.where(size > 0, size, np.inf)
    curved, ways = np.linalg.eigh(normal / np.outer(unit, unit))
    way = random.normal(size=unknowns.size)
    rise = HOP * at.square * 10 ** (HOP_SPREAD * random.uniform(-0.5, 0.5))
    told = np.where(curved > FLAT, way, 0.0) / np.sqrt(np.maximum(curved, FLAT))
    away = ways @ told / np.linalg.norm(way) / unit
    return at.candidate.at(np.clip(unknowns + np.sqrt(rise) * away, *prepared.bounds(at.candidate)))


def given(prepared: PreparedRecording, begin: Hypothesis) -> Linear | None:
    """All its terms as one, along the motion that is behind what the sensors show."""
    if not begin.terms:
        return None
    start = replace(begin, linear=None)
    seen = along_motion.read(prepared, [(start, prepared.measured_motion)])
    return along_motion.linear(prepared, seen)[0]


def descend(prepared, begin, evaluate, rounds, steady, rival=np.inf) -> list[Optimum]:
    """Steps of all candidates together, of each so many `rounds` or until it expects to gain less
    than `steady`, falls too slowly to come near a `rival`, or lies behind another start.

    `evaluate` takes candidates with the motions that they had, and gives products with new ones.
    Where the first step failed, the second is of sizes alone: what is linear is then as large as
    it is, and says where its other parameters should be.
    """
    found = evaluate(prepared, begin)
    at = [Optimum(one, *each) for (one, _), each in zip(begin, found, strict=True)]
    squares = [[each.square] for each in at]
    for done in range(max(rounds, default=0)):
        moving = [
            n
            for n in (range(len(at)) if done < HEAT else leading(at, squares))
            if done < rounds[n] and not at[n].resting and promising(squares[n], rival)
        ]
        if not moving:
            break
        again = [done == 1 and at[number].harder > HARDER for number in moving]
        steps = [step(prepared, at[n], sizes=each) for n, each in zip(moving, again, strict=True)]
        tried = [(to, at[n].motion) for (to, _), n in zip(steps, moving, strict=True)]
        found = evaluate(prepared, tried)
        for number, (to, gain), (products, motion) in zip(moving, steps, found, strict=True):
            least = max(steady, (at[number].square - rival) / AHEAD)
            at[number] = judged(at[number], Optimum(to, products, motion), gain < least, steady)
            squares[number].append(at[number].square)
    return at


def leading(at: list[Optimum], squares: list[list[float]]) -> list[int]:
    """The numbers of the best of the same terms, but of those that the best of all has left far
    behind and that hardly fall.
    """
    best: dict[tuple[type[Term], ...], int] = {}
    for number, one in enumerate(at):
        first = best.setdefault(one.candidate.terms, number)
        if one.square < at[first].square or not np.isfinite(at[first].square):
            best[one.candidate.terms] = number
    far = FAR * min((one.square for one in at if np.isfinite(one.square)), default=np.inf)
    each = best.values()
    return [n for n in each if at[n].square <= far or squares[n][-1] < FAST * squares[n][-2]]


def promising(squares: list[float], rival: float) -> bool:
    """Is it early, or do they still fall, and fast where a rival leaves far less?"""
    if len(squares) > EARLY and squares[-1] > FAR * rival:
        return bool(squares[-1] < FAST * squares[-EARLY // 2])
    return len(squares) <= LONG or squares[-1] < FALLING * squares[-1 - LAST]


def judged(before: Optimum, after: Optimum, resting: bool, steady: float) -> Optimum:
    """Where a candidate stands after a step: there, or where it was and more careful."""
    if not after.square < before.square + steady:
        damping, harder = before.damping * before.harder, before.harder * HASTE
        return replace(before, damping=damping, harder=harder, resting=resting)
    careful = before.damping > CAREFUL
    damping = before.damping * EASIER
    return replace(after, damping=damping, harder=HARDER, resting=resting and not careful)


def step(
    prepared: PreparedRecording, at: Optimum, *, sizes: bool = False
) -> tuple[Hypothesis, float]:
    """The next place to try, and the gain to expect there; with no parameter of a term but its
    size moved, where only `sizes` are.
    """
    unknowns = at.candidate.unknowns
    normal, gradient = at.products.total[:-1, :-1], at.products.total[:-1, -1]
    if not np.isfinite(at.products.total).all():
        return at.candidate, 0.0
    room = np.array(prepared.bounds(at.candidate)) - unknowns
    if sizes:
        room[:, shapes(at.candidate)] = 0.0
    change = bounded(normal, gradient, at.damping, *room)
    gain = -(2 * gradient @ change + change @ normal @ change)
    return at.candidate.at(unknowns + change), float(gain)


def shapes(candidate: Hypothesis) -> np.ndarray:
    """Which unknowns are parameters of a term, but for its first, the size."""
    first = candidate.point.size + candidate.zero.size
    each = [np.arange(value.size) > 0 for value in candidate.values]
    return np.concatenate([np.zeros(first, dtype=bool), *each])


def bounded(
    normal: np.ndarray, gradient: np.ndarray, damping: float, lower: np.ndarray, upper: np.ndarray
) -> np.ndarray:
    """The damped Gauss-Newton step that stays within bounds: what runs into one stays on it, and
    what has no room where it is.
    """
    size = np.sqrt(np.diag(normal))
    unit = np.where(size > 0, size, 1.0)
    scaled = normal / np.outer(unit, unit)
    scaled[np.diag_indices_from(scaled)] += damping + WEAK
    slope = gradient / unit
    fixed = (size == 0) | (lower == upper)
    change = np.zeros_like(slope)
    for _ in range(PASSES):
        free = ~fixed
        known = np.where(fixed, change, 0.0)
        right = -(slope + scaled @ known)[free]
        change[free] = np.linalg.solve(scaled[np.ix_(free, free)], right)
        inside = np.clip(change / unit, lower, upper)
        beyond = (inside != change / unit) & free
        change = np.where(beyond, inside * unit, change)
        if not beyond.any():
            break
        fixed = fixed | beyond
    return change / unit
