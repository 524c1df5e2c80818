"""A few samples that leap aside together and come back are no motion; what bends is."""

import numpy as np
import pytest

from exoid.recordings.signal.excursions import find_excursions

DEGREE = np.radians(1.0)
RATES = [25, 50, 100]  # Hz


def swing(rate):
    time = np.arange(0.0, 8.0, 1 / rate)
    return time, -1.5 + 0.7 * np.exp(-0.5 * time) * np.cos(5.7 * time)


def noise(size, seed):
    return 0.25 * DEGREE * np.random.default_rng(seed).standard_normal(size)


@pytest.mark.parametrize("rate", RATES)
def test_samples_that_are_off_together_are_found_and_no_others(rate):
    draw = np.random.default_rng(rate)
    for seed in range(20):
        time, angle = swing(rate)
        begin, count = int(draw.integers(20, time.size - 20)), int(draw.integers(2, 7))
        off = np.zeros(time.size)
        off[begin : begin + count] = draw.choice([-1, 1]) * draw.uniform(4, 15) * DEGREE
        found = find_excursions(time, angle + off + noise(time.size, seed))
        np.testing.assert_array_equal(found, off != 0)


@pytest.mark.parametrize("rate", RATES)
@pytest.mark.parametrize(
    "shape",
    [
        lambda place: np.where(np.abs(place) < 1, 1 + np.cos(np.pi * place), 0.0) / 2,  # a kick
        lambda place: np.maximum(1 - np.abs(place), 0.0),  # struck, and struck back
        lambda place: np.where(place > 0, np.exp(-place) * np.sin(4.7 * place), 0.0),  # a stop
        lambda place: np.where(place > 0, 1.0, 0.0),  # a strap that slips
    ],
)
def test_what_kicks_strikes_stops_or_slips_is_none(rate, shape):
    """Within three to twelve samples. One in a hundred of two samples may look alike."""
    draw, found = np.random.default_rng(rate), 0
    for seed in range(60):
        time, angle = swing(rate)
        place = (time - draw.uniform(1, 6)) * rate / draw.uniform(3, 12)
        moved = angle + draw.choice([-1, 1]) * draw.uniform(2.5, 12) * DEGREE * shape(place)
        found += find_excursions(time, moved + noise(time.size, seed)).any()
    assert found <= 1
