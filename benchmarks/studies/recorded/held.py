"""Whether the intervals of a report hold the truth."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import nan
from typing import Any

import numpy as np

from .truths import Truth


@dataclass(frozen=True)
class Held:
    """One interval of one study, and what is true."""

    name: str
    value: float
    low: float
    high: float
    truth: float

    @property
    def holds(self) -> bool:
        return self.low <= self.truth <= self.high


def held(document: Mapping[str, Any], truths: Mapping[str, Truth]) -> list[Held]:
    """Of every quantity the difference of the groups, test and retest."""
    return [
        of_interval(f"{what} of {quantity}", interval, truth)
        for quantity, true in truths.items()
        for what, interval, truth in asked_of(document["quantities"][quantity], true)
    ]


def asked_of(answer: Mapping[str, Any], true: Truth) -> list[tuple[str, Any, float]]:
    groups, again = answer["groups"], answer["reliability"]
    return [
        ("difference", groups["differences"][0]["effect"], true.difference),
        ("ICC(A,1)", again["agreement"], true.correlation),
        ("ICC(C,1)", again["consistency"], true.correlation),
        ("detectable change", again["change"], true.change),
    ]


def of_interval(name: str, each: Mapping[str, float | None], truth: float) -> Held:
    """Without an interval it is one that holds nothing."""
    low, high = (nan if end is None else end for end in (each["low"], each["high"]))
    return Held(name, each["value"] or nan, low, high, truth)


def table(found: Sequence[Held]) -> list[str]:
    """A line for each name: of one study its interval, of several how often it holds."""
    lines = []
    for name in dict.fromkeys(each.name for each in found):
        those = [each for each in found if each.name == name]
        count, truth = sum(each.holds for each in those), those[0].truth
        value = float(np.mean([each.value for each in those]))
        said = f"{name:42} truth {truth:8.4f}, found {value:8.4f}"
        if len(those) == 1:
            said += f" ({those[0].low:.4f} to {those[0].high:.4f})"
        lines.append(f"  {said}, held {count} of {len(those)}")
    return lines
