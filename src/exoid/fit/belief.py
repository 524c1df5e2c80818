"""What is believed of this leg before it moves: the prior and the limits of a fit."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from exoid.fit.constraint import Limits
from exoid.fit.prior import Prior
from exoid.physics.anatomy import (
    COM_DISTANCE_SCATTER,
    INERTIA_SCATTER,
    KNEE_DAMPING,
    KNEE_SCATTER,
    KNEE_STIFFNESS,
    MASS_SCATTER,
    Expected,
    ExpectedLeg,
    expected_leg,
    paper_prior,
    reach,
)
from exoid.physics.leg import LegParameters
from exoid.physics.parameter import declarations
from exoid.recording.recording import Subject

PriorName = Literal["de_leva", "winter", "dumas", "paper", "none"]
PRIORS: tuple[PriorName, ...] = ("de_leva", "winter", "dumas", "paper", "none")
NAMES = [name for name, _ in declarations(LegParameters)]
INERTIA_OVER_MOMENT = 0.375  # m, J / (m l) of all anthropometric tables, within 5 %
TALL = 2.0  # m; the reach of a leg whose height is unknown


@dataclass(frozen=True)
class Belief:
    """The prior in words and numbers, and the limits."""

    name: PriorName
    expected: ExpectedLeg | None
    prior: Prior
    limits: Limits
    note: str
    raw: bool = False  # are the prior's standard deviations a weighting, and no belief


def believe(subject: Subject, name: PriorName, weight: float, raw: bool = False) -> Belief:
    """Expected parameters from body mass and height, else from a measured mass and COM distance.

    A rig has neither prior nor limits but that it does not make energy. `raw` takes every
    standard deviation as 1 in the parameter's own unit, the paper's Eq. 11.
    """
    if subject.kind == "rig":
        return Belief("none", None, no_prior(), rig_limits(), "a rig: no anatomy is assumed")
    expected, note = expectation(subject, name)
    limits = leg_limits(subject.height)
    if expected is None:
        return Belief("none", None, no_prior(), limits, note)
    each = [getattr(expected, parameter) for parameter in NAMES]
    prior = Prior(
        expected=LegParameters(*(np.asarray(one.value) for one in each)),
        standard_deviation=LegParameters(
            *(np.asarray(1.0 if raw else one.standard_deviation) for one in each)
        ),
        weight=np.asarray(float(weight)),
    )
    return Belief(name, expected, prior, limits, note, raw)


def expectation(subject: Subject, name: PriorName) -> tuple[ExpectedLeg | None, str]:
    """What anatomy expects, and where that comes from in words."""
    if name == "none":
        return None, "no prior, as asked"
    body_mass, height = subject.body_mass, subject.height
    if body_mass is not None and height is not None:
        if name == "paper":
            return paper_prior(body_mass, height), "Eq. 14 of the original paper, scaled"
        leg = expected_leg(body_mass, height, table=name, shank_length=subject.shank_length)
        return leg, f"{leg.source}, {body_mass:g} kg and {height:g} m"
    mass, distance = subject.shank_foot_mass, subject.com_distance
    if mass is not None and distance is not None:
        return measured_leg(mass, distance), "shank_foot_mass_kg and com_distance_m"
    known = {"body mass": body_mass, "height": height}
    missing = " and ".join(name for name, value in known.items() if value is None)
    return None, (
        f"{missing} unknown, so absolute values stay open: give --body-mass KG and --height M"
    )


def measured_leg(mass: float, distance: float) -> ExpectedLeg:
    """What to expect where mass and COM distance were given: J / (m l) as all tables have it."""
    inertia = INERTIA_OVER_MOMENT * mass * distance
    return ExpectedLeg(
        mass=Expected(mass, MASS_SCATTER * mass),
        inertia=Expected(inertia, INERTIA_SCATTER * inertia),
        com_distance=Expected(distance, COM_DISTANCE_SCATTER * distance),
        damping=Expected(KNEE_DAMPING, KNEE_SCATTER * KNEE_DAMPING),
        stiffness=Expected(KNEE_STIFFNESS, KNEE_SCATTER * KNEE_STIFFNESS),
        source="measured mass and distance",
    )


def no_prior() -> Prior:
    nothing = [np.asarray(1.0) for _ in NAMES]
    infinite = [np.asarray(np.inf) for _ in NAMES]
    return Prior(LegParameters(*nothing), LegParameters(*infinite), np.asarray(1.0))


def leg_limits(height: float | None) -> Limits:
    """The bounds of Eq. 13 and the reach of a leg of this height."""
    declared = [each for _, each in declarations(LegParameters)]
    return Limits(
        lower=LegParameters(*(np.asarray(each.lower) for each in declared)),
        upper=LegParameters(*(np.asarray(each.upper) for each in declared)),
        torque=np.asarray(250.0),
        reach=np.asarray(reach(TALL if height is None else height)),
    )


def rig_limits() -> Limits:
    """Damping cannot be negative; nothing else is known of a rig."""
    lower = {name: np.asarray(-np.inf) for name in NAMES} | {"damping": np.asarray(0.0)}
    upper = [np.asarray(np.inf) for _ in NAMES]
    infinite = np.asarray(np.inf)
    return Limits(LegParameters(**lower), LegParameters(*upper), infinite, infinite)
