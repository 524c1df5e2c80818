"""How good answers are.

A fit is judged where the leg obeys Eq. 9. Its ratios are right within 2 % (gravity) and 15 %
(stiffness, damping), or within three times the smallest possible error. A diagnosis is judged
everywhere; sensors' errors that are there may be named.
"""

from dataclasses import dataclass
from typing import Any

RIGHT = {"gravity_over_inertia": 0.02}  # relative
ELSE_RIGHT = 0.15
BOUNDS = 3.0  # smallest errors that are right as well
CERTAIN = 2.576  # standard errors: 99 %
UNSEEN = 5.0  # noise levels: an effect that changes less than this nobody sees
SENSORS = frozenset({"angle_offset", "gyro_scale", "gyro_bias", "sensor_skew", "encoder_gain"})
DRIFT = frozenset({"gyro_bias", "gyro_scale", "sensor_skew", "fatigue"})
EQUAL = {  # names that are as right, since no drop tells them apart
    "stiffness_rest_angle": {"torque_bias", "angle_offset"},
    "coulomb_friction": {"stribeck_friction"},
    "cubic_stiffness": {"end_range_stiffening"},
    "hard_stop": {"end_range_stiffening"},
    "gyro_scale": {"encoder_gain"},
}


@dataclass(frozen=True)
class FitMark:
    """Of one fit of a leg that obeys Eq. 9; empty where it was refused."""

    refused: str | None
    right: bool = False
    undetermined: tuple[str, ...] = ()
    covered: tuple[bool, ...] = ()  # by the 99 % interval, of each ratio that has an error
    away: tuple[float, ...] = ()  # standard errors
    deviation: tuple[float, ...] = ()  # relative
    error_over_bound: tuple[float, ...] = ()


@dataclass(frozen=True)
class Mark:
    """Of one diagnosis: quiet, sensor, alarm; named, unsure, missed, unseen, wrong; refused."""

    word: str
    said: str


def mark_fit(truth: dict[str, Any], answer: dict[str, Any]) -> FitMark:
    if "refused" in answer:
        return FitMark(answer["refused"])
    found = answer["ratios"]
    known = {k: v for k, v in truth["ratios"].items() if found[k]["value"] is not None}
    right = len(known) == len(truth["ratios"]) and all(
        abs(found[k]["value"] - v) <= max(RIGHT.get(k, ELSE_RIGHT) * v, BOUNDS * truth["bound"][k])
        for k, v in known.items()
    )
    sure = {k: v for k, v in known.items() if found[k]["standard_error"]}
    away = tuple(abs(found[k]["value"] - v) / found[k]["standard_error"] for k, v in sure.items())
    return FitMark(
        None,
        right,
        tuple(k for k in truth["ratios"] if k not in known),
        tuple(each <= CERTAIN for each in away),
        away,
        tuple(found[k]["value"] / v - 1 for k, v in known.items()),
        tuple(found[k]["standard_error"] / truth["bound"][k] for k in sure),
    )


def mark_diagnosis(truth: dict[str, Any], answer: dict[str, Any]) -> Mark:
    if "refused" in answer:
        return Mark("refused", answer["refused"])
    names = set(answer["selected"] or ()) if answer["verdict"] == "mismatch" else set()
    said = answer["verdict"] + (": " + "+".join(sorted(names)) if names else "")
    said += " novel" if answer["novel"] else ""
    loud = answer["verdict"] == "mismatch" or bool(answer["novel"])
    allowed = (SENSORS if truth["systematic"] else frozenset()) | (
        DRIFT if truth["trouble"] == "drift" else frozenset()
    )
    if truth["effect"] == "none":
        sensor = bool(names) and names <= allowed and not answer["novel"]
        return Mark("quiet" if not loud else "sensor" if sensor else "alarm", said)
    if names & ({truth["effect"]} | EQUAL.get(truth["effect"], set())):
        return Mark("named", said)
    if not loud:
        unseen = truth["visible"] < UNSEEN
        unsure = answer["verdict"] != "none"
        return Mark("unseen" if unseen else "unsure" if unsure else "missed", said)
    return Mark("wrong", said)
