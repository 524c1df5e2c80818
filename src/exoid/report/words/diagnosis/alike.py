"""What would look exactly like what was found, in every recording of the motion."""

from dataclasses import replace

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.answer.over_inertia import OVER, guessed, parameters_shown
from exoid.physics.library import library
from exoid.physics.term import holds, name_of
from exoid.report.words.diagnosis.cause import parameter
from exoid.report.words.diagnosis.certainty import twins


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
    each = f"{level.value - bias.value:.3g}", f"{level.value + bias.value:.3g}"
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
