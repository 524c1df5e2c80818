"""A data set in another layout, whole or not at all."""

import shutil
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from time import monotonic
from typing import Literal

from exoid.files.replacing import replace_files
from exoid.files.visible import visible
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.recording import Recording
from exoid.studies.dataset.entry import Dataset, Entry
from exoid.studies.dataset.motion_bids.write_motion import write_motion
from exoid.studies.dataset.open_dataset import DEFAULTS
from exoid.studies.dataset.recording_of import bare, loaded, told_beside, with_sidecar
from exoid.studies.dataset.walk import walk
from exoid.studies.dataset.writing.describe import description, events, readme
from exoid.studies.dataset.writing.init import recorded
from exoid.studies.dataset.writing.names import bids_name, numbered, plain_name
from exoid.studies.dataset.writing.people_table import bids_table, plain_table

Layout = Literal["bids", "plain"]
KEPT = ("README*", "CHANGES*", "LICENSE*", "CITATION*")  # at the top, as they are
BESIDE = ("participants.", "dataset_description.", "task-")  # made anew
PARTS = ("_motion", "_channels", "_events")
OFTEN = 0.2  # s between two words of progress
Progress = Callable[[str], None]


@dataclass(frozen=True)
class Converted:
    """How many recordings came along, and the files that did not."""

    recordings: int
    others: tuple[str, ...]


def convert_dataset(
    dataset: Dataset, folder: Path, layout: Layout, *, whole: bool, say: Progress
) -> Converted:
    """Fills an empty `folder` with the recordings of a data set.

    Each keeps its own sidecar, with who it is of; the table of participants goes along.

    **Raises** `ValueError` (one line) where some recording cannot be read or belongs to nobody.
    """
    entries = [with_sidecar(each, told_beside(each)) for each in dataset.entries]
    targets = numbered(entries)
    faults: list[str] = []
    spoken = monotonic()
    for number, (entry, target) in enumerate(zip(entries, targets, strict=True)):
        try:
            write(described(loaded(entry, whole=whole).recording, entry), folder, target, layout)
        except ValueError as fault:
            faults.append(f"{entry.name}: {bare(str(fault), entry)}")
        if monotonic() - spoken > OFTEN:
            spoken = monotonic()
            say(f"writing recording {number + 1} of {len(entries)}")
    if faults:
        raise ValueError(refused(faults, len(entries)))
    beside(dataset, folder, layout, {each.task for each in targets})
    return Converted(len(entries), others(dataset))


def refused(faults: list[str], count: int) -> str:
    first = f"The first is {faults[0]}" if len(faults) > 1 else faults[0]
    return (
        f"{len(faults)} of {count} recordings cannot be read, and nothing was written. {first} "
        "Mend them, or move them away; exoid study check names all."
    )


def described(recording: Recording, entry: Entry) -> Recording:
    """With whose leg it is, where its own sidecar is silent; its name will not tell it as well."""
    subject = recording.subject
    told = {"id": entry.participant, "side": entry.side, "session": entry.session}
    silent = {name: each for name, each in told.items() if each and not getattr(subject, name)}
    return replace(recording, subject=replace(subject, **silent))


def write(recording: Recording, folder: Path, target: Entry, layout: Layout) -> None:
    path = folder / (bids_name(target) if layout == "bids" else plain_name(target))
    for inside in [*path.relative_to(folder).parents][-2::-1]:
        (folder / inside).mkdir(exist_ok=True)  # not `folder`, which is gone where one interrupts
    if layout == "bids":
        write_motion(recording, path, target.task)
    else:
        write_table(recording, path)


def beside(dataset: Dataset, folder: Path, layout: Layout, tasks: set[str]) -> None:
    """What a data set holds beside its recordings."""
    people = {**dataset.participants, **recorded(dataset)[0]}
    files: dict[str, str] = {}
    if layout == "bids":
        name = visible(dataset.folder.name)
        files = {"dataset_description.json": description(name), "README.md": readme(name)}
        files |= {f"task-{task}_events.json": events() for task in sorted(tasks)}
        files["participants.tsv"], files["participants.json"] = bids_table(people.values())
    else:
        files["participants.csv"] = plain_table(people.values())
    for path in (each for kept in KEPT for each in dataset.folder.glob(kept) if each.is_file()):
        shutil.copyfile(path, folder / path.name)
        files = {name: text for name, text in files.items() if not same_file(name, path.name)}
    replace_files({folder / name: [text] for name, text in files.items()})


def same_file(one: str, other: str) -> bool:
    """README and README.md say the same: BIDS wants one."""
    return Path(one).stem.lower() == Path(other).stem.lower()


def others(dataset: Dataset) -> tuple[str, ...]:
    """Files of a data set that are no part of a recording, nor of what stands beside them all."""
    own = {stem(each.path.relative_to(dataset.folder).as_posix()) for each in dataset.entries}
    tops = [each.rstrip("*").lower() for each in KEPT]
    return tuple(
        visible(name)
        for name in walk(dataset.folder).names
        if stem(name) not in own
        and Path(name).name != DEFAULTS  # it goes along in the sidecar of each
        and not ("/" not in name and name.lower().startswith((*tops, *BESIDE)))
    )


def stem(name: str) -> str:
    """What the files of one recording have in common."""
    bare = name.rpartition(".")[0]
    return bare.rpartition("_")[0] if bare.endswith(PARTS) else bare
