"""Legs drawn from the prior of a fit."""

import numpy as np

from exoid.fitting.model.limits import Prior
from exoid.physics.anatomy.knee import NONE
from exoid.physics.leg import LegParameters


def draw(prior: Prior, rng: np.random.Generator) -> LegParameters:
    """A leg as a joint prior has it, whatever the limits say.

    log m, log l and log J / (m l) are normal, and the softened logarithms of d / J and c / J.
    """
    centre = prior.centre
    size = np.linalg.solve(prior.whitening, rng.normal(size=3)) / np.sqrt(prior.weight)
    mass, distance = centre.mass * np.exp(size[0]), centre.com_distance * np.exp(size[1])
    radius = centre.inertia / (centre.mass * centre.com_distance) * np.exp(size[2])
    inertia = radius * mass * distance
    grown = 2 * NONE * np.sinh(rng.normal(size=2) / prior.knee + np.arcsinh(1 / (2 * NONE)))
    damping, stiffness = inertia / centre.inertia * grown * (centre.damping, centre.stiffness)
    return LegParameters(*map(np.asarray, (mass, inertia, distance, damping, stiffness)))
