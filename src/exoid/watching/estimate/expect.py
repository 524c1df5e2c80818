"""What is expected of a person's leg, as far as the person is known, and of masses on it."""

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

# log J, G, c / J, d / J; log of weight and distance off, k^2; c and d under load off, relative
Row = Float[np.ndarray, " unknown"]
OF_MASS, OF_LOAD = slice(4, 7), slice(7, 9)


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
    heaviest: Mass  # of those that are put on it
    elsewhere: "Unloading | None" = None  # the same of masses that hang centimetres off, if any may


def unloading(expected: ExpectedLeg, subject: Subject, masses: list[Mass]) -> Unloading:
    """Before any drop: the leg by anatomy, the masses as well as they were weighed and placed."""
    heaviest = max(masses, key=lambda each: each.weight)
    by_tape = subject.added_mass_distance_uncertainty
    usual = PLACED if by_tape is None else by_tape
    if not heaviest.placed:
        return believed(expected, subject, heaviest, ANYWHERE)
    elsewhere = None
    if by_tape is None and heaviest.weight:
        elsewhere = believed(expected, subject, heaviest, MISREAD / heaviest.distance)
    return believed(expected, subject, heaviest, usual / heaviest.distance, elsewhere)


def believed(
    expected: ExpectedLeg,
    subject: Subject,
    heaviest: Mass,
    away: float,
    elsewhere: Unloading | None = None,
) -> Unloading:
    """With masses whose distances are known to a share `away` of them."""
    inertia = expected.inertia.value
    gravity = expected.mass.value * expected.com_distance.value * GRAVITY / inertia
    knee = np.array([expected.stiffness.value, expected.damping.value]) / inertia
    extent, of_mass = known_of_mass(subject, heaviest.weight)
    prior = np.array([log(inertia), gravity, *knee, 0.0, 0.0, extent, 0.0, 0.0])
    weighed, spread = of_mass
    off = [1.0, 1.0, *KNEE * knee, weighed, away, spread, *known_of_load(subject)]
    covariance = np.diag(np.square(np.maximum(off, LEAST)))
    covariance[:2, :2] = of_size(expected, gravity)
    root, deviation = np.linalg.inv(np.linalg.cholesky(covariance)), np.sqrt(np.diag(covariance))
    return Unloading(prior, root, deviation, heaviest, elsewhere)


def known_of_mass(subject: Subject, weight: float) -> tuple[float, tuple[float, float]]:
    """The expected k^2 [m^2]; how well the weight is known, relative, and that."""
    said, gyration = subject.added_mass_uncertainty, subject.added_mass_gyration
    weighed = WEIGHED if said is None or not weight else said / weight
    if gyration is None:
        return GYRATION**2, (weighed, 2**0.5 * GYRATION**2)
    return gyration**2, (weighed, 2 * MEASURED_GYRATION * gyration**2)


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
