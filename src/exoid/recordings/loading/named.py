"""Recordings as a user hands them over: read, loaded, named or not, one or several."""

from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import Any

from exoid.files.visible import visible
from exoid.recordings.loading.loaded import Loaded
from exoid.recordings.loading.once import once
from exoid.recordings.loading.warn_user import tell
from exoid.recordings.recording import Recording

Readable = Recording | Loaded | str | PathLike[str]
ONE = (Recording, Loaded, str, PathLike)
RecordingsLike = Readable | Sequence[Readable | tuple[str, Readable]]


def named_recordings(
    given: RecordingsLike, alone: str = "recording"
) -> list[tuple[str, Recording]]:
    """(name, recording) pairs of what was given; one without a name is called `alone`.

    A file is loaded, and what its reader noticed becomes a warning, one for all files that it is
    of.

    **Raises** `ValueError` for what is no recording, or where there is none.
    """
    if isinstance(given, ONE):
        given = [given]
    if not isinstance(given, Sequence) or not given:
        said = "an empty list" if isinstance(given, Sequence) else f"a {type(given).__name__}"
        raise ValueError(
            f"this is {said}, not a recording: give a Recording, a path, or what exoid.load gave; "
            "of data in memory exoid.recording(...) makes one."
        )
    several, noticed = len(given) > 1, []
    try:
        return [
            pair(each, f"{alone} {number}" if several else alone, noticed)
            for number, each in enumerate(given)
        ]
    finally:  # also of those before one that cannot be read
        tell(once(noticed))


def pair(each: Any, name: str, noticed: list[tuple[Path, str]]) -> tuple[str, Recording]:
    """One of them, under its own name where it has one; what is `noticed` of its file is added."""
    if isinstance(each, tuple):
        return str(each[0]), pair(each[1], name, noticed)[1]
    if isinstance(each, Recording):
        return name, each
    if isinstance(each, Loaded):
        return name, each.recording
    if not isinstance(each, str | PathLike):
        raise ValueError(
            f"a recording is asked for, and this is of type {type(each).__name__}: of data in "
            "memory exoid.recording(...) makes one."
        )
    from exoid.recordings.loading.load import load  # what is in memory needs no reader

    loaded = load(each if isinstance(each, str) else Path(each))
    noticed += [(Path(each), note) for note in loaded.notes]
    return visible(Path(each).name), loaded.recording
