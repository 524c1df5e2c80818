"""Every term there is: whatever class of a term is defined in the modules of a package."""

import inspect
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from types import ModuleType

from exoid.physics.term import Term


@cache
def library() -> tuple[type[Term], ...]:
    """The terms that come with exoid, by name."""
    found = [
        term
        for package in ("exoid.physics.terms", "exoid.physics.sensing")
        for each in iter_modules(import_module(package).__path__)
        for term in terms_of(import_module(f"{package}.{each.name}"))
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


def name_of(term: type[Term]) -> str:
    """coulomb_friction for CoulombFriction."""
    letters = (f"_{each.lower()}" if each.isupper() else each for each in term.__name__)
    return "".join(letters).lstrip("_")
