"""What a fit believes of a leg before it moves."""

from dataclasses import dataclass, field

import numpy as np

from exoid.fitting.model.assumptions import BoundsName, PriorName
from exoid.fitting.model.limits import Limits, Prior
from exoid.fitting.model.term_parameters import NAMES
from exoid.fitting.model.user_values import ByHand
from exoid.physics.anatomy.expected import ExpectedLeg


@dataclass(frozen=True)
class Belief:
    """The prior in words and numbers, and the limits."""

    name: PriorName
    expected: ExpectedLeg | None
    prior: Prior
    limits: Limits
    note: str
    raw: bool = False  # are the prior's standard deviations a weighting, and no belief
    bounds: BoundsName = "body"
    by_hand: ByHand = field(default_factory=ByHand)
    untabled: bool = False  # is what is expected only there to be compared with

    @property
    def rig(self) -> bool:
        """Is it no leg: a rig, whose reach is infinite?"""
        return not np.isfinite(self.limits.reach)

    @property
    def typical(self) -> dict[str, float]:
        """Where to begin: what was said by hand, else what is expected; empty where nothing is."""
        hand = self.by_hand.leg
        said = {name: value for name, (value, _) in hand.prior.items()} | dict(hand.fix)
        if self.expected is None or self.untabled:
            return said
        return {name: getattr(self.expected, name).value for name in NAMES} | said
