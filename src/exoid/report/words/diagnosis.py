"""A diagnosis in sentences: what is missing, where, the proof, and what it had been booked as."""

import re
from math import degrees

from exoid.fitting.model.term_parameters import RATIO_UNITS, parameters_of
from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Diagnosis, NovelTorque, Parameter, Tested
from exoid.mismatch.sensors.agreement import BIAS, SensorError
from exoid.physics.library import library
from exoid.physics.parameter import AT_AN_END
from exoid.physics.term import name_of
from exoid.report.words.text import DIMENSIONLESS, in_degrees, quantity_words, with_error

SEEN = 0.01  # share of a number, from which on its change is worth a word
USUAL = {  # of a leg, in their units
    "damping": 0.3,
    "stiffness": 2.5,
    "gravity_moment": 12.0,
    "damping_over_inertia": 0.7,
}
NO_LEG = (
    "its numbers are not to be used: with what was found the model still does not follow the "
    "recording, and no error says how wrong they are."
)
SUSPECTS = 3  # that are named
WHOLE = 0.8  # of a torque's variance, below which a formula is no more than a part of it
BESIDE = (
    "d, c and m l g are here beside the formula: what it has of the speed, the angle or gravity is "
    "not in them."
)
LITTLE = 0.03  # share of what was missing that is worth no word
ORIGINS = {  # of an inertia that the motion does not tell alone
    "prior": "which the prior sets: torques grow with it",
    "both": "to which the prior adds: torques grow with it",
    "bound": "which a bound sets: torques grow with it",
}
CERTAIN = 0.001  # below this share a chance is written as "below"


def headline(found: Diagnosis) -> str:
    """The verdict in one line."""
    if found.verdict == "none":
        return "Nothing is missing: simulation and recording agree within the noise."
    if found.verdict == "cannot_tell":
        return "Cannot tell from this recording."
    if found.novel:
        return "Something is missing that the library does not know."
    if only_sensors(found):
        return "A sensor errs; of the leg's motion nothing is missing."
    if not found.explained and (share_left(found) or 0.0) > LITTLE:
        return "Something is missing, and a part of it has a name."
    return "Something is missing."


def verdict(found: Diagnosis) -> str:
    """What is missing by its name, where it has one; else the headline."""
    if found.verdict != "mismatch" or found.novel or only_sensors(found) or not found.selected:
        return headline(found)
    return "Missing: " + " and ".join(titles(found))


def only_sensors(found: Diagnosis) -> bool:
    """Is all that was found what encoder and gyro show of each other, and the fit estimates?"""
    return found.verdict == "mismatch" and not found.changed and not found.novel


def is_chosen(one: Tested, found: Diagnosis) -> bool:
    """Is it the cause that the answer names? Where the answer is that nobody can tell, none is."""
    return one.chosen and found.verdict == "mismatch"


def parted(found: Diagnosis) -> bool:
    """Is a torque missing, so that there are places where it is?"""
    return found.verdict != "none" and not only_sensors(found)


def sentences(found: Diagnosis) -> dict[str, str]:
    """The answer, line by line, by its heading; first what was missing, how sure that is, what it
    changed and what remains.
    """
    lines = {}
    if found.verdict == "mismatch":
        lines["Missing"] = "; ".join(named(found))
        lines["How sure"] = how_sure(found)
        lines["Changed"] = booked(found)
        lines["Remains"] = remains(found)
        lines["Reason"] = " ".join(explanations(found))
        if found.changed and not found.fit.follows and found.formula is None:
            lines["The leg"] = NO_LEG
    elif found.reasons:
        lines["Why"] = "; ".join(found.reasons) + "."
        if found.changed:
            lines["Suspected"] = suspected(found)
            lines["Remains"] = remains(found)
    if parted(found):
        lines["Where"] = where(found)
    lines["Sensors"] = sensors(found)
    if found.verdict == "none":
        lines["Trust"] = trust(found)
    if found.advice:
        lines["Record next"] = " ".join(found.advice)
    return {heading: line for heading, line in lines.items() if line}


