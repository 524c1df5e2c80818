"""Every term there is: whatever class of a term is defined in the modules of a package."""

import inspect
from collections.abc import Collection
from dataclasses import fields
from difflib import get_close_matches
from functools import cache
from importlib import import_module
from pkgutil import walk_packages
from types import ModuleType
from typing import Any

import jax
import jax.numpy as jnp

from exoid.physics.moment import Cycle, Moment, SegmentConstants
from exoid.physics.parameter import declarations
from exoid.physics.ratios import Ratios
from exoid.physics.term import Term, name_of

MOST_PARAMETERS = 7


@cache
def library() -> tuple[type[Term], ...]:
    """The terms that come with exoid, by name."""
    found = [
        term
        for package in ("exoid.physics.terms", "exoid.physics.sensing")
        for each in walk_packages(import_module(package).__path__, f"{package}.")
        for term in terms_of(import_module(each.name))
    ]
    return tuple(sorted(found, key=name_of))


def term_named(name: str) -> type[Term]:
    """The term of the library that is called so.

    **Raises** `ValueError` where none is.
    """
    known = {name_of(term): term for term in library()}
    if name not in known:
        raise ValueError(f"there is no term {name!r}: {resembled(name, known)}")
    return known[name]


def resembled(name: str, known: Collection[str]) -> str:
    """Which of the known names one that is none of them resembles; all, where it resembles none."""
    inside = [each for each in known if name and name in each.split("_")]
    close = inside or get_close_matches(name, known, 1)
    return f"did you mean {' or '.join(close)}?" if close else f"there are {', '.join(known)}."


def terms_of(module: ModuleType) -> list[type[Term]]:
    """The terms that a module defines."""
    members = inspect.getmembers(module, inspect.isclass)
    return [
        each
        for _, each in members
        if issubclass(each, Term)
        and each.__module__ == module.__name__
        and not inspect.isabstract(each)
    ]


def check_terms(terms: tuple[type[Term], ...]) -> None:
    """Refuse a term that no search could begin with, or whose name is taken."""
    taken = {name_of(term) for term in library()} if terms else set()
    for term in terms:
        name = name_of(term)
        if name in taken:
            raise ValueError(f"the term {term.__name__} has the name of another: {name}.")
        taken.add(name)
        known = dict(declarations(term))
        missing = [field.name for field in fields(term) if field.name not in known]
        unfounded = [name for name, declared in known.items() if not declared.starts]
        if missing or unfounded or not known:
            raise ValueError(
                f"{term.__name__}: declare every field by exoid.parameter(symbol, unit, lower, "
                "upper, title, starts) with at least one start"
                + (f"; {', '.join(missing + unfounded)} is not" if missing + unfounded else "")
                + "."
            )
        if len(known) > MOST_PARAMETERS:
            raise ValueError(
                f"{term.__name__} has {len(known)} parameters; {MOST_PARAMETERS} are the most that "
                "one term may have."
            )
        check_runs(term)


def check_runs(term: type[Term]) -> None:
    """Refuse a term that cannot be simulated, or not at a bent leg that moves."""
    starts = (declared.starts for _, declared in declarations(term))
    first = [each(-1.5, 0.0)[0] if callable(each) else each[0] for each in starts]
    ratios = Ratios(*map(jnp.asarray, (27.0, 6.0, 0.8, 0.0)))
    cycle = Cycle(*map(jnp.asarray, (0.0, 1.0, 1.0, 0.0)))
    place = SegmentConstants(ratios, jnp.asarray(0.4), cycle, jnp.asarray(0.0))
    now = Moment(*map(jnp.asarray, (0.5, -0.7, 1.0, 2.0)), place=place)
    made: Any = term  # whose parameters are its own
    own = made(*map(jnp.asarray, first))
    memory, one = (term.memory_size,), ()
    wanted = {"torque": one, "dry_friction": one, "memory_rate": memory, "memory_within": memory}
    try:
        shapes = jax.eval_shape(everything, own, now)
        values = everything(own, now)
    except Exception as fault:  # whatever a user's class may raise
        said = f"{str(fault).partition(chr(10))[0].rstrip('.')}."
        raise ValueError(
            f"{term.__name__} does not run: {type(fault).__name__}: {said} Mend it."
        ) from fault
    for name, shape in wanted.items():
        if getattr(shapes[name], "shape", None) != shape:
            raise ValueError(f"{term.__name__}.{name} must return an array of shape {shape}.")
    if not all(bool(jnp.isfinite(leaf).all()) for leaf in jax.tree.leaves(values)):
        raise ValueError(
            f"{term.__name__} is not finite where it begins ({', '.join(map(str, first))}), at "
            "-40 deg and 57 deg/s."
        )


def everything(own: Term, now: Moment) -> dict[str, Any]:
    """All that a term says at one instant."""
    memory = own.memory_at_rest(now)
    return {
        "torque": own.torque(now, memory),
        "dry_friction": own.dry_friction(now),
        "memory_rate": own.memory_rate(now, memory),
        "memory_within": own.memory_within(now, memory),
        "shown": own.shown(now, memory),
    }
