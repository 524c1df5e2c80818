"""What is asked of a study, and what it answers, quantity by quantity."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.groups import Comparison
from exoid.studies.statistics.multiple import Correction
from exoid.studies.statistics.physics import Cause
from exoid.studies.statistics.presence import Presence
from exoid.studies.statistics.reliability import Reliability
from exoid.studies.statistics.tables.said import Untold
from exoid.studies.statistics.tables.study import Study
from exoid.studies.statistics.tables.values import Values
from exoid.studies.statistics.visits.exchanged import Exchanged


@dataclass(frozen=True)
class Asked:
    """`by` is a column of people; `before` and `after` are sessions. Without `quantities`, all that
    were read off legs or fitted to them. `primary` were the question from the start: their p are
    corrected among themselves.
    """

    quantities: tuple[str, ...] = ()
    primary: tuple[str, ...] = ()
    by: str = ""
    before: str = ""
    after: str = ""
    adjust: tuple[str, ...] = ()
    task: str = ""
    correction: Correction = "holm"


@dataclass(frozen=True, eq=False)
class Answer:
    """Of one quantity. `presence` is of whom the finding has values. None was not asked;
    `corrected` has every p among those of its kind, by `groups`, `change`, `change_by_group` and
    `sides`, and `among` says of how many.
    """

    quantity: str
    values: Values
    presence: Presence
    reliability: Reliability | Untold
    sides: Agreement | Untold
    retest: Agreement | Untold
    change: Agreement | Untold | None = None
    groups: Comparison | Untold | None = None
    change_by_group: Comparison | Untold | None = None
    corrected: Mapping[str, float] = field(default_factory=dict)
    among: Mapping[str, int] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Answers:
    """All of them; `silent` are the quantities without values, with why. `exchanged` are visits of
    which one has the names of its sides exchanged.
    """

    study: Study
    asked: Asked
    each: tuple[Answer, ...]
    physics: tuple[Cause, ...] | Untold
    silent: Mapping[str, str]
    exchanged: tuple[Exchanged, ...] = ()
