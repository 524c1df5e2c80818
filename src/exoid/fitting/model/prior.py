"""What is believed of a leg before it moves."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Inexact

from exoid.fitting.model.coordinates import Coordinates, leg_parameters, with_inertia
from exoid.fitting.model.limits import Prior
from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.term_parameters import leg_of, with_values
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.anatomy.knee import LOG_SCATTER, NONE
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations

SIZE = {"mass": (1.0, 0.0, 0.0), "com_distance": (0.0, 1.0, 0.0), "inertia": (1.0, 1.0, 1.0)}
KNEE = ("damping", "stiffness")
TINY = 0.01  # of what is expected: below it a logarithm becomes a line, which has no end


def prior_residual(prior: Prior, leg: LegParameters, xp=jnp) -> Inexact[Any, " row *column"]:
    """sqrt(lambda) (P - P_exp) / sd, the second term of Eq. 11 in standardised units."""
    size = prior.whitening @ xp.stack(logarithms(prior.centre, leg, xp))
    ratios = [
        weight * (softened(value / leg.inertia / (centre / prior.centre.inertia), NONE, xp))
        for weight, value, centre in zip(
            prior.knee,
            (leg.damping, leg.stiffness),
            (prior.centre.damping, prior.centre.stiffness),
            strict=True,
        )
    ]
    own = jax.tree.map(
        lambda value, expected, sd: (value - expected) / sd, leg, prior.own, prior.own_deviation
    )
    each = xp.concatenate([size, xp.stack([*ratios, *jax.tree.leaves(own)])])
    return xp.sqrt(prior.weight) * each


def logarithms(centre: LegParameters, leg: LegParameters, xp) -> list[Inexact[Any, "*column"]]:
    """Of m, l and J / (m l) over what is expected; m l / J may be negative, where m and J are not.

    Lines instead of logarithms below a hundredth lead a search back from where no leg is.
    """
    slowness = leg.mass * leg.com_distance / leg.inertia
    expected = centre.mass * centre.com_distance / centre.inertia
    return [
        softened(leg.mass / centre.mass, TINY, xp),
        softened(leg.com_distance / centre.com_distance, TINY, xp),
        -softened(slowness / expected, TINY, xp),
    ]


def softened(ratio: Inexact[Any, "*column"], none: float, xp) -> Inexact[Any, "*column"]:
    """log(ratio) where it is above `none`, proportional to it below; 0 at a ratio of 1."""
    return xp.arcsinh(ratio / (2 * none)) - np.arcsinh(1 / (2 * none))


def log_jacobian(prior: Prior, leg: LegParameters, xp=jnp) -> Inexact[Any, "*column"]:
    """log |d (the prior's variables) / d (the fit's coordinates)|, up to a constant.

    A prior is a density in its own variables, draws are made in log m, log J, m l g / J, d / J and
    c / J. With r the ratio to what is expected, d log(m l / J) is 1 / r, and so it is of d / J and
    c / J, both softened; log m and log l have 1. Parameters in their own units have m, J, l, and J
    for d and for c. Where the prior says nothing, the fit's coordinates are as good.
    """
    centre, own = prior.centre, prior.own_deviation
    expected = centre.mass * centre.com_distance / centre.inertia
    weighs = prior.weight > 0
    of_size = weighs & ((prior.whitening != 0).any() | xp.isfinite(own.com_distance))
    slowness = leg.mass * leg.com_distance / leg.inertia / expected
    total = xp.where(of_size, steepness(slowness, TINY, xp), 0.0)
    for name in SIZE:
        said = weighs & xp.isfinite(getattr(own, name))
        total = total + xp.where(said, xp.log(xp.abs(getattr(leg, name))), 0.0)
    for number, name in enumerate(KNEE):
        ratio = getattr(leg, name) / leg.inertia / (getattr(centre, name) / centre.inertia)
        said = weighs & (prior.knee[number] > 0)
        total = total + xp.where(said, steepness(ratio, NONE, xp), 0.0)
        in_own = weighs & xp.isfinite(getattr(own, name))
        total = total + xp.where(in_own, xp.log(leg.inertia), 0.0)
    return total


def steepness(ratio: Inexact[Any, "*column"], none: float, xp) -> Inexact[Any, "*column"]:
    """log of the derivative of `softened`."""
    return -xp.log(ratio**2 + 4 * none**2) / 2


def belief_residual(prior: Prior, point: Coordinates, xp=jnp) -> Inexact[Any, " row *column"]:
    """What is believed of the leg and of its terms."""
    of_leg = prior_residual(prior, leg_parameters(point, xp), xp)
    return xp.concatenate([of_leg, term_residual(prior, point, xp)])


def term_residual(prior: Prior, point: Coordinates, xp=jnp) -> Inexact[Any, " row *column"]:
    """sqrt(lambda) (value - expected) / sd of the terms' parameters."""
    if not prior.terms:
        return xp.zeros((0, *xp.shape(point.log_mass)))
    each = jax.tree.map(
        lambda value, expected, sd: (value - expected) / sd,
        with_inertia(point, xp),
        prior.terms,
        prior.terms_deviation,
    )
    return xp.sqrt(prior.weight) * xp.stack(jax.tree.leaves(each))


