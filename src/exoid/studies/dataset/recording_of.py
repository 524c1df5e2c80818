"""The recording of an entry, with what table and layout say of its person."""

from dataclasses import replace

from exoid.files.visible import visible
from exoid.recordings.declared.subject import Subject
from exoid.recordings.defaults import keys_told
from exoid.recordings.loading.load import load
from exoid.recordings.loading.loaded import Loaded
from exoid.recordings.recording import Recording
from exoid.studies.dataset.cause import for_all
from exoid.studies.dataset.entry import Dataset, Entry, Participant
from exoid.studies.dataset.motion_bids.labels import SUFFIX, label
from exoid.studies.dataset.motion_bids.read_motion import metadata_of, read_motion, sidecar_of


def recording_of(entry: Entry, dataset: Dataset) -> Recording:
    """The recording, cut into its movements; whose leg it is, is told by its `subject`.

    What its own sidecar says stands. What that leaves open is told by the names of file and
    folders, and by the table of participants.

    **Raises** `ValueError` and `OSError` as `load` does, in one line.
    """
    recording = loaded(entry).recording
    return replace(recording, subject=joined(recording.subject, entry, dataset))


def loaded(entry: Entry, *, whole: bool = False) -> Loaded:
    """The recording by its own files alone, and what its reader noticed."""
    if entry.path.name.endswith(SUFFIX):
        return Loaded(*read_motion(entry.path, whole=whole), None)
    return load(entry.path, whole=whole, defaults=entry.defaults)


def told_beside(entry: Entry) -> Subject:
    """What the recording's sidecars say of its subject; no sample is read."""
    if entry.path.name.endswith(SUFFIX):
        return sidecar_of(entry.path, metadata_of(entry.path))[0]["subject"]
    return keys_told(entry.path.with_suffix(".toml"), "", entry.defaults)[0]["subject"]


def with_sidecar(entry: Entry, subject: Subject) -> Entry:
    """An entry as its sidecar has it, and where that is silent, as its name does."""
    return replace(
        entry,
        participant=visible((subject.id or entry.participant).removeprefix("sub-")),
        side=subject.side or entry.side,
        session=visible(subject.session or entry.session),
    )


def joined(subject: Subject, entry: Entry, dataset: Dataset) -> Subject:
    """A subject with what layout and table say of it, where it is silent."""
    identity = subject.id or entry.participant
    person = person_of(identity, dataset)
    said = {
        "id": identity,
        "side": entry.side,
        "session": entry.session,
        "body_mass": person.body_mass,
        "height": person.height,
        "age": person.age,
    }
    silent = {k: v for k, v in said.items() if getattr(subject, k) is None and v not in (None, "")}
    return replace(subject, **silent) if silent else subject


def person_of(identity: str, dataset: Dataset) -> Participant:
    """Who that is by the table of participants; without a row, nothing is known.

    BIDS writes an id without what is neither letter nor digit.
    """
    people, name = dataset.participants, identity.removeprefix("sub-")
    return people.get(name) or people.get(label(name)) or Participant(identity)


def bare(said: str, entry: Entry) -> str:
    """A reason on one line, without the path that is named beside it."""
    line = " ".join(said.split())
    line = line.replace(f"{visible(str(entry.path))}: ", "").replace(f"{entry.path} ", "")
    return for_all(visible(line), entry.name)
