"""A point of the fit with what a user fixed, where it is not so yet."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from exoid.fitting.model.coordinates import Coordinates
from exoid.fitting.model.term_parameters import parameters_of, with_values
from exoid.physics.leg import GRAVITY


def imposed(point: Coordinates, fixed: Mapping[str, float]) -> Coordinates:
    """The nearest point in its own terms: ratios stay unless d or c is fixed, or J with m and l;
    m l unless m and l both are.
    """
    shared, log_mass = point.shared, point.log_mass
    if "inertia" in fixed:
        shared = replace(shared, log_inertia=np.full_like(log_mass, np.log(fixed["inertia"])))
    elif {"mass", "com_distance"} <= set(fixed):
        moment = fixed["mass"] * fixed["com_distance"] * GRAVITY
        shared = replace(shared, log_inertia=np.log(moment / np.maximum(shared.gravity, 1.0)))
    inertia = np.exp(shared.log_inertia)
    for name in {"damping", "stiffness"} & set(fixed):
        shared = replace(shared, **{name: fixed[name] / inertia})
    if "mass" in fixed:
        log_mass = np.full_like(log_mass, np.log(fixed["mass"]))
    if "com_distance" in fixed:
        distance = fixed["com_distance"]
        if "mass" in fixed:
            shared = replace(shared, gravity=np.exp(log_mass) * distance * GRAVITY / inertia)
        else:
            moment = np.maximum(shared.gravity, 1.0) * inertia / GRAVITY
            log_mass = np.log(moment / distance)
    own = {
        name: fixed[name] / inertia**declared.inertia_power
        for name, declared in parameters_of([type(term) for term in point.terms])
        if name in fixed
    }
    terms = tuple(with_values(term, own) for term in point.terms)
    return replace(point, shared=shared, log_mass=log_mass, terms=terms)
