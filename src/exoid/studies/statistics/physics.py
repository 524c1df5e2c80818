"""Which physics a diagnosis found missing, how often, and in how many people."""

from dataclasses import dataclass

from scipy.stats import binomtest

from exoid.studies.statistics.tables.frames import Frame
from exoid.studies.statistics.tables.said import Interval, NotTold
from exoid.studies.statistics.tables.study import Study

ALL = "all"
NOTHING = ("cannot tell", "none")  # answers that name no cause: told last


@dataclass(frozen=True)
class Cause:
    """In how many recordings of a group, and the share of people in whom it was found at least
    once; its interval is Wilson's (1927). Recordings of a person are not independent, people are.
    """

    name: str
    group: str
    recordings: int
    of_recordings: int
    people: int
    of_people: int
    share: Interval


def missing_physics(study: Study, by: str = "") -> tuple[Cause, ...]:
    """Every cause, the most frequent first; of all, and of each group where `by` names a column.

    **Raises** `NotTold` where nothing was diagnosed.
    """
    rows = study.quantities
    rows = rows[(rows["step"] == "diagnose") & (rows["quantity"] == "missing_physics")]
    rows = rows[rows["participant"] != ""].drop_duplicates(["recording", "note"])
    if rows.empty:
        raise NotTold("No recording was diagnosed: run 'exoid study run' with the step diagnose.")
    causes = rows["note"].value_counts()
    named = [each for each in causes.index if each not in NOTHING]
    found = {ALL: rows}
    if by and by in study.recordings:
        group = study.recordings.drop_duplicates("recording").set_index("recording")[by]
        of = rows["recording"].map(group)
        found |= {str(each): rows[of == each] for each in sorted(of.dropna().unique(), key=str)}
    return tuple(
        counted(cause, group, each)
        for cause in (*named, *(each for each in NOTHING if each in causes.index))
        for group, each in found.items()
    )


def counted(cause: str, group: str, rows: Frame) -> Cause:
    having = rows[rows["note"] == cause]
    people, of_people = having["participant"].nunique(), rows["participant"].nunique()
    of_all = binomtest(people, of_people).proportion_ci(method="wilson")
    share = Interval(people / of_people, of_all.low, of_all.high)
    recordings = having["recording"].nunique(), rows["recording"].nunique()
    return Cause(cause, group, *recordings, people, of_people, share)
