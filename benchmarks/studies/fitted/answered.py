"""What a fitted study answers, and what became of its recordings, beside what is true."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from benchmarks.studies.tables import Truth

from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Answer, Asked
from exoid.studies.statistics.tables.said import Interval
from exoid.studies.statistics.tables.study import Study

from .world import Visit, World
from .write import name_of

MISSED = "misses something"  # of a fit's model, in its own words
PARTLY = "behind the release were left out"
NOTES = (MISSED, PARTLY)
COVERED = 1.96  # standard errors


@dataclass(frozen=True)
class Told:
    """Of one quantity: its intervals by question as (value, low, high), and the corrected p of the
    difference.
    """

    quantity: str
    intervals: dict[str, tuple[float, float, float]]
    p: float


@dataclass(frozen=True)
class Fitted:
    """Of the recordings of one kind and one quantity: how many have a value, how many of these are
    within 1.96 of their errors, the sum of what they are off by, and of its squares.
    """

    quantity: str
    valued: int
    held: int
    off: float
    square: float


@dataclass(frozen=True)
class Kind:
    """Recordings with one fault: how many failed, of how many the fit says that it misses
    something, of how many others that their first swing is kept back, and left out.
    """

    name: str
    recordings: int
    failed: int
    missed: int
    partly: int
    fitted: tuple[Fitted, ...]


@dataclass(frozen=True)
class Answered:
    """One study; `exact` is what it would say if no fit had an error."""

    seed: int
    told: tuple[Told, ...]
    exact: tuple[Told, ...]
    kinds: tuple[Kind, ...]


def told_of(study: Study, world: World) -> tuple[Told, ...]:
    """What a report would say."""
    truths = world.design.truths
    names = tuple(each.quantity for each in truths)
    answers = ask(study, Asked(quantities=names, by="group")).each
    pairs = zip(sorted(answers, key=lambda one: names.index(one.quantity)), truths, strict=True)
    return tuple(of_answer(*each) for each in pairs)


def of_answer(answer: Answer, truth: Truth) -> Told:
    found = answer.reliability
    intervals = {
        "difference of the groups": answer.groups.differences[0].effect,
        "ICC(C,1)": found.consistency,
        "ICC(A,1)": found.agreement,
        "minimal detectable change": found.change,
    }
    plain = {name: ends(each) for name, each in intervals.items()}
    return Told(truth.quantity, plain, answer.corrected["groups"])


def ends(each: Interval) -> tuple[float, float, float]:
    return each.value, each.low, each.high


def values_by_name(study: Study, quantity: str) -> dict[str, tuple[float, float]]:
    """Value and standard error of every recording, NaN where there is none."""
    rows = study.quantities
    rows = rows[(rows["quantity"] == quantity) & (rows["step"] == "fit") & (rows["segment"] == -1)]
    columns = (rows[each].to_numpy(float) for each in ("value", "standard_error"))
    told = dict(zip(rows["name"], zip(*columns, strict=True), strict=True))
    return {name: told.get(name, (np.nan, np.nan)) for name in study.recordings["name"]}


def kinds_of(study: Study, world: World, visits: Sequence[Visit]) -> tuple[Kind, ...]:
    """By what is wrong with recordings."""
    return tuple(kinds(study, [each.quantity for each in world.design.truths], visits))


def kinds(study: Study, quantities: Sequence[str], visits: Sequence[Visit]) -> Iterator[Kind]:
    table, rows = study.recordings, study.quantities
    failed = {*table.loc[table["status"] == "failed", "name"]}
    missed, partly = ({*rows.loc[rows["note"].str.contains(each), "name"]} for each in NOTES)
    for name in sorted({each.kind for each in visits}):
        those = [each for each in visits if each.kind == name]
        names = {name_of(each) for each in those}
        fitted = tuple(fitted_of(study, each, those) for each in quantities)
        counts = (len(names & each) for each in (failed, missed, partly - missed - failed))
        yield Kind(name, len(those), *counts, fitted)


def fitted_of(study: Study, quantity: str, visits: Sequence[Visit]) -> Fitted:
    values = values_by_name(study, quantity)
    each = np.array([[*values[name_of(one)], one.truth(quantity)] for one in visits])
    value, error, truth = each[np.isfinite(each).all(axis=1)].T
    off = value - truth
    held = int(np.sum(np.abs(off) < COVERED * error))
    return Fitted(quantity, off.size, held, float(off.sum()), float(np.sum(off**2)))
