"""What a study's report says first: its clearest answers, and that there is none."""

import re
from dataclasses import replace
from io import StringIO

import pandas as pd
import pytest
from benchmarks.studies.tables import Design, Truth, simulate
from html_tree import parse
from rich.console import Console

from exoid.report.parts.origin import Origin
from exoid.studies.page.page import build_page
from exoid.studies.page.parts.opening import in_whom, opening
from exoid.studies.page.parts.part import Told
from exoid.studies.page.parts.words import FEWEST, finding, grade, repeated
from exoid.studies.page.terminal import notes, print_study
from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Asked
from exoid.studies.statistics.physics import Cause
from exoid.studies.statistics.tables.said import Interval
from exoid.studies.statistics.tables.study import study_of

TRUTHS = (
    Truth(effect=-0.6),
    Truth("period", "s", 1.1, 0.05, 0.02, 0.02, 0.01, 0.01, 0.01, effect=0.0),
)

BY_PERIOD = Asked(by="group", primary=("period",))


@pytest.fixture(scope="module")
def study():
    return simulate(Design(people=16, drops=2, truths=TRUTHS), 0)


def said(study, **asked) -> list[str]:
    return opening(ask(study, Asked(**asked)))


def shifted(study, by: float):
    """The right legs differ by so much."""
    rows = study.quantities
    right = (rows["side"] == "right") & (rows["quantity"] == "period")
    moved = rows["value"].where(~right, rows["value"] + by)
    return study_of(study.recordings, rows.assign(value=moved))


def test_groups_that_were_asked_for_come_first_then_repeats_physics_and_failures(study):
    answers = ask(study, Asked(by="group"))
    first, repeats, physics, failed = opening(answers)
    assert first == finding(answers)
    assert re.search(r"lower by .* \(95 % .*\(corrected for 2 quantities: ", first)
    assert re.search(r"ICC\(A,1\): \w+ for relaxation index; \w+ for period\.$", repeats)
    assert physics == "Missing physics, of 64 recordings: nothing was missing in 64."
    assert failed == "None of 64 recordings failed."


def test_where_nothing_was_asked_a_sure_difference_of_sides_comes_first_or_none_is_said(study):
    assert said(study)[0] == "No difference between left and right is sure in any of 2 quantities."
    differ = said(shifted(study, 0.5))[0]
    assert differ.startswith("Period: sides differ on average, right less left is 0.")
    assert differ.endswith("It rests on 16 of 16 people.")


def test_groups_that_cannot_be_compared_say_why(study):
    of_one = study.recordings["participant_group"] == "control"
    kept = study.recordings[of_one]
    rows = study.quantities[study.quantities["recording"].isin(kept["recording"])]
    first = said(study_of(kept, rows), by="group")[0]
    assert first.startswith("All people with a value are of one group: control.")


def test_a_group_without_values_is_counted_with_all_its_people(study):
    """Two controls and one stroke, of one control no value: two controls there are."""
    people = study.recordings.drop_duplicates("participant")
    (lesser, of_one), (other, of_other) = people.groupby("participant_group")["participant"]
    *_, absent = pair = [*of_one.iloc[:2]]
    kept = study.recordings[study.recordings["participant"].isin([*pair, of_other.iloc[0]])]
    rows = study.quantities[study.quantities["recording"].isin(kept["recording"])]
    lost = (rows["participant"] == absent) & (rows["quantity"] == "relaxation_index")
    rows = rows.assign(
        value=rows["value"].where(~lost), note=rows["note"].where(~lost, "cut before rest.")
    )
    first = said(study_of(kept, rows), by="group")[0]
    assert f"People with a value: {lesser} 1, {other} 1; 2 of each group are needed." in first
    known = f"Relaxation index is known of 1 of 2 {lesser} and 1 of 1 {other} people"
    assert f"{known}, and not of {absent}, mostly as here: cut before rest." in first


def test_few_people_do_not_tell_how_well_anything_repeats():
    """Whatever the interval says: of eight people nobody knows how far people differ."""
    few = simulate(Design(people=FEWEST - 1, drops=2, truths=TRUTHS), 0)
    answers = ask(few, Asked())
    repeats = opening(answers)[1]
    assert repeats.startswith(
        "How well one day of one leg tells people apart, 8 people do not tell: at least 9"
    )
    found = [one.reliability for one in answers.each]
    assert {grade(each) for each in found} == {"too few people"}
    assert "a share that 8 people do not tell" in repeated(found[0])


