"""The noise of a signal against what was put into it."""

import numpy as np
import pytest
from scipy.signal import butter, filtfilt

from exoid.recordings.measured.samples import quantum
from exoid.recordings.signal.neighbours import interpolation_errors
from exoid.recordings.signal.noise import noise_of
from exoid.recordings.signal.smoothed import OF_ANGLE, OF_RATE
from exoid.recordings.signal.spikes import find_spikes

NOISE = np.radians(0.1)


def swing(time):
    """A leg's free swing [rad], close enough: 0.95 Hz, dying out."""
    return -1.2 + np.exp(-0.3 * time) * np.cos(2 * np.pi * 0.95 * time)


def sampled(rate, noise, seed=0, duration=8.0, jitter=0.0):
    generator = np.random.default_rng(seed)
    time = np.arange(0, duration, 1 / rate)
    time = time + jitter / rate * generator.uniform(-0.5, 0.5, time.size)
    return time, swing(time) + noise * generator.normal(size=time.size)


@pytest.mark.parametrize("rate", [30, 120, 1000])
@pytest.mark.parametrize("degrees", [0.005, 2.0])
def test_the_noise_of_a_swing_is_told_whatever_its_rate_and_size(rate, degrees):
    """240 samples tell a deviation to 5 %: three times that is allowed."""
    signals = [sampled(rate, np.radians(degrees), seed) for seed in range(3)]
    found = noise_of([time for time, _ in signals], [angle for _, angle in signals], None)
    assert found.level == pytest.approx(np.radians(degrees), rel=0.15)
    assert not found.heavy


@pytest.mark.parametrize("samples", [40, 100, 220, 500])
def test_the_tails_of_gaussian_noise_are_not_called_heavy_however_few_samples_show_them(samples):
    """One of 700 is allowed to: a ratio of two deviations scatters by 1.2 over the root of their
    number.
    """
    times = [np.arange(samples) / 100] * 200
    generator = np.random.default_rng(samples)
    found = [noise_of([time], [generator.normal(size=samples)], None).heavy for time in times]
    assert sum(found) <= 2


def test_tails_that_are_heavy_are_called_so():
    """A tenth of the samples with four times the noise of the others."""
    generator = np.random.default_rng(2)
    wild = np.where(generator.random(1500) < 0.1, 4.0, 1.0)
    assert noise_of([np.arange(1500) / 100], [wild * generator.normal(size=1500)], None).heavy


@pytest.mark.parametrize("samples", [12, 20, 31, 50, 70])
def test_few_samples_tell_the_noise_roughly_and_are_not_called_smoothed(samples):
    """A tenth of a second of a swing has 6 errors, which tell a deviation to 30 %."""
    found = []
    for seed in range(20):
        time, angle = sampled(100, NOISE, seed, duration=samples / 100)
        angle = np.round(angle, 6)
        each = noise_of([time], [angle], None, swing=OF_ANGLE)
        assert NOISE / 5 < each.level < 5 * NOISE
        found.append(each.level)
        assert each.alike_over == 0
    assert np.median(found) == pytest.approx(NOISE, rel=0.3)


def test_uneven_rates_and_lost_samples_cost_nothing_but_information():
    time, angle = sampled(100, NOISE, jitter=0.6)
    angle[np.random.default_rng(1).random(angle.size) < 0.03] = np.nan
    assert noise_of([time], [angle], None).level == pytest.approx(NOISE, rel=0.1)
    kept = ~np.isnan(angle)
    assert noise_of([time[kept]], [angle[kept]], None).level == pytest.approx(NOISE, rel=0.1)


@pytest.mark.parametrize(("rate", "cutoff"), [(100, 6), (120, 6), (100, 10), (250, 8)])
def test_a_smoothed_angle_counts_with_the_noise_it_had_before(rate, cutoff):
    """As motion capture is exported: Butterworth, forwards and backwards."""
    time, angle = sampled(rate, np.radians(0.3), duration=12.0)
    smooth = filtfilt(*butter(2, cutoff / (rate / 2)), angle)
    found = noise_of([time], [smooth], None, swing=OF_ANGLE)
    assert 0.4 < np.degrees(found.level) / 0.3 < 2.5
    assert 0.04 < found.alike_over < 0.11


