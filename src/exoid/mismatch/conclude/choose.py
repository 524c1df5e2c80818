"""From the baseline to one cause, from there to more: where it is clear, and where it holds."""

from dataclasses import dataclass
from itertools import groupby

from exoid.mismatch.evidence.prediction import Prediction, improves
from exoid.mismatch.evidence.proof import predict
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found, causes
from exoid.mismatch.search.rank import alike, by_evidence

FURTHER = 2.0  # times as far apart must a set be from one with fewer causes: it is one of many


@dataclass(frozen=True, eq=False)
class Chosen:
    """The best explanation that holds on held-out data, and what it and the baseline predict."""

    best: Optimum
    before: Prediction
    after: Prediction


def choose(found: Found) -> Chosen:
    """The best explanation.

    More causes at once are only believed where they leave far less than fewer do, and predict
    better what they have not seen: what bends one way or another can be had from many sets.
    """
    before = predict(found.prepared, found.base)
    chosen = Chosen(found.base, before, before)
    for better in by_count(found):
        first = chosen.best is found.base
        if not found.clear(chosen.best, better):
            continue
        if not first and alike(chosen.best, better, found.yardstick, FURTHER):
            continue
        after = predict(found.prepared, better)
        if first or improves(chosen.after, after):
            chosen = Chosen(better, before, after)
    return chosen


def by_count(found: Found) -> list[Optimum]:
    """The best of one cause, the best of two, and so on."""
    every = [*found.singles[:1], *found.pairs]
    every.sort(key=causes)
    same = [list(each) for _, each in groupby(every, key=causes)]
    return [by_evidence(each, found.base, found.yardstick)[0] for each in same]
