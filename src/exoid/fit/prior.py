"""What is believed of a leg before it moves."""

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float, Inexact

from exoid.fit.coordinates import Mounting
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.anatomy.knee import LOG_SCATTER, NONE
from exoid.physics.leg import LegParameters

SIZE = {"mass": (1.0, 0.0, 0.0), "com_distance": (0.0, 1.0, 0.0), "inertia": (1.0, 1.0, 1.0)}
KNEE = ("damping", "stiffness")
NAMES = [entry.name for entry in fields(LegParameters)]
SILENT = 1e-12  # of precision, relative: none
TINY = 0.01  # of what is expected: below it a logarithm becomes a line, which has no end


class Prior(eqx.Module):
    """Normal in the logarithms of m, l and J / (m l), and of d / J and c / J; or in own units.

    `whitening` is W with W'W the inverse covariance of the three, `knee` one over the standard
    deviation of the two; 0 says nothing. `own` are values in the parameters' own units, an infinite
    deviation says nothing.
    """

    centre: LegParameters
    whitening: Float[Any, "row 3"]
    knee: Float[Any, " 2"]
    own: LegParameters
    own_deviation: LegParameters
    weight: Float[Any, ""]  # lambda of Eq. 11
    mounting: Mounting | None = None  # standard deviations of what recordings own


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


def log_jacobian(prior: Prior, leg: LegParameters) -> Float[Array, ""]:
    """log |d z / d (log m, log J, m l g / J, d / J, c / J)| of the prior's standard scores z.

    A prior is a density in what it is normal in, draws are made in the fit's coordinates. 0 where
    it says nothing of some direction: the coordinates are as good.
    """

    def scores(at):
        inertia, moment = jnp.exp(at[1]), at[2] * jnp.exp(at[1])
        mass = jnp.exp(at[0])
        own = LegParameters(mass, inertia, moment / mass, at[3] * inertia, at[4] * inertia)
        return prior_residual(prior, own)

    logs = [jnp.log(leg.mass), jnp.log(leg.inertia)]
    ratios = [leg.mass * leg.com_distance, leg.damping, leg.stiffness]
    slopes = jax.jacfwd(scores)(jnp.stack([*logs, *(each / leg.inertia for each in ratios)]))
    squared = slopes.T @ slopes
    unit = jnp.sqrt(jnp.maximum(jnp.diag(squared), SILENT))
    scaled = squared / jnp.outer(unit, unit)
    says = jnp.linalg.det(scaled) > SILENT
    safe = jnp.where(says, scaled, jnp.eye(len(unit)))
    return jnp.where(says, jnp.linalg.slogdet(safe)[1] / 2 + jnp.sum(jnp.log(unit)), 0.0)


def draw(prior: Prior, rng: np.random.Generator) -> LegParameters:
    """A leg as a joint prior has it, whatever the limits say."""
    centre, spread = prior.centre, np.sqrt(float(prior.weight))
    logs = np.linalg.solve(prior.whitening, rng.normal(size=3)) / spread
    knee = rng.normal(size=2) / prior.knee / spread
    mass, distance = (
        middle * hardened(log, TINY)
        for middle, log in zip((centre.mass, centre.com_distance), logs[:2], strict=True)
    )
    slowness = centre.mass * centre.com_distance / centre.inertia * hardened(-logs[2], TINY)
    inertia = mass * distance / slowness
    damping, stiffness = (
        inertia * middle / centre.inertia * hardened(log, NONE)
        for middle, log in zip((centre.damping, centre.stiffness), knee, strict=True)
    )
    each = (mass, inertia, distance, damping, stiffness)
    return LegParameters(*(np.asarray(float(value)) for value in each))


def hardened(log: float, none: float) -> float:
    """`softened` undone."""
    return float(2 * none * np.sinh(log + np.arcsinh(1 / (2 * none))))


def mounting_residual(
    prior: Prior, mounting: Mounting, xp=jnp
) -> Inexact[Any, " mounting *column"]:
    """value / sd of what recordings own: they are expected to be as declared."""
    if prior.mounting is None:
        return xp.zeros((0, *mounting.zero.shape[1:]))
    each = jax.tree.map(lambda value, sd: (value.T / sd).T, mounting, prior.mounting)
    return xp.concatenate(jax.tree.leaves(each))


def no_prior() -> Prior:
    """It says nothing."""
    return Prior(
        centre=LegParameters(*(np.asarray(1.0) for _ in NAMES)),
        whitening=np.zeros((3, 3)),
        knee=np.zeros(2),
        own=LegParameters(*(np.asarray(0.0) for _ in NAMES)),
        own_deviation=LegParameters(*(np.asarray(np.inf) for _ in NAMES)),
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
    each = [getattr(expected, name).standard_deviation for name in NAMES]
    return replace(
        no_prior(),
        centre=values_of(expected),
        own=values_of(expected),
        own_deviation=LegParameters(*(np.asarray(1.0 if unit else one) for one in each)),
        weight=np.asarray(float(weight)),
    )


def with_own(prior: Prior, own: Mapping[str, tuple[float, float]], weight: float) -> Prior:
    """The prior with somebody's own (value, standard deviation) in the place of what it says.

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
    values = {name: np.asarray(value) for name, (value, _) in own.items()}
    deviations = {name: np.asarray(deviation) for name, (_, deviation) in own.items()}
    said = np.array([name not in own for name in KNEE], dtype=float)
    return replace(
        prior,
        whitening=whitening,
        knee=prior.knee * said,
        own=replace(prior.own, **values),
        own_deviation=replace(prior.own_deviation, **deviations),
        weight=np.asarray(float(weight)),
    )


def root(precision: np.ndarray) -> np.ndarray:
    """W with W'W the precision, whose rounding may not make it negative."""
    values, vectors = np.linalg.eigh(precision)
    floor = 1e-9 * values.max()
    return np.sqrt(np.where(values > floor, values, 0.0))[:, None] * vectors.T


def values_of(expected: ExpectedLeg) -> LegParameters:
    return LegParameters(*(np.asarray(getattr(expected, name).value) for name in NAMES))
