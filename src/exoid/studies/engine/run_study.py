"""`run_study`: a data set through all steps, what is there already left as it is."""

import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

from exoid.files.extras import require
from exoid.files.visible import visible
from exoid.studies.dataset.entry import Dataset, Participant
from exoid.studies.engine.carry_out import TAKEN_DOWN, carry_out, count_of
from exoid.studies.engine.kept.item import Item, Unread
from exoid.studies.engine.outcome import Outcome, outcome
from exoid.studies.engine.plan import Batch, plan, unlike
from exoid.studies.engine.read_contents import read_contents
from exoid.studies.engine.settings import Settings
from exoid.studies.engine.work import work
from exoid.studies.engine.workers import workers


def run_study(
    dataset: Dataset,
    results: Path,
    settings: Settings,
    *,
    count: int | None = None,
    scheduler: str | None = None,
    told: Callable[[int, int], None] = lambda done, of: None,
) -> Outcome:
    """Compute what is missing in the folder `results`, and write the tables of the study there.

    `count` workers of this machine, or those of `scheduler`. `told` hears how many recordings are
    done, of how many.

    **Raises** `ValueError` where recordings of the study lie in `results`.
    """
    check_apart(dataset, results)
    require("pyarrow", "the tables of a study are written", "study")
    from exoid.studies.engine.kept.assemble import assemble
    from exoid.studies.engine.kept.parts import FOLDER, kept

    began = time.monotonic()
    (results / FOLDER).mkdir(parents=True, exist_ok=True)
    digest = settings.digest
    contents = read_contents(dataset, digest)
    items, again = unlike(each for each in contents if isinstance(each, Item))
    there = kept(results)
    missing = [item for item in items if item.key not in there]
    submitted = partial(work_of, dataset=dataset, rest=(settings, digest, results.absolute()))
    lost = []
    if missing:
        with workers(count, scheduler, settings.memory) as client:
            hear = heard(told, len(missing))
            batches = plan(missing, count_of(client), settings.together)
            lost = carry_out(client, batches, partial(submitted, client), hear)
        there = kept(results)
    found = by_part(items, there)
    others = rows_without_part(contents, again, lost, digest)
    table = assemble(results, found, others, dataset)
    return outcome(table, settings.steps, len(missing), time.monotonic() - began)


def check_apart(dataset: Dataset, results: Path) -> None:
    """A folder of results counts as such, with all that is in it."""
    where = results.absolute()
    for each in dataset.entries:
        if where in each.path.parents:
            raise ValueError(
                f"{results}: {visible(each.name)} of the study lies in there. Name a folder of "
                f"its own, such as {results / 'results'}."
            )


def work_of(client: Any, batch: Batch, *, dataset: Dataset, rest: tuple) -> Any:
    """A batch on its way; of the people only those who are in it."""
    people = {item.participant.id: item.participant for item in batch.items}
    known = {name: each for name, each in dataset.participants.items() if name in people}
    own = replace(dataset, entries=(), participants=known, problems=())
    return client.submit(work, batch, own, *rest, pure=False)


def heard(told: Callable[[int, int], None], whole: int) -> Callable[[int], None]:
    """A function that counts what is done, and tells."""
    done = [0]

    def more(count: int) -> None:
        done[0] += count
        told(done[0], whole)

    told(0, whole)
    return more


def by_part(items: list[Item], there: dict[str, Path]) -> dict[Path, dict[str, str]]:
    """The keys that every part has for this study, with the names of the recordings."""
    found: dict[Path, dict[str, str]] = {}
    for item in items:
        if item.key in there:
            found.setdefault(there[item.key], {})[item.key] = item.entry.name
    return dict(sorted(found.items()))


def rows_without_part(
    contents: list[Item | Unread], again: dict[str, str], lost: list[Item], digest: str
) -> list[dict[str, Any]]:
    """The rows of what was not computed: files that are not read, that hold the same as another, or
    that took their worker down.
    """
    from exoid.studies.engine.kept.measured import Measured
    from exoid.studies.engine.kept.tables import recording_row

    rows = []
    for each in contents:
        if isinstance(each, Unread):
            item = Item(each.entry, Participant(""), "", "", 0)
            rows.append(recording_row(Measured(item, faults=[each.reason]), digest))
        elif each.entry.name in again:
            row = recording_row(Measured(each), digest)
            rows.append(row | {"status": "duplicate", "duplicate_of": again[each.entry.name]})
    return rows + [recording_row(Measured(item, faults=[TAKEN_DOWN]), digest) for item in lost]
