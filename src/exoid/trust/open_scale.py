"""Why a recording does not tell the scale, J, by which all torques go."""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.result.estimates.basis import Basis


def scale_remark(basis: Basis, inertia_told: bool) -> list[str]:
    """Why the data do not fix the scale, where they do not, be it that J is known otherwise."""
    movements = basis.problem.movements
    if inertia_told or not any(each.scaled for each in movements):
        return []
    driven = [each for each in movements if each.kind == "measured"]
    if not basis.problem.gain_known:
        return [
            "a torque of unknown gain fixes no scale, however much it varies: J, and all that goes "
            "with it, stays open."
        ]
    if driven:
        return [f"{why_open(driven)}: J stays open."]
    if len({each.load for each in movements}) > 1:
        return [
            "movements with different known masses do not fix the scale here: J stays open. Check "
            "the masses and their distances, or hang on a heavier one."
        ]
    return [
        "the known mass was on the leg in every segment, so its inertia and the leg's cannot be "
        "told apart (singular): add a drop of the bare leg."
    ]


def why_open(driven: Sequence[Movement]) -> str:
    """Why a torque that was measured leaves J open."""
    if all(steady(each) for each in driven):
        return "the measured torque varied too little to fix the scale"
    return (
        "the measured torque varies, but the leg hardly answers to it otherwise than to what else "
        "is unknown of it (singular): move it quicker and less evenly"
    )


def steady(each: Movement) -> bool:
    """Does a measured torque vary by less than its sensor's zero is known to?"""
    torque, known = each.segment.applied_torque, each.systematics
    assert torque is not None  # of what is measured
    return bool(np.nanstd(torque) <= known.torque_zero * known.torque_reach)
