"""Samples that a buffer gives in batches, that a computer stamps late, and right times."""

import numpy as np
import pytest

import exoid
from exoid.recordings.conventions.batched_times import even_times, unbatched

TAKEN = np.linspace(0.0, 5.99, 600)


def stamped(batch: int, apart: float, seed: int = 0) -> np.ndarray:
    """Every so many samples are read at once, some 2 ms late, and stamped `apart` s apart."""
    random = np.random.default_rng(seed)
    last = np.minimum((np.arange(600) // batch + 1) * batch - 1, 599)
    read = TAKEN[last] + np.repeat(random.exponential(0.002, 600 // batch + 1), batch)[:600]
    place = np.arange(600) % batch
    return np.maximum.accumulate(read + apart * place) + 1e-9 * np.arange(600)


@pytest.mark.parametrize(("batch", "apart"), [(2, 1e-3), (5, 1e-3), (5, 1e-5), (8, 2e-4)])
def test_the_clock_of_the_sensor_is_found_again(batch, apart):
    """To 0.01 %, as well as a clock is believed; when it began nobody knows."""
    found = even_times(stamped(batch, apart))
    assert found is not None
    assert np.ptp(found) == pytest.approx(np.ptp(TAKEN), rel=1e-4)
    assert np.ptp(np.diff(found)) < 1e-9


@pytest.mark.parametrize("jitter", [0.0, 1e-3, 3e-3])
def test_times_that_come_one_by_one_stay(jitter):
    random = np.random.default_rng(1)
    assert even_times(np.sort(random.normal(TAKEN, jitter))) is None


def test_a_gap_is_no_batch():
    kept = np.delete(stamped(5, 1e-3), np.arange(200, 300))
    assert even_times(kept) is None
    assert even_times(np.delete(TAKEN, np.arange(200, 300))) is None


def test_it_is_said():
    segment = exoid.Segment(stamped(5, 1e-3), raw_angle=np.cos(5 * TAKEN) * np.exp(-TAKEN) - 1.5)
    made, (note,) = unbatched(exoid.Recording((segment,)))
    assert note.startswith("samples come in batches")
    assert "evenly apart, by 10 ms" in note
    assert made.segments[0].time[0] == 0.0
    even = exoid.Recording((exoid.Segment(TAKEN, raw_angle=np.cos(5 * TAKEN)),))
    assert unbatched(even) == (even, ())


def swinging(taken: np.ndarray, stamps: np.ndarray, seed: int = 2) -> exoid.Recording:
    """An angle that scatters by 0.1 deg, taken at some times and stamped at others."""
    noise = np.radians(0.1) * np.random.default_rng(seed).normal(size=taken.size)
    angle = np.cos(5 * taken) * np.exp(-0.3 * taken) - 1.5 + noise
    return exoid.Recording((exoid.Segment(stamps - stamps[0], raw_angle=angle),))


def test_samples_that_were_taken_evenly_say_so():
    """Pairs 5 ms apart, and stamps that are off by 2 ms each."""
    random = np.random.default_rng(3)
    for stamps in (stamped(2, 5e-3), np.sort(TAKEN + 2e-3 * random.normal(size=600))):
        made, (note,) = unbatched(swinging(TAKEN, stamps))
        assert note.startswith("times are off, each by its own")
        assert np.ptp(made.segments[0].time) == pytest.approx(np.ptp(TAKEN), rel=5e-4)
        assert np.ptp(np.diff(made.segments[0].time)) < 1e-9


@pytest.mark.parametrize("seed", range(5))
def test_times_at_which_samples_were_taken_stay(seed):
    """Uneven ones, and even ones that are stamped with less error than shows in the noise."""
    random = np.random.default_rng(seed)
    uneven = TAKEN + random.uniform(0, 8e-3, size=600)
    nearly = np.sort(TAKEN + 1e-4 * random.normal(size=600))
    for recording in (swinging(uneven, uneven, seed), swinging(TAKEN, nearly, seed)):
        assert unbatched(recording) == (recording, ())
