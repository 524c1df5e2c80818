"""Recordings of which a diagnosis had once been sure of a wrong name, by others and by exoid."""

import pytest
from benchmarks.blind.deck import deal
from benchmarks.blind.sets import own
from benchmarks.others.write import make

from exoid.mismatch.missing_physics import diagnose
from exoid.recordings.loading.load import load

pytestmark = pytest.mark.proof

SEED = 260
TRUE = {  # what acts; what was named
    92: ({"encoder_eccentricity"}, "a magnet that errs twice per turn"),
    103: ({"stretch_reflex"}, "a fault of exoid"),
    109: (set(), "compliant cuffs, for a hand that let go slowly"),
    140: ({"stretch_reflex"}, "dry friction beside the reflex, for a hand at the end"),
}


@pytest.mark.parametrize("number", TRUE)
def test_nothing_is_named_that_does_not_act(number, tmp_path):
    found = diagnose(load(make(SEED, number, tmp_path, 1)).recording)
    acts, _ = TRUE[number]
    assert set(found.selected) <= acts
    assert not found.novel


def test_a_stop_is_tried_before_something_is_called_new(tmp_path):
    """At 30 Hz a reflex leaves 1.4 times the noise of a soft stop. A formula left less."""
    found = diagnose(load(make(SEED, 175, tmp_path, 1)).recording)
    assert found.selected == ["hard_stop"]


def test_a_scale_of_the_gyro_that_only_a_zero_made_needed_is_not_named():
    """Encoder gain and cubic stiffness: with the gyro's scale in every candidate, an unusual zero
    made up for what the scale did not show, and the scale was asserted.
    """
    number = 56
    card = [*deal(number + 1, SEED)][number]
    assert set(card.effects) == {"cubic_stiffness", "encoder_gain"}
    found = diagnose(own(card, SEED, number).load(), seed=SEED)
    assert "cubic_stiffness" in found.selected
    assert set(found.selected) <= set(card.effects)
