"""Drops by an encoder of few bits, or a goniometer's table of few digits: what stands still shows
one code, whose error no mean takes away.
"""

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.signal.rounding import least_step, shared
from swings import HOLD, Oscillator, recorded

STEP = 0.01  # s
BITS_12, WHOLE = 2 * np.pi / 4096, np.radians(1.0)  # rad
LASTING = 12.0  # s, in which every swing dies out
RUN = 4  # legs, each with its codes elsewhere


def read(leg, code, noise=0.0, seed=0):
    time = np.arange(0, HOLD + LASTING, STEP)
    angle = leg.angle(time - HOLD) + noise * np.random.default_rng(seed).normal(size=time.size)
    (found,) = measure_drops(recorded(code * np.round(angle / code), time, noise=None)).drops
    return found.measures


def scores(code, noise=0.0):
    """By how many errors plateau, start, first flexion and index are off, leg by leg."""
    found = []
    for seed in range(RUN):
        rest = -1.2 - code * seed / RUN
        leg = Oscillator(rest, 1.0 + code * ((3 * seed + 1) % RUN) / RUN, decay=0.7)
        first = leg.amplitude * (1 + np.exp(-leg.decrement / 2))
        truths = {
            "plateau_angle": leg.rest,
            "start_angle": leg.rest + leg.amplitude,
            "first_flexion_amplitude": first,
            "relaxation_index": first / leg.amplitude,
        }
        each = read(leg, code, noise, seed)
        found.append([(each[name].value - true) / each[name].standard_error
                      for name, true in truths.items()])  # fmt: skip
    return np.array(found)


@pytest.mark.parametrize("code", [BITS_12, WHOLE])
def test_an_angle_that_stands_on_one_code_is_as_unsure_as_the_code_is_wide(code):
    off = scores(code)
    assert np.abs(off).max() < 3.0  # sqrt(12) / 2 errors at most, of a place within half a code
    assert np.sqrt(np.mean(off[:, 0] ** 2)) > 0.4  # and no more unsure than that


def test_noise_of_a_step_takes_rounding_away_with_the_root_of_the_samples():
    plateaus = [read(Oscillator(decay=0.7), WHOLE, noise, 1)["plateau_angle"]
                for noise in (0.0, WHOLE)]  # fmt: skip
    still, dithered = (each.standard_error for each in plateaus)
    assert still == pytest.approx(WHOLE / np.sqrt(12), rel=0.1)
    assert dithered < 0.6 * still  # 1.04 codes over the root of 103 samples are a tenth of a code


def test_samples_of_one_code_err_together_and_others_do_not():
    shown = np.array([0.0, 0.0, 0.0, 1.0, 2.0])
    assert least_step(shown) == 1.0
    mean = shared(np.full((1, 5), 0.2), shown)
    assert mean[0] == pytest.approx([0.6 / np.sqrt(12), 0.0])  # the three, which may not slope
    assert shared(np.ones((1, 3)), np.array([0.1, 0.2, 0.3])).size == 0
