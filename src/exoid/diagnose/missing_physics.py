"""What physics was left out: the whole diagnosis of recordings of one leg."""

from collections.abc import Callable
from typing import Any

from exoid.diagnose.bench import Bench
from exoid.diagnose.conclusion import Chosen, concluded
from exoid.diagnose.diagnosis import Diagnosis
from exoid.diagnose.evidence import SURE
from exoid.diagnose.formula import Formula, term_of
from exoid.diagnose.hypothesis import Hypothesis
from exoid.diagnose.locate import locate
from exoid.diagnose.novel import describe
from exoid.diagnose.prepare import prepare
from exoid.diagnose.proof import improves, predict
from exoid.diagnose.search import Found, look
from exoid.diagnose.settle import Settled, settle_free
from exoid.fit.estimate import fit
from exoid.fit.remarks import UPWARDS
from exoid.physics.term import Term
from exoid.recording.recording import Recording

REMAINS = 1.1  # mean square over the noise, from which on a formula is looked for
LEFT = 0.5  # of what the library leaves, that a formula may leave to take its place
KNOWN = 0.5  # share of a formula that a term of the library is, up to which it is new
ROUNDS = 25


def diagnose(
    recordings: list[tuple[str, Recording]] | Recording,
    *,
    terms: tuple[type[Term], ...] = (),
    multistart: int = 64,
    seed: int = 0,
    told: Callable[[str], None] = lambda phase: None,
    **assumed: Any,
) -> Diagnosis:
    """Find where simulation and recordings part, which physics was left out, and prove it.

    `recordings` are (name, recording) pairs of one leg, or one recording. `terms` are tested beside
    the library. The baseline is fitted from `multistart` starts, with `assumed` being `prior`,
    `bounds`, `fix`, `bound` and `expect` as in `fit_leg`; the search for what it misses moves its
    parameters freely. `told` hears the name of every phase.

    **Raises** `ValueError` where a recording cannot be fitted or gravity comes out upwards,
    `ArithmeticError` where no start of the baseline's fit succeeded.
    """
    named = [("recording", recordings)] if isinstance(recordings, Recording) else recordings
    told("fitting the baseline")
    result = fit(named, multistart=multistart, seed=seed, **assumed)
    if UPWARDS in result.notes:
        raise ValueError(UPWARDS)
    bench, base = prepare(result, named, terms)
    found = look(bench, base, told)
    told("proving it on held-out data")
    chosen = choose(bench, found)
    formula = None
    if chosen.best.square > REMAINS * found.yardstick.samples:
        told("looking for a formula")
        chosen, formula = formulated(bench, found, chosen)
    told("locating the mismatch")
    location = locate(bench, base.candidate, chosen.best)
    declared = all(recording.sensors.angle_noise is not None for _, recording in named)
    return concluded(result, bench, found, chosen, formula, location, declared, seed)


def choose(bench: Bench, found: Found) -> Chosen:
    """From the baseline to a term, from there to two: only where it is clear, and where it holds.

    Two terms are only believed where they explain all there is: what bends one way or another can
    be had from many pairs.
    """
    before = predict(bench, found.base)
    chosen = Chosen(found.base, before, before)
    whole = [one for one in found.pairs[:1] if found.yardstick.explains(one.square)]
    for better in (*found.singles[:1], *whole):
        if found.clear(chosen.best, better):
            after = predict(bench, better)
            if improves(chosen.after, after) or chosen.best is found.base:
                chosen = Chosen(better, before, after)
    return chosen


def formulated(bench: Bench, found: Found, chosen: Chosen) -> tuple[Chosen, Formula | None]:
    """The best formula as a term, where it explains more than the library does."""
    formula = describe(bench, found.base.candidate)
    if formula.known > KNOWN:
        return chosen, None
    term = term_of(formula)
    at = found.base.candidate
    start = Hypothesis((term,), (formula.values,), at.point, at.zero)
    one = settle_free(bench, [start], rounds=ROUNDS)[0]
    if better(found, one, chosen.best) and found.clear(found.base, one):
        after = predict(bench, one)
        if improves(chosen.after, after):
            return Chosen(one, chosen.before, after), formula.at(one.candidate.values[0])
    return chosen, None


def better(found: Found, one: Settled, best: Settled) -> bool:
    """Does a formula explain so much more than the library that it must be something else?"""
    if not found.yardstick.explains(best.square):
        return one.square < LEFT * best.square
    return found.evidence(one) > found.evidence(best) + SURE
