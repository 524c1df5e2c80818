"""Why causes that explain a recording are not told by name."""

from exoid.mismatch.conclude.asserted import stand_ins, with_one_less
from exoid.mismatch.conclude.twins import families
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found, names, words
from exoid.physics.term import name_of

LISTED = 4  # explanations at most


def undecided(found: Found, equal: list[Optimum]) -> list[str]:
    """That explanations without a cause in common come out alike, or what a lone one is not."""
    others = stand_ins(found, equal[0])
    if others:
        return [
            f"{words([name_of(term) for term, own in others.items() if own == why])} {why}, and "
            "stands in for something else"
            for why in dict.fromkeys(others.values())
        ]
    best = equal[0]
    noise = found.yardstick.explains(best.square)
    if len(equal) == 1 and not noise and with_one_less(found, best) == [found.base]:
        return [
            f"{words(names(best))} together come nearest, not down to the noise, and with one of "
            "them less no more is explained than by Eq. 9 alone: it may be none of them"
        ]
    nameless = [one for one in equal if {*one.candidate.terms} & NAMELESS]
    if nameless:
        return [
            f"{words(names(nameless[0]))}, a simple torque that the library does not name, "
            f"explains as much as {words(names(best))}: {share(found, nameless[0])} of the "
            f"mismatch and {share(found, best)}"
        ]
    if len(equal) == 1:
        alone = words(names(equal[0]))
        return [f"{alone} explains most, at values at which it is not what it is called"]
    each = [f"{' or '.join(named)} ({share(found, one)})" for one, named in by_push(equal)]
    return [
        "explanations that have nothing in common come out alike (shares of the mismatch): "
        f"{', '.join(each[:LISTED])}"
    ]


def by_push(equal: list[Optimum]) -> list[tuple[Optimum, list[str]]]:
    """The first of those that push alike whatever is recorded, and what all of them are called."""
    alike: dict[str, tuple[Optimum, list[str]]] = {}
    for one in equal:
        _, named = alike.setdefault(repr(families(one)), (one, []))
        named.append(words(names(one)) or "no cause")
    return list(alike.values())


def share(found: Found, one: Optimum) -> str:
    """How much of the mismatch it explains, all of it where the noise turned out smaller."""
    return f"{min(found.followed(one), 1.0):.0%}"
