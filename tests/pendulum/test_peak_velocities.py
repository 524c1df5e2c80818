"""The peak velocity of a flexion that a reflex ends, which is a short one."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.measured.segment import Segment
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


def falls_on(hertz, seed):
    """A drop that a short reflex brakes at its fastest and then lets go: the angle at samples, and
    the greatest speed [rad/s], before the reflex.
    """

    def moved(time, state):
        angle, rate = state
        burst = 25 * np.sin(np.pi * (time - 0.16) / 0.12) ** 2 if 0.16 < time < 0.28 else 0.0
        return [rate, -25 * np.cos(angle) - 5 * angle - 0.8 * rate + burst]

    fine = np.arange(0.0, 9.0, 0.001)
    angle, rate = solve_ivp(moved, (0, 9), [-0.6, 0.0], t_eval=fine, rtol=1e-8, max_step=0.01).y
    time, random = np.arange(0.0, 9.5, 1 / hertz), np.random.default_rng(seed)
    held = np.interp(time - 0.5, fine, angle) + 0.0005 * random.normal(size=time.size)
    return Segment(time, raw_angle=held), -rate[fine < 0.25].min(), -rate[fine > 0.35].min()


def test_of_two_peaks_it_is_the_higher_one_though_short():
    for hertz in (100.0, 200.0):
        each = [falls_on(hertz, seed) for seed in range(3)]
        recording = Recording(tuple(one for one, _, _ in each), protocol=Protocol(kind="passive"))
        for one, (_, fastest, later) in zip(measure_drops(recording).drops, each, strict=True):
            read = one.measures["peak_flexion_velocity"]
            assert fastest > 1.1 * later
            assert read.value > later
            assert abs(read.value - fastest) / read.standard_error < 2
            assert read.standard_error < 0.1 * fastest
