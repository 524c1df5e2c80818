"""The tables of fits without an error of all recordings: what is found less of them is of fits, and
not of whom a study happened to draw.
"""

from collections.abc import Sequence

import pandas as pd
from benchmarks.studies.tables import GROUPS, SIDES

from exoid.studies.statistics.tables.study import Study, study_of

from .world import Visit, World
from .write import name_of


def exact(visits: Sequence[Visit], world: World) -> Study:
    whose = [whose_of(each) for each in visits]
    rows = [
        {
            **own,
            "segment": -1,
            "step": "fit",
            "quantity": truth.quantity,
            "value": visit.truth(truth.quantity),
            "unit": truth.unit,
            "determined_by": "data",
        }
        for own, visit in zip(whose, visits, strict=True)
        for truth in world.design.truths
    ]
    groups = [GROUPS[each.person.group] for each in visits]
    recordings = pd.DataFrame(whose).assign(status="ok", participant_group=groups)
    return study_of(recordings, pd.DataFrame(rows))


def whose_of(visit: Visit) -> dict[str, str]:
    name = name_of(visit)
    about = {"participant": visit.person.id, "side": SIDES[visit.side]}
    return {"recording": name, "name": name, "session": f"day{visit.day + 1}", **about}
