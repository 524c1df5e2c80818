"""What is asked of two tables, sound and unsound: an answer, or a sentence why there is none."""

import numpy as np
import pandas as pd
import pytest
from benchmarks.studies.tables import Design, Truth, simulate

from exoid.studies.statistics.agreement import Agreement
from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Asked
from exoid.studies.statistics.groups import Comparison
from exoid.studies.statistics.physics import missing_physics
from exoid.studies.statistics.reliability import Reliability
from exoid.studies.statistics.tables.said import NotTold, Untold
from exoid.studies.statistics.tables.study import Study, open_study, study_of
from exoid.studies.statistics.tables.values import per_person, values_of

SMALL = Design(people=12, drops=2)
TWO = (Truth(), Truth("period", "s", 1.1, 0.05, 0.02, 0.02, 0.01, 0.01, 0.01, effect=0.0))


@pytest.fixture(scope="module")
def study():
    return simulate(SMALL, 0)


def changed(study, **columns):
    """The same study with other columns of its quantities."""
    return study_of(study.recordings, study.quantities.assign(**columns))


def test_everything_is_answered_of_a_sound_study():
    found = ask(simulate(Design(people=16, drops=2, truths=TWO), 0), Asked(by="group"))
    assert [each.quantity for each in found.each] == ["relaxation_index", "period"]
    for each in found.each:
        assert isinstance(each.reliability, Reliability)
        assert isinstance(each.sides, Agreement)
        assert isinstance(each.groups, Comparison)
        assert each.change is None
    raw = [each.groups.p for each in found.each]
    corrected = [each.corrected["groups"] for each in found.each]
    assert min(corrected) == pytest.approx(min(2 * min(raw), 1.0))  # Holm's, of two


def test_primary_quantities_are_corrected_among_themselves_and_lead():
    three = (*TWO, Truth("time_to_rest", "s", 3.0, 0.1, 0.02, 0.02, 0.01, 0.01, 0.01, effect=0.0))
    study = simulate(Design(people=16, drops=2, truths=three), 0)
    found = ask(study, Asked(by="group", primary=("period",)))
    assert found.each[0].quantity == "period"
    first, *others = found.each
    assert first.corrected["groups"] == first.groups.p
    raw = [each.groups.p for each in others]
    assert min(each.corrected["groups"] for each in others) == pytest.approx(min(2 * min(raw), 1.0))
    assert [each.among["groups"] for each in found.each] == [1, 2, 2]
    with pytest.raises(ValueError, match="'inertial': the results have no such quantity"):
        ask(study, Asked(primary=("inertial",)))


def test_what_changes_between_sessions_is_no_test_and_retest():
    shifted = simulate(Design(people=16, drops=2, truths=(Truth(shift=0.3),)), 0)
    found = ask(shifted, Asked(by="group", before="day1", after="day2")).each[0]
    assert isinstance(found.change, Agreement)
    # Days of 16 people scatter by 0.07: the mean of differences by 0.1 / 4.
    assert found.change.difference.value == pytest.approx(0.3, abs=4 * 0.025)
    assert isinstance(found.reliability, Untold)
    assert "'day2' does not count" in found.reliability.why
    assert isinstance(found.change_by_group, Comparison)
    assert found.change_by_group.p > 0.001  # both groups changed alike


def test_each_leg_and_day_counts_the_same_however_many_drops_it_has(study):
    values = values_of(study, "relaxation_index")
    person = values.frame[values.frame["person"] == "sub-000"]
    kept = values.frame.drop(person.index[:1])
    fewer = per_person(type(values)(values.quantity, values.unit, kept))
    legs = kept[kept["person"] == "sub-000"].groupby(["side", "session"])["value"].mean()
    expected = legs.groupby("side").mean().mean()
    assert fewer.loc["sub-000", "value"] == pytest.approx(expected)


@pytest.mark.parametrize(
    ("asked", "word"),
    [
        (Asked(quantities=("inertie",)), "'inertie': the results have no such quantity"),
        (Asked(by="grp"), "There is: group, dose, age_years, body_mass_kg"),
        (Asked(before="day1", after="day9"), "'day9': the results have no such session"),
        (Asked(before="day1"), "name both"),
        (Asked(task="walk"), "no such task. They have none."),
    ],
)
def test_a_name_that_is_not_there_is_told_with_those_that_are(study, asked, word):
    with pytest.raises(ValueError, match=word):
        ask(study, asked)


def pathological():
    """Studies that tell little, each with what is said of it."""
    study = simulate(SMALL, 0)
    one = study.recordings["participant"] == "sub-000"
    who = study.quantities["participant"] == "sub-000"
    yield "one person", Study(study.recordings[one], study.quantities[who]), "0 people|1 people"
    yield "one session", simulate(Design(people=8, days=1, drops=2), 0), "0 people have values"
    yield "constant", changed(study, value=1.5), "do not vary"
    yield "no drops", changed(study, value=np.nan), "No quantity has values"
    yield "one group", simulate(Design(people=8, groups=1, drops=2), 0), "value are of one group"
    yield "one side", simulate(Design(people=8, sides=1, drops=2), 0), "No value is of the side"
    yield "nobody", changed(study, participant=""), "name no participant"
    yield "anatomy", changed(study, determined_by="prior"), "no recording told them"
    yield "infinite", changed(study, value=np.inf), "No quantity has values"
    yield "empty", Study(study.recordings[:0], study.quantities[:0]), "No quantity has values"


