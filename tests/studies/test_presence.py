"""Of whom a study has values, and of whom not: every value counts, and who is missing is said."""

import numpy as np
import pandas as pd
import pytest
from benchmarks.studies.tables import Design, Truth, simulate

from exoid.fitting.misfit.missed import Missed
from exoid.fitting.result.remarks.residual_remarks import of_missed
from exoid.studies.page.parts.presence import lacking
from exoid.studies.page.parts.words import finding
from exoid.studies.page.sections.summary import amount
from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Asked
from exoid.studies.statistics.groups import Comparison
from exoid.studies.statistics.tables.study import study_of
from exoid.studies.statistics.tables.values import values_of

ENDED = "the recording ended {} s before rest"


@pytest.fixture(scope="module")
def study():
    """Ten people of each group, of very different indices."""
    return simulate(Design(people=20, days=1, drops=2, truths=(Truth(effect=-0.6),)), 0)


def some_failed(study):
    """The fits of seven spastic people do not follow; their drops were measured."""
    spastic = sorted(spastic_of(study))[:7]
    astray = study.recordings["participant"].isin(spastic)
    status = np.where(astray, "failed", "ok")
    samples = np.full(len(status), 1000.0)
    return study.recordings.assign(status=status, samples=samples), spastic


def spastic_of(study):
    rows = study.recordings
    return {*rows.loc[rows["participant_group"] == "spastic", "participant"]}


def people_of(study):
    return {*study.recordings["participant"]}


def test_drops_count_where_only_the_fit_of_their_recording_failed(study):
    recordings, _ = some_failed(study)
    whole = ask(study, Asked(by="group"))
    found = ask(study_of(recordings, study.quantities), Asked(by="group"))
    differences = [each.each[0].groups for each in (found, whole)]
    assert all(isinstance(each, Comparison) for each in differences)
    assert vars(differences[0]) == vars(differences[1])
    assert "It rests on 10 of 10 control and 10 of 10 spastic people." in finding(found)
    assert amount(found) == "20 people, 40 recordings read"


def test_who_is_missing_is_said_with_the_finding_where_groups_differ_in_it(study):
    recordings, lost = some_failed(study)
    rows = study.quantities
    fewer = study_of(
        recordings.assign(samples=np.where(recordings["status"] == "failed", np.nan, 1000.0)),
        rows[~rows["participant"].isin(lost)],
    )
    answers = ask(fewer, Asked(by="group"))
    said = finding(answers)
    assert "It rests on 10 of 10 control and 3 of 10 spastic people" in said
    assert f"missing: {', '.join(lost[:5])} and 2 more" in said
    assert "may bias the difference" in said
    assert amount(answers) == "13 people, 26 recordings read"


def test_recordings_that_are_missing_of_people_who_are_there_are_counted(study):
    gone = study.recordings.loc[study.recordings["side"] == "right", "recording"][:8]
    rows = study.quantities[~study.quantities["recording"].isin(gone)]
    said = finding(ask(study_of(study.recordings, rows), Asked(by="group")))
    assert "8 of 40 recordings without a value: left 0 of 20, right 8 of 20" in said


def test_values_that_are_missing_are_told_with_their_reason_and_where(study):
    rows = study.quantities.copy()
    lost = rows.index[
        rows["participant"].isin(spastic_of(study)) & (rows["quantity"] == "relaxation_index")
    ][::4]
    rows.loc[lost, "value"] = np.nan
    rows.loc[lost, "note"] = [ENDED.format(at / 10) for at in range(len(lost))]
    found = ask(study_of(study.recordings, rows), Asked(by="group"))
    lost_values = "10 of 80 values are missing: control 0 of 40, spastic 10 of 40"
    assert lost_values in finding(found)
    (said,) = [one for one in lacking(found.each[0]) if lost_values in one]
    assert said.endswith("mostly as here: the recording ended 0.0 s before rest.")


def test_nothing_is_said_to_be_missing_where_all_is_there(study):
    said = finding(ask(study, Asked()))
    assert "It rests on 20 of 20 people." in said
    assert "missing" not in said
    assert "bias" not in said


def fitted(study, missing):
    """As if indices were fitted, and the fits of these people said that they miss something."""
    rows = study.quantities.assign(step="fit", segment=-1)
    rows = rows.drop_duplicates(["recording", "quantity"])
    of = rows[rows["participant"].isin(missing)].drop_duplicates("recording")
    missed = Missed("torque", 0.1, 1e3, 1.0, 0.0)
    (said,) = of_missed(missed, "the residual", 27.0, None, 1.0)
    notes = of.assign(quantity="note", value=np.nan, note=said, determined_by="")
    return study_of(study.recordings, pd.concat([rows, notes], ignore_index=True))


def test_fits_that_miss_something_in_one_group_are_told_with_the_difference(study):
    rubbing = sorted(spastic_of(study))[:4]
    told = "8 of 40 values are of fits whose model misses something: control 0 of 20, spastic 8 of"
    answers = ask(fitted(study, rubbing), Asked(by="group"))
    assert told in finding(answers)
    assert "--with has a cause in the model of all" in finding(answers)
    assert any(told in each for each in lacking(answers.each[0]))
    # One of twenty in either group is as it may be.
    both = [sorted(each)[0] for each in (spastic_of(study), people_of(study) - spastic_of(study))]
    assert "misses something" not in finding(ask(fitted(study, both), Asked(by="group")))
    assert "misses something" not in finding(ask(fitted(study, rubbing), Asked()))
    assert "misses something" not in finding(ask(study, Asked(by="group")))


def test_where_a_diagnosis_found_what_a_fit_misses_its_value_counts(study):
    rubbing = sorted(spastic_of(study))[:4]
    plain = fitted(study, rubbing)
    rows = plain.quantities
    of = rows["participant"].isin(rubbing) & (rows["quantity"] == "relaxation_index")
    lost = rows[of].index[0]  # whose fit did not follow
    found = rows[of].assign(step="diagnose", value=9.0)
    rows = rows.assign(value=rows["value"].where(rows.index != lost))
    both = study_of(plain.recordings, pd.concat([rows, found], ignore_index=True))
    values = values_of(both, "relaxation_index")
    assert {*values.frame.loc[values.frame["value"] == 9.0, "person"]} == {*rubbing}
    assert len(values.frame) == 40
    told = "8 of 40 values are of a model with what a diagnosis found missing."
    assert values.notes == (told,)
    assert "misses something" not in finding(ask(both, Asked(by="group")))
