"""What a diagnosis rests on, for those who ask further."""

from dataclasses import dataclass

from exoid.mismatch.screen.optimum import Optimum
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import Found


@dataclass(frozen=True, eq=False)
class Workings:
    """The recording as candidates saw it, all of them, and the best one."""

    prepared: PreparedRecording
    found: Found
    best: Optimum
