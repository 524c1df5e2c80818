"""A point of the fit with what a user fixed, where it is not so yet."""

from collections.abc import Mapping
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.model.coordinates import Coordinates
from exoid.physics.leg import GRAVITY
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import Term, name_of


def imposed(point: Coordinates, fixed: Mapping[str, float]) -> Coordinates:
    """The nearest point in its own terms: ratios stay unless d or c is fixed, m l unless m and l
    both are.
    """
    shared, log_mass = point.shared, point.log_mass
    if "inertia" in fixed:
        shared = replace(shared, log_inertia=np.full_like(log_mass, np.log(fixed["inertia"])))
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
    return replace(point, shared=shared, log_mass=log_mass, terms=terms_at(point, inertia, fixed))


def terms_at(
    point: Coordinates, inertia: np.ndarray, fixed: Mapping[str, float]
) -> tuple[Term, ...]:
    """The terms, every parameter that is fixed at its value."""

    def entry(term: Term, name: str, declared: Declaration):
        value = fixed.get(f"{name_of(type(term))}.{name}")
        here = getattr(term, name)
        return here if value is None else value / inertia**declared.inertia_power + 0.0 * here

    leaves = [
        entry(term, name, declared)
        for term in point.terms
        for name, declared in declarations(type(term))
    ]
    return jax.tree.unflatten(jax.tree.structure(point.terms), leaves)
