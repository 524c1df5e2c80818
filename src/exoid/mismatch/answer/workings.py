"""What a diagnosis rests on, for those who ask further."""

from dataclasses import dataclass

from exoid.mismatch.screen.screened_recording import Bench
from exoid.mismatch.screen.settled import Settled
from exoid.mismatch.search.found import Found


@dataclass(frozen=True, eq=False)
class Workings:
    """The recording as candidates saw it, all of them, and the best one."""

    bench: Bench
    found: Found
    best: Settled
