"""Visits whose sides are exchanged: who and when is told, and nobody else."""

import numpy as np
import pandas as pd
import pytest
from benchmarks.studies.tables import Design, Truth, simulate

from exoid.studies.page.document import study_document
from exoid.studies.page.parts.opening import opening
from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Asked
from exoid.studies.statistics.tables.study import study_of
from exoid.studies.statistics.tables.values import Values
from exoid.studies.statistics.visits.exchanged import Exchanged, exchanged, verdicts

WHO = "sub-005"


@pytest.fixture(scope="module")
def studies():
    """Of two visits and of three: legs of a person differ by seven times what days scatter."""
    truth = Truth(bad=0.0, side=0.25, side_on_day=0.03, drop=0.02)
    return {days: simulate(Design(people=20, days=days, truths=(truth,)), 4) for days in (2, 3)}


def turned(study, person, session):
    """The names of both sides exchanged at one visit."""
    return study_of(
        *(
            table.assign(
                side=table["side"].where(
                    (table["participant"] != person) | (table["session"] != session),
                    table["side"].map({"left": "right", "right": "left"}),
                )
            )
            for table in (study.recordings, study.quantities)
        )
    )


def with_legs(study, person, by):
    """The right leg of a person differs by so much more from the left."""
    rows = study.quantities
    own = (rows["participant"] == person) & (rows["side"] == "right")
    return study_of(
        study.recordings, rows.assign(value=rows["value"].where(~own, rows["value"] + by))
    )


def test_a_sound_study_has_no_visit_that_is_exchanged(studies):
    for study in studies.values():
        assert exchanged(study) == ()
        assert exchanged(with_legs(study, WHO, 1.0)) == ()


def test_of_two_visits_either_may_be_exchanged_and_person_and_visits_are_named(studies):
    study = turned(with_legs(studies[2], WHO, 1.0), WHO, "day2")
    assert exchanged(study) == (Exchanged(WHO, ("day1", "day2")),)
    answers = ask(study, Asked())
    (said,) = [each for each in opening(answers) if "exchanged" in each]
    assert said.startswith(f"{WHO}: left and right of one of the visits day1, day2 look exchanged")
    assert study_document(answers)["sides_exchanged"][0]["person"] == WHO


def test_of_three_visits_the_one_that_is_exchanged_is_named(studies):
    study = turned(with_legs(studies[3], WHO, 1.0), WHO, "day3")
    assert exchanged(study) == (Exchanged(WHO, ("day3",)),)


def test_a_leg_that_changed_and_legs_that_are_alike_are_not_called_exchanged(studies):
    study = studies[2]
    rows = study.quantities
    own = (rows["participant"] == WHO) & (rows["side"] == "right") & (rows["session"] == "day2")
    better = rows.assign(value=rows["value"].where(~own, rows["value"] + 1.0))
    assert exchanged(study_of(study.recordings, better)) == ()
    # The legs of this person differ by what days scatter: an exchange changes nothing.
    means = rows[rows["participant"] == WHO].groupby("side")["value"].mean()
    alike = with_legs(study, WHO, float(means["left"] - means["right"]))
    assert exchanged(turned(alike, WHO, "day2")) == ()


PEOPLE, VISITS = 40, 2


def heavy(draw):
    """Values of one sound study in which legs differ, and visits scatter as t with three degrees of
    freedom does: by the day, and by the leg.
    """
    apart = draw.normal(0.0, 5.0, (PEOPLE, 1))
    legs = np.stack([apart / 2, -apart / 2], axis=1)
    day = draw.standard_t(3, (PEOPLE, 1, VISITS))
    found = legs + day + draw.standard_t(3, (PEOPLE, 2, VISITS))
    rows = [
        (f"p{who:02d}", side, f"day{visit}", found[who, at, visit], 0.1)
        for who in range(PEOPLE)
        for at, side in enumerate(("left", "right"))
        for visit in range(VISITS)
    ]
    columns = ["person", "side", "session", "value", "error"]
    return Values("damping", "1/s", pd.DataFrame(rows, columns=columns))


def test_visits_that_scatter_with_heavy_tails_are_not_called_exchanged():
    # One of these 20 has one by a rule of normal scatter, and by this one at a chance of 5e-3.
    draw = np.random.default_rng(4)
    assert not any(1 in verdicts(heavy(draw)).values() for _ in range(20))
