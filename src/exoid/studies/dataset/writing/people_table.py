"""The table of participants as each layout has it."""

import csv
import io
import json
from collections.abc import Iterable

from exoid.studies.dataset.entry import Participant, Said
from exoid.studies.dataset.motion_bids.labels import label
from exoid.studies.dataset.tables.cells import word_of
from exoid.studies.dataset.tables.tsv import tsv

PLAIN = {"body_mass": "body_mass_kg", "height": "height_m", "age": "age_years"}
BIDS = {"age": "age", "weight": "body_mass", "height": "height"}
UNITS = {
    "age": {"Description": "age at the first recording", "Units": "year"},
    "weight": {"Description": "body mass", "Units": "kg"},
    "height": {"Description": "body height", "Units": "m"},
}


def plain_table(people: Iterable[Participant], further: Iterable[str] = ()) -> str:
    """`participants.csv`; `further` are columns that are there whether anybody fills them."""
    people = [*people]
    more = more_columns(people, further)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["id", *PLAIN.values(), *more])
    for each in people:
        sizes = [getattr(each, name) for name in PLAIN]
        writer.writerow([each.id, *map(word_of, [*sizes, *(each.more.get(n) for n in more)])])
    return text.getvalue()


def bids_table(people: Iterable[Participant], further: Iterable[str] = ()) -> tuple[str, str]:
    """`participants.tsv` and the `participants.json` that says its units."""
    people = [*people]
    more = more_columns(people, further)
    rows: list[list[Said]] = [["participant_id", *BIDS, *more]]
    for each in people:
        cells = [
            *(getattr(each, name) for name in BIDS.values()),
            *(each.more.get(n) for n in more),
        ]
        rows.append([f"sub-{label(each.id)}", *map(word_of, cells)])
    about = UNITS | {name: {"Description": f"{name}, as the study has it"} for name in more}
    return tsv(rows), json.dumps(about, indent=2, ensure_ascii=False) + "\n"


def more_columns(people: list[Participant], further: Iterable[str]) -> list[str]:
    return [*dict.fromkeys([*further, *(name for each in people for name in each.more)])]
