"""A limb that is no whole leg, as a stump: what anatomy expects of a leg does not hold for it."""

from dataclasses import replace

import numpy as np
from jaxtyping import Float

from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.model.trust import Phase
from exoid.online.outlook import Outlook
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.leg import GRAVITY
from exoid.watching.estimate.online import Belief, init, replay

ANY = 1.0  # standard deviation of log m, log l and log J / (m l): a third of a leg's to three times
FAR = 5.0  # standard deviations of m l g / J between whole legs, beyond which there is hardly one
REST = 1.0  # s before a movement, in which the limb is seen to be held


def other_limb(
    expected: ExpectedLeg, model: Model, rows: Float[np.ndarray, "row 6"], begun: float
) -> tuple[Belief, Outlook] | None:
    """What is believed of the limb that moves since `begun` [s]; None where it may be a whole leg,
    or is not explained either.
    """
    inside = rows[rows[:, 0] >= begun - REST]
    belief, said = replay(init(any_limb(expected), model), Sample(*inside.T), model)
    value, error = float(said.ratios[-1, 0]), float(said.errors[-1, 0])
    usual, scatter = gravity_of(expected)
    follows = int(said.phase[-1]) == Phase.MOVING
    apart = abs(value - usual) > FAR * np.hypot(scatter, error)
    return (belief, said) if follows and apart else None


def any_limb(expected: ExpectedLeg) -> ExpectedLeg:
    """The same with nothing known but the order of size."""
    wider = np.array(expected.covariance) + ANY**2 * np.eye(3)
    return replace(expected, covariance=tuple(map(tuple, wider.tolist())))


def gravity_of(expected: ExpectedLeg) -> tuple[float, float]:
    """m l g / J of a whole leg [1/s^2], and how it scatters."""
    arm = expected.mass.value * expected.com_distance.value / expected.inertia.value
    return arm * GRAVITY, arm * GRAVITY * float(np.sqrt(np.array(expected.covariance)[2, 2]))
