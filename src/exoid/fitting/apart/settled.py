"""P at the mean ratios of segments: what prior and limits make of them."""

import jax
import numpy as np

from exoid.fitting.misfit.neighbourhood import derivative
from exoid.fitting.misfit.uncertainty import Information
from exoid.fitting.model.belief import NAMES, Belief
from exoid.fitting.model.constraint import NEVER, violations
from exoid.fitting.model.limits import constraint_names
from exoid.fitting.model.prior import prior_residual
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.found import Found
from exoid.fitting.result.estimates.parameters import parameter_estimate
from exoid.physics.leg import GRAVITY, LegParameters

COMMON = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
SIZES = ("mass", "inertia", "com_distance")
SMALLEST_ERROR = 1e-6  # relative, of a ratio: nothing is known better than that
HOLDS = 1e-6  # relative slack below which a constraint holds as an equality


def settled_parameters(
    belief: Belief, ratios: dict[str, Estimate], like: LegParameters | None
) -> dict[str, Estimate]:
    """P at the mean ratios: prior and limits choose m and J, two unknowns for SciPy's SLSQP.

    A ratio that nothing tells is there as that of a leg `like` these, and weighs nothing.
    """
    from scipy.optimize import minimize

    known = np.array([ratios[name].value is not None for name in COMMON])
    assert like is not None  # every segment's own fit has one
    usual = [like.mass * like.com_distance * GRAVITY, like.stiffness, like.damping]
    told = [ratios[name].value for name in COMMON]
    values = np.where(known, np.array(told, dtype=float), np.array(usual) / like.inertia)
    errors = np.array([ratios[name].standard_error or 0.0 for name in COMMON])
    errors = np.where(known, np.maximum(errors, SMALLEST_ERROR * (1 + np.abs(values))), np.inf)
    limits, fixed = belief.limits, belief.by_hand.leg.fix
    ends = [name in fixed for name in constraint_names(0)]
    # Where the ratio is 0 as well, nothing moves; with J fixed, d and c follow from their ratios.
    movable = [name for name in fixed if name in SIZES or (fixed[name] and "inertia" not in fixed)]

    def leg(logs):
        mass, inertia = np.exp(logs[:2])
        gravity, stiffness, damping = logs[2:]
        distance = gravity * inertia / (mass * GRAVITY)
        return LegParameters(mass, inertia, distance, damping * inertia, stiffness * inertia)

    def by_prior(logs):
        return prior_residual(belief.prior, leg(logs), np)

    def violation(logs):
        no_torque = np.zeros((0, *np.shape(logs)[1:]))
        found = violations(limits, leg(logs), no_torque, np)
        return np.where(np.reshape(ends, (-1, *[1] * np.ndim(logs[0]))), NEVER, found)

    def held(logs):
        values = leg(logs)
        return np.array([getattr(values, name) - fixed[name] for name in movable])

    def at(logs):
        return np.concatenate([logs, values])

    found = minimize(
        lambda logs: float(by_prior(at(logs)) @ by_prior(at(logs))) / 2,
        np.log(first_guess(belief)),
        method="SLSQP",
        constraints=[
            {"type": "ineq", "fun": lambda logs: -violation(at(logs))},
            *([{"type": "eq", "fun": lambda logs: held(at(logs))}] if movable else []),
        ],
    )
    point = at(found.x)
    active = violation(point) > -HOLDS
    prior = derivative(by_prior, point)
    data = np.diag([0.0, 0.0, *errors**-2.0])
    gradients = derivative(lambda logs: np.stack(jax.tree.leaves(leg(logs))), point)
    rows = gradients[[NAMES.index(name) for name in fixed]]
    bound = np.concatenate([derivative(violation, point)[active], rows])
    information = Information(data, prior.T @ prior, bound, rows)
    at_bound = {name for name, holds in zip(constraint_names(0), active, strict=True) if holds}
    return {
        name: parameter_estimate(
            name, belief, Found(float(value), gradient, information, name in at_bound)
        )
        for name, value, gradient in zip(NAMES, jax.tree.leaves(leg(point)), gradients, strict=True)
    }


def first_guess(belief: Belief) -> np.ndarray:
    """m [kg] and J [kg m^2]: what anatomy expects, else those of a middling leg."""
    typical = belief.typical
    return np.array([typical.get("mass", 4.0), typical.get("inertia", 0.4)])
