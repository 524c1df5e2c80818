"""What a spline follows, and how likely a chi-square is, against SciPy's."""

import numpy as np
import pytest
from scipy.interpolate import make_lsq_spline
from scipy.ndimage import median_filter
from scipy.stats import chi2

from exoid.recordings.chi_square import chance_above, median_of
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal import spline
from exoid.recordings.signal.both_sensors.clean import clean
from exoid.recordings.signal.tone import AROUND, standing_out

KNOT = 0.08  # s


def of_scipy(time, signal):
    """With knots that are as dense as the samples."""
    count = max(int((time[-1] - time[0]) / KNOT), 1)
    places = np.linspace(0, time.size - 1, count + 1)[1:-1]
    inner = np.interp(places, np.arange(time.size), time)
    knots = np.concatenate([[time[0]] * 4, inner, [time[-1]] * 4])
    return make_lsq_spline(time, signal, knots)(time)


def clocks():
    rng = np.random.default_rng(0)
    even = np.arange(1_400) * 0.01
    paused = even + 0.9 * (even > 6)
    return {
        "even": even,
        "of a day ago": even + 86_400.0,
        "uneven": np.cumsum(rng.uniform(0.005, 0.03, 900)),
        "with a pause": paused,
        "fast": np.arange(5_000) * 2e-4,
        "a camera's": np.arange(100) / 30,
        "short": np.arange(9) * 0.01,
    }


@pytest.mark.parametrize("clock", clocks())
def test_a_spline_is_that_of_scipy(clock):
    time = clocks()[clock]
    noise = np.random.default_rng(1).normal(0, 0.01, time.size)
    swing = np.exp(-0.3 * (time - time[0])) * np.cos(5.7 * time) + noise
    waves = np.stack([swing, np.cos(60 * time), np.sin(60 * time)], axis=1)
    # Normal equations square the condition of a few hundred: a few thousand roundings.
    limit = 1e-12 if clock != "of a day ago" else 1e-8  # whose clock counts in steps of 1e-11 s
    for signal in (swing, waves):
        (found,) = spline.follow([(time, signal)], KNOT)
        assert np.abs(found - of_scipy(time, signal)).max() < limit


@pytest.mark.parametrize("clock", ["even", "uneven", "with a pause", "a camera's", "short"])
def test_a_short_spline_is_the_same_whole_and_by_its_rows(clock, monkeypatch):
    time = clocks()[clock]
    signals: list = [(time, np.random.default_rng(4).normal(size=(time.size, 2)))]
    found = {}
    for little in (0, 2**30):
        monkeypatch.setattr(spline, "LITTLE", little)
        (found[little],) = spline.follow(signals, KNOT)
    assert np.abs(found[0] - found[2**30]).max() < 1e-12  # a few thousand roundings


def test_what_no_sample_tells_is_nothing_whole_and_by_rows():
    """Two systems, of the second a number that stands in no sample."""
    bands, sides = np.zeros((8, 4, 2)), np.ones((8, 1, 2))
    bands[:5, 0] = 2.0
    bands[:4, 1, 0] = 0.5
    bands[2, 0, 1] = 0.0
    rows = spline.solved(bands.copy(), sides.copy())[:5]
    whole = spline.solved_whole(bands.copy(), sides.copy())[:5]
    assert rows == pytest.approx(whole, abs=1e-14)
    assert whole[2, 0, 1] == 0.0


def test_many_signals_of_any_length_are_followed_as_each_alone(monkeypatch):
    monkeypatch.setattr(spline, "AT_ONCE", 200)  # gaps: of several groups
    rng = np.random.default_rng(2)
    times = [np.arange(int(size)) * 0.01 for size in rng.integers(64, 1_500, 30)]
    signals: list = [(time, rng.normal(size=time.size)) for time in times]
    for one, found in zip(signals, spline.follow(signals, KNOT), strict=True):
        assert found.shape == one[1].shape
        assert np.abs(found - spline.follow([one], KNOT)[0]).max() < 1e-12


@pytest.mark.parametrize("rate", [5, 10, 12, 13])
def test_a_recording_slower_than_the_knots_is_cleaned(rate):
    time = np.arange(0, 20, 1 / rate)
    angle = -1.2 + np.exp(-0.3 * time) * np.cos(3.0 * time)
    recording = Recording((Segment(time, raw_angle=angle),), Subject(kind="leg"))
    assert clean(recording).angle.tone is None


@pytest.mark.parametrize("freedom", [1, 2, 3, 4, 7, 100, 1_430, 7_001])
def test_chances_of_a_chi_square_are_those_of_scipy(freedom):
    scatter = np.sqrt(2 * freedom)
    for away in (-3, -1, 0, 1, 5, 10):
        square = max(freedom + away * scatter, 0.0)
        # Logarithms of some 10^4 are rounded to 10^-12.
        assert chance_above(freedom, square) == pytest.approx(chi2.sf(square, freedom), rel=1e-10)
    assert median_of(freedom) == pytest.approx(chi2.median(freedom), rel=1e-10)


@pytest.mark.parametrize("size", [64, 101, 1_400, 50_000])
@pytest.mark.parametrize("freedom", [2, 1_430])
def test_what_stands_out_is_told_as_by_all_medians(size, freedom):
    rng = np.random.default_rng(size)
    hill = 1 + 50 * np.exp(-0.5 * (np.arange(size) / size * 8) ** 2)
    power = hill * rng.chisquare(freedom, size)
    times = power / median_filter(power, AROUND, mode="mirror")
    assert standing_out(power) == (int(np.argmax(times)), times.max())
