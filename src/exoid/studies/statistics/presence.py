"""Of how many people, recordings and drops a quantity has a value, and of how many it has none."""

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from scipy.stats import fisher_exact

from exoid.studies.statistics.mixed.covariates import label
from exoid.studies.statistics.tables.frames import Column, Frame
from exoid.studies.statistics.tables.study import Study
from exoid.studies.statistics.tables.values import (
    DIAGNOSED,
    FITTED,
    WHOLE,
    Values,
    asked_rows,
    of_recordings,
)

CHANCE = 0.05  # p, from which shares that are missing may be alike
UNEVEN = 0.05  # by which shares that are missing differ before it is said: one of twenty
INCOMPLETE = "misses something"  # of its model, as the note of a fit says
NUMBER = re.compile(r"\d+(?:[.,:]\d+)*(?:e[+-]?\d+)?")


@dataclass(frozen=True)
class Count:
    """How many of those there are have a value."""

    told: int
    of: int

    @property
    def missing(self) -> int:
        return self.of - self.told


def by_chance(counts: Sequence[Count]) -> float:
    """p of shares as unlike as these: of Fisher's exact test of each part against all others, by
    Bonferroni.
    """
    lacking, there = sum(each.missing for each in counts), sum(each.told for each in counts)
    each_p = [exact([[n.missing, n.told], [lacking - n.missing, there - n.told]]) for n in counts]
    return min(each_p) * (len(counts) if len(counts) > 2 else 1)


def exact(table: list[list[int]]) -> float:
    """p of Fisher's test."""
    found: Any = fisher_exact(table)
    return float(found.pvalue)


@dataclass(frozen=True)
class Tally:
    """All, and by what parts them: `group` or `side`, then its names."""

    every: Count
    parts: Mapping[str, Mapping[str, Count]]

    def uneven(self, part: str) -> bool:
        """Do shares that are missing differ, by more than chance?"""
        counts = [*self.parts.get(part, {}).values()]
        shares = [each.missing / each.of for each in counts]
        return bool(shares) and max(shares) - min(shares) > UNEVEN and by_chance(counts) < CHANCE


@dataclass(frozen=True)
class Presence:
    """`values` are of recordings that have one. `complete` are the values of fits, without those
    whose model misses something. `missing` are the people without a value, `reason` is of values
    that are missing an example of the most frequent one.
    """

    people: Tally
    recordings: Tally
    values: Tally
    complete: Tally
    missing: tuple[str, ...]
    reason: str


def presence(
    study: Study, values: Values, asked: tuple[str, str], whom: Collection[str]
) -> Presence:
    """Of the task and the column of groups `asked`; an answer rests on the people `whom`."""
    task, by = asked
    table = study.once[study.once["participant"] != ""]
    table = table[table["task"] == task] if task else table
    table = table.assign(group=groups_of(table, by))
    people = table.drop_duplicates("participant")
    rows = of_drops(asked_rows(study, values.quantity, task))
    rows = rows[rows["recording"].isin(table["recording"])]
    group = table.drop_duplicates("recording").set_index("recording")["group"]
    rows = rows.assign(group=rows["recording"].map(group))
    there = people["participant"].isin(list(whom))
    used = rows["value"].notna() & of_recordings(rows)
    partly = rows[rows["recording"].isin(rows.loc[used, "recording"])]
    return Presence(
        tally(people, there, ("group",)),
        tally(table, table["recording"].isin(values.frame["recording"]), ("group", "side")),
        tally(partly, used[partly.index], ("group", "side")),
        complete(study, rows),
        tuple(sorted(people.loc[~there, "participant"])),
        reason_of(rows[rows["value"].isna()]),
    )


def complete(study: Study, rows: Frame) -> Tally:
    """How many values of fits are of a model that misses nothing which the recording tells."""
    fitted = rows[rows["step"].isin((FITTED, DIAGNOSED)) & rows["value"].notna()]
    notes = study.quantities[study.quantities["quantity"] == "note"]
    missed = notes.loc[notes["note"].str.contains(INCOMPLETE, regex=False), "recording"]
    mended = fitted["step"] == DIAGNOSED
    return tally(fitted, mended | ~fitted["recording"].isin(missed), ("group",))


def groups_of(table: Frame, by: str) -> Column | str:
    """The name of each one's group; doses and people of none have none."""
    return table[by].map(label, na_action="ignore") if by in table else ""


def of_drops(rows: Frame) -> Frame:
    """Of each drop; of recordings as wholes where no drop is told."""
    drops = rows[rows["segment"] != WHOLE]
    return rows if drops.empty else drops


def tally(rows: Frame, there: Column, parts: tuple[str, ...]) -> Tally:
    """How many are there, of all and of each part that has a name."""
    found = {}
    for part in parts:
        named = rows[part].where(rows[part] != "").dropna()
        grouped = there[named.index].groupby(named)
        found[part] = {str(name): Count(int(each.sum()), len(each)) for name, each in grouped}
    return Tally(Count(int(there.sum()), len(rows)), found)


def reason_of(rows: Frame) -> str:
    """A note of the most frequent kind."""
    said = rows.loc[rows["note"] != "", "note"]
    kinds = said.map(without_numbers)
    return "" if said.empty else str(said[kinds == kinds.value_counts().index[0]].iloc[0])


def without_numbers(sentence: str) -> str:
    """Sentences that differ in their numbers alone are one."""
    return NUMBER.sub("…", sentence)
