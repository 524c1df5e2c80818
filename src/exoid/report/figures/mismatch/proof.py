"""Held-out segments as they were predicted, without and with what was found."""

from typing import Any

import numpy as np

from exoid.mismatch.answer.diagnosis import Diagnosis
from exoid.mismatch.evidence.proof import Prediction
from exoid.report.figures.figure import Figure
from exoid.report.figures.style import (
    BAND,
    RESIDUAL_LINE,
    blank,
    curve,
)
from exoid.report.plots.diagnosis import AFTER, BEFORE
from exoid.report.words.text import in_degrees

HEIGHT = 280  # pixels
AFTER_LINE = {"color": AFTER["color"], "width": 1.8, "dash": "6px,3px"}


def draw_proof(found: Diagnosis, number: int) -> Figure:
    """Predicted - measured angle [deg] of one segment, of which the fit saw nothing."""
    shown, time = found.proof, found.proof.time[number]
    drawing = blank(HEIGHT, hovermode="x unified")
    noise = 2 * float(np.degrees(found.proof.noise_floor))
    drawing.add_hrect(-noise, noise, **BAND)
    both = predictions(found)
    for name, one, line in both:
        held_out = one.counted[number]
        left = np.degrees(one.angle[number] - shown.angle[number])[held_out]
        look = {"name": name, "line": line, "hovertemplate": "%{y:.3f} deg"}
        curve(drawing, time[held_out], left, **look)
    drawing.update_xaxes(title_text="time [s]", hoverformat=".2f")
    drawing.update_yaxes(title_text="predicted - measured [deg]")
    segment = found.location.missing[number].segment
    said = " and ".join(
        f"{in_degrees(float(one.rmse[number]))} deg {name.partition(',')[0]}"
        for name, one, _ in both
    )
    return Figure(
        f"proof-{number}",
        f"Predicted minus measured angle of held-out segment {segment} in deg over time in s: an "
        f"RMSE of {said}.",
        f"Segment {segment}: RMSE {said}. Grey band: twice the noise of the sensor.",
        drawing,
        "whole",
    )


def predictions(found: Diagnosis) -> list[tuple[str, Prediction, dict[str, Any]]]:
    """Names, predictions and lines: one where nothing was added to the model."""
    shown = found.proof
    if not found.changed:
        return [("held out", shown.before, RESIDUAL_LINE)]
    return [
        (BEFORE["label"], shown.before, RESIDUAL_LINE),
        (AFTER["label"], shown.after, AFTER_LINE),
    ]
