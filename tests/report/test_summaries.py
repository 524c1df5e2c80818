"""What the prompt and a notebook show of a result: short, escaped, and a frame for pandas."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from diagnosis_by_hand import doubtful, found, nothing
from test_fit_json import fitted

from exoid.pendulum.catalogue import MEASURES
from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.studies.dataset.entry import Entry, Participant
from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.kept.measured import Measured
from exoid.studies.engine.kept.quantities import of_fit
from exoid.studies.engine.kept.tables import quantities_table


def test_a_fit_is_shown_a_line_for_each_quantity():
    result = fitted()
    lines = repr(result).splitlines()
    assert lines[0].startswith("FitResult: ")
    assert len(lines) == 1 + len(result.parameters) + len(result.ratios)
    assert len(repr(result)) < 2000
    assert "<table>" in result._repr_html_()


def test_a_fit_is_a_data_frame_with_numbers_in_its_columns():
    pytest.importorskip("pandas")
    result = fitted()
    frame = result.to_dataframe()
    assert [*frame.index] == [*result.parameters, *result.ratios]
    for name, each in (result.parameters | result.ratios).items():
        value = np.nan if each.value is None else each.value
        np.testing.assert_equal(frame.loc[name, "value"], value)
        assert frame.loc[name, "unit"] == each.unit
    assert frame["standard_error"].dtype == np.float64


def test_what_a_slack_angle_leaves_open_is_in_the_prompt_the_frame_and_a_study():
    pytest.importorskip("pandas")
    result = fitted()
    name, each = next((name, one) for name, one in result.ratios.items() if one.value is not None)
    leaning = replace(result, ratios=result.ratios | {name: replace(each, if_slack=1.25)})
    assert "(± 1.2 if slack)" in repr(leaning)
    assert "if slack" not in repr(result)
    frame = leaning.to_dataframe()
    assert frame.loc[name, "if_slack"] == 1.25
    assert frame["if_slack"].notna().sum() == 1
    item = Item(Entry(Path("drops.csv"), "drops.csv"), Participant(""), "", "", 0)
    rows = quantities_table(
        [Measured(item, rows=[*of_fit(replace(leaning, segments=[]))])]
    ).to_pylist()
    assert {row["quantity"]: row["if_slack"] for row in rows if row["if_slack"]} == {name: 1.25}


@pytest.mark.parametrize("diagnosis", [found(), nothing(), doubtful()])
def test_a_diagnosis_is_shown_in_few_lines(diagnosis):
    assert repr(diagnosis).startswith("Diagnosis: ")
    assert len(repr(diagnosis)) < 1000
    for each in diagnosis.findings:
        assert each.title in repr(diagnosis)
        assert each.title in diagnosis._repr_html_()
    assert "ndarray" not in repr(diagnosis)


@pytest.fixture(scope="module")
def pendulum():
    """A drop, and a segment that is none: it ends where it began."""
    time = np.arange(0.0, 8.0, 0.01)
    swing = np.radians(-90 + 70 * np.exp(-0.6 * time) * np.cos(5 * time))
    rise = np.radians(-90 + 40 * (1 - np.cos(2 * np.pi * time / 8)))
    segments = tuple(Segment(time, raw_angle=angle) for angle in (swing, rise))
    return measure_drops(Recording(segments, Subject(kind="leg"), Protocol(kind="passive")))


def test_a_pendulum_test_is_shown_a_line_for_each_average(pendulum):
    lines = repr(pendulum).splitlines()
    assert lines[0] == "PendulumTest: 1 of 2 segments read"
    assert len(lines) == 1 + len(pendulum.average)
    assert all(one.title in pendulum._repr_html_() for one in pendulum.average.values())


def test_a_pendulum_test_is_a_data_frame_with_a_row_for_every_measure_of_every_drop(pendulum):
    pytest.importorskip("pandas")
    frame = pendulum.to_dataframe().set_index(["drop", "measure"])
    assert len(frame) == 2 * len(MEASURES)
    assert frame.loc["0"]["value"].dtype == np.float64
    for name, each in pendulum.drops[0].measures.items():
        value = np.nan if each.value is None else each.value
        np.testing.assert_equal(frame.loc[("0", name), "value"], value)
    assert set(frame.loc["1"]["reason"]) == {pendulum.drops[1].reason}