def turning(rate, noise, duration):
    """A gyro beside it [rad/s], about its middle."""
    time, _ = sampled(rate, 0.0, duration=duration)
    slope = np.gradient(swing(np.arange(0, duration, 1e-4)), 1e-4)
    clean = np.interp(time, np.arange(0, duration, 1e-4), slope)
    return time, clean + noise * np.random.default_rng(5).normal(size=time.size)


@pytest.mark.parametrize(("rate", "cutoff"), [(100, 6), (120, 6), (200, 6), (250, 8)])
def test_a_smoothed_gyro_counts_with_about_the_noise_it_had_before(rate, cutoff):
    """A rate swings more than an angle: it hides the widest stretches over which errors are alike.
    By neighbours alone the noise would be a thousandth of what it was.
    """
    time, gyro = turning(rate, np.radians(0.5), duration=12.0)
    smooth = filtfilt(*butter(2, cutoff / (rate / 2)), gyro)
    found = noise_of([time], [smooth], None, swing=OF_RATE)
    assert 0.15 < np.degrees(found.level) / 0.5 < 2.5
    assert 0.035 < found.alike_over < 0.11


@pytest.mark.parametrize("rate", [30, 60, 100, 240, 1000])
@pytest.mark.parametrize("noise", [0.05, 1.0])  # deg/s
def test_a_gyro_that_nobody_smoothed_is_not_called_so(rate, noise):
    time, gyro = turning(rate, np.radians(noise), duration=3.0)
    found = noise_of([time], [gyro], None, swing=OF_RATE)
    assert found.alike_over == 0
    assert np.degrees(found.level) == pytest.approx(noise, rel=0.3)


@pytest.mark.parametrize("rate", [50, 100, 200])
def test_a_gyro_that_play_holds_at_the_turns_is_not_called_smoothed(rate):
    """It stands still while the play is crossed, and jumps: the jumps share nothing."""
    time, gyro = turning(rate, np.radians(0.1), duration=6.0)
    turns = np.flatnonzero(np.diff(np.sign(gyro)))
    for turn in turns:
        held = (time > time[turn]) & (time < time[turn] + 0.04)
        gyro[held] = np.radians(0.1) * np.random.default_rng(turn).normal(size=held.sum())
    found = noise_of([time], [gyro], None, swing=OF_RATE)
    assert found.alike_over == 0
    assert np.degrees(found.level) == pytest.approx(0.1, rel=0.35)


def test_an_interpolated_angle_counts_with_the_noise_it_had_before():
    time, angle = sampled(30, np.radians(0.3), duration=12.0)
    dense = np.arange(0, time[-1], 0.01)
    found = noise_of([dense], [np.interp(dense, time, angle)], None, swing=OF_ANGLE)
    # 100 samples a second with this noise tell as much as 30 with 0.3 deg
    assert 0.5 < np.degrees(found.level) / (0.3 * np.sqrt(100 / 30)) < 2.5


@pytest.mark.parametrize(("rate", "every"), [(120, 4), (300, 3), (400, 8)])
def test_an_angle_whose_gyro_is_faster_is_not_called_smoothed(rate, every):
    """Cells between its samples are empty: 240 samples tell a deviation to 5 %."""
    time, angle = sampled(rate, NOISE)
    angle[np.arange(angle.size) % every != 0] = np.nan
    found = noise_of([time], [angle], None, swing=OF_ANGLE)
    assert found.level == pytest.approx(NOISE, rel=0.15)
    assert found.alike_over == 0


@pytest.mark.parametrize("rate", [30, 60, 100, 240, 1000])
@pytest.mark.parametrize("degrees", [0.005, 0.3])
def test_neighbours_that_share_nothing_are_not_called_smoothed(rate, degrees):
    """Not for a fast swing without a rest either."""
    time, angle = sampled(rate, np.radians(degrees), duration=3.0)
    found = noise_of([time], [angle], None, swing=OF_ANGLE)
    assert found.alike_over == 0
    assert np.degrees(found.level) == pytest.approx(degrees, rel=0.3)


def test_a_polynomial_of_degree_five_has_no_noise():
    time = np.sort(np.random.default_rng(3).uniform(0, 1, 60))
    left = interpolation_errors(time, np.polyval([3.0, -2.0, 1.0, 4.0, -1.0, 2.0], time))
    assert np.nanmax(np.abs(left)) < 1e-8  # of values of order one, rounding times the weights
    assert np.isnan(left).sum() == 6


