"""Into how many parts a step is cut, so that terms faster than the leg are followed."""

from collections.abc import Collection
from math import ceil

from exoid.physics.term import Term, holds, strikes

Terms = Collection[type[Term]]

USUAL = 1e-2  # s, a step that is cut into as many parts as a term says
TURNS = 5e-3  # s, of a part in which dry friction turns over: the angle is then off by 1e-4 deg
MOST = 16  # parts in which it turns over


def most_parts(terms: Terms) -> int:
    """Of a step of whatever length, but for how finely dry friction turns over."""
    return max([1, *(term.substeps for term in terms)])


def parts_to_follow(terms: Terms, step: float) -> int:
    """Of a step of this length [s]: a shorter one than usual needs fewer, but where things meet,
    which are as brief in a longer one.
    """
    length = step / USUAL
    share = max(length, 1.0) if any(map(strikes, terms)) else min(length, 1.0)
    followed = ceil(most_parts(terms) * share - 1e-6)
    turned = min(ceil(step / TURNS - 1e-6), MOST)
    return max(followed, turned) if any(map(holds, terms)) else followed