def named(found: Diagnosis) -> list[str]:
    """Every effect with its parameters."""
    if found.formula is not None:
        own, share = found.formula, f"{found.formula.explained:.0%}"
        clock = ", t in s from a segment's first fitted sample on" if "t" in arguments(own) else ""
        units = f"x in rad, v in rad/s{clock}; {for_inertia(found.inertia, found.fit)}"
        if own.explained < WHOLE:
            said = f"a torque that is no short formula; {own.words} ({units})"
            return [f"{said} explains only {share} of its variance{at_once(own)}"]
        said = f"{own.words} ({units}), which explains {share} of the missing torque's variance"
        return [f"{said}{at_once(own)}"]
    lines = []
    for one in found.findings:
        own = [each for each in found.parameters if each.name.startswith(f"{one.name}.")]
        if found.after is not None and found.after.parameters["inertia"].value is None:
            own = [over_inertia(each, found.after) for each in own]
        lines.append(f"{one.title}, {', '.join(map(parameter, own))}{scale(found, own)}")
    return lines


def arguments(formula: NovelTorque) -> set[str]:
    """Of angle x, speed v and time t those that it has."""
    return set(re.findall(r"\b[xvt]\b", formula.words))


def at_once(formula: NovelTorque) -> str:
    """That what acts once goes with a place, or with a moment."""
    if formula.once is None:
        return ""
    first, last = formula.once
    return (
        f". Nearly all of it acts once, from {first:.2f} to {last:.2f} s: whether that goes with "
        "the place or with the moment, as a touch does, one passage cannot tell"
    )


def over_inertia(each: Parameter, after: FitResult) -> Parameter:
    """The ratio in place of a torque, where nothing tells the inertia that it goes with."""
    ratio = after.of_terms.get(f"{each.name}_over_inertia")
    if ratio is None or ratio.value is None:
        return each
    return Parameter(f"{each.name} / J", ratio.value, ratio.unit, ratio.standard_error)


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
        return f"not determined (± {error:.2g}{unit})"
    return f"{with_error(number, error)}{unit}"


def at_limit(each: Parameter | SensorError) -> bool:
    """Is it as large, or as small, as its term lets it be?"""
    declared = dict(parameters_of(library())).get(each.name)
    if declared is None:
        return False
    near = AT_AN_END * (declared.upper - declared.lower)
    return min(abs(each.value - declared.lower), abs(each.value - declared.upper)) < near


def explanations(found: Diagnosis) -> list[str]:
    if found.formula is not None:
        return []
    return [each.explanation for each in found.findings]


def titles(found: Diagnosis) -> list[str]:
    """What is missing, in a user's words."""
    return [each.title for each in found.findings]


def others(found: Diagnosis) -> list[str]:
    """What may act besides, and what it may be instead."""
    named = set(found.selected)
    mine = named - {BIAS}  # a bias is free in every candidate, and has no rival
    each = [name.split(" + ") for name in found.equivalent]
    beside = [" + ".join(x for x in one if x not in named) for one in each if mine <= {*one}]
    rest = {" + ".join(one): exact_twin(mine, {*one}) for one in each if not mine <= {*one}}
    instead = [name for name, twin in rest.items() if not twin]
    said = [f"besides it perhaps {', or '.join(filter(None, beside))}"] if any(beside) else []
    said += [f"or instead {', or '.join(instead)}"] if instead else []
    doubts = [f"{'; '.join(said)}: this recording cannot tell"] if said else []
    twins = [f"{twin} would look exactly alike" for twin in rest.values() if twin]
    return [one.replace("_", " ") for one in (*twins, *doubts)]


def exact_twin(mine: set[str], other: set[str]) -> str | None:
    """The one cause that is another there, where it is the same in every recording."""
    known = {name_of(term): term for term in library()}
    match [*(mine - other)], [*(other - mine)]:
        case [one], [twin] if one in known and twin in (known[one].twin, known[one].same_torque):
            return twin
    return None


