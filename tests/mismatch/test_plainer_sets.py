"""What a cause with many numbers explains, several simple ones may explain as well."""

import pytest
from found_by_hand import SAMPLES, explaining, found_of

from exoid.mismatch.search import pairs
from exoid.mismatch.search.pairs import plainer_sets
from exoid.physics.terms.device.torque_bias import TorqueBias
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening
from exoid.physics.terms.tissue.polycentric_axis import PolycentricAxis
from exoid.physics.terms.tissue.wobbling_mass import WobblingMass


@pytest.mark.parametrize(("left", "asks"), [(1000.0, True), (1300.0, False)])
def test_where_only_noise_is_left_simple_causes_take_the_place_of_a_rich_one(
    left, asks, monkeypatch
):
    """A moving axis and a rest angle were told as that axis and a stiffening at the ends."""
    asked = []
    monkeypatch.setattr(pairs, "settle_free", lambda prepared, one: one)
    monkeypatch.setattr(
        pairs, "beside_free", lambda prepared, plain, one: asked.append((one.terms, plain)) or []
    )
    best = explaining(left, EndRangeStiffening, PolycentricAxis)
    prepared = found_of([], [best]).prepared
    prepared.samples = SAMPLES
    plainer_sets(prepared, [CubicStiffness, WobblingMass, TorqueBias], best)
    assert asked == ([((PolycentricAxis,), [CubicStiffness, TorqueBias])] if asks else [])
