"""What the recordings of a data set are: all by their sidecars, some by their samples."""

from collections.abc import Callable
from time import monotonic

import numpy as np

from exoid.files.system_errors import told
from exoid.files.visible import visible
from exoid.recordings.conventions.balance import Balance, balance, middle
from exoid.recordings.conventions.other_leg import EXPLAINED
from exoid.recordings.declared.subject import Subject
from exoid.recordings.loading.loaded import Loaded
from exoid.recordings.rate import rate_of
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import classify
from exoid.recordings.tables.assemble import GYRO_AMONG
from exoid.studies.dataset.check.looked import Facts, Looked
from exoid.studies.dataset.entry import Dataset, Entry
from exoid.studies.dataset.recording_of import bare, loaded, told_beside, with_sidecar

NODE = "exoid node"
OFTEN = 0.2  # s between two words of progress
Progress = Callable[[str], None]


def look(dataset: Dataset, most: int, say: Progress) -> list[Looked]:
    """Every recording by its sidecar, and `most` of them, spread over the data set, read."""
    count = len(dataset.entries)
    chosen = {*np.linspace(0, count - 1, min(most, count)).astype(int).tolist()}
    begun = spoken = monotonic()
    found: list[Looked] = []
    for number, entry in enumerate(dataset.entries):
        found.append(look_at(entry, read=number in chosen))
        if monotonic() - spoken > OFTEN:
            spoken = monotonic()
            left = (spoken - begun) / (number + 1) * (count - number - 1)
            say(f"looking at recording {number + 1} of {count}, {left:.0f} s left")
    return found


def look_at(entry: Entry, *, read: bool) -> Looked:
    subject = Subject()
    try:
        subject = told_beside(entry)
        whose = with_sidecar(entry, subject)
        return Looked(whose, subject, entry, facts=facts_of(loaded(entry)) if read else None)
    except ValueError as fault:
        return Looked(with_sidecar(entry, subject), subject, entry, bare(str(fault), entry))
    except OSError as fault:
        return Looked(with_sidecar(entry, subject), subject, entry, told(fault))


def facts_of(read: Loaded) -> Facts:
    recording = read.recording
    kinds = [
        recording.kind(number) or classify(segment)
        for number, segment in enumerate(recording.segments)
    ]
    return Facts(
        device_of(read),
        rate_of(recording.segments),
        len(kinds),
        kinds.count("passive"),
        pull_of(recording, [n for n, kind in enumerate(kinds) if kind == "passive"]),
        any(GYRO_AMONG in note for note in read.notes),
    )


def device_of(read: Loaded) -> str:
    """What recorded it: as the sidecar says, the node, or which channels there are."""
    said = read.recording.sensors.device
    if said is not None:
        return visible(said)
    if read.quality is not None:
        return NODE
    channels = {name for each in read.recording.segments for name in each.channels()}
    return " and ".join(sorted(channels - {"time"})).replace("_", " ")


def pull_of(recording: Recording, drops: list[int]) -> Balance | None:
    """How hard gravity and stiffness draw the bare leg, by the drop in the middle."""
    bare = [balance(recording.segments[n]) for n in drops if not recording.added_mass(n)]
    sure = [each for each in bare if each is not None and each.explained > EXPLAINED]
    return middle(sure) if sure else None
