"""The person who alone makes most of what days differ by is named, and else nobody."""

from benchmarks.studies.tables import Design, Truth, simulate

from exoid.studies.statistics.reliability import reliability
from exoid.studies.statistics.tables.study import study_of
from exoid.studies.statistics.tables.values import values_of
from exoid.studies.statistics.visits.standing_out import standing_out

TRUTH = Truth(bad=0.0)
WHO = "sub-003"


def test_who_makes_most_of_the_scatter_is_named_and_of_sound_people_nobody():
    for seed in range(5):
        study = simulate(Design(people=12, drops=2, truths=(TRUTH,)), seed)
        rows = study.quantities
        assert standing_out(values_of(study, TRUTH.quantity)) == ""
        one = (rows["participant"] == WHO) & (rows["session"] == "day2")
        off = rows.assign(value=rows["value"].where(~one, rows["value"] + 1.0))
        values = values_of(study_of(study.recordings, off), TRUTH.quantity)
        assert standing_out(values) == WHO
    assert WHO in reliability(values).notes[0]
