"""Which physics was missing, how often, in whom."""

from collections.abc import Iterator

from exoid.report.sections.blocks import Block
from exoid.studies.page.parts.part import Told, part
from exoid.studies.page.parts.tables import causes
from exoid.studies.page.pictures.intervals import causes as drawn
from exoid.studies.statistics.physics import ALL
from exoid.studies.statistics.tables.said import Untold

MOST_GROUPS = 6  # side by side


@part("physics", "Missing physics")
def physics(told: Told) -> Iterator[Block]:
    found = told.answers.physics
    if isinstance(found, Untold):
        yield found.why
        return
    several = list(dict.fromkeys(each.group for each in found if each.group != ALL))
    groups = several if 1 < len(several) <= MOST_GROUPS else [ALL]
    yield drawn(found, groups, told.answers.asked.by)
    yield causes(found, [ALL, *several] if several else [ALL])
    yield (
        "A person counts once, however often they were recorded: recordings of one person are not "
        "independent of each other."
    )
