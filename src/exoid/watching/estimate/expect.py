"""The leg that is expected of a person, as far as the person is known."""

from dataclasses import replace

import numpy as np

from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.subject import Subject

ADULT = 72.0, 1.72  # kg, m
SCATTER = (0.25, 0.10, 0.05)  # of log m, log l and log J / (m l) between adults, beside the tables'


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
