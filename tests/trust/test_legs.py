"""Recordings of different legs that were joined by mistake."""

import pytest
from numpy import radians

from exoid.fitting.estimate import fit
from exoid.trust.legs import strangers
from exoid.twin.motion import Movement
from fit_cases import DROP, LOADED, recorded

LOW = Movement(radians(-35), 2.3)


def said(*recordings):
    names = "abc"
    return strangers(fit(list(zip(names, recordings, strict=False)), multistart=2))


@pytest.fixture(scope="module")
def first():
    return recorded(DROP, LOW)


@pytest.mark.parametrize(
    ("other", "symbol"),
    [
        ({"damping": 0.5}, "d / J"),
        pytest.param({"stiffness": 3.4}, "c / J", marks=pytest.mark.proof),
    ],
)
def test_another_leg_is_noticed_and_named_with_what_differs(first, other, symbol):
    (sentence,) = said(first, recorded(DROP, LOW, seed=1, **other))
    assert sentence.startswith("a and b do not look like one leg")
    assert symbol in sentence


@pytest.mark.proof
def test_the_one_that_is_of_another_leg_is_in_every_sentence(first):
    sentences = said(first, recorded(DROP, LOW, seed=1, damping=0.5), recorded(DROP, LOW, seed=2))
    assert [each[:7] for each in sentences] == ["a and b", "b and c"]


@pytest.mark.proof
def test_a_loaded_recording_of_another_leg_is_noticed(first):
    assert len(said(first, recorded(LOADED, LOADED, seed=1, damping=0.5))) == 1


def test_the_same_leg_on_another_day_is_no_stranger(first):
    assert said(first, recorded(DROP, LOW, seed=1)) == []
    assert said(first, recorded(LOADED, LOADED, seed=1)) == []
    # One per cent is less than what a leg changes by in a night.
    assert said(first, recorded(DROP, LOW, seed=1, damping=0.3333)) == []


def test_one_recording_has_nobody_to_differ_from(first):
    assert said(first) == []


@pytest.mark.proof
def test_legs_that_a_moved_sensor_could_nearly_join_are_noticed(first):
    """All ratios differ by less than a tenth: each is explained alone, both are not together."""
    other = recorded(DROP, LOW, seed=1, damping=0.35, stiffness=2.75)
    (sentence,) = said(first, other)
    assert "but not both together, however they were mounted" in sentence
