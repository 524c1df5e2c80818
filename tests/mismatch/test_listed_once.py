"""A set of causes is one candidate, whichever way a search came to it."""

from types import SimpleNamespace

import pytest
from found_by_hand import SAMPLES, explaining, found_of

from exoid.cli.inputs.terms import rivals_in
from exoid.mismatch.answer.diagnosis import Suspect
from exoid.mismatch.conclude.asserted import equivalents
from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.search import search
from exoid.mismatch.search.found import best_of
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening


def test_the_order_of_causes_makes_no_other_set():
    first, better = (
        explaining(left, *terms)
        for left, terms in (
            (1200.0, (HardStop, EndRangeStiffening)),
            (1100.0, (EndRangeStiffening, HardStop)),
        )
    )
    assert best_of([first, better]) == best_of([better, first]) == [better]


@pytest.fixture
def searched(monkeypatch):
    """A search in which a set lost all causes but one, which had run free by itself, too."""
    for step in ("nested", "plainer_sets", "simulated", "reduced", "twins"):
        monkeypatch.setattr(search, step, lambda *_: [])
    monkeypatch.setattr(search, "yardstick", lambda *_: Yardstick(SAMPLES, scale=1.0))
    monkeypatch.setattr(search, "hopped", lambda prepared, one: one)
    alone, again = (explaining(each, EndRangeStiffening) for each in (1000.0, 1000.1))
    monkeypatch.setattr(search, "several", lambda *_: [again])
    found = found_of([alone], [explaining(1400.0, EndRangeStiffening, CubicStiffness)])
    found.prepared.common, found.prepared.samples = (), SAMPLES
    return search.with_sets(found, [], lambda _: None)


def test_what_remains_of_a_set_is_no_second_candidate(searched):
    assert [one.candidate.terms for one in searched.singles] == [(EndRangeStiffening,)]
    assert all(len(one.candidate.terms) == 2 for one in searched.pairs)
    assert equivalents(searched, searched.singles[0]) == searched.singles


def test_nothing_is_told_apart_from_itself():
    suspected = [Suspect(["hard_stop"], [])] * 2
    assert rivals_in(SimpleNamespace(suspected=suspected)) == ["hard_stop"]
