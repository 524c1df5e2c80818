"""A gyro that is later than the encoder, told from their motions alone; one that is not used."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.signal import butter, lfilter

from exoid.fitting.data.segment import movement
from exoid.fitting.estimate import fit
from exoid.fitting.result.remarks.gyro_remarks import (
    how_late,
    late_gyro,
    of_late_gyro,
    of_unused_gyro,
    scale_of,
)
from exoid.physics.sensing.butterworth_filter import ButterworthFilter
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from hands import ADULT, Device, Hand, dropped
from legs import fall
from legs import recording as of_an_adult

MIDDLE, SIZE, DECAY, RATE = -1.3, 0.9, 0.4, 5.5  # rad, rad, 1/s, rad/s


def swing(late=0.0, scale=1.0, err=0.0, noise=True, rocking=0.0):
    """A decaying swing in closed form, the gyro `late` [s]; the encoder errs by `err` [rad], the
    thigh below it goes on `rocking` [rad].
    """
    time, random = np.arange(0.0, 4.0, 0.01), np.random.default_rng(0)
    faded = SIZE * np.exp((1j * RATE - DECAY) * time)
    angle = MIDDLE + faded.real
    before = SIZE * np.exp((1j * RATE - DECAY) * (time - late))
    velocity = scale * ((1j * RATE - DECAY) * before).real
    angle = angle - rocking * np.sin(RATE * time)
    angle = angle + err * np.sin(2 * angle) + noise * 1e-3 * random.standard_normal(time.size)
    velocity = velocity + 0.02 + noise * 1e-2 * random.standard_normal(time.size)
    segment = Segment(time, raw_angle=angle, raw_angular_velocity=velocity)
    recording = Recording((segment,), protocol=Protocol(kind="passive"))
    return [movement(recording, 0, "swing 0")]


@pytest.mark.parametrize("late", [0.02, 0.005, -0.01])
def test_the_delay_of_a_gyro_is_found_beside_its_scale_and_bias(late):
    # noise of the slopes, 0.03 rad/s of 25 rad/s^2 times 5 ms, and windows at the ends leave a part
    assert late_gyro(swing(late, scale=1.05)) == pytest.approx(late, rel=0.05, abs=2e-4)


def test_other_errors_are_no_delay():
    assert late_gyro(swing()) is late_gyro(swing(scale=1.1)) is None
    assert late_gyro(swing(err=0.02)) is None


@pytest.mark.parametrize("scale", [0.9, 1.05, 1.4])
def test_a_gyros_scale_is_told_by_the_encoders_slope_alone(scale):
    # within 0.05 s, over which a slope is taken, the swing bends by 0.2 %
    assert scale_of(swing(scale=scale)) == pytest.approx(scale - 1, abs=0.004)


def test_a_gyro_that_agrees_or_is_late_has_no_other_scale():
    assert scale_of(swing()) is scale_of(swing(0.02)) is None


def test_the_user_is_told_when_and_what_to_do():
    (said,) = of_late_gyro(swing(0.02))
    assert "about 20 ms later" in said
    assert "--with butterworth_filter" in said  # as long as that, it is rather a filter
    assert "sensor_skew" in said
    (said,) = of_late_gyro(swing(-0.01))
    assert "about 10 ms earlier" in said
    assert "'exoid fit --with sensor_skew'" in said
    assert of_late_gyro(swing()) == []


def test_a_thigh_that_rocks_on_is_no_delay_and_what_swings_with_the_leg_may_be_either():
    (said,) = of_late_gyro(swing(rocking=0.05))
    assert "as no delay is" in said
    assert "the thigh moves under an encoder" in said
    assert "sensor_skew" not in said
    assert how_late(swing(rocking=0.05)).startswith("the gyro seems")
    (said,) = of_late_gyro(swing(0.01))
    assert "a thigh that rocks looks alike" in said
    assert "sensor_skew" in said
    assert "sensor_skew' estimates that" in how_late(swing(0.009))
    assert how_late(swing()) is None


def beside_gyro(angle: np.ndarray, velocity: np.ndarray):
    """A drop of which every fourth of these samples at 400 Hz is kept."""
    random, time = np.random.default_rng(2), 0.0025 * np.arange(angle.size)
    noisy = angle + 1e-3 * random.standard_normal(angle.size)
    rate = velocity + 4e-3 * random.standard_normal(angle.size)
    segment = Segment(time[::4], raw_angle=noisy[::4], raw_angular_velocity=rate[::4])
    return [movement(Recording((segment,), protocol=Protocol(kind="passive")), 0, "drop 0")]


def fused(angle: np.ndarray, velocity: np.ndarray, lasting: float, reach: float) -> np.ndarray:
    """A complementary filter of the time constant `lasting` [s] makes this of the gyro and of an
    accelerometer so far [m] below the knee.
    """
    change = np.gradient(velocity, 0.0025)
    along = 9.81 * np.sin(angle) - reach * velocity**2
    tilt = np.arctan2(along, 9.81 * np.cos(angle) + reach * change)
    seen, share = [angle[0]], 0.0025 / lasting
    for rate, shown in zip(velocity[1:], tilt[1:], strict=True):
        seen.append((1 - share) * (seen[-1] + 0.0025 * rate) + share * shown)
    return np.array(seen)


@pytest.mark.parametrize(("lasting", "reach"), [(0.4, 0.2), (0.8, 0.25), (1.0, 0.12)])
def test_an_angle_that_is_fused_from_gyro_and_accelerometer_is_told_from_a_delay(lasting, reach):
    _, angle, velocity = fall(start=-0.3, duration=5.0, step=0.0025)
    beside = beside_gyro(fused(angle, velocity, lasting, reach), velocity)
    assert late_gyro(beside) > 0.01
    (said,) = of_late_gyro(beside)
    assert "fused from gyro and accelerometer" in said
    assert "exoid fit --with" not in said
    assert "neither is late" in how_late(beside)


@pytest.mark.parametrize("late", [0.01, 0.03, 0.06, -0.03])
def test_a_delay_is_not_taken_for_an_angle_that_is_fused(late):
    time, angle, velocity = fall(start=-0.3, duration=5.0, step=0.0025)
    beside = beside_gyro(angle, np.interp(time - late, time, velocity))
    (said,) = of_late_gyro(beside)
    assert "exoid fit --with" in said
    assert "neither is late" not in said
    assert ("fused from" in said) == (late == 0.01)  # too small to be told from that


def test_a_delay_is_as_long_while_the_leg_is_let_go():
    """Its larger half is one fall, and a gyro that is late shows none at its begin yet."""
    time, angle, velocity = fall((27.0, 4.0, 2.3), start=-0.3, duration=5.0, step=0.0025)
    beside = beside_gyro(angle, np.interp(time - 0.006, time, velocity))
    assert late_gyro(beside) == pytest.approx(0.006, rel=0.03)
    (said,) = of_late_gyro(beside)
    assert "as no delay is" not in said


def test_a_raw_gyro_beside_a_filtered_angle_is_said_to_be_unused():
    (swung,) = swing()
    whole = swung.segment
    segment = Segment(
        whole.time, angle=whole.raw_angle, raw_angular_velocity=whole.raw_angular_velocity
    )
    each = movement(Recording((segment,), protocol=Protocol(kind="passive")), 0, "swing 0")
    (said,) = of_unused_gyro([each])
    assert "the gyro of segment swing 0 is not used" in said
    assert of_unused_gyro([swung]) == []


@pytest.mark.parametrize("corner", [5.0, 12.0])  # Hz
def test_a_fit_that_a_slow_filter_of_the_gyro_spoils_says_what_mends_it(corner):
    recording, _ = dropped(ADULT, Hand(), Device(), lasting=6.0)
    (segment,) = recording.segments
    low = butter(2, corner, fs=1 / np.median(np.diff(segment.time)))
    slow = replace(segment, raw_angular_velocity=lfilter(*low, segment.raw_angular_velocity))
    spoiled = replace(recording, segments=(slow,))
    plain = fit(spoiled, multistart=4)
    assert not plain.follows
    assert "'exoid fit --with butterworth_filter'" in plain.notes[0]
    mended = fit(spoiled, multistart=4, terms=(ButterworthFilter,))
    assert mended.follows
    assert not any("later than the encoder" in each for each in mended.notes)
    for name in ("gravity", "stiffness", "damping"):
        found = mended.ratios[f"{name}_over_inertia"]
        assert abs(found.value - getattr(ADULT, name)) < 3 * found.standard_error
        assert found.standard_error < 0.1 * getattr(ADULT, name)


def rubbed(start: float, late: float, seed: int) -> Segment:
    """A drop with dry friction of 0.4 rad/s^2 over J, the gyro `late` [s]."""

    def slope(_, state):
        angle, speed = state
        pull = 27.5 * np.cos(angle) + 6.0 * angle + 0.8 * speed + 0.4 * np.tanh(speed / 3e-3)
        return speed, -pull

    time, random = np.arange(0.0, 5.0, 0.01), np.random.default_rng(seed)
    made = solve_ivp(
        slope, (0.0, 5.0), (start, 0.0), "Radau", dense_output=True, rtol=1e-6, atol=1e-8
    ).sol
    return Segment(
        time,
        raw_angle=made(time)[0] + 8e-4 * random.standard_normal(time.size),
        raw_angular_velocity=made(np.maximum(time - late, 0.0))[1]
        + 3e-3 * random.standard_normal(time.size),
    )


@pytest.mark.parametrize("late", [0.0, 0.006])
def test_a_late_gyro_is_told_beside_a_torque_that_the_model_lacks(late):
    starts = (-0.15, -0.6)
    drops = [rubbed(start, late, seed) for seed, start in enumerate(starts)]
    notes = fit(of_an_adult(*drops), multistart=2).notes
    assert any("an unknown torque of about" in each for each in notes)
    told = [each for each in notes if "the gyro shows the leg about" in each]
    assert len(told) == (late > 0)
    assert all("--with sensor_skew" in each for each in told)
