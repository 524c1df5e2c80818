"""What is taken for granted of sensors and seat where nobody declares it."""

from collections.abc import Callable, Collection, Sequence

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.model.systematics import OF_THE_LOAD, OF_THE_TORQUE, SLANT
from exoid.fitting.result.chief import WORDS
from exoid.fitting.solve.problem import Problem

GRANTED: tuple[tuple[str, str, Callable[[float], str]], ...] = (
    ("torque_zero", WORDS["torque_zero"], lambda newton_metre: f"{newton_metre:.2g} N m"),
    ("torque_gain", WORDS["torque_gain"], lambda share: f"{100 * share:.2g} %"),
    ("zero", "the encoder's zero", lambda rad: f"{np.degrees(rad):.2g} deg"),
    ("tilt", "the seat's level", lambda rad: f"{np.degrees(rad):.2g} deg"),
    ("gyro_scale", "the gyro's scale", lambda share: f"{100 * share:.2g} %"),
    ("log_added", "the weight of the added mass", lambda share: f"{100 * share:.2g} %"),
    ("distance", "its distance from the knee", lambda off: f"{1e3 * off:.2g} mm"),
    ("damping_under_load", "damping beside that mass", lambda share: f"{100 * share:.2g} %"),
    ("stiffness_under_load", "stiffness beside it", lambda share: f"{100 * share:.2g} %"),
    ("clock", "times", lambda share: f"{100 * share:.2g} %"),
)
BY_SCALE = (
    " All that is in N m goes with the weight of the added mass, which no motion shows wrong, and "
    "with its distance, which a mass of another extent hides."
)
AMISS = (
    " Times by a camera or a node without a crystal may be percents off: d / J goes with them, "
    "m l g / J and c / J with their square (clock_uncertainty)."
)
ASKEW = (
    " A camera that looks 10 deg off square at the plane in which the leg swings makes d / J about "
    "0.5 % too high, c / J 3 to 8 %, one that is 20 deg off four times as much, which an angle "
    "alone hardly shows."
)
BY_A_FOOT = (
    f"in one leg of two {np.degrees(SLANT):.2g} deg, for its foot puts the centre of mass beside "
    "the shank's line"
)


def granted(problem: Problem, doubted: Collection[str] = ()) -> list[str]:
    """How well what no sidecar says is taken to be known, in one sentence, but for what is
    `doubted`.
    """
    said = []
    for name, words, shown in GRANTED:
        each = [
            known_to(name, one)
            for one in problem.movements
            if name not in {*one.systematics.declared, *doubted} and applies(name, one)
        ]
        foot = f" ({BY_A_FOOT})" if name == "tilt" and not problem.belief.rig else ""
        said += [f"{words} to {shown(max(each))}{foot}"] if each else []
    if not said:
        return []
    weighed = BY_SCALE if any("added mass" in each for each in said) else ""
    return [
        f"± takes for granted, where no sidecar says better or worse: {', '.join(said)} (one "
        f"standard deviation).{AMISS if said[-1].startswith('times') else ''}"
        f"{'' if problem.belief.rig else of_a_camera(problem.movements)}{weighed}"
    ]


def of_a_camera(movements: Sequence[Movement]) -> str:
    """What an angle that is seen askew makes of the ratios; nothing where a gyro would show it."""
    return "" if any(one.angular_velocity is not None for one in movements) else ASKEW


def applies(name: str, one: Movement) -> bool:
    """Has a movement what this is known of?"""
    if name in ("log_added", "distance"):
        return one.added_mass > 0 and not (name == "distance" and one.unplaced)
    if name in OF_THE_LOAD:
        return one.borne > 0 and getattr(one.systematics, name) > 0
    if name in OF_THE_TORQUE:
        return one.kind == "measured" and one.gain_known
    return name != "gyro_scale" or one.angular_velocity is not None


def known_to(name: str, one: Movement) -> float:
    """One standard deviation of what nobody declares of a movement: a torque's zero in N m."""
    known = one.systematics
    return known.torque_zero * known.torque_reach if name == "torque_zero" else getattr(known, name)
