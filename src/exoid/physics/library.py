"""Every term there is: whatever class of a term is defined in the modules of a package."""

import inspect
from dataclasses import fields
from functools import cache
from importlib import import_module
from pkgutil import walk_packages
from types import ModuleType

from exoid.physics.parameter import declarations
from exoid.physics.term import Term, name_of

MOST_PARAMETERS = 6


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
    taken = {name_of(term) for term in library()}
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
