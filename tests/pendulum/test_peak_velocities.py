"""The peak velocity of a flexion that a reflex ends, which is a short one."""

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.recording import Recording
from reflexes import ADULT, CHILD, START, measured, swung

MANY = 8  # drops of a leg


def errors_of(knee, hertz, strength):
    """How many of its standard errors each reading is from the truth."""
    angle, rate = swung(knee, 0.0, START, 0.0, strength)
    turn = int(np.argmax(rate > 0))
    segments = tuple(measured(angle, hertz, seed) for seed in range(MANY))
    drops = measure_drops(Recording(segments, protocol=Protocol(kind="passive"))).drops
    read = [each.measures["peak_flexion_velocity"] for each in drops]
    return [(each.value + rate[:turn].min()) / each.standard_error for each in read]


@pytest.mark.parametrize("strength", [0.0, 1.3, 2.2])
def test_two_errors_hold_it(strength):
    """In 95 of 100 drops: of 64, ten or more are outside once in a thousand times."""
    legs = [(knee, hertz) for knee in (CHILD, ADULT) for hertz in (30.0, 50.0, 100.0, 200.0)]
    outside = [abs(each) > 2 for leg in legs for each in errors_of(*leg, strength)]
    assert sum(outside) < 10
