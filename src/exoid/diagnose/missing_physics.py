"""What physics was left out: the whole diagnosis of recordings of one leg."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from exoid.diagnose.bench import Bench, Candidate
from exoid.diagnose.consistency import SensorError
from exoid.diagnose.evidence import Yardstick
from exoid.diagnose.honesty import too_little, unsure
from exoid.diagnose.locate import Location, locate
from exoid.diagnose.novel import Formula, describe, term_of
from exoid.diagnose.prepare import prepare
from exoid.diagnose.proof import Prediction, Proof, improves, predict, proof
from exoid.diagnose.search import Found, equivalents, look, names, size
from exoid.diagnose.settle import Settled, settle_free
from exoid.fit.estimate import fit
from exoid.fit.result import FitResult
from exoid.physics.library import name_of
from exoid.physics.parameter import declarations
from exoid.physics.term import Term
from exoid.recording.recording import Recording

Verdict = Literal["none", "mismatch", "cannot_tell"]
LEFT = 0.5  # of what the library leaves, that a formula may leave to take its place
KNOWN = 0.5  # share of a formula that a term of the library is, up to which it is new
ROUNDS = 25
BIAS = "gyro_bias"
CERTAIN = 5.0  # standard deviations
BIASED = np.radians(0.1)  # rad/s, from which on a gyro's bias is worth a word


@dataclass(frozen=True)
class Parameter:
    """A parameter of what was found."""

    name: str
    value: float
    unit: str
    standard_error: float | None


@dataclass(frozen=True)
class Booked:
    """What the baseline had made of it."""

    name: str
    before: float
    after: float
    unit: str


@dataclass(frozen=True, eq=False)
class Diagnosis:
    """The answer, and what it rests on."""

    verdict: Verdict
    reasons: list[str]  # why not more could be said
    selected: list[str]
    ranking: list[str]
    equivalent: list[str]
    formula: Formula | None
    parameters: list[Parameter]
    booked: list[Booked]
    location: Location
    proof: Proof
    false_alarm_rate: float
    power: float
    sensors: list[SensorError]
    best: Settled
    found: Found
    bench: Bench
    fit: FitResult
    advice: list[str] = field(default_factory=list)

    @property
    def excluded(self) -> list[str]:
        """Terms whose derivatives are not finite."""
        return [name_of(term) for term in self.found.failed]

    @property
    def yardstick(self) -> Yardstick:
        return self.found.yardstick


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
    return concluded(result, bench, found, chosen, formula, location)


@dataclass(frozen=True, eq=False)
class Chosen:
    """The best explanation that holds on held-out data, and what it and the baseline predict."""

    best: Settled
    before: Prediction
    after: Prediction


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
    start = Candidate((term,), (formula.coefficients,), at.point, at.zero)
    one = settle_free(bench, [start], rounds=ROUNDS)[0]
    if one.square < LEFT * chosen.best.square and found.clear(found.base, one):
        after = predict(bench, one)
        if improves(chosen.after, after):
            return Chosen(one, chosen.before, after), formula
    return chosen, None


def concluded(
    result: FitResult,
    bench: Bench,
    found: Found,
    chosen: Chosen,
    formula: Formula | None,
    location: Location,
) -> Diagnosis:
    """The verdict and everything that goes with it."""
    best, shown = chosen.best, proof(bench, chosen.before, chosen.after)
    selected = named_terms(best, formula)
    bias = gyro_bias(best, found.yardstick)
    verdict, reasons = judge(bench, found, best, shown)
    if bias is not None and verdict != "cannot_tell":
        verdict = "mismatch"
        selected = [*selected, BIAS]
    equal = [] if formula or not best.candidate.terms else equivalents(found, best)
    parameters = size(best)
    measure = found.yardstick
    tried = [len(list(declarations(term))) for term in found.pinned]
    return Diagnosis(
        verdict=verdict,
        reasons=reasons,
        selected=selected if verdict == "mismatch" else [],
        ranking=ranked(found, selected, formula),
        equivalent=[name for one in equal for name in one_name(one)] if verdict != "none" else [],
        formula=formula,
        parameters=[*parameters_of(best, measure, formula), *([bias] if bias else [])],
        booked=booked(bench, found.base, best),
        location=location,
        proof=shown,
        false_alarm_rate=measure.false_alarm_rate(tried),
        power=measure.power(found.base.square, best.square, max(parameters, 1)),
        sensors=bench.sensors.errors,
        best=best,
        found=found,
        bench=bench,
        fit=result,
        advice=advice(bench, found, best, verdict, formula),
    )


def named_terms(best: Settled, formula: Formula | None) -> list[str]:
    return [] if formula else names(best)


def one_name(one: Settled) -> list[str]:
    return [" + ".join(names(one))]


def gyro_bias(best: Settled, measure: Yardstick) -> Parameter | None:
    """The bias of the gyro, which is free in every fit, where it is worth a word."""
    at = best.candidate.point.size
    precision = float(best.products.total[at, at])
    if precision <= 0:
        return None
    error = (measure.scale / precision) ** 0.5
    value = float(best.candidate.zero[0])
    if abs(value) < max(BIASED, CERTAIN * error):
        return None
    return Parameter(f"{BIAS}.bias", value, "rad/s", error)


def judge(bench: Bench, found: Found, best: Settled, shown: Proof) -> tuple[Verdict, list[str]]:
    """None, mismatch, or an honest doubt."""
    little = too_little(bench, found)
    if best is found.base:
        left = found.base.square / found.yardstick.samples
        if little:
            return "cannot_tell", little
        if not found.yardstick.explains(found.base.square):
            return "cannot_tell", [
                f"simulation and recording differ by {left**0.5:.2g} times the noise, but no cause "
                "explains it clearly better than another"
            ]
        return "none", []
    doubts = [*little, *unsure(bench, best, shown)]
    return ("cannot_tell", doubts) if doubts else ("mismatch", [])


def ranked(found: Found, selected: list[str], formula: Formula | None) -> list[str]:
    """Names, best first: what was selected, then every other single term by what it explains."""
    singles = [names(one)[0] for one in found.singles if names(one)]
    others = [name_of(term) for term in sorted(found.pinned, key=found.pinned.__getitem__)]
    first = [] if formula else by_share(found, selected)
    return list(dict.fromkeys([*first, *singles, *others]))


def by_share(found: Found, selected: list[str]) -> list[str]:
    """Of two effects the one first that explains more by itself."""
    alone = {name_of(term): square for term, square in found.pinned.items()}
    return sorted(selected, key=lambda name: alone.get(name, np.inf))


def parameters_of(best: Settled, measure: Yardstick, formula: Formula | None) -> list[Parameter]:
    """Values and errors of the terms' parameters."""
    candidate = best.candidate
    normal = best.products.total[:-1, :-1]
    size_of = np.sqrt(np.diag(normal))
    unit = np.where(size_of > 0, size_of, 1.0)
    inverse = np.linalg.pinv(normal / np.outer(unit, unit), hermitian=True)
    errors = np.sqrt(np.maximum(np.diag(inverse), 0.0) * measure.scale) / unit
    found, at = [], candidate.point.size + 2
    for term, values in zip(candidate.terms, candidate.values, strict=True):
        owner = "formula" if formula else name_of(term)
        for (name, declared), value in zip(declarations(term), values, strict=True):
            known = bool(size_of[at] > 0) and declared.lower < value < declared.upper
            error = float(errors[at]) if known else None
            found.append(Parameter(f"{owner}.{name}", float(value), declared.unit, error))
            at += 1
    return found


