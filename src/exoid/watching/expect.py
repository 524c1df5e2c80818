"""The leg that is expected of a person, as far as the person is known."""

from dataclasses import replace

import numpy as np

from exoid.fitting.model.prior_and_limits import expectation
from exoid.physics.anatomy import ExpectedLeg, expected_leg
from exoid.recordings.recording import Subject

ADULT = 72.0, 1.72  # kg, m
SCATTER = (0.25, 0.10, 0.05)  # of log m, log l and log J / (m l) between adults, beside the tables'


def expected_of(subject: Subject) -> ExpectedLeg:
    """By body mass and height or measured mass and distance; else that of any adult."""
    found, _ = expectation(subject, "auto")
    if found is not None:
        return found
    adult = expected_leg(*ADULT)
    wider = np.array(adult.covariance) + np.diag(np.square(SCATTER))
    return replace(adult, covariance=tuple(map(tuple, wider.tolist())))


def is_known(subject: Subject) -> bool:
    """Is it more than any adult that is expected?"""
    return expectation(subject, "auto")[0] is not None