def test_single_spikes_are_found_and_nothing_else():
    time, angle = sampled(100, NOISE)
    clean = angle.copy()
    angle[100] += 30 * NOISE
    angle[300] -= 20 * NOISE
    assert np.flatnonzero(find_spikes(time, angle)).tolist() == [100, 300]
    assert not find_spikes(time, clean).any()


@pytest.mark.parametrize("apart", [1, 2, 3])
def test_two_spikes_beside_each_other_are_found(apart):
    """Of five in a thousand every fiftieth is that close to another."""
    time, angle = sampled(100, NOISE)
    wild = [100, 100 + apart]
    angle[wild] += [30 * NOISE, 40 * NOISE]
    assert np.flatnonzero(find_spikes(time, angle)).tolist() == wild


def test_a_spike_where_a_swing_turns_is_found():
    """Still on one side, moving on the other, as where a leg is let go; but far from both."""
    time = np.arange(600) / 60.0
    angle = np.radians(30) * np.cos(2 * np.pi * time / 1.1)
    angle += np.radians(0.5) * np.random.default_rng(0).normal(size=time.size)
    turns = np.flatnonzero(np.diff(np.sign(np.diff(np.cos(2 * np.pi * time / 1.1)))))[1:-1:3]
    for shift in range(-4, 5):
        disturbed = angle.copy()
        disturbed[turns + shift] += np.radians(20)
        assert np.flatnonzero(find_spikes(time, disturbed)).tolist() == (turns + shift).tolist()


def test_clean_samples_are_hardly_ever_called_spikes():
    """Five deviations: 0.06 of 100,000 to be expected, and a few more by chance."""
    found = [find_spikes(*sampled(100, NOISE, seed, duration=100.0)).sum() for seed in range(10)]
    assert sum(found) <= 2


def test_a_jump_that_lasts_is_motion():
    """A gyro jumps where a stop is hit: all samples stay."""
    time, rate = sampled(200, 0.007)
    rate[600:] -= 1.5
    assert not find_spikes(time, rate).any()


@pytest.mark.parametrize("at", range(200, 210))
def test_a_gyro_that_begins_to_turn_has_no_spike(at):
    """Its bend where a leg is let go stands out of both sides, but only one of them is at rest."""
    time = np.arange(400) * 0.01
    rate = -25 * np.maximum(time - time[at] + 0.004, 0.0)
    rate += 0.0012 * np.random.default_rng(at).normal(size=time.size)
    assert not find_spikes(time, rate).any()
    rate[100] += 0.02  # one while it is held
    assert np.flatnonzero(find_spikes(time, rate)).tolist() == [100]


def test_tails_are_counted_by_their_root_mean_square():
    """Student's t with 3 degrees of freedom has 1.73 times its scale; less what was left out."""
    time, angle = sampled(100, 0.0, duration=60.0)
    angle = angle + NOISE * np.random.default_rng(0).standard_t(3, angle.size)
    spikes = find_spikes(time, angle)
    assert 0 < spikes.mean() < 0.01
    kept = np.where(spikes, np.nan, angle)
    found = noise_of([time], [kept], None)
    truth = np.nanstd(kept - swing(time))
    assert found.level == pytest.approx(truth, rel=0.1)
    assert found.level > 1.3 * NOISE


def test_a_declaration_counts_until_the_samples_scatter_by_more():
    time, angle = sampled(100, NOISE)
    assert noise_of([time], [angle], NOISE).level == NOISE
    assert not noise_of([time], [angle], NOISE).contradicted
    low = noise_of([time], [angle], NOISE / 4)
    assert low.level == pytest.approx(NOISE, rel=0.1)
    assert low.contradicted
    high = noise_of([time], [angle], 4 * NOISE)
    assert high.level == 4 * NOISE
    assert high.contradicted


def test_a_signal_in_steps_scatters_at_least_as_steps_do():
    """A 12-bit encoder at rest shows the same count throughout."""
    step = 2 * np.pi / 4096
    time = np.arange(0, 8, 0.01)
    stepped = np.round(swing(time) / step) * step
    assert quantum([stepped]) == pytest.approx(step, rel=1e-6)
    assert quantum([sampled(100, NOISE)[1]]) < step / 10
    rest = np.where(time < 5, stepped[0], stepped)
    assert noise_of([time], [rest], None).level >= 0.99 * step / np.sqrt(12)
    assert noise_of([time], [np.zeros(time.size)], None).level > 0
