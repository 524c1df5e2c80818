"""The bare leg, from what drops with several weights told: weighted least squares.

With the leg's G = m l g / J, c / J and b = d / J, and a mass M at r with the radius of gyration k,
a drop has

    J' = J + M (r^2 + k^2),   G' = (J G + M g r) / J',   (c / J)' = J c / J',   b' = J b / J'.

Two weights tell J, and r and k as far as they are not known: a mass that is 5 mm off its place
would else make J wrong by 6 %. That is why every weight is followed as a leg of its own.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from math import exp, inf, log

import numpy as np
from jaxtyping import Float

from exoid.fitting.model.systematics import GYRATION, MEASURED_GYRATION, PLACED, WEIGHED
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.subject import Subject
from exoid.watching.estimate.load import Mass
from exoid.watching.estimate.moment import Quantity

NAMES = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
UNITS = ("1/s^2", "1/s^2", "1/s")
ABSOLUTE = {"gravity": "N m", "stiffness": "N m/rad", "damping": "N m s/rad"}
ANYWHERE = 0.5  # of the logarithm of a distance that nobody measured
KNEE = 5.0  # times what a relaxed knee has, where nothing else is known
ROUNDS = 8  # of Gauss-Newton at most
SETTLED = 1e-6  # standard deviations that the last step moves

Row = Float[np.ndarray, " unknown"]  # log J, G, c / J, d / J, log of weight and distance off, k^2


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


@dataclass(frozen=True, eq=False)
class Unloading:
    """What is believed of a leg, and of the masses that are put on it."""

    prior: Row
    root: Float[np.ndarray, "unknown unknown"]  # of its information: whitens a deviation
    deviation: Row


def unloading(expected: ExpectedLeg, subject: Subject, masses: list[Mass]) -> Unloading:
    """Before any drop: the leg by anatomy, the masses as well as they were weighed and placed."""
    inertia = expected.inertia.value
    gravity = expected.mass.value * expected.com_distance.value * GRAVITY / inertia
    knee = expected.stiffness.value / inertia, expected.damping.value / inertia
    heaviest = max(masses, key=lambda each: each.weight)
    said, by_tape = subject.added_mass_uncertainty, subject.added_mass_distance_uncertainty
    weighed = WEIGHED if said is None or not heaviest.weight else said / heaviest.weight
    away = (PLACED if by_tape is None else by_tape) / heaviest.distance
    gyration = subject.added_mass_gyration
    extent = GYRATION**2 if gyration is None else gyration**2
    spread = 2**0.5 * extent if gyration is None else 2 * MEASURED_GYRATION * extent
    prior = np.array([log(inertia), gravity, *knee, 0.0, 0.0, extent])
    deviation = np.array(
        [
            1.0,
            1.0,
            KNEE * knee[0],
            KNEE * knee[1],
            weighed,
            away if heaviest.placed else ANYWHERE,
            1.0,
        ]
    )
    deviation[-1] = max(spread, 1e-9)
    covariance = np.diag(deviation**2)
    covariance[:2, :2] = of_size(expected, gravity)
    return Unloading(
        prior, np.linalg.inv(np.linalg.cholesky(covariance)), np.sqrt(np.diag(covariance))
    )


def of_size(expected: ExpectedLeg, gravity: float) -> Float[np.ndarray, "2 2"]:
    """The covariance of log J and G."""
    assert expected.covariance is not None
    rows = np.array([[1.0, 1.0, 1.0], [0.0, 0.0, -gravity]])
    return rows @ np.array(expected.covariance) @ rows.T


def unloaded(before: Unloading, told: Mapping[Mass, Told], near: Row | None = None) -> Bare:
    """The bare leg by all weights that were told of; the search begins `near` a row."""
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
    return read(row, np.linalg.inv(slopes.T @ slopes), before, apart)


def residual(
    before: Unloading, told: Mapping[Mass, Told], row: Row
) -> tuple[Float[np.ndarray, " residual"], Float[np.ndarray, "residual unknown"]]:
    """What the row says less what was told and believed, over standard errors; and its slopes."""
    off, slopes = [before.root @ (row - before.prior)], [before.root]
    for mass, one in told.items():
        values, errors = [*one.ratios], [*one.errors]
        if one.inertia is not None:
            values, errors = [*values, one.inertia[0]], [*errors, one.inertia[1]]
        shown, slope = with_mass(row, mass)
        size, scale = len(values), np.array(errors)
        off.append((shown[:size] - np.array(values)) / scale)
        slopes.append(slope[:size] / scale[:, None])
    return np.concatenate(off), np.concatenate(slopes)


def with_mass(row: Row, mass: Mass) -> tuple[Float[np.ndarray, "4"], Float[np.ndarray, "4 7"]]:
    """The ratios of the loaded leg and its J, and their slopes in the row."""
    _, gravity, stiffness, damping, heavier, farther, extent = row.tolist()
    inertia, weight = exp(row[0]), mass.weight * exp(heavier)
    distance = mass.distance * exp(farther)
    moment, spread = weight * GRAVITY * distance, weight * distance**2
    added = spread + weight * extent
    loaded = inertia + added
    own = np.array([inertia * gravity + moment, inertia * stiffness, inertia * damping]) / loaded
    of_own = np.zeros((3, row.size))
    of_own[:, 0] = inertia * row[1:4]
    of_own[:, 1:4] = inertia * np.eye(3)
    of_own[0, 4:6] = moment
    of_loaded = np.array([inertia, 0.0, 0.0, 0.0, added, 2 * spread, weight])
    slopes = (of_own - np.outer(own, of_loaded)) / loaded
    return np.append(own, loaded), np.concatenate([slopes, of_loaded[None]])


def read(row: Row, covariance: np.ndarray, before: Unloading, apart: float) -> Bare:
    """The row in the numbers that people read."""
    errors = np.sqrt(np.diag(covariance))
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
    return Bare(told, tuple(absolute), narrowed, row, apart)
