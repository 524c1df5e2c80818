"""Of every kind of recording: what became of it, and whether a value is wrong in silence."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import pyarrow.parquet as pq

from .visit import Visit
from .world import SIDES

WRONG = 0.1  # of the damping over inertia
ERRORS = 4.0  # standard ones
SAID = "more than the sensors' noise"  # of a fit that misses something


@dataclass(frozen=True)
class Ended:
    """What became of a visit: its status, and the fit's error in the damping, relative."""

    kind: str
    status: str
    off: float | None
    wrong: bool
    said: bool


def silence(visits: Sequence[Visit], results: Path) -> list[str]:
    """A line for every kind of recording."""
    found = list(ended(visits, results))
    lines = ["  kind of recording        of them  failed  fitted  wrong  and nothing says so"]
    for kind in sorted({each.kind for each in found}):
        those = [each for each in found if each.kind == kind]
        fitted = [each for each in those if each.off is not None]
        wrong = [each for each in fitted if each.wrong]
        numbers = (len(those), sum(each.status == "failed" for each in those), len(fitted))
        silent = sum(not each.said for each in wrong)
        lines.append("  {:24} {:7} {:7} {:7} {:6} {:7}".format(kind, *numbers, len(wrong), silent))
    return lines


def ended(visits: Sequence[Visit], results: Path) -> Iterator[Ended]:
    status = {
        row["name"]: row["status"]
        for row in pq.read_table(results / "recordings.parquet").to_pylist()
    }
    rows = pq.read_table(results / "quantities.parquet").to_pylist()
    fits = [row for row in rows if row["step"] == "fit" and row["segment"] == -1]
    notes = {row["name"] for row in fits if row["quantity"] == "note" and SAID in row["note"]}
    values = {row["name"]: row for row in fits if row["quantity"] == "damping_over_inertia"}
    for visit in visits:
        name = name_of(visit)
        row, truth = values.get(name), float(visit.damping.mean())
        value = None if row is None else row["value"]
        away = None if value is None else value - truth
        error = (row or {}).get("standard_error") or 0.0
        wrong = away is not None and abs(away) > max(WRONG * truth, ERRORS * error)
        kind = " and ".join(filter(None, (visit.fault, "friction" * visit.person.rubs))) or "sound"
        yield Ended(kind, status[name], away, wrong, name in notes)


def name_of(visit: Visit) -> str:
    return f"{visit.person.id}/day{visit.day + 1}/{SIDES[visit.side]}.csv"
