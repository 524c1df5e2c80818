"""Which drops pass the threshold of a stretch reflex, and from which angle on a drop does."""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from jaxtyping import Float

from exoid.fitting.model.coordinates import Shared
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.parameter import declarations
from exoid.physics.terms.muscle.stretch_reflex import StretchReflex

PLAIN = f"To tell {StretchReflex.title} apart: {StretchReflex.isolate}."
FALL = np.linspace(-np.pi / 2, 0.0, 2001)  # rad, from hanging to level
WHOLLY = 0.99  # damped, at most
LOWER = np.radians(5.0)  # rad, by which a drop must begin lower to stay below for sure

Angles = Float[np.ndarray, " drop"]  # rad
Rates = Float[np.ndarray, " drop"]  # rad/s


@dataclass(frozen=True)
class Drop:
    """One that was recorded."""

    name: str
    start: Annotated[float, "rad"]
    fastest: Annotated[float, "rad/s"]  # while flexing


def with_threshold(said: list[str], prepared: PreparedRecording, each: list[Optimum]) -> list[str]:
    """The advice, with what drops are worth beside a reflex whose threshold is known."""
    reflex = next((one for one in each if StretchReflex in one.candidate.terms), None)
    passive = all(one.kind == "passive" for one in prepared.problem.movements)
    if reflex is None or PLAIN not in said or not passive:
        return said
    shared = prepared.coordinates(reflex.candidate).shared
    threshold = threshold_of(reflex)
    told = of_drops(drops_of(prepared), threshold, passing_from(shared, threshold))
    return [told if one == PLAIN else one for one in said]


def threshold_of(reflex: Optimum) -> float:
    values = reflex.candidate.values[reflex.candidate.terms.index(StretchReflex)]
    names = [name for name, _ in declarations(StretchReflex)]
    return float(values[names.index("threshold")])


def drops_of(prepared: PreparedRecording) -> list[Drop]:
    """Where each began, and how fast it flexed, as the sensors show it."""
    movements = prepared.problem.movements
    return [
        Drop(one.name, float(shown.angle[0]), float(-shown.angular_velocity.min()))
        for one, shown in zip(movements, prepared.sensors.references, strict=True)
    ]


def fastest_from(start: Angles, shared: Shared) -> Rates:
    """The fastest flexion [rad/s] of drops by Eq. 9, without any reflex.

    v^2 / 2 = U(start) - U(rest), U = g sin phi + c phi^2 / 2 over J; damping takes what it takes
    of a linear oscillator, exp(-zeta acos(zeta) / sqrt(1 - zeta^2)).
    """
    gravity, stiffness = float(shared.gravity), float(shared.stiffness)
    rest = rest_of(gravity, stiffness)
    fall = gravity * (np.sin(start) - np.sin(rest)) + stiffness * (start**2 - rest**2) / 2
    natural = np.sqrt(stiffness - gravity * np.sin(rest))
    zeta = min(float(shared.damping) / (2 * natural), WHOLLY)
    lost = np.exp(-zeta * np.arccos(zeta) / np.sqrt(1 - zeta**2))
    return np.sqrt(2 * np.maximum(fall, 0.0)) * lost


def rest_of(gravity: float, stiffness: float) -> float:
    """Where g cos phi + c phi = 0 [rad], over J: it rises from hanging to level."""
    return float(np.interp(0.0, gravity * np.cos(FALL) + stiffness * FALL, FALL))


def passing_from(shared: Shared, threshold: float) -> float | None:
    """The lowest angle from which a drop passes the threshold [rad]; None where none does."""
    rest = rest_of(float(shared.gravity), float(shared.stiffness))
    starts = FALL[rest < FALL]
    fastest = fastest_from(starts, shared)
    return None if fastest[-1] <= threshold else float(np.interp(threshold, fastest, starts))


def of_drops(drops: list[Drop], threshold: float, lowest: float | None) -> str:
    """What to record beside these drops, in a sentence."""
    limit = f"its threshold of {np.degrees(threshold):.0f} deg/s"
    below = [one.name for one in drops if one.fastest < threshold]
    if lowest is not None:
        limit += f", which the leg passes in drops from about {np.degrees(lowest):.0f} deg on"
    if below:
        which = f"segment {', '.join(below)} stayed below {limit}"
        told = f"{which}, the others passed it: record both kinds again, with EMG"
    elif lowest is None:
        return PLAIN
    else:
        starts = f"from {np.degrees(min(one.start for one in drops)):.0f} deg and higher"
        low = f"{np.degrees(lowest - LOWER):.0f} deg or lower"
        told = f"all drops here, {starts}, passed {limit}: add some from {low}; EMG"
    return f"To tell {StretchReflex.title} apart: {told}."
