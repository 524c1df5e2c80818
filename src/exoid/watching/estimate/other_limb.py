"""A limb that moves as no leg of its body does, as a stump: the tables say nothing of it."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from jaxtyping import Float

from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.model.trust import Phase
from exoid.online.outlook import Outlook
from exoid.physics.anatomy.expected import STRANGE, ExpectedLeg
from exoid.physics.anatomy.likeness import away, pendulum_length
from exoid.physics.leg import GRAVITY
from exoid.watching.estimate.moment import Moment, Unlike
from exoid.watching.estimate.online import Belief, at_begin, init, replay

ANY = 1.0  # standard deviation of log m, l and log J / (m l): a third of a leg's to three times
FAR = 5.0  # standard deviations, beyond which a movement that strayed was followed by wrong tables
REST = 1.0  # s before a movement, in which the limb is seen to be held

Rows = Float[np.ndarray, "row 6"]  # of samples
Marks = Sequence[float]  # s, where the records of movements begin


@dataclass(frozen=True)
class OtherLimb:
    """What is believed of a limb of which the tables tell nothing, and what was said last."""

    belief: Belief
    said: Outlook
    unlike: Unlike


def other_limb(
    expected: ExpectedLeg, model: Model, rows: Rows, begun: float, marks: Marks = ()
) -> OtherLimb | None:
    """The limb that moves since `begun` [s]; None where it may be a whole leg, or is not explained
    either.
    """
    inside = rows[rows[:, 0] >= begun - REST]
    found = as_any_limb(expected, model, inside, marks, FAR)
    return found if found and int(found.said.phase[-1]) == Phase.MOVING else None


def strange_leg(
    expected: ExpectedLeg, model: Model, rows: Rows, marks: Marks, told: Moment
) -> OtherLimb | None:
    """The leg of these drops where fewer than one in a thousand of its body moves like it: then
    what was `told` of it leans on tables that are wrong. None where it may be one.
    """
    if unlike(expected, told.ratios[0].value, 0.0, STRANGE) is None:
        return None
    found = as_any_limb(expected, model, rows, marks, STRANGE)
    return found if found and found.said.rests[-1] == told.drops else None


def as_any_limb(
    expected: ExpectedLeg, model: Model, rows: Rows, marks: Marks, far: float
) -> OtherLimb | None:
    """The limb that moves so, nothing being known of it. None where it is no farther than `far`
    from what is expected.
    """
    belief, ends = init(any_limb(expected), model), np.flatnonzero(np.isin(rows[:, 0], marks)) + 1
    for first, end in pairwise([0, *ends.tolist()]):
        belief = at_begin(replay(belief, Sample(*rows[first:end].T), model)[0], model)
    rest = rows[ends[-1] if ends.size else 0 :]
    if not len(rest):
        return None
    belief, said = replay(belief, Sample(*rest.T), model)
    found = unlike(expected, float(said.ratios[-1, 0]), float(said.errors[-1, 0]), far)
    return None if found is None else OtherLimb(belief, said, found)


def unlike(expected: ExpectedLeg, gravity: float, error: float, far: float) -> Unlike | None:
    """How a limb with this m l g / J [1/s^2] differs from its body's; None where it does not."""
    usual = pendulum_length(expected)
    if abs(away(expected, gravity, error)) <= far:
        return None
    return Unlike(GRAVITY / gravity, usual.value, usual.standard_deviation or 0.0)


def any_limb(expected: ExpectedLeg) -> ExpectedLeg:
    """The same with nothing known but the order of size."""
    wider = np.array(expected.covariance) + ANY**2 * np.eye(3)
    return replace(expected, covariance=tuple(map(tuple, wider.tolist())))
