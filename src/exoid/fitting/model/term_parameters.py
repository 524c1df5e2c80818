"""The parameters of a model, its terms' above all: by name, in their sizes, and as motion alone
tells them.
"""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

import equinox as eqx
import jax
import numpy as np

from exoid.physics.leg import LegParameters
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.term import Term, name_of

HANGING = (-2.0, -1.0)  # rad, about where a drop ends
PART = 0.05  # of a parameter's range, where no start of its says what is much
RATIO_UNITS = {
    "N m": "1/s^2",
    "N m/rad": "1/s^2",
    "N m s/rad": "1/s",
    "N m s^2/rad^2": "1/rad",
    "N m/rad^3": "1/(rad^2 s^2)",
    "kg m^2": "1",
    "rad/(N m)": "s^2",
}  # of a parameter over J, or times J


NAMES = [name for name, _ in declarations(LegParameters)]  # of the leg's parameters
Model = TypeVar("Model")


def parameters_of(terms: Sequence[type[Term]]) -> list[tuple[str, Declaration]]:
    """Every parameter of the terms, as coulomb_friction.level."""
    return [
        (f"{name_of(term)}.{name}", declared)
        for term in terms
        for name, declared in declarations(term)
    ]


def term_of(term: type[Term], value: Callable[[str, Declaration], Any]) -> Term:
    """The term whose every parameter is what `value` makes of its name and its declaration."""
    each: dict[str, Any] = {
        name: np.asarray(value(f"{name_of(term)}.{name}", declared))
        for name, declared in declarations(term)
    }
    return term(**each)


def leg_of(value: Callable[[str], Any]) -> LegParameters:
    """The leg whose every parameter is what `value` makes of its name."""
    return LegParameters(*(np.asarray(value(name)) for name in NAMES))


def with_values(model: Model, values: Mapping[str, Any]) -> Model:
    """The leg, or a term, with those of the values that are its own; a term's are called as
    coulomb_friction.level.
    """
    owner = f"{name_of(type(model))}." if isinstance(model, Term) else ""
    names = [name for name, _ in declarations(type(model)) if owner + name in values]
    if not names:
        return model
    new = [np.asarray(values[owner + name]) for name in names]
    return eqx.tree_at(lambda at: [getattr(at, name) for name in names], model, new)


def over_inertia(term: Term, inertia: Any) -> Term:
    """A term's parameters over J where they are torques, times J where they give way to them."""
    powers = term_of(type(term), lambda _, declared: float(declared.inertia_power))
    return jax.tree.map(lambda value, power: value / inertia**power, term, powers)


def ratio_name(name: str, declared: Declaration) -> str:
    """What motion alone tells of a parameter that goes with J."""
    return f"{name}_over_inertia" if declared.inertia_power > 0 else f"{name}_times_inertia"


def ratio_unit(declared: Declaration) -> str:
    """Its unit."""
    other = "per kg m^2" if declared.inertia_power > 0 else "kg m^2"
    return RATIO_UNITS.get(declared.unit, f"{declared.unit} {other}")


def typical_term(term: type[Term]) -> Term:
    """A step of order one of every parameter: where searches begin, or a part of the range."""
    return term_of(term, lambda _, declared: step_of(declared))


def step_of(declared: Declaration) -> float:
    """A step of order one of a parameter."""
    starts = declared.starts_between(*HANGING)
    return max(map(abs, starts), default=0.0) or (declared.upper - declared.lower) * PART
