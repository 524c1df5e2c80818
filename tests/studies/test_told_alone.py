"""What anatomy told of most legs is compared of none, and what is missing is counted once."""

import numpy as np
import pytest
from benchmarks.studies.tables import Design, Truth, simulate

from exoid.studies.page.parts.presence import biased, lacking
from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Asked
from exoid.studies.statistics.presence import Count, by_chance
from exoid.studies.statistics.tables.said import NotTold
from exoid.studies.statistics.tables.study import study_of
from exoid.studies.statistics.tables.values import values_of

QUANTITY = "relaxation_index"


@pytest.fixture(scope="module")
def study():
    """Eighty values, two of each leg."""
    return simulate(Design(people=20, days=1, drops=2, truths=(Truth(),)), 0)


def determined(study, alone: int, others: str):
    """So many values are told by recordings alone."""
    by = np.where(np.arange(len(study.quantities)) < alone, "recording", others)
    return study_of(study.recordings, study.quantities.assign(determined_by=by))


@pytest.mark.parametrize("others", ["prior", "both", "bound"])
def test_a_quantity_that_most_recordings_leave_to_the_prior_is_not_compared(study, others):
    few = determined(study, 20, others)
    with pytest.raises(NotTold, match=r"no recording told them, or only in part.*known mass"):
        values_of(few, QUANTITY)
    answers = ask(few, Asked(by="group"))
    assert not [each for each in answers.each if each.quantity == QUANTITY]
    assert QUANTITY in answers.silent


def test_values_that_rest_partly_on_anatomy_do_not_enter_and_are_not_counted(study):
    rows = study.quantities
    count = int(rows["quantity"].eq(QUANTITY).sum()) - 10
    (each,) = ask(determined(study, count, "both"), Asked(quantities=(QUANTITY,))).each
    assert len(each.values.frame) <= count
    assert each.presence.values.every.told == len(each.values.frame)
    assert "left out: they rest partly on anatomy" in each.values.notes[0]


def test_shares_differ_only_where_an_exact_test_tells_it():
    # Fisher's exact test: of 1 of 39 and 4 of 40, p = 0.36; of 0 of 20 and 8 of 20, 0.0033.
    assert by_chance([Count(38, 39), Count(36, 40)]) == pytest.approx(0.36, abs=0.005)
    assert by_chance([Count(20, 20), Count(12, 20)]) == pytest.approx(0.0033, abs=5e-5)


def test_a_recording_without_a_value_is_counted_once(study):
    rows = study.quantities
    lost = [*study.recordings["recording"][:3]]
    gone = rows.assign(value=rows["value"].where(~rows["recording"].isin(lost)))
    (each,) = ask(study_of(study.recordings, gone), Asked(by="group")).each
    assert [*lacking(each)] == ["3 of 40 recordings without a value."]
    assert [*biased(each)] == []
