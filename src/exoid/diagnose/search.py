"""Which terms explain the mismatch: all of them pinned, the best of them free, then in pairs."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from exoid.diagnose.bench import Bench
from exoid.diagnose.evidence import ALIKE, APART, Yardstick, yardstick
from exoid.diagnose.hypothesis import Hypothesis
from exoid.diagnose.lanes import linear
from exoid.diagnose.settle import Settled, settle, settle_free
from exoid.physics.library import name_of
from exoid.physics.parameter import declarations
from exoid.physics.term import Term

SHORT = 4  # candidates that run free, by what they explain pinned
PAIRED = 3  # first terms of a pair
REACH = 3.0  # times the best, within which running free may change the order
ROUNDS = 8  # of pinned steps; what is close by then is brought to its end running free
PAIR_ROUNDS = 6
FREE_ROUNDS = 25
FLOOR = 1.3  # mean square over the noise at which nothing more is looked for

Told = Callable[[str], None]


@dataclass(frozen=True, eq=False)
class Found:
    """What a search found, best first; `pinned` are the sums of squares of the first look."""

    base: Settled
    singles: list[Settled]  # running free
    pairs: list[Settled]
    pinned: dict[type[Term], float]
    failed: list[type[Term]]  # whose derivatives are not finite
    yardstick: Yardstick

    def clear(self, worse: Settled, better: Settled) -> bool:
        parameters = size(better) - size(worse)
        return self.yardstick.clear(worse.square, better.square, max(parameters, 1))

    def evidence(self, one: Settled) -> float:
        return self.yardstick.evidence(self.base.square, one.square, size(one))


def size(one: Settled) -> int:
    """How many parameters its terms have."""
    return sum(value.size for value in one.candidate.values)


def names(one: Settled) -> list[str]:
    return [name_of(term) for term in one.candidate.terms]


def look(bench: Bench, base: Settled, told: Told) -> Found:
    """Every term by itself; pairs where no single one is enough."""
    point, zero = base.candidate.point, base.candidate.zero
    usable = [term for term in bench.library if applies(bench, term)]
    told(f"testing {len(usable)} candidates")
    starts = [
        Hypothesis((term,), (value,), point, zero)
        for term in usable
        for value in bench.starts(term)
    ]
    first = best_of(settle(bench, starts, rounds=ROUNDS))
    failed = [term for (term,), one in first.items() if not sound(one)]
    ranked = ordered([one for one in first.values() if sound(one)])
    near = [one for one in ranked[:SHORT] if one.square < REACH * ranked[0].square]
    told("simulating the best of them")
    singles = [polished(bench, one) for one in near]
    singles += [*twins(bench, singles), *nested(bench, singles)]
    measure = yardstick(bench, min([base, *singles], key=lambda one: one.square))
    singles = by_evidence(singles, base, measure)
    pinned = {one.candidate.terms[0]: one.square for one in ranked}
    found = Found(base, singles, [], pinned, failed, measure)
    if min(base, *singles, key=lambda one: one.square).square < FLOOR * measure.samples:
        return found
    told("testing pairs")
    seconds = pairs(bench, ranked, singles)
    pairs_at_best = best_of(settle(bench, seconds, rounds=PAIR_ROUNDS))
    both = ordered([one for one in pairs_at_best.values() if sound(one)])
    told("simulating the best pairs")
    joint = [polished(bench, one) for one in both[:SHORT] if one.square < REACH * both[0].square]
    singles = by_evidence([*singles, *reduced(bench, ordered(joint)[:1])], base, measure)
    singles += nested(bench, singles)
    measure = yardstick(bench, min([base, *singles, *joint], key=lambda one: one.square))
    joint = by_evidence(joint, base, measure)
    return Found(base, by_evidence(singles, base, measure), joint, pinned, failed, measure)


def applies(bench: Bench, term: type[Term]) -> bool:
    """Can it act here: a voluntary torque, or a gyro?"""
    if term.living and bench.rig:
        return False
    if term.voluntary:
        return any(each.voluntary for each in bench.problem.movements)
    name = name_of(term)
    if name == "gyro_bias" or (name == "angle_offset" and bench.rig):
        return False  # it is free in every fit
    if name in ("gyro_scale", "sensor_skew"):
        return bool((bench.seen.velocity_weight > 0).any())
    return True


def sound(one: Settled) -> bool:
    """Are its sum of squares and all derivatives finite?"""
    return bool(np.isfinite(one.products.total).all())


def best_of(settled: list[Settled]) -> dict[tuple[type[Term], ...], Settled]:
    """Of all starts of the same terms the best."""
    best: dict[tuple[type[Term], ...], Settled] = {}
    for one in settled:
        terms = one.candidate.terms
        if terms not in best or not one.square >= best[terms].square:
            best[terms] = one
    return best


def ordered(settled: list[Settled]) -> list[Settled]:
    return sorted(settled, key=lambda one: one.square)


def by_evidence(settled: list[Settled], base: Settled, measure: Yardstick) -> list[Settled]:
    known = list(best_of([one for one in settled if sound(one)]).values())
    known.sort(key=lambda one: measure.evidence(base.square, one.square, size(one)), reverse=True)
    if not known or measure.explains(known[0].square):
        return known
    alike = [one for one in known if one.square < ALIKE * known[0].square]
    return sorted(known, key=lambda one: size(one) if one in alike else np.inf)


def polished(bench: Bench, one: Settled) -> Settled:
    """Running free from where it came pinned."""
    return settle_free(bench, [one.candidate], rounds=FREE_ROUNDS)[0]


def reduced(bench: Bench, joint: list[Settled]) -> list[Settled]:
    """Each term of a pair alone again, from where the pair is: is the other one needed?"""
    return [
        polished(
            bench, replace(one, candidate=replace(one.candidate, terms=(term,), values=(value,)))
        )
        for one in joint
        for term, value in zip(one.candidate.terms, one.candidate.values, strict=True)
    ]


def twins(bench: Bench, singles: list[Settled]) -> list[Settled]:
    """What is exactly the same torque under another name: a rest angle, and a constant torque."""
    known = {name_of(one.candidate.terms[0]): one for one in singles}
    terms = {name_of(term): term for term in bench.library}
    pair = ("torque_bias", "stiffness_rest_angle")
    missing = [name for name in pair if name not in known]
    if len(missing) != 1:
        return []
    one = known[next(name for name in pair if name in known)]
    coordinates = bench.coordinates(one.candidate)
    stiffness = float(coordinates.shared.stiffness * np.exp(coordinates.shared.log_inertia))
    value = one.candidate.values[0]
    other = value / max(stiffness, 1e-3) if missing[0] == pair[1] else value * stiffness
    declared = next(each for _, each in declarations(terms[missing[0]]))
    start = np.clip(other, declared.lower, declared.upper)
    moved = Hypothesis((terms[missing[0]],), (start,), one.candidate.point, one.candidate.zero)
    return [settle_free(bench, [moved], rounds=FREE_ROUNDS)[0]]


def nested(bench: Bench, singles: list[Settled]) -> list[Settled]:
    """A simple term again from where a richer one is that holds all its parameters."""
    found = []
    for rich in singles:
        (term,) = rich.candidate.terms
        known = dict(zip(dict(declarations(term)), rich.candidate.values[0], strict=True))
        for simple in singles:
            (other,) = simple.candidate.terms
            wanted = list(dict(declarations(other)))
            if len(wanted) < len(known) and known.keys() >= set(wanted):
                value = np.array([known[name] for name in wanted])
                start = replace(rich.candidate, terms=(other,), values=(value,), linear=None)
                found.append(settle_free(bench, [start], rounds=FREE_ROUNDS)[0])
    return found


def pairs(bench: Bench, ranked: list[Settled], singles: list[Settled]) -> list[Hypothesis]:
    """The best single terms, each with every other."""
    refined = {one.candidate.terms[0]: one for one in singles}
    firsts = [refined.get(one.candidate.terms[0], one).candidate for one in ranked[:PAIRED]]
    found = linear(bench, firsts, [one.course for one in ranked[:PAIRED]])
    made = []
    for number, (first, known) in enumerate(zip(firsts, found, strict=True)):
        done = {one.terms[0] for one in firsts[: number + 1]}
        made += [
            Hypothesis(
                (*first.terms, *second.candidate.terms),
                (*first.values, value),
                first.point,
                first.zero,
                known,
            )
            for second in ranked
            for value in bench.starts(second.candidate.terms[0])
            if second.candidate.terms[0] not in done
        ]
    return made


def equivalents(found: Found, best: Settled) -> list[Settled]:
    """The candidates that this recording cannot tell from the best, itself included."""
    rivals = found.pairs if len(best.candidate.terms) > 1 else found.singles
    if not found.yardstick.explains(best.square):
        least = min(one.square for one in rivals)
        return [one for one in rivals if one is best or one.square < ALIKE * least]
    top = found.evidence(best)
    return [one for one in rivals if top - found.evidence(one) < APART]
