"""What gyros and encoders usually differ by is told as no fault; anything more is one."""

from dataclasses import replace

import numpy as np
import pytest
from diagnosis_by_hand import found, nothing, novel

from exoid.mismatch.answer.diagnosis import Finding, Parameter
from exoid.report.words.diagnosis.asserted import only_usual
from exoid.report.words.diagnosis.sentences import sentences
from exoid.report.words.diagnosis.verdict import headline, verdict

BIAS = float(np.radians(0.6))


def finding(name):
    return Finding(name, name.replace("_", " "), "It has a reason.", "a data sheet")


def of_gyro(scale=0.004, bias=BIAS, **changes):
    """A scale and a bias of the gyro, after which only noise is left."""
    chosen = replace(found().best, terms=["gyro_scale"], mean_square=1.01)
    known = replace(
        found(),
        findings=[finding("gyro_scale"), finding("gyro_bias")],
        parameters=[
            Parameter("gyro_scale.scale", scale, "1", 0.0024),
            Parameter("gyro_bias.bias", bias, "rad/s", 1e-4),
        ],
        equivalent=["gyro_scale", "clock_rate"],
        best=chosen,
        singles=[chosen],
        pairs=[],
    )
    return replace(known, **changes)


def test_the_first_sentence_says_that_nothing_of_the_leg_is_missing():
    one = of_gyro()
    said = "Nothing of the leg is missing: gyro and encoder differ by 0.4 % in scale and 0.6 deg/s"
    assert headline(one).startswith(said)
    assert verdict(one) == headline(one)
    lines = sentences(one)
    assert "Missing" not in lines
    assert "Where" not in lines
    assert lines["Found"].endswith("or rate of the clock, which would look exactly alike")
    assert "no fault" in lines["Reason"]
    assert "Record next" not in sentences(replace(one, advice=["To tell drag apart: swing."]))
    assert one.verdict == "mismatch"  # for machines: Eq. 9 alone does not explain the recording


@pytest.mark.parametrize(("sign"), [-1.0, 1.0])
@pytest.mark.parametrize(
    ("scale", "bias", "usual"),
    [(0.029, 0.0, True), (0.031, 0.0, False), (0.0, 9.9, True), (0.0, 10.1, False)],
)
def test_two_standard_deviations_over_gyros_are_usual(sign, scale, bias, usual):
    assert only_usual(of_gyro(sign * scale, sign * np.radians(bias))) == usual


@pytest.mark.parametrize(
    "other",
    [
        of_gyro(equivalent=["gyro_scale", "gyro_scale + quadratic_drag"]),
        of_gyro(equivalent=["gyro_scale", "polycentric_axis"]),
        of_gyro(best=replace(found().best, terms=["gyro_scale"], mean_square=3.0)),
        of_gyro(verdict="cannot_tell"),
        found(),
        nothing(),
        novel(),
    ],
)
def test_what_leaves_more_or_may_be_of_the_leg_is_not_called_usual(other):
    assert not only_usual(other)
