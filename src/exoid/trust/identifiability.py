"""What was told by whom."""

from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Float

from exoid.fitting.result.estimates.estimate import Estimate
from exoid.trust.limit import Limit

MIRRORED = 0.05  # odd part over the whole, below which a motion counts as its own mirror image

Changes = dict[str, float]  # parameter or ratio: relative change


@dataclass(frozen=True)
class Direction:
    """Parameters that may move together, and how far: by `error` times `changes` for one sd."""

    changes: Changes
    error: float  # inf where no motion of this kind tells
    words: str


@dataclass(frozen=True)
class Reversal:
    """How far a movement is from its own mirror image in time."""

    segment: str
    voluntary: bool
    odd: float  # root mean square of the odd part of the angle over that of all of it

    @property
    def mirrored(self) -> bool:
        return self.odd < MIRRORED


@dataclass(frozen=True, eq=False)
class Identifiability:
    """What was told by whom.

    >>> told = exoid.identify(exoid.fit("drops.csv"))
    >>> {"mass", "inertia"} <= set(told.names)
    True
    """

    null_directions: list[Direction]  # exact: a longer recording of the same kind would not help
    weak_directions: list[Direction]  # practical: this recording hardly tells
    combinations: dict[str, Estimate]  # what the data alone determine, with the data's own errors
    names: list[str]  # of the rows of `correlation`
    correlation: Float[np.ndarray, "name name"]  # of the errors; data, prior and bounds together
    segment_shares: dict[str, Float[np.ndarray, " segment"]]  # which segments told a combination
    reversals: list[Reversal]  # every segment against its mirror image in time
    sentences: list[str]  # the strangers first
    strangers: list[str] = field(default_factory=list)  # recordings that cannot be of one leg
    not_found: list[Limit] = field(default_factory=list)  # effects that the recording lacks
