"""What is said of fits of one segment each."""

import re
from collections.abc import Iterable, Sequence

from exoid.fitting.result.fit_result import FitResult

MIXED = (
    "some cycles fit better with f = 1/T, some with 2/T (Eq. 4), and tau / J is a mean over both: "
    "choose one with torque_frequency"
)


def said_of(results: Sequence[FitResult], aside: Sequence[str]) -> list[str]:
    """First why the first that follows nothing does not, then how the means came about, what was
    set `aside`, and what segments say.
    """
    lost = [each.notes[0] for each in results if not each.follows][:1]
    each = of_every_kind(dict.fromkeys(note for one in results for note in one.notes))
    readings = {one.torque_frequency for one in results} - {None}
    return [
        *lost,
        f"every segment was fitted alone: the ratios are the mean of {len(results)} fits, "
        "their errors come from the scatter between them and from what is the same in all "
        "segments of a session, and the starts are those of the first",
        *aside,
        *(note for note in each if note not in lost),
        *([MIXED] if len(readings) > 1 else []),
    ]


def of_every_kind(notes: Iterable[str]) -> list[str]:
    """Of notes that differ in their numbers alone the first, unless they say of which segment."""
    kinds = {}
    for note in notes:
        kind = note if "segment" in note else re.sub(r"\d[\d.e+-]*", "", note)
        kinds.setdefault(kind, note)
    return list(kinds.values())