def booked(bench: Bench, before: Settled, after: Settled) -> list[Booked]:
    """Damping, stiffness and gravity moment without and with what was found."""
    pairs = [bench.coordinates(one.candidate).shared for one in (before, after)]
    rows = [
        {
            "damping": (float(leg.damping * np.exp(leg.log_inertia)), "N m s/rad"),
            "stiffness": (float(leg.stiffness * np.exp(leg.log_inertia)), "N m/rad"),
            "gravity_moment": (float(leg.gravity * np.exp(leg.log_inertia)), "N m"),
        }
        for leg in pairs
    ]
    return [Booked(name, rows[0][name][0], rows[1][name][0], rows[0][name][1]) for name in rows[0]]


def advice(
    bench: Bench, found: Found, best: Settled, verdict: Verdict, formula: Formula | None
) -> list[str]:
    """What to record next."""
    if verdict == "none":
        return []
    if formula is not None:
        return ["Change one thing at a time (speed, angle, load) and watch which moves the torque."]
    rivals = equivalents(found, best) if best.candidate.terms else found.singles[:2]
    terms = dict.fromkeys(term for one in rivals for term in one.candidate.terms)
    if verdict == "mismatch" and len(rivals) < 2:
        return []
    return [f"To tell {term.title} apart: {term.isolate}." for term in terms]