def term_log_jacobian(prior: Prior, point: Coordinates, xp=jnp) -> Inexact[Any, ""]:
    """log |d (terms' parameters) / d (the fit's coordinates)|, of those of which much is said."""
    powers = [
        xp.where(xp.isfinite(getattr(deviation, name)), float(declared.inertia_power), 0.0)
        for deviation in prior.terms_deviation
        for name, declared in declarations(type(deviation))
    ]
    return (prior.weight > 0) * sum(powers, xp.zeros(())) * point.shared.log_inertia


def mounting_residual(
    prior: Prior, mounting: Mounting, xp=jnp
) -> Inexact[Any, " mounting *column"]:
    """W value / sd of what recordings own: they are expected to be as declared."""
    if prior.mounting is None:
        return xp.zeros((0, *mounting.zero.shape[1:]))
    each = jax.tree.map(
        lambda value, sd, whitening: whitening @ (value.T / sd).T,
        mounting,
        prior.mounting,
        prior.in_common,
    )
    return xp.concatenate(jax.tree.leaves(each))


def no_prior() -> Prior:
    """It says nothing."""
    return Prior(
        centre=leg_of(lambda _: 1.0),
        whitening=np.zeros((3, 3)),
        knee=np.zeros(2),
        own=leg_of(lambda _: 0.0),
        own_deviation=leg_of(lambda _: np.inf),
        weight=np.asarray(1.0),
    )


def joint_prior(expected: ExpectedLeg, weight: float) -> Prior:
    """m, l and J with their covariance, d and c over decades."""
    return replace(
        no_prior(),
        centre=values_of(expected),
        whitening=root(np.linalg.inv(np.array(expected.covariance))),
        knee=np.full(2, 1 / LOG_SCATTER),
        weight=np.asarray(float(weight)),
    )


def own_units(expected: ExpectedLeg, weight: float, *, unit: bool) -> Prior:
    """Each parameter by itself, as Eq. 11 has it; by deviations of 1 where `unit`."""
    return replace(
        no_prior(),
        centre=values_of(expected),
        own=values_of(expected),
        own_deviation=leg_of(
            lambda name: 1.0 if unit else getattr(expected, name).standard_deviation
        ),
        weight=np.asarray(float(weight)),
    )


def with_own(prior: Prior, own: Mapping[str, tuple[float, float]], weight: float) -> Prior:
    """The prior with somebody's own (value, standard deviation) in the place of what it says of
    the leg or its terms.

    Of m, l and J what it says of the others, given these, stays: the joint density over that of
    the named ones.
    """
    if not own:
        return prior
    named = np.array([SIZE[name] for name in own if name in SIZE]).reshape(-1, 3)
    whitening = prior.whitening
    if named.size and whitening.any():
        precision = whitening.T @ whitening
        marginal = named @ np.linalg.inv(precision) @ named.T
        whitening = root(precision - named.T @ np.linalg.inv(marginal) @ named)
    values, deviations = ({name: each[part] for name, each in own.items()} for part in (0, 1))
    said = np.array([name not in own for name in KNEE], dtype=float)
    return replace(
        prior,
        whitening=whitening,
        knee=prior.knee * said,
        own=with_values(prior.own, values),
        own_deviation=with_values(prior.own_deviation, deviations),
        terms=tuple(with_values(each, values) for each in prior.terms),
        terms_deviation=tuple(with_values(each, deviations) for each in prior.terms_deviation),
        weight=np.asarray(float(weight)),
    )


def root(precision: np.ndarray) -> np.ndarray:
    """W with W'W the precision, whose rounding may not make it negative."""
    values, vectors = np.linalg.eigh(precision)
    floor = 1e-9 * values.max()
    return np.sqrt(np.where(values > floor, values, 0.0))[:, None] * vectors.T


def values_of(expected: ExpectedLeg) -> LegParameters:
    return leg_of(lambda name: getattr(expected, name).value)
