"""What an estimator believes of a leg, and where it stands, as one row of numbers."""

from dataclasses import dataclass
from functools import cache
from typing import Any

import jax
import numpy as np
from jaxtyping import Float

from exoid.online.filter.pack import Form
from exoid.online.filter.prior import prior_of
from exoid.online.model.model import Model
from exoid.online.movement.begin import begin
from exoid.online.movement.knowledge import Knowledge
from exoid.online.movement.watch import begun
from exoid.physics.anatomy import ExpectedLeg, expected_leg


@jax.tree_util.register_dataclass
@dataclass(frozen=True)
class Belief:
    """All that an estimator remembers between two samples. One row: what is handed to a program
    as forty arrays takes longer to hand over than to compute.
    """

    numbers: Float[Any, " number"]


DEFAULT = Model()


def init(expected: ExpectedLeg, model: Model = DEFAULT) -> Belief:
    """The belief before the first sample: what anatomy expects, and how legs scatter about it.

    **Raises** `ValueError` where what is expected says nothing of that scatter.

    >>> belief = online.init(exoid.expected_leg(77.0, 1.80))
    >>> online.estimates(belief)["gravity_over_inertia"].value > 20.0  # 1/s^2
    True
    """
    return belief_of(begin(prior_of(expected, model), model.node), model)


def knowledge_of(belief: Belief, model: Model) -> Knowledge:
    """What the numbers mean."""
    return form(model).unpacked((np.asarray(belief.numbers),))


def belief_of(known: Knowledge, model: Model) -> Belief:
    """`knowledge_of` undone."""
    with jax.enable_x64(True):
        return Belief(np.asarray(form(model).packed(known)[0]))


def at_begin(belief: Belief, model: Model) -> Belief:
    """The belief where a movement's record begins with the last sample, so that a leg need not be
    seen at rest before it is let go.
    """
    return belief_of(begun(knowledge_of(belief, model)), model)


@cache
def form(model: Model) -> Form:
    """How knowledge lies in a row, whoever's leg it is of."""
    with jax.enable_x64(True):
        return Form(begin(prior_of(expected_leg(77.0, 1.80), model), model.node), small=None)