def test_what_an_operator_chooses_leads_no_report():
    order = study_of(*of_quantities("start_angle", "period", "damping_over_inertia")).told
    assert order == ("damping_over_inertia", "period", "start_angle")


def of_quantities(*names):
    """Tables with one value of each."""
    found = simulate(Design(people=3, drops=1, truths=TRUTHS), 0)
    row = found.quantities.iloc[:1]
    return found.recordings, pd.concat([row.assign(quantity=name, value=1.0) for name in names])


def test_a_cause_is_counted_by_recordings_and_by_people():
    interval = Interval(1 / 3, 0.06, 0.79)
    cause = Cause("coulomb_friction", "all", 2, 12, 1, 3, interval)
    assert in_whom(cause) == "coulomb friction in 2, of 1 of 3 people, 33 % (95 % 6 % to 79 %)"
    assert in_whom(replace(cause, name="none", recordings=10)) == "nothing was missing in 10"


def test_what_failed_has_its_most_frequent_reason(study):
    status = ["failed"] * 3 + ["ok"] * (len(study.recordings) - 3)
    reasons = ["fit: it misses by 1 deg.", "empty.", "fit: it misses by 2 deg."]
    reason = [*reasons, *([""] * (len(study.recordings) - 3))]
    recordings = study.recordings.assign(status=status, reason=reason)
    first = recordings["name"].iloc[0]
    told = said(study_of(recordings, study.quantities))[-1]
    assert told == f"3 of 64 recordings failed, 2 of them as {first}: fit: it misses by 1 deg."


def test_one_day_tells_no_repeat_and_an_empty_study_nothing(study):
    day = study.quantities[study.quantities["session"] == "day1"]
    assert "How well they repeat is not told: 0 people" in said(study_of(study.recordings, day))[1]
    empty = said(study_of(study.recordings[:0], study.quantities[:0]))
    assert empty[0] == "No quantity has values that recordings told."


def test_the_page_has_all_of_it_before_anything_else(study):
    answers = ask(study, Asked())
    page = build_page(Told(answers, Origin("exoid study report", "", {}, {}, {}), "results"))
    text = " ".join(parse(page).by_id("summary").text.split())
    places = [text.index(each) for each in opening(answers)]
    assert places == sorted(places)
    assert places[-1] < text.index("Were all recordings read?")


def test_a_question_that_no_recording_told_is_said_before_anything_else(study):
    rows = study.quantities
    told = rows["determined_by"].where(rows["quantity"] != "period", "prior")
    answers = ask(study_of(study.recordings, rows.assign(determined_by=told)), BY_PERIOD)
    first, second, *_ = opening(answers)
    assert first.startswith("Period, which was the question, is not told, and nothing below")
    assert "anatomy" in first
    assert second.startswith("Relaxation index is lower")


def test_the_finding_is_of_a_quantity_that_groups_tell(study):
    rows = study.quantities
    one_group = study.recordings.set_index("recording")["participant_group"] == "control"
    untold = (rows["quantity"] == "relaxation_index") & rows["recording"].map(one_group)
    lost = study_of(study.recordings, rows.assign(value=rows["value"].mask(untold)))
    assert said(lost, by="group")[0].startswith("Period: no difference that is sure between")


def test_somebody_of_no_group_is_named_in_the_terminal(study):
    known = study.recordings["participant_group"].mask(study.recordings["participant"] == "sub-003")
    told = study_of(study.recordings.assign(participant_group=known), study.quantities)
    answers = ask(told, Asked(by="group"))
    assert "1 person left out (sub-003): group is not known." in notes(answers)


def test_the_differences_of_sides_are_read_on_80_columns(study):
    console = Console(width=80, file=StringIO())
    print_study(ask(study, Asked()), console)
    *_, of_sides = console.file.getvalue().partition("right - left")
    for words in ("relaxation index", "period", "quantity", "mean difference", "corrected"):
        assert words in of_sides
