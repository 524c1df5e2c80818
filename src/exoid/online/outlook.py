"""What an estimator says after a sample."""

from dataclasses import dataclass
from typing import Any

import jax
from jaxtyping import Float, Int

from exoid.online.model.trust import Phase, Trust


@jax.tree_util.register_dataclass
@dataclass(frozen=True)
class Outlook:
    """The estimates, and how far to believe them.

    `ratios` are m l g / J, c / J and d / J [1/s^2, 1/s^2, 1/s].
    """

    trust: Int[Any, "*time"]
    phase: Int[Any, "*time"]
    drops: Int[Any, "*time"]  # of this leg that count
    rests: Int[Any, "*time"]  # the last of them, on which the estimates rest
    ratios: Float[Any, "*time 3"]
    errors: Float[Any, "*time 3"]  # standard
    if_slack: Float[Any, "*time 3"]  # and more, where the knee's spring is slack elsewhere
    begun: Float[Any, "*time"]  # s, when the movement began to count, or the last one
    ended: Float[Any, "*time"]  # s, up to when that counted
    unwhite: Float[Any, "*time"]  # standard deviations by which innovations are not white
    change: Float[Any, "*time"]  # log odds that this is another leg than before
    late: Int[Any, "*time"]  # 1 where it began as the leg turned: what was before had strayed

    @property
    def said(self) -> Trust:
        return Trust(int(self.trust))

    @property
    def doing(self) -> Phase:
        return Phase(int(self.phase))
