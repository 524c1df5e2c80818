"""Which systematic limits a number most, and what would narrow it."""

from dataclasses import replace

import numpy as np

from exoid.fitting.model.systematics import OF_THE_LOAD
from exoid.fitting.result.chief import WORDS, chief
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.anatomy_remarks import SWING
from exoid.fitting.solve.problem import Problem
from exoid.physics.anatomy.added_mass import changes_swing_least

TAPE = 5e-4  # m, to which a tape's millimetres are read
DECLARED_AS = {  # by `Systematics`, where it has another name there
    "added_mass": "log_added",
    "added_mass_distance": "distance",
    "added_mass_gyration": "extent",
}
ADVICE = {
    "zero": "say how well the encoder's zero is known (angle_zero_uncertainty_deg)",
    "tilt": "hold a level to the thigh and give thigh_angle_uncertainty_deg, with what the foot "
    "makes of it",
    "gyro_scale": "turn the node by a known angle and give gyro_scale_uncertainty",
    "gyro_bias": "keep the node still for a while before the release",
    "clock": "compare the clock with a true one and give clock_uncertainty",
    "torque_zero": "take off what it reads with nothing on it, say how well that is known "
    "(torque_zero_uncertainty_nm), or record drops beside it, its motor taken off",
    "torque_gain": "compare it with a known weight on a lever and give torque_gain_uncertainty",
    "reflex_form": "record drops that are too slow to trip it, and fit them alone",
    "added_mass": "weigh the added mass to 0.1 % and give added_mass_uncertainty_kg",
    "added_mass_distance": "measure where it sits and give added_mass_distance_uncertainty_m",
    "added_mass_gyration": "give added_mass_gyration_m, or use a compact weight",
    "distance_apart": "measure where each sits and give added_mass_distance_uncertainty_m",
    "extent_apart": "give added_mass_gyration_m, or use compact weights",
}


def limiting(result: FitResult, only: Estimate | None = None) -> list[str]:
    """One sentence for each systematic that limits something, or one number `only`: what, and what
    to do. What else limits a number has a note of its own.
    """
    found: dict[str, list[str]] = {}
    every = (*result.parameters.values(), *result.ratios.values())
    for each in every if only is None else [only]:
        if each.standard_error and (most := chief(each)) and most[0] in WORDS:
            found.setdefault(most[0], []).append(f"{each.symbol} ({most[1]:.0%})")
    return [
        f"{WORDS[name]} limits {', '.join(symbols)} (its part of the variance): "
        f"{what_to_do(name, result)}."
        for name, symbols in found.items()
    ]


def what_to_do(name: str, result: FitResult) -> str:
    """What narrows a systematic: where the motion tells a place better than a tape, or the sidecar
    says already how well something is known, not what was done.
    """
    each = [one.known[name] for one in result.mountings if name in one.known]
    errors = [one.standard_error or np.inf for one in each]
    if name == "added_mass_distance" and errors and max(errors) < TAPE:
        return (
            f"the motion tells it to {1e3 * max(errors):.1g} mm, better than a tape does: drop it "
            "more often, with that mass and without"
        )
    if result.basis is not None and is_declared(name, result.basis.problem):
        return "± holds what the sidecar says of it: only what is known better narrows it"
    return weighed_by_gravity(name, result) if name in OF_THE_LOAD else ADVICE[name]


def weighed_by_gravity(name: str, result: FitResult) -> str:
    """What tells J though d and c change under a load: how a mass changes m l g / J."""
    gravity, declare = result.ratios[SWING].value, f"give {name}_uncertainty where it is known"
    if not gravity or gravity < 0:
        return f"drop it with a heavier mass; {declare}"
    where = changes_swing_least(gravity)
    return (
        f"drop it with a heavy and compact mass, its added_mass_gyration_m given, about "
        f"{where / 2:.2f} m from the axis, where it changes m l g / J most, by which J is told "
        f"then: at {where:.2f} m not at all; {declare}"
    )


def is_declared(name: str, problem: Problem) -> bool:
    """Do all recordings say how well it is known?"""
    own = DECLARED_AS.get(name, name)
    movements = [one for one in problem.movements if one.added_mass > 0 or name == own]
    return all(own in one.systematics.declared for one in movements)


def limited_anew(result: FitResult, before: FitResult) -> FitResult:
    """The same after its errors were widened from those of `before`: its notes tell what limits a
    number of its error as it is now.
    """
    old, new = limiting(before), limiting(result)
    notes = result.notes
    first = next((at for at, note in enumerate(notes) if note in old), len(notes))
    behind = [note for note in notes[first:] if note not in old]
    kept = new if first < len(notes) else []  # where there were none, none is to be told
    return replace(result, notes=[*notes[:first], *kept, *behind])