def where(found: Diagnosis) -> str:
    regions = [f"{each.description} (segment {each.segment}, {each.begin:.2f}-{each.end:.2f} s)"
               for each in found.location.regions[:3]]  # fmt: skip
    if not regions:
        return "no torque stands out of the noise: the sensors differ, or it is spread thinly."
    said = for_inertia(found.location.inertia or found.inertia, found.before)
    scale = f" ({said})" if "," in said else ""
    return f"{'; '.join(regions)}{scale}. Over all of it, {found.location.pattern}."


def how_sure(found: Diagnosis) -> str:
    """Whether other data would say the same, and what else it may be."""
    if only_sensors(found):
        return "encoder and gyro show it of each other, without any leg model."
    share, weight = found.inclusion, found.weight
    held = "" if weight is None else f"explanations with it hold {certain(weight)} of the weight; "
    again = "" if share is None else f"with segments drawn anew, {share:.0%} say the same; "
    alike = "".join(f"{one}; " for one in others(found))
    return (
        f"{held}{again}{alike}chance alone would look like it in "
        f"{chance(found.false_alarm_rate)} of recordings, an effect of this size is found with a "
        f"chance of {certain(found.power)}."
    )


def suspected(found: Diagnosis) -> str:
    """What explains most of it, and how much."""
    first = [one for one in (*found.singles, *found.pairs) if one.terms][:SUSPECTS]
    return ", ".join(" + ".join(one.terms).replace("_", " ") for one in first) + "."


def remains(found: Diagnosis) -> str:
    """What is left on data that the fit has not seen, beside what was there before."""
    shown = found.proof
    before, after = in_degrees(shown.before.total), in_degrees(shown.after.total)
    times = f"{shown.after.total / shown.noise_floor:.1f} times the noise floor"
    if not found.changed:
        return f"held-out angle RMSE {after} deg, {times}."
    parts = "quarters of the recording" if shown.in_time else "segments"
    return (
        f"held-out angle RMSE {before} -> {after} deg, {left_over(found)}{times} "
        f"({shown.better} of {shown.after.squares.size} {parts} better, each from the others)."
    )


def left_over(found: Diagnosis) -> str:
    share = share_left(found)
    if share is not None and share > 1:
        return "worse than without it; "
    return "" if share is None else f"{share:.0%} of the squares that were missing; "


def share_left(found: Diagnosis) -> float | None:
    """The share of what was missing over the noise, in squares, that still is."""
    shown = found.proof
    missing = shown.before.total**2 - shown.noise_floor**2
    if missing <= 0:
        return None
    return max(shown.after.total**2 - shown.noise_floor**2, 0.0) / missing


def chance(share: float) -> str:
    return "below 0.1 %" if share < CERTAIN else f"{share:.1%}"


def certain(share: float) -> str:
    return "above 99.9 %" if share > 1 - CERTAIN else f"{share:.1%}"


def booked(found: Diagnosis) -> str:
    """What the baseline had made of it: whatever changes by more than a percent."""
    changes = [
        f"{quantity_words(each.name)} {each.before:.3g} -> {each.after:.3g} {each.unit}"
        for each in found.booked
        if abs(each.after - each.before)
        > SEEN * max(abs(each.before), abs(each.after), USUAL[each.name])
    ]
    if not changes:
        stay = ", ".join(quantity_words(each.name) for each in found.booked)
        return f"nothing: {stay} changed by less than 1 %."
    scale = " (for the inertia that the fit took)" if "N m" in found.booked[0].unit else ""
    return f"{', '.join(changes)}{scale}."


def sensors(found: Diagnosis) -> str:
    """What encoder and gyro say of each other."""
    if not found.sensors:
        return "no gyro: encoder and gyro cannot be compared."
    clear = [each for each in found.sensors if each.clear]
    if not clear:
        return "encoder and gyro agree."
    return f"encoder and gyro differ as if by {', '.join(map(parameter, clear))}."


def trust(found: Diagnosis) -> str:
    return (
        f"the {len(found.pinned)} causes that can act here were tested; chance makes one of them "
        f"stand out in {chance(found.false_alarm_rate)} of recordings."
    )
