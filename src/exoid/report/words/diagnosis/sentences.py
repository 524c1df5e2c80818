"""A diagnosis in sentences: what is missing, where, the proof, and what it had been booked as."""

from dataclasses import replace
from math import hypot

from exoid.fitting.result.remarks.rig_words import of_rig
from exoid.mismatch.answer.diagnosis import Diagnosis, Parameter
from exoid.mismatch.answer.over_inertia import OVER, guessed, parameters_shown
from exoid.mismatch.sensors.agreement import OwnValue, SensorError
from exoid.physics.library import library
from exoid.physics.term import holds, name_of
from exoid.recordings.tables.sheet import listed
from exoid.report.words.diagnosis.asserted import only_sensors, only_usual, parted, reason
from exoid.report.words.diagnosis.cause import explanations, for_inertia, named, parameter
from exoid.report.words.diagnosis.certainty import (
    explanations_alike,
    how_sure,
    suspected,
    trust,
    twins,
)
from exoid.report.words.diagnosis.leg import booked, doubted
from exoid.report.words.diagnosis.located import located
from exoid.report.words.diagnosis.remainder import remains
from exoid.report.words.diagnosis.samples import of_plays, of_times
from exoid.report.words.text import in_words, with_error

APART = 3.0  # standard errors, within which two tell the same
BY_NOISE = "± by noise alone, whichever of them errs"
BY_SENSORS = "encoder and gyro show it of each other, without any leg model."


def sentences(found: Diagnosis) -> dict[str, str]:
    """The answer, line by line, by its heading; first what was missing, how sure that is, what it
    changed and what remains.
    """
    lines = {}
    if found.verdict == "mismatch":
        usual = only_usual(found)
        lines["Found" if usual else "Missing"] = "; ".join([*named(found), *alike(found)])
        lines["How sure"] = BY_SENSORS if only_sensors(found) else how_sure(found)
        lines["Changed"] = booked(found)
        lines["Remains"] = remains(found)
        why = [*explanations(found), *explanations_alike(found)]
        lines["Reason"] = reason() if usual else " ".join(why)
    elif found.reasons:
        heading = "Note" if found.verdict == "none" else "Why"
        lines[heading] = "; ".join(found.reasons) + "."
        if found.changed:
            lines["Suspected"] = suspected(found)
            lines["Remains"] = remains(found)
    if parted(found):
        lines["Where"] = where(found)
    lines[whose(found)] = " ".join(doubted(found))
    lines["Sensors"] = sensors(found)
    if found.verdict == "none":
        lines["Trust"] = trust(found)
    if found.advice and not only_usual(found):
        lines["Record next"] = " ".join(found.advice)
    of_its_own = of_rig if found.location.rig else str
    return {heading: of_its_own(line) for heading, line in lines.items() if line}


def whose(found: Diagnosis) -> str:
    """The heading of what is said of its numbers."""
    return "The rig" if found.location.rig else "The leg"


def alike(found: Diagnosis) -> list[str]:
    """What may act in the place of a cause, how large it is then, and no recording of motion tells
    which of the two it is.
    """
    named = [f"or {title}{size_of(name, found)}" for name, title in twins(found).items()]
    return [f"{each}, which would look exactly alike" for each in (*named, *by_direction(found))]


def by_direction(found: Diagnosis) -> list[str]:
    """Dry friction beside a constant torque is, whether it slides or sticks, friction that differs
    by direction: F - tau_b towards extension, F + tau_b towards flexion.
    """
    frictions = {f"{name_of(term)}.level" for term in library() if holds(term)}
    shown = {each.name.split()[0]: each for each in parameters_shown(found, found.parameters)}
    level = next((each for name, each in shown.items() if name in frictions), None)
    bias = shown.get("torque_bias.bias")
    if level is None or bias is None or not level.value > abs(bias.value):
        return []
    error = hypot(level.standard_error or 0.0, bias.standard_error or 0.0)
    each = [with_error(level.value + way * bias.value, error) for way in (-1, 1)]
    return [
        f"or, in the place of both, friction that differs by direction, {each[0]} {level.unit} "
        f"towards extension and {each[1]} {level.unit} towards flexion"
    ]


