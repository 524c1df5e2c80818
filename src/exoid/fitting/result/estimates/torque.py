"""The person's torque as an estimate."""

import numpy as np

from exoid.fitting.misfit.uncertainty import HELD
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.found import ON_BOUND, mean_of
from exoid.fitting.result.estimates.scale import SCALE_FREE
from exoid.physics.parameter import declarations
from exoid.physics.torque import CycleTorque


def estimate_torque(basis: Basis, names: list[str], at_bound: set[str]) -> Estimate:
    """The mean of tau over the voluntary segments of which these are the quantities."""
    declared = dict(declarations(CycleTorque))["amplitude"]
    found = mean_of(basis, names, at_bound)
    strongest = float(basis.problem.belief.limits.torque)
    bounded = bool(np.isfinite(strongest))
    return found.estimate(
        (declared.symbol, declared.title, declared.unit),
        lower=-strongest if bounded else None,
        upper=strongest if bounded else None,
        reason=ON_BOUND if found.shares == HELD else found.untold(SCALE_FREE),
    )
