"""Outcomes kept in a table, each of the first time that its recording was asked about.

An answer that was seen may lead to a mend. To ask again would then flatter: who was asked once, by
the code of its day, stays as it is (progressive validation).
"""

import csv
from collections.abc import Sequence
from dataclasses import asdict, fields
from datetime import UTC, datetime
from pathlib import Path

from .outcomes import Outcome

ASKED = "asked"  # the day
FIELDS = [*(each.name for each in fields(Outcome)), ASKED]
SAID = {"True": True, "False": False, "": None}


def kept(path: Path) -> list[Outcome]:
    """Those of the table, in its order."""
    if not path.exists():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        return [outcome_of(row) for row in csv.DictReader(file)]


def outcome_of(row: dict[str, str]) -> Outcome:
    return Outcome(
        row["name"],
        row["world"],
        row["kind"],
        asserted=row["asserted"] == "True",
        right=SAID[row["right"]],
        whole=row["whole"] == "True",
        weight=float(row["weight"]) if row["weight"] else None,
    )


def keep(path: Path, found: Sequence[Outcome]) -> list[Outcome]:
    """All outcomes, those behind that the table did not have; it has them now."""
    before = kept(path)
    known = {(one.world, one.name) for one in before}
    new = [one for one in found if (one.world, one.name) not in known]
    today = datetime.now(UTC).date().isoformat()
    began = path.exists()
    with path.open("a", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, FIELDS, lineterminator="\n")
        if not began:
            table.writeheader()
        table.writerows({**asdict(one), ASKED: today} for one in new)
    return [*before, *new]