def size_of(twin: str, found: Diagnosis) -> str:
    """How large it is: a torque for the inertia that the numbers go with, and over that."""
    own = [each for each in found.twins if each.name.startswith(f"{twin}.")]
    untold = guessed(found.fit) and any(each.name.endswith(OVER) for each in own)
    shown = [each for each in own if not (untold and each.unit.startswith("N m"))]
    return "".join(f", {parameter(replace(e, name=e.name.replace(OVER, ' / J')))}" for e in shown)


def where(found: Diagnosis) -> str:
    place = located(found)
    regions = [f"{each.description} (segment {each.segment}, {each.begin:.2f}-{each.end:.2f} s)"
               for each in place.regions[:3]]  # fmt: skip
    if not regions:
        differ = "the sensors differ, or " if found.sensors else ""
        return (
            f"no torque that lasts stands out of the noise: {differ}it is spread thinly, or acts "
            "for moments only, as where something strikes."
        )
    said = for_inertia(place.inertia or found.inertia, found.fit)
    scale = f" ({said})" if "," in said else ""
    if guessed(found.fit):
        scale = " (torques over J, which nothing tells)"
    return f"{'; '.join(regions)}{scale}. Over all of it, {place.pattern}."


def sensors(found: Diagnosis) -> str:
    """What encoder and gyro say of each other, and of their times."""
    return " ".join(filter(None, (of_each_other(found), of_plays(found), of_times(found))))


def of_each_other(found: Diagnosis) -> str:
    if not found.sensors:
        return "no gyro: encoder and gyro cannot be compared."
    own = [of_segments(each.own, found) for each in found.sensors if each.own]
    own += [of_sizes(each.by_size) for each in found.sensors if each.by_size and not each.own]
    clear = [each for each in found.sensors if each.clear and not each.own and not each.by_size]
    if not clear:
        return " ".join(own) or "encoder and gyro agree."
    told = {each.name: each for each in clear if among_others(each, found)}
    above = [in_words(name) for name, each in told.items() if agrees(each, found)]
    alone = [each for name, each in told.items() if in_words(name) not in above]
    others = [each for each in clear if each.name not in told]
    said = [f"by the {listed(above)} that is named above"] if above else []
    said += [f"as if by {listed(list(map(parameter, others)))} ({BY_NOISE})"] if others else []
    said += [as_if_alone(alone, found)] if alone else []
    return " ".join([*own, f"encoder and gyro differ {', and '.join(said)}."])


def of_segments(delays: list[OwnValue], found: Diagnosis) -> str:
    """How late the gyro is in each segment by itself."""
    names = [each.segment for each in found.location.missing]
    each = [f"{1e3 * one.value:.2g} ms in segment {names[one.number]}" for one in delays]
    error = 1e3 * max(one.standard_error for one in delays)
    return (
        f"encoder and gyro lie apart by another time in each segment: the gyro is late by "
        f"{listed(each)} (± {error:.1g} ms by noise alone; below 0 it is early)."
    )


def of_sizes(delays: list[float]) -> str:
    """How late the gyro seems in the larger and in the smaller swings."""
    larger, smaller = (f"{1e3 * one:.2g} ms" for one in delays)
    return (
        f"encoder and gyro lie apart as by a delay of {larger} in the larger swings, of {smaller} "
        "in the smaller ones, which is none: a thigh that rocks or sinks, of which an encoder of "
        "the knee knows nothing, does that, and play or soft tissue under a sensor."
    )


def among_others(each: SensorError, found: Diagnosis) -> bool:
    """Is it named with its size beside other causes?"""
    return len(found.selected) > 1 and each.name in found.selected and fitted(each, found) != []


def fitted(each: SensorError, found: Diagnosis) -> list[Parameter]:
    """The same as it is named, told together with what else is missing."""
    return [one for one in found.parameters if one.name.partition(".")[0] == each.name]


def agrees(each: SensorError, found: Diagnosis) -> bool:
    """Do encoder and gyro alone tell the same size?"""
    (one,) = fitted(each, found)
    return abs(one.value - each.value) < APART * hypot(each.standard_error, one.standard_error or 0)


def as_if_alone(errors: list[SensorError], found: Diagnosis) -> str:
    """What they would seem to be where nothing else errs, that a size is named once."""
    rest = [one.title for one in found.findings if one.name not in {each.name for each in errors}]
    return (
        f"as if by {listed(list(map(parameter, errors)))} ({BY_NOISE}) were there no "
        f"{' and no '.join(rest)}: beside that it is as large as named above"
    )
