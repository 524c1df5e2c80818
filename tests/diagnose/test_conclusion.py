"""From what a search found to a verdict."""

from types import SimpleNamespace

import pytest

from exoid.diagnose.conclusion import partial
from exoid.diagnose.evidence import Yardstick


@pytest.mark.parametrize(
    ("left", "doubted"),
    [(1000.0, False), (20_000.0, False), (40_000.0, True)],
    ids=["all", "four fifths", "two thirds"],
)
def test_a_part_is_no_cause_where_nobody_declared_the_noise(left, doubted):
    measure = Yardstick(samples=1000, scale=1.0)
    found = SimpleNamespace(
        yardstick=measure, followed=lambda best: measure.followed(101_000.0, best.square)
    )
    reasons = partial(found, SimpleNamespace(square=left))
    assert bool(reasons) == doubted
    if doubted:
        assert "declare the sensors' noise" in reasons[0]
