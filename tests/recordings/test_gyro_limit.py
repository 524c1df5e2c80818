"""A gyro that turns faster than it can tell, and those that only stand at their peaks; by SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.recordings.conventions.left_out.gyro_limit import without_saturated

TIME = 0.01 * np.arange(600)
DEGREE = np.radians(1.0)


@pytest.fixture(scope="module")
def swings():
    """Angle and rate of a leg that is let go after 0.6 s, from four angles."""

    def slope(_, state):
        angle, rate = state
        return rate, -26.5 * np.cos(angle) - 3.2 * angle - 0.55 * rate

    exact = {"rtol": 1e-9, "atol": 1e-10, "dense_output": True}
    starts = [[np.radians(each), 0.0] for each in (-15.0, -30.0, -50.0, -22.0)]
    each = [solve_ivp(slope, (0.0, 6.0), start, **exact).sol for start in starts]
    return [one(np.maximum(TIME - 0.6, 0.0)) for one in each]


def recorded(swings, shown, seed: int = 0, noise: float = 0.3) -> exoid.Recording:
    """By an encoder that scatters by 0.05 deg, and what is `shown` of a gyro's rate [rad/s] that
    scatters by `noise` [deg/s].
    """
    random, segments = np.random.default_rng(seed), []
    for angle, rate in swings:
        seen = angle + 0.05 * DEGREE * random.normal(size=TIME.size)
        rate = shown(rate + noise * DEGREE * random.normal(size=TIME.size))
        segments.append(exoid.Segment(TIME, raw_angle=seen, raw_angular_velocity=rate))
    return exoid.Recording(tuple(segments))


def clipped(limit: float):
    return lambda rate: np.clip(rate, -limit * DEGREE, limit * DEGREE)


def rates(recording: exoid.Recording) -> np.ndarray:
    found = [each.raw_angular_velocity for each in recording.segments]
    return np.concatenate([each for each in found if each is not None])


@pytest.mark.parametrize("limit", [125.0, 160.0, 200.0, 250.0])
@pytest.mark.parametrize("step", [0.0, 1.0])
def test_what_stands_at_the_end_of_a_range_is_left_out(swings, limit, step):
    def shown(rate):
        coarse = np.round(rate / DEGREE / step) * step * DEGREE if step else rate
        return clipped(limit)(coarse)

    recording = recorded(swings, shown)
    mended, (note,) = without_saturated(recording)
    cut = np.abs(rates(recording)) == limit * DEGREE
    assert cut.sum() > 20
    assert np.isnan(rates(mended)).tolist() == cut.tolist()
    assert f"{limit:g} deg/s while the leg turns faster" in note
    assert f"{cut.sum()} such samples are left out" in note


@pytest.mark.parametrize("step", [0.001, 1.0, 4.0, 10.0])
@pytest.mark.parametrize("noise", [0.0, 0.3, 2.0])
def test_a_coarse_gyro_at_its_peaks_is_at_no_limit(swings, step, noise):
    """Nor is one that says 5 % less than the encoder, or is held for three samples."""

    def coarse(rate):
        return np.round(0.95 * rate / DEGREE / step) * step * DEGREE

    def held(rate):
        return np.repeat(coarse(rate)[::3], 3)

    for shown in (coarse, held):
        for seed in range(5):
            recording = recorded(swings, shown, seed, noise)
            assert without_saturated(recording) == (recording, ())


@pytest.mark.parametrize("step", [0.001, 1.0, 4.0])
def test_a_joint_that_spins_evenly_is_at_no_limit(step):
    """To and fro, however coarse its gyro, which says 2 % less than the encoder."""
    rate = 2.0 * np.array([0, 1, 0, -1])[(TIME / 0.4).astype(int) % 4]

    def shown(rate):
        return np.round(0.98 * rate / DEGREE / step) * step * DEGREE

    recording = recorded([(np.cumsum(rate) * 0.01, rate)], shown, noise=0.1 * step)
    assert without_saturated(recording) == (recording, ())


@pytest.mark.parametrize("share", [0.7, 0.8, 0.9])
def test_one_place_where_it_stands_for_long_is_enough(swings, share):
    """One high drop tops out in its first fall alone, for ten samples and more."""
    limit = share * np.degrees(np.abs(swings[0][1]).max())
    once = recorded(swings[:1], clipped(limit))
    mended, (note,) = without_saturated(once)
    cut = np.isclose(np.abs(rates(once)), limit * DEGREE, rtol=1e-9)
    assert cut.sum() >= 10
    assert np.isnan(rates(mended)).tolist() == cut.tolist()
    assert "while the leg turns faster" in note


def test_one_short_place_at_the_declared_range_is_enough(swings):
    """By 25 samples a second it stands there for a few, which tell no end of a range by themselves,
    nor beside a declared range that is another."""
    limit = 0.85 * np.degrees(np.abs(swings[0][1]).max())
    (segment,) = recorded(swings[:1], clipped(limit)).segments
    slow = exoid.Segment(
        segment.time[::4],
        raw_angle=segment.raw_angle[::4],
        raw_angular_velocity=segment.raw_angular_velocity[::4],
    )

    def left_out(gyro_range: float | None) -> int:
        sensors = exoid.Sensors(gyro_range=gyro_range)
        told = exoid.Recording((slow,), sensors=sensors)
        return int(np.isnan(rates(without_saturated(told)[0])).sum())

    assert left_out(None) == left_out(4.0 * limit) == 0
    assert 3 <= left_out(limit) < 10


def test_one_short_place_or_no_gyro_tells_nothing(swings):
    once = recorded(swings[:1], lambda rate: np.maximum(rate, -0.97 * np.abs(rate.min())))
    assert without_saturated(once) == (once, ())
    none = exoid.Recording((exoid.Segment(TIME, raw_angle=swings[0][0]),))
    assert without_saturated(none) == (none, ())
