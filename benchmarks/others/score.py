"""How good answers are.

A fit is judged where the leg obeys Eq. 9. Its ratios are right within 2 % (gravity) and 15 %
(stiffness, damping), or within three times the smallest possible error. A diagnosis is judged
everywhere; sensors' errors that are there may be named.
"""

from dataclasses import dataclass
from typing import Any

from .ask import Answer

RIGHT = {"gravity_over_inertia": 0.02}  # relative
ELSE_RIGHT = 0.15
BOUNDS = 3.0  # smallest errors that are right as well
CERTAIN, LIKELY = 2.576, 1.960  # standard errors: 99 %, 95 %
LEG = ("mass", "inertia", "com_distance", "damping", "stiffness")
UNSEEN = 5.0  # noise levels: an effect that changes less than this nobody sees
SENSORS = frozenset({"angle_offset", "gyro_scale", "gyro_bias", "sensor_skew", "encoder_gain"})
DRIFT = frozenset({"gyro_bias", "gyro_scale", "sensor_skew", "fatigue", "zero_drift"})
WANDER = frozenset({"gyro_bias", "zero_drift"})  # what mains folded to a standstill are
MAINS = (50.0, 60.0)  # Hz
SEEN_BIAS = 0.05  # of the gyro's noise: a bias that some hundred samples show
EQUAL = {  # names that are as right, since no drop tells them apart
    "stiffness_rest_angle": {"torque_bias", "angle_offset"},
    "coulomb_friction": {"stribeck_friction"},
    "quadratic_drag": {"power_drag"},
    "cubic_damping_novel": {"power_drag"},
    "cubic_stiffness": {"end_range_stiffening", "slack_cubic_stiffness"},
    "hard_stop": {"end_range_stiffening"},
    "gyro_scale": {"encoder_gain"},
}


@dataclass(frozen=True)
class FitMark:
    """Of one fit of a leg that obeys Eq. 9; empty where it was refused."""

    refused: str | None
    warned: bool = False  # it says itself that it failed
    right: bool = False
    undetermined: tuple[str, ...] = ()
    covered: tuple[
        bool, ...
    ] = ()  # by the 99 % interval, of each ratio; without an error it is not
    leg_covered: tuple[bool, ...] = ()  # by the 95 % interval, of each parameter that is told
    away: tuple[float, ...] = ()  # standard errors
    deviation: tuple[float, ...] = ()  # relative
    error_over_bound: tuple[float, ...] = ()


@dataclass(frozen=True)
class Mark:
    """Of one diagnosis: quiet, sensor, alarm; named, part of it, unsure, missed, unseen, wrong;
    refused.
    """

    word: str
    said: str


def mark_fit(truth: dict[str, Any], answer: Answer) -> FitMark:
    if answer.document is None:
        return FitMark(answer.said)
    found = answer.document["ratios"]
    known = {k: v for k, v in truth["ratios"].items() if found[k]["value"] is not None}
    right = len(known) == len(truth["ratios"]) and all(
        abs(found[k]["value"] - v) <= max(RIGHT.get(k, ELSE_RIGHT) * v, BOUNDS * truth["bound"][k])
        for k, v in known.items()
    )
    sure = {k: v for k, v in known.items() if found[k]["standard_error"]}
    told = {k: each for k, each in answer.document["parameters"].items() if k in LEG}
    return FitMark(
        None,
        answer.code != 0,
        right,
        tuple(k for k in truth["ratios"] if k not in known),
        tuple(away(found[k], v) <= CERTAIN for k, v in known.items()),
        tuple(
            away(each, truth["leg"][k]) <= LIKELY
            for k, each in told.items()
            if each["value"] is not None
        ),
        tuple(away(found[k], v) for k, v in sure.items()),
        tuple(found[k]["value"] / v - 1 for k, v in known.items()),
        tuple(found[k]["standard_error"] / truth["bound"][k] for k in sure),
    )


def away(estimate: dict[str, Any], true: float) -> float:
    """In standard errors; a value without one is never near enough."""
    error = estimate["standard_error"]
    return abs(estimate["value"] - true) / error if error else float("inf")


def mark_diagnosis(truth: dict[str, Any], answer: Answer) -> Mark:
    found = answer.document
    if found is None:
        return Mark("refused", answer.said)
    names = set(found["selected"] or ()) if found["verdict"] == "mismatch" else set()
    said = found["verdict"] + (": " + "+".join(sorted(names)) if names else "")
    said += " novel" if found["novel"] else ""
    loud = found["verdict"] == "mismatch" or bool(found["novel"])
    if truth["effect"] == "none":
        sensor = bool(names) and names <= present(truth) and not found["novel"]
        return Mark("quiet" if not loud else "sensor" if sensor else "alarm", said)
    rights = [{each} | EQUAL.get(each, set()) for each in truth["effect"].split("+")]
    right = frozenset().union(*rights)
    if names & right:
        whole = all(names & each for each in rights)
        word = "named" if whole else "part"
        return Mark(word if names <= right | present(truth) else "wrong", said)
    alike = {name for each in found["equivalent"] for name in each.split(" + ")}
    if alike & right and not found["novel"]:
        return Mark("unsure", said)
    if not loud or (names and names <= present(truth) and not found["novel"]):
        unseen = truth["visible"] < UNSEEN
        unsure = found["verdict"] == "cannot_tell"
        return Mark("unseen" if unseen else "unsure" if unsure else "missed", said)
    return Mark("wrong", said)


def present(truth: dict[str, Any]) -> frozenset[str]:
    """Errors of the sensors that are there although the leg obeys Eq. 9."""
    noise = truth["velocity_noise_rad_s"]
    biased = noise is not None and abs(truth["errors"]["bias"]) > SEEN_BIAS * noise
    return (
        (SENSORS if truth["systematic"] else frozenset())
        | (DRIFT if truth["trouble"] == "drift" else frozenset())
        | (WANDER if stands_still(truth) else frozenset())
        | (frozenset({"gyro_bias"}) if biased else frozenset())
    )


def stands_still(truth: dict[str, Any]) -> bool:
    """Is a hum of the mains sampled at its own rate, or a part of it?"""
    if truth["trouble"] != "hum":
        return False
    return any(each % truth["device"]["rate"] == 0 for each in MAINS)
