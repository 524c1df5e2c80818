"""What reading a file gives."""

from dataclasses import dataclass

from exoid.recordings.can.quality import LogQuality
from exoid.recordings.recording import Recording


@dataclass(frozen=True, eq=False)
class Loaded:
    """A recording, what its reader noticed, and for a CAN log its quality report."""

    recording: Recording
    notes: tuple[str, ...]
    quality: LogQuality | None
