"""The recordings of a data set by their contents."""

import hashlib
from pathlib import Path

from exoid.files.system_errors import told
from exoid.studies.dataset.entry import Dataset, Entry
from exoid.studies.dataset.motion_bids.labels import SUFFIX, inherited
from exoid.studies.dataset.recording_of import person_of
from exoid.studies.engine.kept.item import Item, Unread

BESIDE = ("_channels.tsv", "_events.tsv", "_motion.json")


def read_contents(dataset: Dataset) -> list[Item | Unread]:
    """Every recording with its keys.

    The key of its results is a hash of the recording, of what stands beside it, and of what layout
    and table of participants say of it; not of its name.
    """
    return [content_of(entry, dataset) for entry in dataset.entries]


def content_of(entry: Entry, dataset: Dataset) -> Item | Unread:
    try:
        content = entry.path.read_bytes()
        others = [path.read_bytes() for path in (*entry.defaults, *beside(entry.path))]
    except OSError as fault:
        return Unread(entry, told(fault))
    person = person_of(entry.participant, dataset)
    said = (entry.participant, entry.session, entry.side, entry.task, entry.run, entry.path.suffix)
    recording = hashlib.sha256(content).hexdigest()
    row = (person.body_mass, person.height, person.age, sorted(person.more.items()))
    digest = hashlib.sha256(repr((recording, said, row)).encode())
    for each in others:
        digest.update(hashlib.sha256(each).digest())
    return Item(entry, person, recording[:32], digest.hexdigest()[:32], len(content))


def beside(path: Path) -> list[Path]:
    """The files that say more about a recording."""
    if path.name.endswith(SUFFIX):
        return [each for ending in BESIDE for each in inherited(path, ending)]
    sidecar = path.with_suffix(".toml")
    return [sidecar] if sidecar.is_file() else []
