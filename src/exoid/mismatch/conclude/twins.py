"""What no recording can tell apart, by its names: an exact twin in the place of any cause."""

from itertools import product

import numpy as np

from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import names
from exoid.physics.parameter import declarations
from exoid.physics.term import Term, name_of

MOST = 8  # sets that are named: three causes that have a twin each


def named_alike(prepared: PreparedRecording, equal: list[Optimum]) -> list[str]:
    """Sets of causes that are alike, and each again by its exact twins: names joined by " + "."""
    known = [names(one) for one in equal]
    twins = [list(each) for one in equal for each in by_twins(prepared, one)]
    once: dict[frozenset[str], list[str]] = {}
    for each in [*known, *twins]:
        if len(set(each)) == len(each):
            once.setdefault(frozenset(each), each)
    return [" + ".join(each) for each in list(once.values())[: max(MOST, len(known))]]


def by_twins(prepared: PreparedRecording, one: Optimum) -> list[tuple[str, ...]]:
    """The names of its causes, each also as its twin."""
    each = zip(one.candidate.terms, one.candidate.values, strict=True)
    return list(product(*(names_of(prepared, one, *term) for term in each)))


def names_of(
    prepared: PreparedRecording, one: Optimum, term: type[Term], value: np.ndarray
) -> list[str]:
    """The name of a cause, and those of its exact twins."""
    found = [name_of(term), term.twin]
    known = {name_of(each): each for each in prepared.library}
    if term.same_torque in known and fits(prepared, one, term, known[term.same_torque], value):
        found.append(term.same_torque)
    return [each for each in found if each]


def fits(
    prepared: PreparedRecording, one: Optimum, term: type[Term], twin: type[Term], value: np.ndarray
) -> bool:
    """Can the twin be so large? A soft spring would have to rest too far away."""
    shared = prepared.coordinates(one.candidate).shared
    stiffness = float(shared.stiffness * np.exp(shared.log_inertia))
    declared = next(each for _, each in declarations(twin))
    if stiffness <= 0:
        return False
    size = float(term.as_same_torque(value[0], stiffness))
    return declared.lower < size < declared.upper


def families(one: Optimum) -> list[list[str]]:
    """Its causes, each with its exact twin."""
    return sorted(
        sorted({name_of(term), term.twin, term.same_torque}) for term in one.candidate.terms
    )
