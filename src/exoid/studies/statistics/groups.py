"""Groups of people, or a dose, against a quantity, all drops of all days at once."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

import numpy as np
from jaxtyping import Float
from scipy.stats import f

from exoid.files.counted import counted, some_of
from exoid.studies.statistics.agreement import wald
from exoid.studies.statistics.hedges import hedges
from exoid.studies.statistics.mixed.covariates import apart, centred, label
from exoid.studies.statistics.mixed.fit_mixed import Mixed, fit_mixed
from exoid.studies.statistics.multiple import corrected
from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.said import Interval, NotTold
from exoid.studies.statistics.tables.values import Values, per_person

FEWEST = 2  # people of a group
MOST_GROUPS = 12
NAMED = 8  # people who are left out; the others are counted
Contrast = Float[np.ndarray, " effect"]


@dataclass(frozen=True)
class Group:
    """People who share a word, and their mean."""

    name: str
    people: int
    mean: Interval


@dataclass(frozen=True)
class Difference:
    """`second` less `first`, which Hedges' g has in standard deviations of people; `p` is corrected
    among the pairs.
    """

    first: str
    second: str
    effect: Interval
    p: float
    g: Interval


@dataclass(frozen=True, eq=False)
class Comparison:
    """`kind` says whether the column names groups or counts a dose; then `slope` is the change per
    unit of it. `p` asks whether there is any difference.
    """

    quantity: str
    unit: str
    by: str
    kind: Literal["groups", "dose"]
    people: int
    p: float
    groups: tuple[Group, ...] = ()
    differences: tuple[Difference, ...] = ()
    slope: Interval | None = None
    notes: tuple[str, ...] = ()


def compare_groups(values: Values, by: str, adjust: Sequence[str] = ()) -> Comparison:
    """Of the column `by` of people: words are groups, numbers of three sizes or more a dose.

    Columns of `adjust` are held at their mean: numbers, or words as the shares that they have.
    **Raises** `NotTold` (why) where there is nothing to compare, or where `by` and `adjust` part
    people in the same way.
    """
    frame, notes = complete(values, [by, *adjust])
    held = [each for column in adjust for each in centred(frame, column)]
    numbers = frame[by].map(type).isin([int, float]).all() and frame[by].nunique() > 2
    if numbers:
        dose = frame[by].to_numpy(float)
        effects = apart([np.ones(len(frame)), dose - dose.mean(), *held], by, adjust)
        return of_dose(values, by, fit_mixed(frame, effects), notes)
    names = sorted(frame[by].map(label).unique())
    labels = frame[by].map(label)
    sizes = {each: frame.loc[labels == each, "person"].nunique() for each in names}
    check(by, sizes)
    columns = [(labels == each).to_numpy(float) for each in names]
    effects = apart([np.ones(len(frame)), *columns[1:], *held], by, adjust)
    return of_groups(
        values, frame.assign(group=labels), by, fit_mixed(frame, effects), (sizes, notes)
    )


def complete(values: Values, columns: Sequence[str]) -> tuple[Frame, tuple[str, ...]]:
    """Rows of people of whom all columns are known, once each."""
    frame = values.frame
    for column in columns:
        if column not in frame:
            raise NotTold(f"The table of participants has no column {column!r}.")
        several = frame.dropna(subset=[column]).groupby("person")[column].nunique() > 1
        if several.any():
            who = ", ".join(several.index[several][:3])
            raise NotTold(f"{column!r} is not one thing for each person: see {who}.")
    known = frame[columns].notna().all(axis=1) & (frame[columns] != "").all(axis=1)
    absent = sorted(frame.loc[~known, "person"].unique())
    what = " or ".join(each.removeprefix("participant_").replace("_", " ") for each in columns)
    who = f"{counted(len(absent), 'person', 'people')} left out ({some_of(absent, NAMED, 'more')})"
    notes = (f"{who}: {what} is not known.",) if absent else ()
    if not known.any():
        raise NotTold(f"{what} is known of nobody.")
    return frame[known].reset_index(drop=True), notes


def check(by: str, sizes: dict[str, int]) -> None:
    if len(sizes) < 2:
        word = by.removeprefix("participant_")
        raise NotTold(f"All people with a value are of one {word}: {', '.join(sizes)}.")
    if len(sizes) > MOST_GROUPS:
        raise NotTold(f"{by!r} has {len(sizes)} groups: at most {MOST_GROUPS} are compared.")
    if min(sizes.values()) < FEWEST:
        each = ", ".join(f"{name} {people}" for name, people in sizes.items())
        raise NotTold(f"People with a value: {each}; {FEWEST} of each group are needed.")


def of_dose(values: Values, by: str, mixed: Mixed, notes: tuple[str, ...]) -> Comparison:
    """The change per unit of dose."""
    freedom = mixed.people - mixed.effects.size
    slope, p = wald(float(mixed.effects[1]), float(mixed.covariance[1, 1]) ** 0.5, freedom)
    told = f"{by} is a number, and taken as a dose; name groups by words to compare them."
    return Comparison(
        values.quantity, values.unit, by, "dose", mixed.people, p, slope=slope, notes=(*notes, told)
    )


def of_groups(
    values: Values, frame: Frame, by: str, mixed: Mixed, said: tuple[dict[str, int], tuple]
) -> Comparison:
    """Means, any difference at all, and each pair."""
    sizes, notes = said
    freedom = mixed.people - mixed.effects.size
    rows = np.eye(mixed.effects.size)[: len(sizes)]
    at_mean = contrasts(mixed, len(sizes))
    groups = tuple(
        Group(name, people, told(mixed, each, freedom)[0])
        for (name, people), each in zip(sizes.items(), at_mean, strict=True)
    )
    differences = of_pairs(values, frame, mixed, list(sizes))
    p = any_difference(mixed, rows[1:], freedom)
    about = (values.quantity, values.unit, by, "groups", mixed.people, p)
    return Comparison(*about, groups, differences, notes=notes)


def of_pairs(
    values: Values, frame: Frame, mixed: Mixed, names: list[str]
) -> tuple[Difference, ...]:
    """Each two groups, in the order of their names."""
    freedom = mixed.people - mixed.effects.size
    means = per_person(Values(values.quantity, values.unit, frame))["value"]
    of_whom = frame.groupby("person")["group"].first()
    people = [means[of_whom == name] for name in names]
    at_mean = contrasts(mixed, len(names))
    pairs = list(combinations(range(len(names)), 2))
    each = [told(mixed, at_mean[second] - at_mean[first], freedom) for first, second in pairs]
    among = corrected([p for _, p in each], "holm")
    return tuple(
        Difference(
            names[first],
            names[second],
            effect,
            p,
            hedges(effect, freedom, people[first], people[second]),
        )
        for (first, second), (effect, _), p in zip(pairs, each, among, strict=True)
    )


def contrasts(mixed: Mixed, groups: int) -> Float[np.ndarray, "group effect"]:
    """The mean of each group; effects of the others are added to that of the first."""
    rows = np.eye(mixed.effects.size)[:groups]
    return np.vstack([rows[:1], rows[0] + rows[1:]])


def any_difference(mixed: Mixed, apart: Float[np.ndarray, "difference effect"], freedom: int):
    """p of Wald's F over all differences at once."""
    away = apart @ mixed.effects
    wide = apart @ mixed.covariance @ apart.T
    ratio = float(away @ np.linalg.solve(wide, away)) / len(apart)
    return float(f.sf(ratio, len(apart), freedom))


def told(mixed: Mixed, contrast: Contrast, freedom: int) -> tuple[Interval, float]:
    """A sum of effects."""
    error = float(contrast @ mixed.covariance @ contrast) ** 0.5
    return wald(float(contrast @ mixed.effects), error, freedom)
