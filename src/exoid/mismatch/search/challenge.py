"""What came as near as the best along the measured motion: is it a rival where it runs free?"""

from collections.abc import Callable
from dataclasses import replace

from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.flight.starts import partners, starts_in_flight
from exoid.mismatch.screen.hypothesis import Linear, Optimum
from exoid.mismatch.screen.optimise import enough, given, strikes
from exoid.mismatch.search.found import Found, lone_and_joint
from exoid.mismatch.search.likely import smeared
from exoid.mismatch.search.race import left_of, raced, simulated
from exoid.mismatch.search.rank import alike, by_evidence
from exoid.physics.term import Term
from exoid.physics.terms.device.backlash import Backlash

MOST = 4  # rivals that run free, the nearest first


def challenged(found: Found) -> Found:
    """The same with what could be a rival of the best and was not simulated yet, running free.

    A leg that sticks is smeared along a motion, where nearly everything may look alike.
    """
    best = max((found.base, *found.singles, *found.pairs), key=found.evidence)
    rivals = [one.candidate for one in as_near(found, best)[:MOST]]
    more = simulated(found.prepared, rivals, best.square)
    singles, pairs = lone_and_joint(found.prepared, more)

    def sorted_with(known: list[Optimum], new: list[Optimum]) -> list[Optimum]:
        return by_evidence([*known, *new], found.base, found.yardstick) if new else known

    return replace(
        found,
        singles=sorted_with(found.singles, singles),
        pairs=sorted_with(found.pairs, pairs),
    )


def as_near(found: Found, best: Optimum) -> list[Optimum]:
    """Those like the best along the measured motion that did not run free, the nearest first."""
    seen = {one.candidate.terms: one for one in (*found.pinned, *found.glimpsed)}
    own = seen.get(best.candidate.terms)
    if own is None or found.yardstick.explains(best.square):
        return []
    done = {one.candidate.terms for one in (*found.singles, *found.pairs)}
    left = [one for terms, one in seen.items() if terms not in done and not strikes(one.candidate)]
    near = [one for one in left if alike(one, own, found.yardstick)]
    return sorted(near, key=lambda one: one.square)


def with_hidden(found: Found, some: list[Optimum], told: Callable[[str], None]) -> Found:
    """The same with those of `some` that act in moments only, as what strikes or sticks: the first
    look along a motion shows nothing of them, so that they begin from all their starts. What sticks
    and ran free before is left out; what strikes may have stopped in a false valley.
    """
    done = {one.candidate.terms for one in found.singles if not strikes(one.candidate)}
    left = [one for one in some if smeared(one.candidate) and one.candidate.terms not in done]
    if not left:
        return found
    told("simulating what acts for moments only")
    rival = min((found.base, *found.singles), key=left_of)
    known = given(found.prepared, found.begin)
    more = side_by_side(lambda one: found_anyhow(found, one, known, rival), left)
    singles = by_evidence([*found.singles, *more], found.base, found.yardstick)
    return replace(found, singles=singles)


def found_anyhow(found: Found, one: Optimum, known: Linear | None, rival: Optimum) -> Optimum:
    """Running free from where it came pinned, and from all its starts where that led nowhere or
    may have: what acts for a few samples only, such as a stop, is not seen along a motion with
    noise, nor is a leg that sticks, or one within the play of the frame that carries the sensors.
    """
    prepared, term = found.prepared, one.candidate.terms[-1]
    led = [one.candidate] if one.square < found.base.square else []
    seen = starts_in_flight(prepared, found.begin) if term is Backlash else []
    own = [found.begin.with_term(term, value, known) for value in prepared.starts(term)]
    return raced(prepared, [*led, *seen, *own], rival)


def beside_play(found: Found, usable: list[type[Term]], told: Callable[[str], None]) -> Found:
    """The same with play beside those causes that explain most between strikes."""
    prepared, each = found.prepared, (found.base, *found.singles, *found.pairs)
    rival = min(each, key=left_of)
    if Backlash not in usable or enough(prepared, rival.square):
        return found
    others = [starts_in_flight(prepared, one) for one in partners(prepared, usable, found.begin)]
    if not others:
        return found
    told("simulating play beside other causes")
    ended = side_by_side(lambda starts: raced(prepared, starts, rival), others)
    more = [one for one in ended if one.sound]
    return replace(found, pairs=by_evidence([*found.pairs, *more], found.base, found.yardstick))
