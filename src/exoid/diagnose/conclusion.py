"""From what was found to what is said: verdict, names, numbers with errors, and advice."""

from dataclasses import dataclass

import numpy as np

from exoid.diagnose.bench import Bench
from exoid.diagnose.diagnosis import Booked, Diagnosis, Parameter, Verdict
from exoid.diagnose.evidence import Yardstick
from exoid.diagnose.honesty import too_little, unsure
from exoid.diagnose.locate import Location
from exoid.diagnose.novel import Formula
from exoid.diagnose.proof import Prediction, Proof, proof
from exoid.diagnose.search import Found, equivalents, names, size
from exoid.diagnose.settle import Settled
from exoid.fit.result import FitResult
from exoid.physics.library import name_of
from exoid.physics.parameter import declarations

BIAS = "gyro_bias"
CERTAIN = 5.0  # standard deviations
BIASED = np.radians(0.1)  # rad/s, from which on a gyro's bias is worth a word
FOLLOWED = 0.97  # share of the mismatch that a term must explain to be named beside something new


@dataclass(frozen=True, eq=False)
class Chosen:
    """The best explanation that holds on held-out data, and what it and the baseline predict."""

    best: Settled
    before: Prediction
    after: Prediction


def concluded(
    result: FitResult,
    bench: Bench,
    found: Found,
    chosen: Chosen,
    formula: Formula | None,
    location: Location,
    declared: bool,
) -> Diagnosis:
    """The verdict and everything that goes with it.

    Where the sensors' noise is `declared`, what is left beyond it is something new, and no term is
    named that explains only part of the mismatch.
    """
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
    novel = formula is not None or (
        verdict == "mismatch" and declared and not measure.explains(best.square)
    )
    if novel and followed(found, best) < FOLLOWED:
        selected = [name for name in selected if name == BIAS]
    tried = [len(list(declarations(term))) for term in found.pinned]
    return Diagnosis(
        verdict=verdict,
        reasons=reasons,
        selected=selected if verdict == "mismatch" else [],
        ranking=ranked(found, selected, formula),
        equivalent=[name for one in equal for name in one_name(one)] if verdict != "none" else [],
        novel=novel,
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


def followed(found: Found, best: Settled) -> float:
    """The share of the baseline's excess over the noise that the best explains."""
    samples = found.yardstick.samples
    return 1 - (best.square - samples) / max(found.base.square - samples, 1.0)


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
    """Values and errors of the terms' parameters, for the inertia that the fit took."""
    candidate = best.candidate
    normal = best.products.total[:-1, :-1].copy()
    normal[0], normal[:, 0] = 0.0, 0.0
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
