"""The bare leg, from what drops with several weights told: weighted least squares.

With the leg's G = m l g / J, c / J and b = d / J, and a mass M at r with the radius of gyration k,
a drop has

    J' = J + M (r^2 + k^2),              G' = (J G + M g r) / J',
    (c / J)' = (1 + s h) J c / J',       b' = (1 + q h) J b / J',

where h is how much heavier M is than the least of all masses, 1 for the heaviest: a leg that bears
more is damped, and drawn back, by a little more or less, s and q, and c / J and b tell J no surer
than that. Every mass has its own M, r, k, s and q.

Two weights tell J, and r and k as far as they are not known: a mass that is 5 mm off its place
would else make J wrong by 6 %. That is why every weight is followed as a leg of its own.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import exp, hypot, inf

import numpy as np
from jaxtyping import Float

from exoid.fitting.model.systematics import SELDOM
from exoid.physics.anatomy.added_mass import UNUSUAL, same_swing
from exoid.physics.anatomy.expected import STRANGE
from exoid.physics.leg import GRAVITY
from exoid.watching.estimate.expect import KNEE_UNDER_IT, OF_MASS, PLACE, Row, Unloading, of_mass
from exoid.watching.estimate.load import Mass
from exoid.watching.estimate.moment import Misplaced, Quantity

NAMES = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
UNITS = ("1/s^2", "1/s^2", "1/s")
ABSOLUTE = {"gravity": "N m", "stiffness": "N m/rad", "damping": "N m s/rad"}
ROUNDS = 8  # of Gauss-Newton at most
MOST = 700.0  # of a logarithm of odds
SETTLED = 1e-6  # standard deviations that the last step moves


@dataclass(frozen=True)
class Told:
    """The ratios of a leg with a mass on it, and J with it where a known torque told that."""

    ratios: tuple[float, ...]
    errors: tuple[float, ...]
    inertia: tuple[float, float] | None = None  # kg m^2, with its standard error


@dataclass(frozen=True, eq=False)
class Bare:
    """The quantities of the bare leg, and how much of log J the prior left."""

    ratios: tuple[Quantity, ...]
    absolute: tuple[Quantity, ...]
    narrowed: float  # error of log J over that a priori
    row: Row
    apart: float  # standard deviations, by which anatomy and what the weights told contradict
    misplaced: float  # standard deviations, by which the masses are not as declared


@dataclass(frozen=True, eq=False)
class Solved:
    """The row where the search ended, its covariance, and the logarithm of the evidence."""

    row: Row
    covariance: Float[np.ndarray, "unknown unknown"]
    apart: float
    evidence: float


def unloaded(before: Unloading, told: Mapping[Mass, Told], near: Row | None = None) -> Bare:
    """The bare leg by all weights that were told of; the search begins `near` a row.

    Errors hold that the masses hang centimetres from where they are said to, by the odds that they
    do (`fitting/multistart/seldom.py`).
    """
    usual = solved(before, told, near)
    if before.elsewhere is None or not any(mass.weight for mass in told):
        return read(usual, usual.covariance, before)
    far = solved(before.elsewhere, told, usual.row)
    odds = 1 / (1 + exp(min(usual.evidence - far.evidence, MOST)) * (1 / SELDOM - 1))
    return read(usual, usual.covariance + odds * beyond(usual, far), before)


def beyond(usual: Solved, far: Solved) -> Float[np.ndarray, "unknown unknown"]:
    """What the mean square is larger by about where one search ended, by what the other found."""
    step = far.row - usual.row
    return far.covariance - usual.covariance + np.outer(step, step)


def solved(before: Unloading, told: Mapping[Mass, Told], near: Row | None) -> Solved:
    """By Gauss-Newton."""
    row, slopes = (before.prior if near is None else near).copy(), before.root
    if near is None:
        for each in told.values():
            row[1:4] = each.ratios
    for _ in range(ROUNDS):
        off, slopes = residual(before, told, row)
        step = np.linalg.lstsq(slopes, -off, rcond=None)[0]
        row = row + step
        if np.max(np.abs(step) / before.deviation) < SETTLED:
            break
    apart = float(np.linalg.norm(residual(before, told, row)[0]))
    information = slopes.T @ slopes
    known = float(np.linalg.slogdet(information)[1] / 2 - np.linalg.slogdet(before.root)[1])
    return Solved(row, np.linalg.inv(information), apart, -(apart**2) / 2 - known)


def residual(
    before: Unloading, told: Mapping[Mass, Told], row: Row
) -> tuple[Float[np.ndarray, " residual"], Float[np.ndarray, "residual unknown"]]:
    """What the row says less what was told and believed, over standard errors; and its slopes."""
    off, slopes = [before.root @ (row - before.prior)], [before.root]
    for mass, one in told.items():
        values, errors = [*one.ratios], [*one.errors]
        if one.inertia is not None:
            values, errors = [*values, one.inertia[0]], [*errors, one.inertia[1]]
        own = of_mass(before.masses.index(mass)) if mass.weight else None
        shown, slope = with_mass(row, mass, own, heavier(mass, told))
        size, scale = len(values), np.array(errors)
        off.append((shown[:size] - np.array(values)) / scale)
        slopes.append(slope[:size] / scale[:, None])
    return np.concatenate(off), np.concatenate(slopes)


def heavier(mass: Mass, told: Iterable[Mass]) -> float:
    """By how much it is heavier than the least of all, 1 for the heaviest."""
    weights = [each.weight for each in told]
    return (mass.weight - min(weights)) / ((max(weights) - min(weights)) or 1.0)


def with_mass(
    row: Row, mass: Mass, own: slice | None, heavier: float
) -> tuple[Float[np.ndarray, "4"], Float[np.ndarray, "4 unknown"]]:
    """The ratios of the loaded leg and its J, and their slopes in the row, which has of the mass
    what is `own`.
    """
    entries = np.zeros(OF_MASS) if own is None else row[own]
    added, farther, extent = entries[PLACE].tolist()
    inertia, weight = exp(row[0]), mass.weight * exp(added)
    distance = mass.distance * exp(farther)
    moment, spread = weight * GRAVITY * distance, weight * distance**2
    loaded = inertia + spread + weight * extent
    more = np.concatenate([[1.0], 1 + heavier * entries[KNEE_UNDER_IT]])
    bare = inertia * row[1:4] * more
    shown = (bare + np.array([moment, 0.0, 0.0])) / loaded
    of_shown, of_loaded = np.zeros((3, row.size)), np.zeros(row.size)
    of_shown[:, 0] = bare
    of_shown[:, 1:4] = inertia * np.diag(more)
    of_loaded[0] = inertia
    if own is not None:
        of_shown[0, own][PLACE] = moment, moment, 0.0
        of_shown[1:, own][:, KNEE_UNDER_IT] = heavier * inertia * np.diag(row[2:4])
        of_loaded[own][PLACE] = spread + weight * extent, 2 * spread, weight
    slopes = (of_shown - np.outer(shown, of_loaded)) / loaded
    return np.append(shown, loaded), np.concatenate([slopes, of_loaded[None]])


def read(found: Solved, covariance: np.ndarray, before: Unloading) -> Bare:
    """The row in the numbers that people read."""
    row, errors = found.row, np.sqrt(np.diag(covariance))
    inertia = exp(row[0])
    ratios = zip(NAMES, row[1:4].tolist(), errors[1:4].tolist(), UNITS, strict=True)
    absolute = [Quantity("inertia", inertia, inertia * float(errors[0]), "kg m^2")]
    for at, (name, unit) in enumerate(ABSOLUTE.items(), start=1):
        value = inertia * float(row[at])
        slope = np.zeros(row.size)
        slope[0], slope[at] = value, inertia
        absolute.append(Quantity(name, value, float(np.sqrt(slope @ covariance @ slope)), unit))
    narrowed = float(errors[0] / before.deviation[0]) if before.deviation[0] > 0 else inf
    told = tuple(Quantity(*each) for each in ratios)
    return Bare(
        told, tuple(absolute), narrowed, row, found.apart, max(astray(before, row), default=0.0)
    )


def astray(before: Unloading, row: Row) -> list[float]:
    """By how many standard deviations each of the masses is not as declared."""
    away = (row - before.prior) / before.deviation
    return [hypot(*away[of_mass(at)][PLACE].tolist()) for at in range(len(before.masses))]


def misplaced_by(before: Unloading, bare: Bare) -> Misplaced | None:
    """Where a mass swings as if it hung, where that is hardly where it is declared: the one that
    is farthest from it, as it is known.
    """
    if bare.misplaced <= UNUSUAL:
        return None
    number = int(np.argmax(astray(before, bare.row)))
    mass, own = before.masses[number], of_mass(number)
    if not mass.placed:
        return None
    _, farther, extent = bare.row[own][PLACE].tolist()
    usual = float(before.prior[own][PLACE][-1])
    acts = same_swing(mass.distance * exp(farther), max(extent, 0.0), usual)
    return Misplaced(mass.distance, acts, bare.misplaced > STRANGE)
