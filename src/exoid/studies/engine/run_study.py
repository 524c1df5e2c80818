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
from exoid.studies.engine.settings import TOGETHER, Settings
from exoid.studies.engine.work import work
from exoid.studies.engine.workers import workers


def run_study(
    dataset: Dataset,
    results: Path,
    settings: Settings,
    *,
    count: int | None = None,
    scheduler: str | None = None,
    told: Callable[[str, int, int], None] = lambda step, done, of: None,
) -> Outcome:
    """Compute what is missing in the folder `results`, one step of all recordings after the other,
    and write the tables of the study there after each step.

    `count` workers of this machine, or those of `scheduler`. `told` hears of a step with how many
    recordings it is done, of how many.

    **Raises** `ValueError` where recordings of the study lie in `results`, or a package is missing.
    """
    check_apart(dataset, results)
    check_packages()
    from exoid.studies.engine.kept.assemble import assemble
    from exoid.studies.engine.kept.parts import FOLDER, folder_of, missing_in

    began = time.monotonic()
    (results / FOLDER).mkdir(parents=True, exist_ok=True)
    contents = read_contents(dataset)
    items, again = unlike(each for each in contents if isinstance(each, Item))
    folders = {step: folder_of(results, step, settings.digest(step)) for step in settings.steps}
    missing = missing_in(folders, items)
    names = {item.key: item.entry.name for item in items}
    write = partial(assemble, results, folders, names, dataset)
    others = {"": rows_of_no_step(contents, again)}
    if missing:
        with workers(count, scheduler, settings.memory) as client:
            for step, left in missing.items():
                if step != settings.steps[0]:
                    write(others)  # so that what is there can be asked while this step goes on
                batches = plan(left, count_of(client), TOGETHER[step])
                rest = (step, settings, folders[step].absolute())
                submit = partial(work_of, client, dataset=dataset, rest=rest)
                lost = carry_out(client, batches, submit, heard(told, step, len(left)))
                others[step] = rows_of_lost(lost)
    computed = {item.key for left in missing.values() for item in left}
    return outcome(write(others), settings.steps, len(computed), time.monotonic() - began)


def check_packages() -> None:
    """**Raises** `ValueError` where a package is missing with which a study is run."""
    require("distributed", "a study is computed", "study")
    require("pyarrow", "the tables of a study are written", "study")


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


def heard(told: Callable[[str, int, int], None], step: str, whole: int) -> Callable[[int], None]:
    """A function that counts what is done, and tells."""
    done = [0]

    def more(count: int) -> None:
        done[0] += count
        told(step, done[0], whole)

    told(step, 0, whole)
    return more


def rows_of_no_step(contents: list[Item | Unread], again: dict[str, str]) -> list[dict[str, Any]]:
    """The rows of files that are not read, or that hold the same as another."""
    from exoid.studies.engine.kept.measured import Measured
    from exoid.studies.engine.kept.tables import recording_row

    rows = []
    for each in contents:
        if isinstance(each, Unread):
            item = Item(each.entry, Participant(""), "", "", 0)
            rows.append(recording_row(Measured(item, fault=each.reason)))
        elif each.entry.name in again:
            row = recording_row(Measured(each))
            rows.append(row | {"status": "duplicate", "duplicate_of": again[each.entry.name]})
    return rows


def rows_of_lost(lost: list[Item]) -> list[dict[str, Any]]:
    """The rows of recordings that took their worker down."""
    from exoid.studies.engine.kept.measured import Measured
    from exoid.studies.engine.kept.tables import recording_row

    return [recording_row(Measured(item, fault=TAKEN_DOWN)) for item in lost]
