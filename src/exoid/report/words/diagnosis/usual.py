"""An answer that is no more than what gyros and encoders usually differ by, which is counted."""

from math import degrees

from exoid.fitting.model.systematics import DECLARED_NOTHING
from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.report.words.diagnosis.certainty import others

WITHIN = 2.0  # standard deviations of a gyro's usual errors: 19 of 20 gyros
USUAL = {  # parameter: one standard deviation of it over gyros
    "gyro_scale.scale": DECLARED_NOTHING.gyro_scale,
    "gyro_bias.bias": DECLARED_NOTHING.gyro_bias,
}


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
        and not others(found)
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
