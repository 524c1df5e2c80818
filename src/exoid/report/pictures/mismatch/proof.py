"""Held-out segments as they were predicted, without and with what was found."""

import numpy as np

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.evidence.prediction import Prediction
from exoid.report.pictures.motion import TIME
from exoid.report.pictures.panel import Axis, Band, Line, Panel, Picture
from exoid.report.pictures.role import Role
from exoid.report.words.text import in_degrees

SIZE = 3.2


def proof_of(found: Diagnosis, number: int) -> Panel:
    """Predicted - measured angle [deg] of one segment, of which the fit saw nothing."""
    shown, noise = found.proof, 2 * float(np.degrees(found.proof.noise_floor))
    lines = []
    for role, one in predictions(found).items():
        held_out = one.counted[number]
        left = np.degrees(one.angle[number] - shown.angle[number])
        lines.append(Line(role, shown.time[number][held_out], left[held_out]))
    title = f"segment {found.location.missing[number].segment}"
    marks = (Band(Role.NOISE, -noise, noise), *lines)
    return Panel(TIME, Axis("predicted - measured", "deg"), marks, title, SIZE)


def predictions(found: Diagnosis) -> dict[Role, Prediction]:
    """One where nothing was added to the model."""
    if not found.changed:
        return {Role.HELD_OUT: found.proof.before}
    return {Role.BEFORE: found.proof.before, Role.AFTER: found.proof.after}


def show_proof(found: Diagnosis, number: int) -> Picture:
    segment = found.location.missing[number].segment
    said = " and ".join(
        f"{in_degrees(float(one.rmse[number]))} deg {role.title.partition(',')[0]}"
        for role, one in predictions(found).items()
    )
    return Picture(
        f"proof-{number}",
        f"Predicted minus measured angle of held-out segment {segment} in deg over time in s: an "
        f"RMSE of {said}.",
        f"Segment {segment}: RMSE {said}. Grey band: twice the noise of the sensor.",
        (proof_of(found, number),),
        "whole",
    )
