"""From what a search found to a verdict."""

import numpy as np
import pytest

from exoid.diagnose.conclusion import partial
from exoid.diagnose.evidence import Yardstick
from exoid.diagnose.hypothesis import Hypothesis, Products
from exoid.diagnose.search import Found
from exoid.diagnose.settle import Settled

SAMPLES = 1000
NOTHING = Hypothesis((), (), np.zeros(4))


def leaving(square):
    """A candidate that leaves so much."""
    return Settled(NOTHING, Products(np.zeros((1, 1, 1)), np.array([[square]])), course=None)


@pytest.mark.parametrize(
    ("left", "doubted"),
    [(1000.0, False), (20_000.0, False), (40_000.0, True)],
    ids=["all", "four fifths", "two thirds"],
)
def test_a_part_is_no_cause_where_nobody_declared_the_noise(left, doubted):
    base = leaving(101_000.0)
    found = Found(base, NOTHING, [], [], {}, [], Yardstick(SAMPLES, scale=1.0))
    reasons = partial(found, leaving(left))
    assert bool(reasons) == doubted
    if doubted:
        assert "declare the sensors' noise" in reasons[0]
