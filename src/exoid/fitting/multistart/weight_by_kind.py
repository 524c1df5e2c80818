"""What every kind of segment misses, and by how much each therefore counts.

Eq. 9 may hold to the noise where a leg swings by itself, and miss how it is moved at will; or the
other way round. One process for all segments would then spoil what the good ones tell. So each kind
is also fitted alone: where processes of their own explain what is left much better than one for
all, every kind's residual is divided by the largest factor by which its errors are widened, and
that of all but the best by ten times as much. None then counts for more than it carries.
"""

from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.disturbance.explain import CLEAR, explain
from exoid.fitting.misfit.gram import CAUSES, Cause, Grams
from exoid.fitting.misfit.information import common, spoiled
from exoid.fitting.misfit.missed import DOUBT, KINDS, NOISY, Disturbance, Missed
from exoid.fitting.model.coordinates import layout
from exoid.fitting.multistart.beginning.tethers import FINE, led
from exoid.fitting.solve.ask import advance, better_of, declared_at, grams_at, left_by, take, task
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved

PLAUSIBLE = 0.3  # of what moves the leg: a model that misses more is none
# Gain of log likelihood below which all kinds miss the same. To hold that movements at will, which
# lean on a form of their torque and are short, miss less than the others, takes more.
DIFFERENT = {"passive": CLEAR, "measured": CLEAR, "active": 2 * CLEAR}
BLIND = 1e8  # what the residual of a segment is divided by that is not to count


def explained(problem: Problem, at: Solved, row: int = 0) -> Disturbance:
    """What is in the residual of all segments alike, and what it leaves of their information."""
    size = layout(take(at.coordinates, row)).size
    every, most = grams_at(problem, at, row), plausible(problem.observation)
    each = [*every, declared_at(problem, at, row)]
    found = explain(each, most, count(problem, problem.kinds), size)
    return left_by(every, problem, at, row, common(found, problem.kinds))


def likelihood(problem: Problem, at: Solved, row: int, weighed: Disturbance) -> float:
    """The logarithm of the likelihood of what is in the residual: of all segments, or of those that
    are weighed most.
    """
    if not weighed.apart:
        return next(iter(explained(problem, at, row).kinds.values())).likelihood
    kind, size = weighed.trusted, layout(take(at.coordinates, row)).size
    each = [*of_kind(problem, kind, at, row), declared_at(problem, at, row)]
    return explain(each, plausible(problem.observation), count(problem, [kind]), size).likelihood


def by_themselves(problem: Problem, at: Solved, row: int, alike: Disturbance) -> Solved | None:
    """Where every kind of segments ends by itself, one lane a kind; None where there is one kind,
    or nothing but noise is `alike` in all.
    """
    kinds = kinds_of(problem)
    if len(kinds) < 2 or (alike.cause is None and alike.noise < NOISY):
        return None
    solved = alone(problem, at, row, kinds)
    return solved if np.isfinite(solved.loss).all() else None


def explained_apart(problem: Problem, solved: Solved | None, alike: Disturbance) -> Disturbance:
    """What is missed by kinds of segments, each `solved` by itself, where that explains much better
    what is `alike` in all.
    """
    if solved is None:
        return alike
    kinds = kinds_of(problem)
    size, most = layout(take(solved.coordinates, 0)).size, plausible(problem.observation)
    parts = [of_kind(problem, kind, solved, lane) for lane, kind in enumerate(kinds)]
    told = [[*part, declared_at(problem, solved, lane)] for lane, part in enumerate(parts)]
    counts = [count(problem, [kind]) for kind in kinds]
    own = {
        kind: explain(grams, most, counted, size)
        for kind, grams, counted in zip(kinds, told, counts, strict=True)
    }
    together = explain(side_by_side(told, size), most, sum(counts), size * len(kinds))
    gain = sum(missed.likelihood for missed in own.values()) - together.likelihood
    if not any(missed.cause for missed in own.values()):
        # Each is explained by itself, but not with the others: then it is the last that is off.
        own[kinds[-1]] = next(iter(alike.kinds.values()))
    widened = {
        kind: most_widened(own[kind], kind, part, size)
        for kind, part in zip(kinds, parts, strict=True)
    }
    least = min(widened, key=widened.__getitem__)
    if gain < DIFFERENT[least]:
        return alike
    scales = {kind: DOUBT * each / widened[least] for kind, each in widened.items()}
    scales[least] = 1.0
    counts = [int(problem.samples[np.isin(problem.kinds, [kind])].sum()) for kind in kinds]
    left = np.sqrt(solved.misfit / np.array(counts))
    by_itself = dict(zip(kinds, left.tolist(), strict=True))
    return replace(alike, kinds=own, scales=scales, alone=by_itself)


