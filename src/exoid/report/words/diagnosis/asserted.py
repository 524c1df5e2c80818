"""What an answer asserts, and what it does not."""

from math import degrees

from exoid.fitting.model.systematics import DECLARED_NOTHING
from exoid.mismatch.answer.diagnosis import Diagnosis, Tested

MOST = 8  # candidates that are listed
WITHIN = 2.0  # standard deviations of a gyro's usual errors: 19 of 20 gyros
USUAL = {  # parameter: one standard deviation of it over gyros
    "gyro_scale.scale": DECLARED_NOTHING.gyro_scale,
    "gyro_bias.bias": DECLARED_NOTHING.gyro_bias,
}
OF_GYROS = {"gyro_scale", "gyro_bias", "clock_rate"}  # and what looks exactly like them


def only_sensors(found: Diagnosis) -> bool:
    """Is all that was found what encoder and gyro show of each other, and the fit estimates?"""
    return found.verdict == "mismatch" and not found.changed and not found.novel


def only_usual(found: Diagnosis) -> bool:
    """Is all that was found, and all that it may be instead, an error that most gyros have?"""
    sizes = {each.name: abs(each.value) for each in found.parameters}
    return (
        found.verdict == "mismatch"
        and not found.novel
        and found.explained
        and bool(sizes)
        and {name.partition(".")[0] for name in sizes} == {*found.selected}
        and all(name in USUAL and size < WITHIN * USUAL[name] for name, size in sizes.items())
        and {term for each in found.equivalent for term in each.split(" + ")} <= OF_GYROS
    )


def usual_errors(found: Diagnosis) -> str:
    """How far gyro and encoder are apart, for the first sentence of an answer."""
    sizes = {each.name: abs(each.value) for each in found.parameters}
    shown = (
        ("gyro_scale.scale", lambda value: f"{100 * value:.2g} % in scale"),
        ("gyro_bias.bias", lambda value: f"{degrees(value):.2g} deg/s in zero"),
    )
    return " and ".join(words(sizes[name]) for name, words in shown if name in sizes)


def reason() -> str:
    """Why that is no fault."""
    scale, bias = USUAL["gyro_scale.scale"], USUAL["gyro_bias.bias"]
    return (
        f"a gyro's scale is right to {100 * scale:.2g} %, its zero to {degrees(bias):.2g} deg/s "
        "(one standard deviation): this is no fault, and the leg's numbers take it into account."
    )


def is_chosen(one: Tested, found: Diagnosis) -> bool:
    """Is it the cause that the answer names? Where the answer is that nobody can tell, none is."""
    return one.chosen and found.verdict == "mismatch"


def parted(found: Diagnosis) -> bool:
    """Is a torque missing, so that there are places where it is?"""
    nothing = found.verdict == "none" or found.but_ends
    return not (nothing or only_sensors(found) or only_usual(found))


def ran_free(found: Diagnosis) -> list[Tested]:
    """The candidates that ran free, the most evident first, and always the one that was chosen."""
    ran = sorted([*found.pairs, *found.singles], key=evidence, reverse=True)[:MOST]
    listed = any({*one.terms} == {*found.best.terms} for one in ran)
    return ran if listed or not found.changed else [*ran, found.best]


def evidence(one: Tested) -> float:
    assert one.evidence is not None  # it ran free
    return one.evidence
