"""Which further cause would explain most, to first order: of all of them by one table of products.

Along the measured motion a simulation is linear in torques and in what sensors show. The products
of everything that may act therefore tell what each set of causes would leave, without another look
at the data (regression by normal equations; Miller, Subset Selection in Regression, 2002, ch. 2).
"""

from dataclasses import replace

import jax
import numpy as np

from exoid.mismatch.screen.along_motion import effects_of_last, nothing, read
from exoid.mismatch.screen.hypothesis import Effect, Hypothesis, Optimum
from exoid.mismatch.screen.many_free import respond
from exoid.mismatch.screen.many_pinned import with_columns
from exoid.mismatch.screen.measured_motion import MeasuredMotion, rate
from exoid.mismatch.screen.optimise import bounded
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.term import Term, busy

DAMPED = 1e-6  # relative to the curvature: causes that are much alike are told apart all the same
ROOM = 64  # columns of a program that serves any number of causes, or twice as many, and so on


def nearest(prepared: PreparedRecording, starts: list[Hypothesis], most: int) -> list[Hypothesis]:
    """Of starts that all have the same causes but the last the `most` that would leave least, of
    each last cause the best start, with the step that takes it there.
    """
    if not starts:
        return []
    known = known_of(starts[0])
    seen = read(prepared, [(known, prepared.measured_motion)])[0]
    each = effects_of_last(prepared, starts, seen[1])
    tether = (prepared.tethers or (0.0,))[-1]
    table = with_columns(prepared, seen, padded(prepared, each), tether)
    return [one for _, one in by_what_is_left(prepared, starts, each, table)][:most]


def beside_free(
    prepared: PreparedRecording, usable: list[type[Term]], known: Optimum
) -> list[tuple[float, Hypothesis]]:
    """What runs free with one cause more, by what would be left to first order along its own
    motion: no sensor's noise is in that, which smears what sticks along a measured one.
    """
    angle, velocity = np.moveaxis(known.motion, -1, 0)
    simulated = MeasuredMotion(angle, velocity, rate(velocity, prepared.seen.time))
    starts = [
        known.candidate.with_term(term, value)
        for term in usable
        if term not in known.candidate.terms and not busy(term)
        for value in prepared.starts(term)
    ]
    alone = [replace(one, terms=one.terms[-1:], values=one.values[-1:]) for one in starts]
    each = effects_of_last(prepared, alone, simulated)
    table = respond(prepared, known.candidate, padded(prepared, each))
    return by_what_is_left(prepared, starts, each, table)


def by_what_is_left(
    prepared: PreparedRecording, starts: list[Hypothesis], each: list[Effect], table: np.ndarray
) -> list[tuple[float, Hypothesis]]:
    """What would be left, and where the step leads, of the best start of each last cause. The
    table is over what is known, `each` behind one another, and the residual.
    """
    found: dict[type[Term], tuple[float, Hypothesis]] = {}
    first = known_of(starts[0]).unknowns.size if starts else 0
    for start, effect in zip(starts, each, strict=True):
        columns = np.arange(first, first + effect.shown.shape[0])
        first += columns.size
        left, to = step(prepared, start, table, columns)
        last = start.terms[-1]
        if np.isfinite(left) and not left > found.get(last, (np.inf,))[0]:
            found[last] = left, to
    return sorted(found.values(), key=lambda one: one[0])


def known_of(start: Hypothesis) -> Hypothesis:
    """The start without its last cause."""
    return replace(start, terms=start.terms[:-1], values=start.values[:-1])


def padded(prepared: PreparedRecording, each: list[Effect]) -> Effect:
    """All of them behind one another, up to the size of the program."""
    count, room = sum(one.shown.shape[0] for one in each), ROOM
    while room < count:
        room *= 2
    rest = nothing(prepared, room - count)
    return jax.tree.map(lambda *leaves: np.concatenate(leaves), *each, rest)


def step(
    prepared: PreparedRecording, start: Hypothesis, table: np.ndarray, columns: np.ndarray
) -> tuple[float, Hypothesis]:
    """What is left after one step from a start, and where it leads; its last cause does what the
    first of its `columns` says, and its parameters change that by the others.
    """
    at, usual, now = start.unknowns, prepared.usual, columns[0]
    rows = [*range(at.size - columns.size + 1), *columns[1:]]
    normal, gradient = table[np.ix_(rows, rows)], table[rows, -1] + table[rows, now]
    square = table[-1, -1] + 2 * table[now, -1] + table[now, now]
    unusual = usual * at[: usual.size]
    normal[range(usual.size), range(usual.size)] += usual**2
    gradient[: usual.size] += usual * unusual
    lower, upper = prepared.bounds(start)
    change = bounded(normal, gradient, DAMPED, lower - at, upper - at)
    left = square + unusual @ unusual + 2 * gradient @ change + change @ normal @ change
    return float(left), start.at(at + change)
