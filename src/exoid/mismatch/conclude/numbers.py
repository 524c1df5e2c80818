"""The numbers of an answer: what every cause leaves, parameters, and what they were booked as."""

import numpy as np

from exoid.fitting.model.coordinates import Shared
from exoid.mismatch.answer.diagnosis import Booked, Parameter, Tested
from exoid.mismatch.evidence.yardstick import KNOWN, Yardstick
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.search.found import Found, names, unscaled_covariance
from exoid.mismatch.sensors.agreement import BIAS
from exoid.physics.parameter import declarations
from exoid.physics.term import Term, name_of

FORMULA = "formula"  # the name of a term that has none
CERTAIN = 5.0  # standard deviations
NUDGE = 1e-6  # of an unknown, by which a slope is taken
BIASED = np.radians(0.1)  # rad/s, from which on a gyro's bias is worth a word


def weighed(found: Found, one: Optimum, best: Optimum) -> Tested:
    """What a candidate leaves, running free."""
    left = one.square / found.yardstick.samples
    chosen = one is best and best is not found.base
    return Tested(names(one), left, found.evidence(one), chosen)


def pinned(found: Found) -> list[Tested]:
    """What every term leaves at first sight, along the motion that the sensors show."""
    samples = found.yardstick.samples
    return [Tested(names(one), one.square / samples, None) for one in found.pinned]


def leg_of(found: Found, one: Optimum) -> Shared:
    """What the leg owns as a candidate has it."""
    return found.prepared.coordinates(one.candidate).shared


def gyro_bias(best: Optimum, measure: Yardstick) -> Parameter | None:
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


def covariance(found: Found, one: Optimum) -> np.ndarray:
    """Of all unknowns, for the inertia that the fit took; 0 of what is fixed or not told."""
    return unscaled_covariance(found.prepared, one) * found.yardstick.scale


def taken_in(found: Found, best: Optimum) -> set[str]:
    """The terms whose size is that of another with which they are one cause, but for the sign and
    within the error of their sum; a term that is the same torque is meant, too.
    """
    inside = set()
    for term in best.candidate.terms:
        for other in best.candidate.terms:
            if term.opposite and term.opposite in (name_of(other), other.same_torque):
                value, error = apart(found, best, term, other)
                if abs(value) < CERTAIN * error:
                    inside.add(name_of(other))
    return inside


def apart(found: Found, best: Optimum, term: type[Term], other: type[Term]) -> tuple[float, float]:
    """The sum of a term's size and of that of its opposite, and its error."""

    def both(unknowns: np.ndarray) -> float:
        at = best.candidate.at(unknowns)
        size = dict(zip(at.terms, (value[0] for value in at.values), strict=True))
        if name_of(other) == term.opposite:
            return float(size[term] + size[other])
        return float(size[term] + found.prepared.as_its_twin(at, other, size[other]))

    here = best.candidate.unknowns
    steps = NUDGE * np.maximum(np.abs(here), 1.0)
    slopes = [(both(here + step) - both(here - step)) / (2 * step.sum()) for step in np.diag(steps)]
    variance = np.array(slopes) @ covariance(found, best) @ np.array(slopes)
    return both(here), float(np.sqrt(max(variance, 0.0)))


def widening(found: Found, one: Optimum) -> float:
    """By what the variances of a cause's numbers are larger than those of independent noise.

    What it leaves over the noise lies beside what its numbers do, for they take up what lies along
    that: as much of what nobody knows may have moved any one of them.
    """
    measure = found.yardstick
    remains = one.square > KNOWN * measure.samples
    return measure.scale + (one.square - measure.samples if remains else 0.0)


def parameters_of(found: Found, best: Optimum, formula: Formula | None) -> list[Parameter]:
    """Values and errors of the terms' parameters, for the inertia that the fit took."""
    candidate = best.candidate
    free = np.maximum(np.diag(unscaled_covariance(found.prepared, best)), 0.0)
    variance = free * widening(found, best)
    told = np.diag(best.products.total)[:-1] > 0
    parameters, at = [], candidate.point.size + 2
    for term, values in zip(candidate.terms, candidate.values, strict=True):
        owner = FORMULA if formula and term is candidate.terms[-1] else name_of(term)
        for (name, declared), value in zip(declarations(term), values, strict=True):
            called = f"{owner}.{name}"
            known = bool(told[at]) and declared.lower < value < declared.upper
            off = [
                declared.law * value,
                *(each.law_of.get(called, 0.0) for each in candidate.terms),
            ]
            error = float(np.linalg.norm([variance[at] ** 0.5, *off])) if known else None
            parameters.append(Parameter(called, float(value), declared.unit, error))
            at += 1
    return parameters


def moved(found: Found, before: Optimum, after: Optimum) -> list[Booked]:
    """The ratios that motion tells, without and with a cause, and what goes with the inertia."""
    if found.prepared.rig:
        return booked(found, before, after)
    legs = leg_of(found, before), leg_of(found, after)
    less, more = (float(np.exp(leg.log_inertia)) for leg in legs)
    return [Booked("inertia", less, more, "kg m^2"), *booked(found, before, after)]


def booked(found: Found, before: Optimum, after: Optimum) -> list[Booked]:
    """Ratios, damping, stiffness and gravity moment without and with what was found.

    A rig's zero is anywhere, so that its gravity and its stiffness are one restoring moment, and
    nothing tells its inertia: of it only the damping over that.
    """
    one, other = leg_of(found, before), leg_of(found, after)
    less, more = np.exp(one.log_inertia), np.exp(other.log_inertia)
    told = [
        Booked("damping", float(one.damping * less), float(other.damping * more), "N m s/rad"),
        Booked("stiffness", float(one.stiffness * less), float(other.stiffness * more), "N m/rad"),
        Booked("gravity_moment", float(one.gravity * less), float(other.gravity * more), "N m"),
    ]
    ratios = [
        Booked(f"{name}_over_inertia", float(getattr(one, name)), float(getattr(other, name)), unit)
        for name, unit in (("gravity", "1/s^2"), ("stiffness", "1/s^2"), ("damping", "1/s"))
    ]
    return ratios[-1:] if found.prepared.rig else [*ratios, *told]
