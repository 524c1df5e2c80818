"""The cards at the top of a report do not contradict each other."""

from dataclasses import replace

import pytest
from diagnosis_by_hand import doubtful, found, nothing
from page_cases import made_up
from test_fit_json import common

from exoid.fitting.misfit.missed import Missed
from exoid.report.sections.summary import summary


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
