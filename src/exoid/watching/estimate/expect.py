"""What is expected of a person's leg, as far as the person is known, and of masses on it."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import log

import numpy as np
from jaxtyping import Float

from exoid.fitting.model.systematics import (
    DAMPING_UNDER_LOAD,
    GYRATION,
    MEASURED_GYRATION,
    MISREAD,
    PLACED,
    STIFFNESS_UNDER_LOAD,
    WEIGHED,
)
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.subject import Subject
from exoid.watching.estimate.load import Mass

ADULT = 72.0, 1.72  # kg, m
SCATTER = (0.25, 0.10, 0.05)  # of log m, log l and log J / (m l) between adults, beside the tables'
ANYWHERE = 0.5  # of the logarithm of a distance that nobody measured
KNEE = 5.0  # times what a relaxed knee has, where nothing else is known
LEAST = 1e-9  # a variance may not vanish

# log J, G, c / J, d / J; of each mass log of weight and distance off, k^2, and how far off c and d
# are under it, relative
Row = Float[np.ndarray, " unknown"]
OF_LEG, OF_MASS = 4, 5
PLACE, KNEE_UNDER_IT = slice(0, 3), slice(3, 5)  # of those of a mass


def of_mass(number: int) -> slice:
    """Where a row has what is not known of this one of the masses."""
    return slice(OF_LEG + OF_MASS * number, OF_LEG + OF_MASS * (number + 1))


def expected_of(subject: Subject) -> ExpectedLeg:
    """By body mass and height or measured mass and distance; else that of any adult."""
    from exoid.physics.anatomy import expected_leg

    found = said_of(subject)
    if found is not None:
        return found
    adult = expected_leg(*ADULT)
    wider = np.array(adult.covariance) + np.diag(np.square(SCATTER))
    return replace(adult, covariance=tuple(map(tuple, wider.tolist())))


def is_known(subject: Subject) -> bool:
    """Is it more than any adult that is expected?"""
    return said_of(subject) is not None


def said_of(subject: Subject) -> ExpectedLeg | None:
    from exoid.fitting.model.prior_and_limits import expectation

    return expectation(subject, "auto")[0]


def sizes_of(expected: ExpectedLeg) -> dict[str, float]:
    """About how large the leg's quantities are, by name."""
    inertia = expected.inertia.value
    own = {
        "gravity": expected.mass.value * expected.com_distance.value * GRAVITY,
        "stiffness": expected.stiffness.value,
        "damping": expected.damping.value,
    }
    ratios = {f"{name}_over_inertia": value / inertia for name, value in own.items()}
    return {"inertia": inertia, **own, **ratios}


def check_subject(subject: Subject) -> None:
    """**Raises** `ValueError` for what is no leg."""
    if subject.kind == "rig":
        raise ValueError(
            "live estimates are of legs: what a rig may be is not expected beforehand. Record it "
            "and fit it (exoid record, exoid fit)."
        )


@dataclass(frozen=True, eq=False)
class Unloading:
    """What is believed of a leg, and of the masses that are put on it."""

    prior: Row
    root: Float[np.ndarray, "unknown unknown"]  # of its information: whitens a deviation
    deviation: Row
    masses: tuple[Mass, ...]  # that are put on it, each with errors of its own
    elsewhere: "Unloading | None" = None  # the same of masses that hang centimetres off, if any may


def unloading(expected: ExpectedLeg, subject: Subject, masses: Iterable[Mass]) -> Unloading:
    """Before any drop: the leg by anatomy, the masses as well as they were weighed and placed."""
    put_on = tuple(each for each in dict.fromkeys(masses) if each.weight)
    by_tape = subject.added_mass_distance_uncertainty
    usual = believed(expected, subject, put_on, PLACED if by_tape is None else by_tape)
    if by_tape is None and any(each.placed for each in put_on):
        return replace(usual, elsewhere=believed(expected, subject, put_on, MISREAD))
    return usual


def believed(
    expected: ExpectedLeg, subject: Subject, masses: tuple[Mass, ...], by_tape: float
) -> Unloading:
    """With masses whose distances are known so well [m], where they are at all."""
    inertia = expected.inertia.value
    gravity = expected.mass.value * expected.com_distance.value * GRAVITY / inertia
    knee = np.array([expected.stiffness.value, expected.damping.value]) / inertia
    each = [known_of_mass(subject, mass, by_tape) for mass in masses]
    prior = np.array([log(inertia), gravity, *knee, *(mean for one in each for mean, _ in one)])
    off = [1.0, 1.0, *KNEE * knee, *(spread for one in each for _, spread in one)]
    covariance = np.diag(np.square(np.maximum(off, LEAST)))
    covariance[:2, :2] = of_size(expected, gravity)
    root, deviation = np.linalg.inv(np.linalg.cholesky(covariance)), np.sqrt(np.diag(covariance))
    return Unloading(prior, root, deviation, masses)


def known_of_mass(subject: Subject, mass: Mass, by_tape: float) -> tuple[tuple[float, float], ...]:
    """What is expected of its entries in a row, each with its standard deviation."""
    said, gyration = subject.added_mass_uncertainty, subject.added_mass_gyration
    weighed = WEIGHED if said is None else said / mass.weight
    away = by_tape / mass.distance if mass.placed else ANYWHERE
    if gyration is None:
        extent = GYRATION**2, 2**0.5 * GYRATION**2
    else:
        extent = gyration**2, 2 * MEASURED_GYRATION * gyration**2
    under_it = ((0.0, each) for each in known_of_load(subject))
    return (0.0, weighed), (0.0, away), extent, *under_it


def known_of_load(subject: Subject) -> tuple[float, float]:
    """How well stiffness and damping stay the same beside a mass, relative."""
    stiffer = subject.stiffness_under_load_uncertainty
    damped = subject.damping_under_load_uncertainty
    return (
        STIFFNESS_UNDER_LOAD if stiffer is None else stiffer,
        DAMPING_UNDER_LOAD if damped is None else damped,
    )


def of_size(expected: ExpectedLeg, gravity: float) -> Float[np.ndarray, "2 2"]:
    """The covariance of log J and G."""
    assert expected.covariance is not None
    rows = np.array([[1.0, 1.0, 1.0], [0.0, 0.0, -gravity]])
    return rows @ np.array(expected.covariance) @ rows.T
