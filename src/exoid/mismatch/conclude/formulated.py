"""What the library does not know: the best formula as a term, against the best of the library."""

from dataclasses import replace
from functools import partial

import numpy as np

from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.conclude.choose import Chosen
from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.evidence.prediction import improves
from exoid.mismatch.evidence.proof import predict
from exoid.mismatch.evidence.yardstick import SURE
from exoid.mismatch.novel.formula import Formula, term_of
from exoid.mismatch.novel.sparse_regression import describe
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.search.found import Found, causes

LEFT = 0.5  # of what the library leaves, that a formula may leave to take its place
KNOWN = 0.5  # share of a formula that a term of the library is, up to which it is new


def formulated(found: Found, chosen: Chosen) -> tuple[Chosen, Formula | None]:
    """The best formula as a term, where it explains more than the library does.

    One that a single cause of the library knows is that cause; a set may imitate what is new.
    """
    if not possible(found, chosen.best):
        return chosen, None
    single = causes(chosen.best) < 2
    new = [
        each for each in describe(found.prepared, found.begin) if each.known <= KNOWN or not single
    ]
    if not new:
        return chosen, None
    tried = [free(found, each) for each in new]
    one, formula = max(zip(tried, new, strict=True), key=lambda each: found.evidence(each[0]))
    if better(found, one, chosen.best) and found.clear(found.base, one):
        after = predict(found.prepared, one)
        if improves(chosen.after, after):
            return Chosen(one, chosen.before, after), formula.at(one.candidate.values[-1])
    return chosen, None


def by_what_is_left(found: Found, one: Optimum) -> Found:
    """The same, all measured by what a formula leaves: what the library left beside it was no
    noise, and made candidates that it refutes seem as likely.
    """
    return replace(found, yardstick=yardstick(found.prepared, one))


def possible(found: Found, best: Optimum) -> bool:
    """Would one with a single parameter that leaves only noise be enough better than the library?
    Where sets of few causes reach the noise, none can be.
    """
    rival = nearest(found, best)
    if not found.yardstick.explains(rival.square):
        return True
    left = min(rival.square, float(found.yardstick.samples))
    most = found.yardstick.evidence(found.base.square, left, 1)
    return most > found.evidence(rival) + SURE


def nearest(found: Found, best: Optimum) -> Optimum:
    """What of the library explains most."""
    return max((best, *found.singles, *found.pairs), key=found.evidence)


def free(found: Found, formula: Formula) -> Optimum:
    """A formula as a term, running free from its size along the measured motion, where the leg may
    be another one, and from none.
    """
    term, count = term_of(formula), len(formula.features)
    sizes = formula.values, np.where(np.arange(formula.values.size) < count, 0.0, formula.values)
    starts = [found.begin.with_term(term, each) for each in sizes]
    ends = side_by_side(partial(settle_free, found.prepared), starts)
    return min(ends, key=lambda one: one.square if one.sound else np.inf)


def better(found: Found, one: Optimum, best: Optimum) -> bool:
    """Does a formula explain so much more than the library that it must be something else?"""
    rival = nearest(found, best)
    if not found.yardstick.explains(rival.square):
        return one.square < LEFT * rival.square
    return found.evidence(one) > found.evidence(rival) + SURE
