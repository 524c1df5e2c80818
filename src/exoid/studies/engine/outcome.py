"""What a run of a study did, and why recordings failed: one line for each cause."""

import re
from collections import Counter, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from exoid.studies.dataset.cause import cause
from exoid.studies.engine.settings import STEPS

BY_STEP = re.compile(rf"(?:^| )(?=(?:{'|'.join(STEPS)}): )")
NAMED = 3  # recordings, of those with one reason
UNLIKE = "it does not follow the recording"  # how, differs from recording to recording


@dataclass(frozen=True)
class Outcome:
    """What a run did; `reasons` are those of recordings that failed, with how many."""

    recordings: int
    computed: int  # in this run; the others were there
    ok: int
    failed: int
    partly: int  # of those that failed: other steps were measured
    duplicates: int
    reasons: dict[str, int]
    seconds: float


def outcome(table: Any, steps: Sequence[str], computed: int, seconds: float) -> Outcome:
    """Of the table of recordings, in which all `steps` were asked for."""
    status = Counter(table["status"].to_pylist())
    failed = [row for row in rows_of(table) if row["status"] == "failed"]
    measured = [measured_of(row, steps) for row in failed]
    reasons = reasons_of([(row["name"], row["reason"]) for row in failed], measured)
    return Outcome(
        recordings=table.num_rows,
        computed=computed,
        ok=status["ok"],
        failed=status["failed"],
        partly=sum(map(bool, measured)),
        duplicates=status["duplicate"],
        reasons=reasons,
        seconds=seconds,
    )


def rows_of(table: Any) -> list[dict[str, Any]]:
    return table.select(["name", "status", "reason", "segments"]).to_pylist()


def measured_of(row: dict[str, Any], steps: Sequence[str]) -> tuple[str, ...]:
    """The steps that were measured of a recording of which some step failed."""
    if row["segments"] is None:  # it was not read
        return ()
    failed = {each.partition(":")[0] for each in BY_STEP.split(row["reason"]) if each}
    return tuple(step for step in steps if step not in failed)


def reasons_of(said: list[tuple[str, str]], measured: list[tuple[str, ...]]) -> dict[str, int]:
    """A sentence for each cause, with the recordings that have it, and how many these are; what
    most have comes first.
    """
    groups: dict[tuple[str, ...], list[tuple[str, str]]] = defaultdict(list)
    for each, steps in zip(said, measured, strict=True):
        groups[cause_of(each[1]), *steps].append(each)
    ordered = sorted(groups.items(), key=lambda each: -len(each[1]))
    return {sentence(group, steps): len(group) for (_, *steps), group in ordered}


def cause_of(said: str) -> str:
    """What recordings with one cause have in common."""
    head, told, _ = said.partition(f"fit: {UNLIKE}")
    return cause(f"{head}{told}")


def sentence(group: list[tuple[str, str]], steps: list[str]) -> str:
    """Which recordings, the reason of the first, and what was measured of them all."""
    names, reasons = zip(*group, strict=True)
    more = len(names) - NAMED
    which = f"{', '.join(names[:NAMED])}{f' and {more} more' if more > 0 else ''}"
    first = ", the first of them" if len({*reasons}) > 1 else ""
    kept = f" Measured nevertheless: {', '.join(steps)}." if steps else ""
    return f"{which}{first}: {reasons[0].rstrip('.')}.{kept}"
