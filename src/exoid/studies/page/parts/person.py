"""What opens where a person is chosen: who they are, and their recordings."""

import json
from typing import Any

from exoid.report.words.text import quantity_words, shown_unit
from exoid.report.words.typeset import tidy
from exoid.studies.page.parts.numbers import number
from exoid.studies.page.parts.words import column_words
from exoid.studies.statistics.asked import Answers
from exoid.studies.statistics.mixed.covariates import label
from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.values import PERSONAL

SHOWN = 4  # quantities of a recording
MOST = 20_000  # recordings that a page lists
UNITS = {"age_years": "years", "body_mass_kg": "kg", "height_m": "m"}


def people(answers: Answers) -> str:
    """JSON of every person by id; its angle brackets are escapes, so that no name ends a script."""
    table = answers.study.recordings
    table = table[table["participant"] != ""]
    columns = shown(answers)
    listed = len(table) <= MOST
    found = {
        who: {"facts": facts(rows), "rows": recordings(rows, columns) if listed else []}
        for who, rows in table.groupby("participant")
    }
    heads = ["recording", "session", "side", *columns, "what became of it"] if listed else []
    document = json.dumps({"heads": heads, "people": found}, ensure_ascii=False)
    return document.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def shown(answers: Answers) -> dict[str, Any]:
    """The means of each recording under a head."""
    columns = {}
    for each in answers.each[:SHOWN]:
        unit = shown_unit(each.values.unit)
        head = tidy(f"{quantity_words(each.quantity)}{f' [{unit}]' if unit else ''}")
        columns[head] = each.values.frame.groupby("recording")["value"].mean()
    return columns


def facts(rows: Frame) -> list[tuple[str, str]]:
    """What the table of participants says."""
    known = [each for each in rows if each.startswith("participant_") or each in PERSONAL]
    first = {each: rows[each].dropna() for each in known}
    return [
        (column_words(each.rpartition("_")[0] if each in UNITS else each), said(each, one.iloc[0]))
        for each, one in first.items()
        if len(one) and one.iloc[0] != ""
    ]


def said(column: str, cell: Any) -> str:
    return f"{cell:.3g} {UNITS[column]}" if column in UNITS else label(cell)


def recordings(rows: Frame, columns: dict[str, Any]) -> list[list[str]]:
    """A row of words for each."""
    return [
        [
            row["name"],
            row["session"],
            row["side"],
            *(
                number(float(means[row["recording"]]), float(means[row["recording"]]) / 100)
                if row["recording"] in means.index
                else ""
                for means in columns.values()
            ),
            row["reason"] or ("" if row["status"] == "ok" else row["status"]),
        ]
        for row in rows.sort_values(["session", "side", "name"]).to_dict("records")
    ]
