"""What is missing: its name, its numbers, the inertia that they go with, and its reason."""

import re
from math import degrees

from exoid.fitting.model.term_parameters import RATIO_UNITS, parameters_of, step_of
from exoid.fitting.result.chief import WORDS, chief
from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Diagnosis, NovelTorque, Parameter
from exoid.mismatch.answer.over_inertia import guessed, parameters_shown
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.mismatch.sensors.agreement import SensorError
from exoid.physics.library import library
from exoid.physics.parameter import AT_AN_END
from exoid.physics.term import Term, name_of
from exoid.report.words.text import DIMENSIONLESS, with_error

MOSTLY = 0.5  # of a variance
WHOLE = 0.8  # of a torque's variance, below which a formula is no more than a part of it
ORIGINS = {  # of an inertia that the motion does not tell alone
    "prior": "which the prior sets: torques grow with it",
    "both": "to which the prior adds: torques grow with it",
    "bound": "which a bound sets: torques grow with it",
}


def named(found: Diagnosis) -> list[str]:
    """Every effect with its parameters."""
    if found.formula is not None:
        title = "".join(f"{term.title}: " for term in simple(found))
        return [f"{title}{in_formula(found, found.formula)}"]
    lines = []
    for one in found.findings:
        each = [each for each in found.parameters if each.name.startswith(f"{one.name}.")]
        own = parameters_shown(found, each)
        said = ", ".join(f"{parameter(one)}{limited(found, one)}" for one in own)
        lines.append(f"{one.title}, {said}{scale(found, own)}{remark(one.name)}")
    return lines


def remark(name: str) -> str:
    """What to know of the numbers of a term of the library."""
    said = {name_of(term): term.remark for term in library()}.get(name)
    return f" ({said})" if said else ""


def limited(found: Diagnosis, each: Parameter) -> str:
    """Which systematic makes most of the error of a sensor's parameter, which is told of the
    sensors by themselves as well.
    """
    known = {} if found.after is None else found.after.of_terms
    twice = each.name.partition(".")[0] in {one.name for one in found.sensors}
    most = chief(known[each.name]) if twice and each.name in known else None
    if most is None or most[0] not in WORDS or most[1] < MOSTLY:
        return ""
    return f" (± mostly by {WORDS[most[0]]})"


def in_formula(found: Diagnosis, own: NovelTorque) -> str:
    """A formula with its units, and how much it explains. Along the measured motion it may explain
    less than it does running free, where that leaves only noise.
    """
    share, words = f"{own.explained:.0%}", formula_words(found, own)
    clock = ", t in s from a segment's first fitted sample on" if "t" in arguments(own) else ""
    units = f"x in rad, v in rad/s{clock}"
    if words == own.words:
        units = f"{units}; {for_inertia(found.inertia, found.fit)}"
    if own.explained >= WHOLE:
        said = f"{words} ({units}), which explains {share} of the missing torque's variance"
    elif found.explained:
        said = f"{words} ({units}), which leaves only noise"
    else:
        words = f"a torque that is no short formula; {words}"
        said = f"{words} ({units}) explains only {share} of its variance"
    return f"{said}{at_once(own, len(found.location.missing))}"


def formula_words(found: Diagnosis, own: NovelTorque) -> str:
    """The formula, over J where nothing tells that; a file of old has it only in N m."""
    return (guessed(found.fit) and own.over_inertia) or own.words


def arguments(formula: NovelTorque) -> set[str]:
    """Of angle x, speed v and time t those that it has."""
    return set(re.findall(r"\b[xvt]\b", formula.words))


def at_once(formula: NovelTorque, segments: int) -> str:
    """That what acts once, or once in each of the segments, goes with a place, or with a moment."""
    if formula.once is None:
        return ""
    first, last = formula.once
    when = f"from {first:.2f} to {last:.2f} s"
    if segments > 1:
        return (
            f". Nearly all of it acts once in each segment, {when}: a formula does not tell what "
            "acts at a moment from what acts when the leg first passes a place, as a catch does"
        )
    return (
        f". Nearly all of it acts once, {when}: whether that goes with the place or with the "
        "moment, as a touch does, one passage cannot tell"
    )


def scale(found: Diagnosis, parameters: list[Parameter]) -> str:
    """The inertia that torques go with: drops alone tell only their ratio to it."""
    torques = [each for each in parameters if each.unit.startswith("N m")]
    if not torques:
        return ""
    inertia, first = found.inertia, torques[0]
    if first.standard_error is None:
        return ""
    name = first.name.rpartition(".")[2].replace("_", " ")
    unit = RATIO_UNITS.get(first.unit, f"{first.unit} per kg m^2")
    ratio = f"{name} / J = {first.value / inertia:.3g} {unit}"
    return f" ({for_inertia(inertia, found.fit)}; {ratio})"


def for_inertia(inertia: float, fit: FitResult) -> str:
    """The inertia that torques go with, and who says it where that is not the motion."""
    said = f"for J = {inertia:.3g} kg m^2"
    known = fit.parameters["inertia"]
    if known.value is None:
        return f"{said}, which is a guess: torques grow with it"
    if known.by_hand == "fix":
        return f"{said}, which you fixed: torques grow with it"
    if known.determined_by in ("prior", "both") and not fit.follows:
        return f"{said}, {ORIGINS['prior']}"
    return f"{said}, {ORIGINS[known.determined_by]}" if known.determined_by in ORIGINS else said


def parameter(each: Parameter | SensorError) -> str:
    return f"{each.name.rpartition('.')[2].replace('_', ' ')} {value(each)}"


def value(each: Parameter | SensorError) -> str:
    """With its error and its unit; one without an error lies at its limit, or acts nowhere."""
    number, error, unit = each.value, each.standard_error, f" {each.unit}"
    if each.unit in ("rad", "rad/s"):
        number, error, unit = degrees(number), error and degrees(error), unit.replace("rad", "deg")
    if each.unit in DIMENSIONLESS:
        unit = ""
    if error is None:
        limit = ", its limit" if at_limit(each) else ""
        return f"not determined (at {number:.3g}{unit}{limit})"
    if error > abs(number):
        small = (each.standard_error or 0.0) < much(each)
        return f"0 within ± {error:.2g}{unit}" if small else f"not determined (± {error:.2g}{unit})"
    return f"{with_error(number, error)}{unit}"


def much(each: Parameter | SensorError) -> float:
    """A size of its parameter that is worth a word, below which an error tells that it is none."""
    declared = dict(parameters_of(library())).get(each.name)
    return 0.0 if declared is None else step_of(declared)


def at_limit(each: Parameter | SensorError) -> bool:
    """Is it as large, or as small, as its term lets it be?"""
    declared = dict(parameters_of(library())).get(each.name)
    if declared is None:
        return False
    near = AT_AN_END * (declared.upper - declared.lower)
    return min(abs(each.value - declared.lower), abs(each.value - declared.upper)) < near


def explanations(found: Diagnosis) -> list[str]:
    if found.formula is not None:
        return [term.explanation for term in simple(found)]
    return [each.explanation for each in found.findings]


def simple(found: Diagnosis) -> list[type[Term]]:
    """The simple torque without a name of its own that the formula is, if it is one."""
    name = found.formula.simple if found.formula else ""
    return [term for term in NAMELESS if name_of(term) == name]
