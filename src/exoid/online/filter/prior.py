"""What is believed before the leg moves: anatomy, and the sensors' data sheets."""

from math import log

import numpy as np

from exoid.online.filter.gaussian import Gaussian
from exoid.online.model.model import Model
from exoid.online.model.unknowns import AT, FIRST_TERM, entry, is_positive
from exoid.physics.anatomy import ExpectedLeg
from exoid.physics.leg import GRAVITY
from exoid.physics.parameter import Declaration

HANGING = (-2.0, -1.0)  # rad, about where a drop ends
KNEE = 5.0  # times what a relaxed knee has: the standard deviation of c / J and d / J
ROOM = 10.0  # times where its searches begin, the same of a term's parameter
FACTOR = 1.0  # of the logarithm of one that cannot be negative
ANYWHERE = 1.0  # rad and rad/s, of a motion that nobody has seen


def prior_of(expected: ExpectedLeg, model: Model) -> Gaussian:
    """m l g / J and J with their covariance, c / J and d / J anywhere, sensors by data sheet."""
    inertia = expected.inertia.value
    gravity = expected.mass.value * expected.com_distance.value * GRAVITY / inertia
    stiffness, damping = expected.stiffness.value / inertia, expected.damping.value / inertia
    node, size = model.node, model.unknowns.size
    mean, deviation = np.zeros(size), np.zeros(size)
    known = {
        "stiffness": (stiffness, KNEE * stiffness),
        "damping": (damping, KNEE * damping),
        "offset": (0.0, KNEE * stiffness * node.zero + ANYWHERE),
        "upright_gravity": (0.0, gravity * np.hypot(node.zero, node.tilt)),
        "gyro_bias": (0.0, node.bias),
        "gyro_scale": (0.0, node.scale),
        "gyro_delay": (node.delay, node.delay_error),
    }
    for name, (value, scatter) in known.items():
        mean[AT[name]], deviation[AT[name]] = value, scatter
    for at, (_, declared) in enumerate(model.unknowns.declared, start=FIRST_TERM):
        mean[at], deviation[at] = expected_of(declared, inertia)
    if model.unknowns.weighed is not None:
        first = model.unknowns.first_of_mass
        for at, each in enumerate(model.unknowns.weighed.expected, start=first):
            mean[at], deviation[at] = each
    deviation[-2:] = ANYWHERE
    covariance = np.diag(deviation**2)
    pair = [AT["level_gravity"], AT["log_inertia"]]
    mean[pair] = gravity, log(inertia)
    covariance[np.ix_(pair, pair)] = of_size(expected, gravity)
    return Gaussian(mean, np.linalg.cholesky(covariance))


def of_size(expected: ExpectedLeg, gravity: float) -> np.ndarray:
    """The covariance of m l g / J and log J, of which anatomy speaks by log m, l and J / (m l)."""
    if expected.covariance is None:
        raise ValueError(
            f"{expected.source} says nothing of how m, l and J scatter together: expect the leg by "
            "another table than that of the paper."
        )
    rows = np.array([[0.0, 0.0, -gravity], [1.0, 1.0, 1.0]])
    return rows @ np.array(expected.covariance) @ rows.T


def expected_of(declared: Declaration, inertia: float) -> tuple[float, float]:
    """Where a term's entry is expected, and how far it may be away."""
    starts = declared.starts_between(*HANGING)
    value = float(np.median(starts))
    size = max(map(abs, starts)) or (declared.upper - declared.lower) / ROOM
    if is_positive(declared):
        return entry(value, declared, inertia), FACTOR
    return entry(value, declared, inertia), abs(entry(ROOM * size, declared, inertia))