def as_weighed(problem: Problem, found: Disturbance) -> Problem:
    """The same, what is declared of a torque sensor's zero counting as little as the segments that
    alone show it: else the less these weigh, the more it would stay as declared.
    """
    if "torque_zero" not in problem.owned:
        return problem
    wider = found.scales.get("measured", 1.0)
    return problem.widened(torque_zero=wider * problem.deviation_of("torque_zero"))


def alone(problem: Problem, at: Solved, row: int, kinds: list[str]) -> Solved:
    """Where a fit to the segments of each of these kinds alone ends: one lane a kind.

    It begins where all together ended, and once more tied to the measured motion with everything
    as declared: what bad segments made of seat and zero leads astray.
    """
    counts = np.array([[kind == own for own in problem.kinds] for kind in kinds])
    near, size = take(at.coordinates, [row] * len(kinds)), len(kinds)
    scale = np.where(counts, 1.0, BLIND)
    anew = led(problem, replace(near, mounting=jax.tree.map(np.zeros_like, near.mounting)), scale)
    starts = jax.tree.map(lambda *each: np.concatenate(each), near, anew)
    asked = task(problem, 0.0, problem.steps, FINE)
    ended = advance(problem, starts, asked, np.concatenate([scale, scale]))
    return better_of(take(ended, np.arange(size)), take(ended, np.arange(size, 2 * size)))


def kinds_of(problem: Problem) -> list[str]:
    """The kinds of its segments, in the order in which they are trusted."""
    return [kind for kind in KINDS if kind in problem.kinds]


def of_kind(problem: Problem, kind: str, at: Solved, row: int) -> list[Grams]:
    """Of the segments of one kind, at one end point."""
    each = zip(grams_at(problem, at, row), problem.kinds, strict=True)
    return [grams for grams, own in each if own == kind]


def side_by_side(parts: list[list[Grams]], size: int) -> list[Grams]:
    """All in one, as if every kind were of a leg of its own."""
    return [
        {cause: replace(gram, place=gram.place + number * size) for cause, gram in grams.items()}
        for number, part in enumerate(parts)
        for grams in part
    ]


def most_widened(missed: Missed, kind: str, part: list[Grams], size: int) -> float:
    """The largest factor by which the errors of this kind alone are widened."""
    each = [grams[missed.cause or CAUSES[0]] for grams in part]
    found = spoiled(common(missed, [kind]), each, [kind] * len(each), size)
    return float(found.widening.max())


def count(problem: Problem, kinds: list[str]) -> int:
    """Measured numbers of all segments of these kinds, and what is declared of the recordings."""
    declared = sum(leaf.size for leaf in jax.tree.leaves(problem.belief.prior.mounting))
    return declared + int(problem.samples[np.isin(problem.kinds, kinds)].sum())


def plausible(seen: Observation) -> dict[Cause, float]:
    """The largest deviation of what is missed: a part of the leg's acceleration, or its angle."""
    used = np.asarray(seen.angle_weight)[:, 1:] > 0
    time, angle, velocity = map(np.asarray, (seen.time, seen.guide_angle, seen.guide_velocity))
    acceleration = (np.diff(velocity, axis=1) / np.diff(time, axis=1))[used]
    return {
        "torque": PLAUSIBLE * float(np.std(acceleration)),
        "encoder": PLAUSIBLE * float(np.std(angle[:, 1:][used])),
    }
