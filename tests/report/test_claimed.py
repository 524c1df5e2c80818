"""What is claimed where the model with what was found does not follow."""

from dataclasses import replace
from unittest.mock import Mock

import pytest
from diagnosis_by_hand import found

from exoid.mismatch import with_model


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
    monkeypatch.setattr(with_model, "by_eq9", lambda same: same)
    monkeypatch.setattr(with_model, "fit", Mock(side_effect=ArithmeticError))
    said = with_model.with_model(one, [], {}, lambda phase: None)
    assert said.verdict == verdict
    assert bool(said.selected) == said.novel == (verdict == "mismatch")
