"""Where a leg rests whose record ends while it still swings by a degree, or friction stopped it."""

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.landmarks.dying_swing import middle_of
from exoid.recordings.landmarks.track import Peak
from swings import Oscillator, recorded

REST, RATE, START = -1.25, 5.8, 1.0  # rad, rad/s, rad above the rest
STEP, NOISE = 0.01, 1e-3  # s, rad


def stopped(time, band):
    """Swings [rad] about either end of a band of friction, which shrink by equal steps until one
    ends in the band, and where that is.
    """
    half = np.floor(time * RATE / np.pi)
    last = np.ceil((START - band) / (2 * band))
    size = START - band - 2 * band * np.minimum(half, last)
    way = np.where(half % 2 == 0, 1.0, -1.0)
    swings = REST + way * band + size * np.cos(RATE * time)
    end = REST + (-1.0) ** last * (START - 2 * band * last)
    return np.where(half >= last, end, swings), end


def plateau(angle, seed):
    noise = NOISE * np.random.default_rng(seed).standard_normal(angle.size)
    held = np.full(100, angle[0]) + NOISE * np.random.default_rng(seed + 99).standard_normal(100)
    every = np.concatenate([held, angle + noise])
    (found,) = measure_drops(recorded(every, STEP * np.arange(every.size))).drops
    read = found.measures["plateau_angle"]
    assert read.value is not None, read.reason
    assert read.standard_error is not None
    return read.value, read.standard_error


@pytest.mark.parametrize("decay", [0.25, 0.4, 0.8])
def test_a_leg_that_still_swings_rests_at_its_middle(decay):
    """The mean over a period is 0.03 deg off at 1 deg of swing, always to the same side."""
    off = []
    leg = Oscillator(REST, START, RATE, decay)
    for seed, lost in enumerate(np.linspace(4.2, 5.4, 12)):  # of the log of its amplitude
        value, error = plateau(leg.angle(np.arange(0.0, lost / decay, STEP)), seed)
        off.append((value - REST) / error)
    assert np.sqrt(np.mean(np.square(off))) < 1.6  # of 12, once in 1000
    assert abs(np.mean(off)) < 3.3 / np.sqrt(len(off))


def test_a_leg_that_friction_stopped_rests_where_it_stands():
    """Its last period holds some of its last swing: no middle of that is its rest."""
    for seed, band in enumerate(np.linspace(0.011, 0.017, 6)):
        time = np.arange(0.0, 30.0, STEP)
        angle, end = stopped(time, band)
        stop = int(np.flatnonzero(angle != end)[-1]) + 1
        for later in (0.35, 0.7, 1.5):
            value, error = plateau(angle[: stop + int(later / STEP)], seed)
            assert abs(value - end) < 3 * error, (band, later)
            assert error < 0.02


def test_where_friction_stops_a_swing_there_is_no_middle_of_it():
    turns = [
        Peak(0, at, 0.0, REST + size, 0.0) for at, size in ((0.0, 0.1), (0.54, -0.06), (1.08, 0.02))
    ]
    time = np.arange(0.0, 1.08, STEP)
    noise = NOISE * np.random.default_rng(1).standard_normal(time.size)
    swing = 0.02 * np.exp(-time) * np.cos(RATE * time)
    assert middle_of(time, REST + swing + noise, NOISE, turns) is not None
    stands = np.where(time < 0.4, swing, swing[40])
    assert middle_of(time, REST + stands + noise, NOISE, turns) is None
