"""Shares of right answers, in a table and as a curve."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from scipy.stats import beta

from exoid.report.plots.style import TEXT

from .outcomes import Outcome

BINS = (0.0, 0.3, 0.5, 0.7, 0.9, 0.97, 0.99, 0.999, 1.0)  # of the weight
HEAD = ("world", "kind", "recordings", "asserted", "all named", "wrong", "wrong at most")
SURE = 0.95  # of an interval
DOTS = 200  # per inch
SAID = ("weights of the bin", "their mean", "share that is right (95 %)")


def asserted_rows(found: Sequence[Outcome]) -> list[tuple[str, ...]]:
    """What was asserted of every world and kind, and of all."""
    groups = sorted({(one.world, one.kind) for one in found})
    rows = [row(*group, [one for one in found if (one.world, one.kind) == group])
            for group in groups]  # fmt: skip
    return [*rows, row("both", "all", list(found))]


def row(world: str, kind: str, some: list[Outcome]) -> tuple[str, ...]:
    sure = [one for one in some if one.asserted]
    wrong = sum(one.right is False for one in sure)
    _, most = interval(wrong, len(sure))
    whole = sum(one.whole for one in sure)
    counts = (len(some), len(sure), whole, wrong)
    return world, kind, *map(str, counts), f"{most:.1%}" if sure else "-"


def binned(found: Sequence[Outcome], edges: Sequence[float]) -> list[tuple[str, ...]]:
    """By weight: how many answers, their mean weight and the share that is right."""
    return [
        (f"{low:.1%} to {high:.1%}", str(count), f"{mean:.1%}", f"{right} ({right / count:.1%})")
        for low, high, count, mean, right in parts(found, edges)
    ]


def parts(
    found: Sequence[Outcome], edges: Sequence[float]
) -> Iterator[tuple[float, float, int, float, int]]:
    """(low, high, count, mean weight, right) of every bin that is not empty."""
    told = [(one.weight, one.right) for one in found if None not in (one.weight, one.right)]
    weight, right = (np.array(each, float) for each in zip(*told, strict=True))
    place = np.clip(np.searchsorted(edges, weight, side="right") - 1, 0, len(edges) - 2)
    for number, (low, high) in enumerate(pairwise(edges)):
        here = place == number
        if here.any():
            yield low, high, int(here.sum()), float(weight[here].mean()), int(right[here].sum())


def interval(hits: int, count: int) -> tuple[float, float]:
    """Clopper and Pearson's, of a share."""
    tail = (1 - SURE) / 2
    low = beta.ppf(tail, hits, count - hits + 1) if hits else 0.0
    high = beta.ppf(1 - tail, hits + 1, count - hits) if hits < count else 1.0
    return float(low), float(high)


def draw(found: Sequence[Outcome], path: Path) -> None:
    """The share of right answers of every bin of weights, with 95 % intervals, beside the weight.

    Weights crowd at 1, so that bins stand evenly.
    """
    told = list(parts(found, BINS))
    with mpl.rc_context(TEXT):
        figure = Figure(figsize=(4.6, 3.0), layout="constrained")
        axes = figure.subplots()
        for place, (low, high, count, mean, right) in enumerate(told):
            ends = [100 * each for each in interval(right, count)]
            axes.bar(place, 100 * (high - low), 0.8, 100 * low, color="0.85", label=SAID[0])
            axes.plot([place - 0.4, place + 0.4], 2 * [100 * mean], color="0.5", label=SAID[1])
            axes.plot([place, place], ends, color="#0072B2", linewidth=1.2, label=SAID[2])
            axes.plot(place, 100 * right / count, "o", color="#0072B2", markersize=5)
            axes.annotate(f"n = {count}", (place, 103), ha="center", annotation_clip=False)
        names = [f"{100 * low:g} to\n{100 * high:g} %" for low, high, *_ in told]
        axes.set_xticks(range(len(told)), names)
        axes.set(ylim=(0, 101), xlabel="weight of what the best answer names", ylabel="right [%]")
        once = dict(zip(*reversed(axes.get_legend_handles_labels()), strict=True))
        figure.legend(once.values(), once.keys(), loc="outside upper left", frameon=False, ncols=3)
        figure.savefig(path, dpi=DOTS)
