"""Of every kind of recording: what became of it, and whether a value is wrong in silence."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq

from .truths import QUANTITIES
from .visit import Visit
from .world import SIDES

WRONG = 0.1  # of the value
ERRORS = 4.0  # standard ones
SAID = "more than the sensors' noise"  # of a fit that misses something


@dataclass(frozen=True)
class Ended:
    """What became of a visit, and whether its value is there, and wrong, and that said."""

    kind: str
    failed: bool
    told: bool
    wrong: bool
    said: bool


def silence(visits: Sequence[Visit], results: Path, quantity: str) -> list[str]:
    """A line for every kind of recording."""
    found = list(ended(visits, results, quantity))
    lines = [f"  {quantity}:", "  kind of recording  of them  failed  valued  wrong  and silent"]
    for kind in sorted({each.kind for each in found}):
        those = [each for each in found if each.kind == kind]
        each = ("failed", "told", "wrong")
        counts = [len(those), *(sum(getattr(one, name) for one in those) for name in each)]
        silent = sum(one.wrong and not one.said for one in those)
        lines.append("  {:18} {:8} {:7} {:7} {:6} {:11}".format(kind, *counts, silent))
    return lines


def ended(visits: Sequence[Visit], results: Path, quantity: str) -> Iterator[Ended]:
    recordings = pq.read_table(results / "recordings.parquet").to_pylist()
    status = {row["name"]: row["status"] for row in recordings}
    rows = pq.read_table(results / "quantities.parquet").to_pylist()
    whole = [row for row in rows if row["segment"] == -1]
    notes = {row["name"] for row in whole if row["quantity"] == "note" and SAID in row["note"]}
    values = {row["name"]: row for row in whole if row["quantity"] == quantity}
    for visit in visits:
        name = name_of(visit)
        row, truth = values.get(name, {}), true_mean(visit, quantity)
        told, error = row.get("value") is not None, row.get("standard_error") or 0.0
        away = abs(row["value"] - truth) if told else 0.0
        wrong = away > max(WRONG * truth, ERRORS * error)
        kind = " and ".join(filter(None, (visit.fault, "friction" * visit.person.rubs)))
        yield Ended(kind or "sound", status[name] == "failed", told, wrong, name in notes)


def true_mean(visit: Visit, quantity: str) -> float:
    """Of the drops of a visit."""
    drops = zip(visit.damping.tolist(), visit.tone.tolist(), visit.starts.tolist(), strict=True)
    return float(np.mean([QUANTITIES[quantity](visit.person, *each) for each in drops]))


def name_of(visit: Visit) -> str:
    return f"{visit.person.id}/day{visit.day + 1}/{SIDES[visit.side]}.csv"
