"""Scores a detector of free movements alone: begins and ends against what the hands did.

A detector is FUNCTION(path of a table) -> for each segment a list of (begin, end) in seconds of
the time column, the stretches that it takes for free motion. Each should begin no earlier than the
hand is harmless and hardly later, and end no later than a hand comes back.
"""

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

Found = Sequence[Sequence[tuple[float, float]]]
Detector = Callable[[Path], Found]


@dataclass(frozen=True)
class Meeting:
    """One drop and what was found of it, in samples of its device."""

    case: str
    device: str
    drop: int
    early: float  # begin before the hand was harmless; negative: after it
    beyond: float  # end after a hand came back; negative: before it


def detector(name: str) -> Detector:
    """From MODULE:FUNCTION."""
    module, _, function = name.partition(":")
    return getattr(import_module(module), function)


def report(tables: list[Path], find: Detector) -> str:
    """A line for each case that is not as it should be, and the summary."""
    lines: list[str] = []
    meetings: list[Meeting] = []
    missed = extra = drops = 0
    for table in tables:
        truth = json.loads(table.with_suffix(".truth.json").read_text(encoding="utf-8"))
        drops += len(truth["drops"])
        try:
            found = find(table)
        except (ValueError, OSError, ArithmeticError) as fault:
            lines.append(f"{truth['id']} refused: {str(fault)[:200]}")
            missed += len(truth["drops"])
            continue
        met = meet(truth, found)
        pieces = sum(map(len, found))
        meetings += met
        missed += len(truth["drops"]) - len(met)
        extra += max(0, pieces - len(met))
        lines.append(words(truth, met, pieces))
    return "\n".join([*lines, "", *summary(meetings, drops, missed, extra)])


def meet(truth: dict[str, Any], found: Found) -> list[Meeting]:
    """Each drop with the piece that shares most time with it."""
    rate, met = truth["device"]["rate"], []
    for number, drop in enumerate(truth["drops"]):
        pieces = found[drop["segment"]] if drop["segment"] < len(found) else ()
        begin = max(drop["harmless_s"], 0.0)
        common = [min(end, drop["end_s"]) - max(start, begin) for start, end in pieces]
        if common and max(common) > 0:
            start, end = pieces[int(np.argmax(common))]
            early, beyond = (begin - start) * rate, (end - drop["end_s"]) * rate
            met.append(Meeting(truth["id"], truth["device"]["kind"], number, early, beyond))
    return met


def words(truth: dict[str, Any], met: list[Meeting], pieces: int) -> str:
    early = " ".join(f"{each.early:+.1f}" for each in met)
    beyond = " ".join(f"{each.beyond:+.1f}" for each in met)
    kinds = f"{truth['device']['kind']} {truth['device']['rate']:.0f} Hz {truth['trouble']}"
    count = f"{len(met)} of {len(truth['drops'])} drops, {pieces} pieces"
    return f"{truth['id']} {kinds}: {count}; early {early}; beyond {beyond} samples"


def summary(meetings: list[Meeting], drops: int, missed: int, extra: int) -> list[str]:
    lines = [f"{drops} drops: {missed} missed, {extra} pieces that are none"]
    for kind in ("all", *sorted({each.device for each in meetings})):
        those = [each for each in meetings if kind in ("all", each.device)]
        if not those:
            continue
        early = np.array([each.early for each in those])
        beyond = np.array([each.beyond for each in those])
        late = np.percentile(-early, [50, 90, 99])
        lines.append(
            f"{kind}: begins before the hand is harmless {np.mean(early > 0):.1%}, by more than "
            f"a sample {np.mean(early > 1):.1%}; late by {late[0]:.1f} (half), {late[1]:.1f} "
            f"(90 %), {late[2]:.1f} (99 %) samples; ends after a hand is back "
            f"{np.mean(beyond > 0.5):.1%}, before it by {np.median(-beyond):.1f} samples"
        )
    return lines
