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
from exoid.diagnose.proof import Proof, prove
from exoid.diagnose.search import Found, equivalents, look, names, size
from exoid.diagnose.settle import Settled, settle_free
from exoid.fit.estimate import fit
from exoid.fit.result import FitResult
from exoid.physics.library import name_of
from exoid.physics.parameter import declarations
from exoid.physics.term import Term
from exoid.recording.recording import Recording

Verdict = Literal["none", "mismatch", "cannot_tell"]
NOVEL = 1.6  # mean square over the noise that the library must leave for a formula to be sought
FOLLOWED = 0.99  # share of the excess that the library may explain for the rest to be new
ROUNDS = 25
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
    told("locating the mismatch")
    location = locate(bench, base.candidate)
    best, formula = found.best, None
    if is_novel(found):
        told("looking for a formula")
        best, formula = formulated(bench, found)
    told("proving it on held-out data")
    proof = prove(bench, base, best)
    return concluded(result, bench, found, best, formula, location, proof)


def is_novel(found: Found) -> bool:
    """Does the library leave too much of the mismatch?"""
    samples = found.yardstick.samples
    left, whole = found.best.square - samples, found.base.square - samples
    return found.best.square > NOVEL * samples and left > (1 - FOLLOWED) * whole


def formulated(bench: Bench, found: Found) -> tuple[Settled, Formula | None]:
    """The best formula as a term, where it explains more than the library does."""
    formula = describe(bench, found.base.candidate)
    term = term_of(formula)
    at = found.base.candidate
    start = Candidate((term,), (formula.coefficients,), at.point, at.bias)
    one = settle_free(bench, [start], rounds=ROUNDS)[0]
    rival = found.evidence(found.best)
    if found.evidence(one) > rival and found.clear(found.base, one):
        return one, formula
    return found.best, None


def concluded(
    result: FitResult,
    bench: Bench,
    found: Found,
    best: Settled,
    formula: Formula | None,
    location: Location,
    proof: Proof,
) -> Diagnosis:
    """The verdict and everything that goes with it."""
    selected = named_terms(best, formula)
    biased = [each for each in bench.sensors.errors if matters(each)]
    names_of_sensors = [each.name for each in biased if each.name == "gyro_bias"]
    verdict, reasons = judge(bench, found, best, proof)
    if names_of_sensors and verdict != "cannot_tell":
        verdict = "mismatch"
        selected = [*selected, *names_of_sensors]
    equal = [] if formula or not best.candidate.terms else equivalents(found)
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
        parameters=parameters_of(best, measure, formula),
        booked=booked(bench, found.base, best),
        location=location,
        proof=proof,
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


def matters(error: SensorError) -> bool:
    return error.name == "gyro_bias" and error.clear and abs(error.value) > BIASED


def judge(bench: Bench, found: Found, best: Settled, proof: Proof) -> tuple[Verdict, list[str]]:
    """None, mismatch, or an honest doubt."""
    little = too_little(bench, found)
    if best is found.base:
        left = found.base.square / found.yardstick.samples
        if little:
            return "cannot_tell", little
        if left > NOVEL:
            return "cannot_tell", [
                f"simulation and recording differ by {left**0.5:.2g} times the noise, but no cause "
                "explains it clearly better than another"
            ]
        return "none", []
    doubts = [*little, *unsure(bench, best, proof)]
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
    found, at = [], candidate.point.size + 1
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
    rivals = equivalents(found) if best.candidate.terms else found.singles[:2]
    terms = dict.fromkeys(term for one in rivals for term in one.candidate.terms)
    if verdict == "mismatch" and len(rivals) < 2:
        return []
    return [f"To tell {term.title} apart: {term.isolate}." for term in terms]
