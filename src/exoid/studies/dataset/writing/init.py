"""What a data set lacks beside its recordings, written beside them; nothing is replaced."""

from dataclasses import dataclass, replace
from pathlib import Path

from exoid.files.replacing import replace_files
from exoid.studies.dataset.entry import Dataset, Participant
from exoid.studies.dataset.recording_of import person_of, told_beside, with_sidecar
from exoid.studies.dataset.writing.describe import description, readme
from exoid.studies.dataset.writing.people_table import bids_table, plain_table

FURTHER = ("sex", "group")  # what most studies compare


@dataclass(frozen=True)
class Begun:
    """What was written, and who is still to be told of."""

    written: tuple[Path, ...]
    table: Path
    absent: tuple[str, ...]  # people with recordings who are not in the table that was there
    of_nobody: tuple[str, ...]  # recordings


def begin_study(dataset: Dataset) -> Begun:
    """Write the table of participants that is missing, with an empty row for each who was recorded
    and what sidecars tell; for BIDS also its description.

    **Raises** `ValueError` for a sidecar that cannot be read, and `OSError`.
    """
    people, nobody = recorded(dataset)
    files: dict[Path, str] = {}
    table = dataset.table or dataset.folder / f"participants.{'tsv' if dataset.bids else 'csv'}"
    if dataset.table is None and dataset.bids:
        files[table], files[table.with_suffix(".json")] = bids_table(people.values(), FURTHER)
    elif dataset.table is None:
        files[table] = plain_table(people.values(), FURTHER)
    if dataset.bids:
        name = dataset.folder.name
        files[dataset.folder / "dataset_description.json"] = description(name)
        if not any(dataset.folder.glob("README*")):
            files[dataset.folder / "README.md"] = readme(name)
    files = {path: text for path, text in files.items() if not path.exists()}
    replace_files({path: [text] for path, text in files.items()})
    absent = () if dataset.table is None else tuple(people.keys() - dataset.participants.keys())
    return Begun(tuple(files), table, tuple(sorted(absent)), tuple(nobody))


def recorded(dataset: Dataset) -> tuple[dict[str, Participant], list[str]]:
    """Who was recorded, in order, with what table and sidecars say; and recordings of nobody."""
    people: dict[str, Participant] = {}
    nobody = []
    for entry in dataset.entries:
        subject = told_beside(entry)
        name = with_sidecar(entry, subject).participant
        if not name:
            nobody.append(entry.name)
            continue
        person = people.get(name) or replace(person_of(name, dataset), id=name)
        silent = [size for size in ("body_mass", "height", "age") if getattr(person, size) is None]
        people[name] = replace(person, **{size: getattr(subject, size) for size in silent})
    return dict(sorted(people.items())), nobody
