"""What the prompt and a notebook show of a result: short, escaped, and a frame for pandas."""

import numpy as np
import pytest
from diagnosis_by_hand import doubtful, found, nothing
from test_fit_json import fitted


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


@pytest.mark.parametrize("diagnosis", [found(), nothing(), doubtful()])
def test_a_diagnosis_is_shown_in_few_lines(diagnosis):
    assert repr(diagnosis).startswith("Diagnosis: ")
    assert len(repr(diagnosis)) < 1000
    for each in diagnosis.findings:
        assert each.title in repr(diagnosis)
        assert each.title in diagnosis._repr_html_()
    assert "ndarray" not in repr(diagnosis)
