"""A tremor that encoder and gyro show together is motion, what one shows alone is its own."""

from functools import cache

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.signal import butter, filtfilt

from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import Cleaned, clean
from exoid.recordings.signal.both_sensors.leg_tone import leg_tone, swing_of

TIME = 0.01 * np.arange(800)
OF_ANGLE, OF_RATE = np.radians(0.05), np.radians(0.17)  # white noise of the sensors
PLACES = (1.0, -0.4, 0.7)  # rad, phases of the tone in three drops


@cache
def swung(frequency: float, torque: float) -> list[tuple[np.ndarray, np.ndarray]]:
    """Angle and rate of three drops of a leg whose muscle adds a tone [Hz, rad/s^2]."""
    each = []
    for start, phase in zip((-0.3, -0.6, -0.8), PLACES, strict=True):

        def slope(time, state, phase=phase):
            angle, rate = state
            tone = torque * np.sin(2 * np.pi * frequency * time + phase)
            return rate, -26.5 * np.cos(angle) - 3.2 * angle - 0.85 * rate + tone

        exact = {"rtol": 1e-9, "atol": 1e-10, "t_eval": TIME}
        each.append(tuple(solve_ivp(slope, (0.0, 8.0), [start, 0.0], **exact).y))
    return each


def noisy(drops, seed: int = 0):
    random = np.random.default_rng(seed)
    return [
        (
            angle + OF_ANGLE * random.normal(size=TIME.size),
            rate + OF_RATE * random.normal(size=TIME.size),
        )
        for angle, rate in drops
    ]


def cleaned(drops) -> Cleaned:
    segments = (Segment(TIME, raw_angle=angle, raw_angular_velocity=rate) for angle, rate in drops)
    return clean(Recording(tuple(segments)))


@pytest.mark.parametrize("frequency", [3.3, 4.5, 6.0, 8.0, 10.0, 12.0])
@pytest.mark.parametrize("torque", [1.0, 6.0])  # rad/s^2: 0.5 and 3 N m of a grown leg
def test_a_tremor_leaves_both_sensors_the_noise_that_they_have(frequency, torque):
    """2,400 samples tell a deviation to 1.5 %; motion adds up to a tenth to a gyro's."""
    found = cleaned(noisy(swung(frequency, torque)))
    assert found.velocity is not None
    assert found.angle.level == pytest.approx(OF_ANGLE, rel=0.15)
    assert found.velocity.level == pytest.approx(OF_RATE, rel=0.15)
    for noise in (found.angle, found.velocity):
        assert noise.alike_over == 0
        assert noise.tone is None


def test_hum_of_a_gyro_alone_is_taken_out():
    hum = np.radians(1.0) * np.sin(2 * np.pi * 12.0 * TIME)
    found = cleaned([(angle, rate + hum) for angle, rate in noisy(swung(12.0, 0.0))])
    assert found.velocity is not None
    assert found.velocity.tone is not None
    assert found.velocity.tone.frequency == pytest.approx(12.0, abs=0.05)
    assert found.velocity.level == pytest.approx(OF_RATE, rel=0.15)


@pytest.mark.parametrize("cutoff", [6.0, 8.0, 10.0])
def test_a_gyro_that_a_filter_smoothed_is_still_told(cutoff):
    smooth = butter(2, cutoff / 50.0)
    found = cleaned([(angle, filtfilt(*smooth, rate)) for angle, rate in noisy(swung(5.0, 0.0))])
    assert found.velocity is not None
    assert found.velocity.alike_over > 0


@pytest.mark.parametrize("cutoff", [6.0, 10.0, 20.0])
def test_a_rate_that_was_made_from_the_angle_is_no_second_witness(cutoff):
    """Both show the encoder's noise, the one smoothed."""
    smooth = butter(2, cutoff / 50.0)
    made = [
        (angle, filtfilt(*smooth, np.gradient(angle, TIME))) for angle, _ in noisy(swung(5.0, 0.0))
    ]
    found = cleaned(made)
    assert found.velocity is not None
    assert found.velocity.alike_over > 0
    assert found.velocity.level > 5 * OF_RATE


def left(frequency: float, torque: float, seed: int = 0):
    """What a simulation without the tone leaves, of a leg that has it, beside noise."""
    pairs = zip(noisy(swung(frequency, torque), seed), swung(frequency, 0.0), strict=True)
    return [(TIME, angle - still, rate - slow) for (angle, rate), (still, slow) in pairs]


@pytest.mark.parametrize("frequency", [3.3, 4.5, 8.0, 12.0])
def test_a_tone_is_told_by_its_frequency_and_size(frequency):
    """Its torque over J turns the leg by that over the square of 2 pi f, less gravity's 27 + 3."""
    tone = leg_tone(left(frequency, 2.0))
    assert tone is not None
    assert tone.frequency == pytest.approx(frequency, abs=0.02)
    size = 2.0 / abs((2 * np.pi * frequency) ** 2 - 29.0)
    assert tone.amplitude == pytest.approx(size, rel=0.05)
    assert tone.rate == pytest.approx(2 * np.pi * frequency * tone.amplitude, rel=1e-9)


def test_neither_noise_nor_one_sensor_nor_what_dies_out_is_a_tone_of_a_leg():
    for seed in range(20):
        assert leg_tone(left(5.0, 0.0, seed)) is None
    alone = [(time, 0.0 * angle, rate) for time, angle, rate in left(5.0, 2.0)]
    assert leg_tone(alone) is None
    fading = [
        (time, np.exp(-1.5 * time) * angle, np.exp(-1.5 * time) * rate)
        for time, angle, rate in left(5.0, 2.0)
    ]
    assert leg_tone(fading) is None


def test_a_harmonic_of_the_own_swing_is_no_tone():
    """What friction leaves of a swing of 0.9 Hz has 2.7 Hz; a rig that swings at 2.9 has that."""
    _, slow = swung(5.0, 0.0)[0]
    own = swing_of([(TIME, slow)])
    assert own == pytest.approx(np.sqrt(29.0) / (2 * np.pi), rel=0.05)
    third = left(3.0 * own, 2.0)
    assert leg_tone(third) is not None
    assert leg_tone(third, own) is None
    assert leg_tone(left(4.5, 2.0), own) is not None
    assert leg_tone(left(4.5, 2.0), 2.9) is None
    assert swing_of([(TIME, 0.0 * TIME)]) == 0.0
