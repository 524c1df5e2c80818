"""What a diagnosis rests on, for those who ask further."""

from dataclasses import dataclass

from exoid.diagnose.bench import Bench
from exoid.diagnose.search import Found
from exoid.diagnose.settle import Settled


@dataclass(frozen=True, eq=False)
class Workings:
    """The recording as candidates saw it, all of them, and the best one."""

    bench: Bench
    found: Found
    best: Settled
