"""The cards at the top of a report do not contradict each other."""

from dataclasses import replace
from math import radians

import pytest
from diagnosis_by_hand import doubtful, found, nothing
from page_cases import made_up
from test_fit_json import common

from exoid.fitting.misfit.missed import Missed
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.recordings.conventions.left_out.lost_time import TIME_LOST
from exoid.report.sections.summary import agreement, believed, recording, summary


def told(diagnosis):
    """Answers and words of a report on a fit that leaves more than noise."""
    case = made_up()
    missed = common(Missed("encoder", 0.05, 0.0004, 1.0, 0.0), ["passive", "active"])
    case = replace(case, fit=replace(case.fit, disturbance=missed), diagnosis=diagnosis)
    return " ".join(map(str, summary.blocks(case)))


def test_what_a_diagnosis_finds_no_cause_for_is_not_called_missing():
    said = told(nothing())
    assert "Nearly." in said
    assert "misses something" not in said


@pytest.mark.parametrize("diagnosis", [None, found(), doubtful()])
def test_what_is_missing_or_may_be_is_said_of_every_number(diagnosis):
    said = told(diagnosis)
    assert "Not entirely" in said
    assert "misses something, so no error bar is complete" in said


@pytest.mark.parametrize("seconds", [0.0, 0.53])
def test_a_card_that_says_yes_says_what_was_left_out(seconds):
    case = made_up()
    first, *others = case.fit.segments
    cut = replace(first, left_out=seconds)
    said = str(agreement(replace(case, fit=replace(case.fit, segments=[cut, *others]))))
    assert (f"first 0.53 s behind the release of segment {first.name}" in said) == (seconds > 0)
    assert ("(the first swing, to and fro)" in said) == (seconds > 0)


def test_a_card_says_that_a_hand_ended_a_drop_which_leaves_the_others_good():
    case = made_up()
    first, *others = case.fit.segments
    cut = replace(first, caught=2.07)
    said = str(agreement(replace(case, fit=replace(case.fit, segments=[cut, *others]))))
    behind = "from where a hand, muscle or lost samples end it"
    assert f"Left out: segment {first.name} {behind}." in said
    assert "but for what was left out" not in said


def test_a_rate_is_in_degrees_as_in_the_words_above_the_table():
    case = made_up()
    bias = Estimate("b", "bias", "rad/s", radians(0.6), radians(0.01))
    fit = replace(case.fit, terms={"gyro_bias": {"bias": bias}})
    row = next(row for row in believed(replace(case, fit=fit)).rows if "bias" in row[0])
    assert any("0.600 ± 0.010 deg/s" in cell for cell in row)


@pytest.mark.parametrize("lost", [False, True])
def test_a_recording_is_not_called_whole_where_time_is_lost(lost):
    case = made_up()
    said = f"drops.csv: {TIME_LOST} at 20.63 s, in segment 1" if lost else "nothing"
    source = replace(case.sources[0], notes=(said,))
    told = str(recording(replace(case, sources=(source,))))
    assert ("untimed gap" in told) == lost
