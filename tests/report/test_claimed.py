"""What is claimed where the model with what was found does not follow."""

from dataclasses import replace
from unittest.mock import Mock

import pytest
from diagnosis_by_hand import doubtful, found

from exoid.mismatch import with_model
from exoid.mismatch.answer.diagnosis import Parameter, Suspect


@pytest.mark.parametrize(
    ("astray", "verdict"), [("it misses the angle", "cannot_tell"), (None, "mismatch")]
)
def test_a_cause_is_not_claimed_where_neither_model_follows(astray, verdict, monkeypatch):
    one = found()
    one = replace(one, before=replace(one.before, astray=astray), novel=True)
    monkeypatch.setattr(with_model, "just_made", Mock())
    monkeypatch.setattr(with_model, "extended", Mock(return_value=(None,)))
    monkeypatch.setattr(with_model, "leg_of", Mock())
    monkeypatch.setattr(with_model, "likely", Mock(return_value=[]))
    monkeypatch.setattr(with_model, "suspects", Mock(return_value=[]))
    monkeypatch.setattr(with_model, "advice", Mock(return_value=[]))
    monkeypatch.setattr(with_model, "with_threshold", Mock(return_value=[]))
    monkeypatch.setattr(with_model, "by_eq9", lambda same: same)
    monkeypatch.setattr(with_model, "fit", Mock(side_effect=ArithmeticError))
    said = with_model.with_model(one, [], {}, lambda phase: None)
    assert said.verdict == verdict
    assert bool(said.selected) == said.novel == (verdict == "mismatch")


@pytest.mark.parametrize("astray", ["it misses the angle by 2 deg", None])
def test_first_of_the_reasons_is_that_no_model_follows(astray, monkeypatch):
    """That ± covers a rival is no reason then, and whether a hand was there comes first."""
    one = doubtful()
    before = replace(one.before, astray=astray)
    rivals = replace(before, notes=[*before.notes, "± covers that it may be another cause."])
    monkeypatch.setattr(with_model, "just_made", Mock())
    monkeypatch.setattr(with_model, "with_rivals", lambda *_: rivals)
    monkeypatch.setattr(with_model, "by_the_fits", lambda *_: ([], []))
    monkeypatch.setattr(with_model, "astray", lambda _: astray)
    one = replace(one, before=before, after=None, best=replace(one.best, terms=[]))
    told = with_model.by_eq9(one)
    reasons = told.reasons
    first = f"no model here follows the recording: {astray}. A stretch reflex"
    assert reasons[0].startswith(first) == (astray is not None)
    assert (told.advice == [with_model.ALONE]) == (astray is not None)
    assert ("± covers that it may be another cause" in reasons) == (astray is None)


@pytest.mark.parametrize(
    ("astray", "inertia"), [("it misses the angle by 2 deg", 0.45), (None, 0.3)]
)
def test_torques_of_one_answer_go_with_one_inertia(astray, inertia, monkeypatch):
    """The fit has 0.3 kg m^2, the search took 0.45; a fit that does not follow says nothing."""
    one = doubtful()
    leg = {**one.before.parameters}
    leg["inertia"] = replace(leg["inertia"], value=0.3)
    before = replace(one.before, astray=astray, parameters=leg)
    level = Parameter("coulomb_friction.level", 0.45, "N m", 0.01)
    suspects = [Suspect(["coulomb_friction"], [], [level])]
    monkeypatch.setattr(with_model, "just_made", Mock())
    monkeypatch.setattr(with_model, "with_rivals", lambda *_: before)
    monkeypatch.setattr(with_model, "limited_anew", lambda one, _: one)
    monkeypatch.setattr(with_model, "by_the_fits", lambda *_: ([], suspects))
    place = replace(one.location, inertia=0.2)
    told = with_model.by_eq9(replace(one, before=before, location=place, parameters=[level]))
    (suspect,) = told.suspected
    assert told.inertia == told.location.inertia == inertia
    assert suspect.parameters[0].value == told.parameters[0].value == pytest.approx(inertia)
