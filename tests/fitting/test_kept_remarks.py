"""What is said of drops that count only up to where a hand seems to end them."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.movements import movements_of
from exoid.fitting.result.remarks.stopped_remarks import of_kept
from hands import dropped


@pytest.fixture(scope="module")
def whole():
    recording, _ = dropped(lasting=6.0)
    (movement,) = movements_of([("", recording)])
    return movement


def test_of_a_leg_that_came_to_rest_by_itself_no_hand_is_sure(whole):
    assert whole.extent.ended != "caught"
    (said,) = of_kept([replace(whole, kept=whole.angle.size // 2)])
    assert "stops the leg softly, or friction" in said
    assert of_kept([whole]) == []


def test_a_hand_that_was_seen_is_said(whole):
    seen = replace(whole, kept=100, extent=replace(whole.extent, ended="caught"))
    (said,) = of_kept([seen])
    assert "as where a hand stops the leg and keeps it." in said
    assert np.isclose(
        whole.segment.time[100], float(said.split(" s after")[0].split()[-1]), atol=0.01
    )
