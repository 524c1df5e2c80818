"""What strikes takes longest to simulate: it is raced only where it can come near."""

import pytest
from found_by_hand import SAMPLES, explaining, found_of

from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.search import search
from exoid.mismatch.search.search import strikes_in_reach
from exoid.physics.terms.device.backlash import Backlash
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.terms.device.sticking_backlash import StickingBacklash
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.physics.terms.tissue.wobbling_mass import WobblingMass

FEW, MANY = (CoulombFriction, StiffnessRestAngle), (WobblingMass, QuadraticDrag)  # 2, 4 numbers
FIRST_LOOK = [explaining(50_000.0, one) for one in (HardStop, Backlash, StickingBacklash)]


@pytest.mark.parametrize(
    ("pair", "left", "raced"),
    [
        (FEW, 1000.0, {StickingBacklash}),
        (FEW, 1200.0, {StickingBacklash, HardStop, Backlash}),
        (MANY, 1000.0, {StickingBacklash, HardStop}),
    ],
    ids=["two numbers, noise left", "more left", "four numbers, noise left"],
)
def test_beside_a_pair_that_leaves_noise_only_what_needs_hardly_more_numbers(
    pair, left, raced, monkeypatch
):
    """A number costs ln 1000 = 6.9; apart is what is better by 10. A stop has four, play seven."""
    monkeypatch.setattr(search, "yardstick", lambda *_: Yardstick(SAMPLES, 1.0))
    found = found_of([], [explaining(left, *pair)], FIRST_LOOK)
    found.prepared.samples = SAMPLES
    assert {one.candidate.terms[-1] for one in strikes_in_reach(found)} == raced
