"""What physics was left out: the whole diagnosis of recordings of one leg."""

from collections.abc import Callable

from exoid.diagnose.bench import Bench
from exoid.diagnose.conclusion import Chosen, concluded
from exoid.diagnose.diagnosis import Diagnosis
from exoid.diagnose.hypothesis import Hypothesis
from exoid.diagnose.locate import locate
from exoid.diagnose.novel import Formula, describe, term_of
from exoid.diagnose.prepare import prepare
from exoid.diagnose.proof import improves, predict
from exoid.diagnose.search import Found, look
from exoid.diagnose.settle import Settled, settle_free
from exoid.fit.estimate import fit
from exoid.physics.term import Term
from exoid.recording.recording import Recording

LEFT = 0.5  # of what the library leaves, that a formula may leave to take its place
KNOWN = 0.5  # share of a formula that a term of the library is, up to which it is new
ROUNDS = 25


def diagnose(
    recordings: list[tuple[str, Recording]] | Recording,
    *,
    terms: tuple[type[Term], ...] = (),
    seed: int = 0,
    told: Callable[[str], None] = lambda phase: None,
) -> Diagnosis:
    """Find where simulation and recordings part, which physics was left out, and prove it.

    `recordings` are (name, recording) pairs of one leg, or one recording. `terms` are tested beside
    the library. `told` hears the name of every phase.

    **Raises** `ValueError` where a recording cannot be fitted, `ArithmeticError` where no start of
    the baseline's fit succeeded.
    """
    named = [("recording", recordings)] if isinstance(recordings, Recording) else recordings
    told("fitting the baseline")
    result = fit(named, seed=seed)
    bench, base = prepare(result, named, terms)
    found = look(bench, base, told)
    told("proving it on held-out data")
    chosen = choose(bench, found)
    formula = None
    if is_novel(found, chosen.best):
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


def is_novel(found: Found, best: Settled) -> bool:
    """Does the library leave too much of the mismatch?"""
    return not found.yardstick.explains(best.square)


def formulated(bench: Bench, found: Found, chosen: Chosen) -> tuple[Chosen, Formula | None]:
    """The best formula as a term, where it explains more than the library does."""
    formula = describe(bench, found.base.candidate)
    if formula.known > KNOWN:
        return chosen, None
    term = term_of(formula)
    at = found.base.candidate
    start = Hypothesis((term,), (formula.coefficients,), at.point, at.zero)
    one = settle_free(bench, [start], rounds=ROUNDS)[0]
    if one.square < LEFT * chosen.best.square and found.clear(found.base, one):
        after = predict(bench, one)
        if improves(chosen.after, after):
            return Chosen(one, chosen.before, after), formula
    return chosen, None