@pytest.mark.parametrize(("name", "study", "word"), [*pathological()])
def test_a_study_that_tells_little_says_so(name, study, word):
    from exoid.studies.page.parts.words import finding, why_not

    found = ask(study, Asked(by="group" if "participant_group" in study.recordings else ""))
    kinds = ("reliability", "sides", "retest", "groups")
    said = [why for kind in kinds for why in why_not(found, kind).values()]
    said += [*found.silent.values(), finding(found)]
    text = "\n".join(said)
    assert any(part in text for part in word.split("|")), text
    for each in found.each:
        for kind in kinds:
            assert getattr(each, kind) is not None


def test_errors_that_are_not_known_leave_the_scatter(study):
    found = ask(changed(study, standard_error=np.nan), Asked()).each[0]
    assert isinstance(found.reliability, Reliability)
    assert isinstance(found.sides, Agreement)
    assert found.sides.by_error is None


def with_whole(study, of_recording):
    """The study with a value of each whole recording beside those of its drops."""
    drops = study.quantities[study.quantities["step"] == "drops"]
    whole = drops.drop_duplicates("recording").assign(segment=-1)
    mean = drops.groupby("recording")["value"].mean()
    whole["value"] = of_recording(whole["recording"].map(mean))
    return study_of(study.recordings, pd.concat([study.quantities, whole]))


def test_drops_count_where_the_recording_is_their_mean_else_the_recording(study):
    means = values_of(with_whole(study, lambda mean: mean), "relaxation_index").frame
    alone = values_of(study, "relaxation_index").frame
    assert sorted(means["value"]) == sorted(alone["value"])
    fitted = values_of(with_whole(study, lambda mean: 0 * mean + 9.0), "relaxation_index").frame
    assert fitted["value"].tolist() == [9.0] * 48  # recordings
    assert set(fitted["recording"]) == set(alone["recording"])


def test_what_leads_is_asked_first_and_what_is_not_of_a_leg_only_by_name(study):
    rows = study.quantities[study.quantities["step"] == "drops"]
    others = [
        rows.assign(quantity="start_angle", unit="rad"),
        rows,
        rows.assign(quantity="noise_scale", step="fit", determined_by=""),
        rows.assign(quantity="friction", step="diagnose"),
    ]
    found = study_of(study.recordings, pd.concat(others))
    assert found.of_legs == ("relaxation_index", "start_angle")
    asked = ask(found, Asked(quantities=("noise_scale",)))
    assert [each.quantity for each in asked.each] == ["noise_scale"]


def test_of_several_steps_the_first_that_told_a_quantity_counts(study):
    again = study.quantities.assign(step="diagnose", value=9.0)
    both = study_of(study.recordings, pd.concat([again, study.quantities]))
    assert 9.0 not in set(values_of(both, "relaxation_index").frame["value"])


def test_recordings_that_are_there_twice_do_not_count_those_of_a_failed_step_do(study):
    status = ["failed", "duplicate"] + ["ok"] * (len(study.recordings) - 2)
    fewer = study_of(study.recordings.assign(status=status), study.quantities)
    left = values_of(fewer, "relaxation_index").frame["recording"]
    assert set(left) == {*study.recordings["recording"]} - {study.recordings["recording"][1]}


def test_angles_are_told_in_degrees(study):
    turned = values_of(changed(study, unit="rad/s"), "relaxation_index")
    plain = values_of(study, "relaxation_index")
    assert turned.unit == "deg/s"
    for column in ("value", "error"):
        np.testing.assert_allclose(turned.frame[column], np.degrees(plain.frame[column]))
    assert values_of(changed(study, unit="N m/rad"), "relaxation_index").unit == "N m/rad"


def test_units_that_differ_are_refused(study):
    units = np.where(np.arange(len(study.quantities)) % 3 > 0, "1", "rad")
    with pytest.raises(NotTold, match="several units"):
        values_of(changed(study, unit=units), "relaxation_index")


def test_missing_physics_is_counted_by_people_with_wilsons_interval():
    study = simulate(Design(people=20, drops=1, friction=0.5), 1)
    found = missing_physics(study, "participant_group")
    rubs = {each.group: each for each in found if each.name == "dry friction"}
    assert [*rubs] == ["all", "control", "spastic"]
    assert rubs["control"].people == 0
    one = rubs["all"]
    p, n, z = one.people / 20, 20, 1.959964
    centre, half = p + z**2 / (2 * n), z * (p * (1 - p) / n + z**2 / (4 * n**2)) ** 0.5
    wilson = [(centre - half) / (1 + z**2 / n), (centre + half) / (1 + z**2 / n)]
    assert [one.share.low, one.share.high] == pytest.approx(wilson, abs=1e-6)
    assert found[-1].name == "none"  # what names no cause is told last


def test_tables_are_read_as_they_were_written(study, tmp_path):
    study.recordings.to_parquet(tmp_path / "recordings.parquet")
    study.quantities.to_parquet(tmp_path / "quantities.parquet")
    again = open_study(tmp_path)
    pd.testing.assert_frame_equal(again.quantities, study.quantities, check_dtype=False)


def test_a_folder_that_is_no_result_is_told(study, tmp_path):
    with pytest.raises(ValueError, match="no such folder"):
        open_study(tmp_path / "results")
    with pytest.raises(ValueError, match=r"no recordings\.parquet"):
        open_study(tmp_path)
    (tmp_path / "recordings.parquet").write_bytes(b"PAR1 no table")
    with pytest.raises(ValueError, match="no sound Parquet"):
        open_study(tmp_path)
    with pytest.raises(ValueError, match="no column session, side"):
        study_of(study.recordings.drop(columns=["session", "side"]), study.quantities)
    words = study.quantities.assign(value="much")
    with pytest.raises(ValueError, match="words where values belong"):
        study_of(study.recordings, words)
