"""A study for other programs."""

from typing import Any

from exoid.report.document.plain_json import plain, shown
from exoid.studies.page.parts.words import finding
from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.asked import Answer, Answers
from exoid.studies.statistics.tables.said import Untold

KINDS = ("reliability", "retest", "sides", "change", "groups", "change_by_group")


def study_document(answers: Answers) -> dict[str, Any]:
    """All answers; what is not told has `untold`, the reason."""
    table = answers.study.recordings
    return {
        "finding": finding(answers),
        "people": table.loc[table["participant"] != "", "participant"].nunique(),
        "recordings": table["status"].value_counts().to_dict(),
        "asked": plain(answers.asked),
        "quantities": {each.quantity: entry(each) for each in answers.each},
        "without_values": dict(answers.silent),
        "missing_physics": told(answers.physics),
        "sides_exchanged": plain(answers.exchanged),
    }


def entry(answer: Answer) -> dict[str, Any]:
    """One quantity."""
    frame = answer.values.frame
    return {
        "unit": answer.values.unit,
        "people": answer.values.people,
        "values": len(frame),
        "presence": plain(answer.presence),
        "notes": list(answer.values.notes),
        **{kind: told(found) for kind in KINDS if (found := getattr(answer, kind)) is not None},
        "corrected_p": dict(answer.corrected),
    }


def told(found: Any) -> Any:
    """An answer, or why there is none."""
    if isinstance(found, Untold):
        return {"untold": found.why}
    if isinstance(found, Agreement):
        pairs = found.pairs
        about = {"first": pairs.first, "second": pairs.second, "people": found.people}
        return {**about, **plain(shown(found, without=("pairs",)))}
    if hasattr(found, "change"):
        return {**plain(found), "change": plain(found.change)}
    return plain(found)
