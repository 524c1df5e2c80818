"""Which errors of sensors are sure, before any leg model, by recordings that SciPy made."""

from dataclasses import dataclass

import numpy as np
import pytest
from faulty_sensors import Faults, cycles, drops

from exoid.fitting.data.observe import observe
from exoid.fitting.data.segment import movement
from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.sensors.consistency import consistency
from exoid.physics.sensing.encoder_second_harmonic import EncoderSecondHarmonic
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.sensing.sensor_skew import SensorSkew
from hands import Knee

SCALE, SKEW, TWICE = GyroScale, SensorSkew, EncoderSecondHarmonic
SECOND = (0.0105, 0.007)  # rad
RIGHT = {
    "a delay": (Faults(delay=5e-3), {SKEW: 5e-3}),
    "a scale": (Faults(scale=-0.02), {SCALE: -0.02}),
    "a clock": (Faults(clock=5e-3), {SCALE: 1 / 1.005 - 1}),
    "a gain": (Faults(gain=0.02), {SCALE: 1 / 1.02 - 1}),
    "twice per turn": (Faults(second=SECOND), {TWICE: SECOND}),
    "five at once": (
        Faults(zero=0.026, scale=-0.012, bias=0.03, delay=7e-3, clock=5e-3),
        {SCALE: 0.988 / 1.005 - 1, SKEW: 7e-3},
    ),
    "harmonics of a late gyro": (Faults(second=SECOND, delay=4e-3), {SKEW: 4e-3, TWICE: SECOND}),
}


def sure_of(recording):
    count = range(len(recording.segments))
    seen = observe([movement(recording, number, str(number)) for number in count], "1/T")
    return {each.fault.term: each.values for each in consistency(seen, Yardstick).sure.errors}


@pytest.mark.parametrize("name", RIGHT)
def test_all_that_the_sensors_do_wrong_is_one_estimate(name):
    faults, expected = RIGHT[name]
    found = sure_of(drops(faults))
    assert found.keys() == expected.keys()
    for term, true in expected.items():
        # A jump of the acceleration at the release is smoothed: half a percent of a delay, and
        # what it leaves goes into the harmonics, which are nearly alike over a quarter of a turn.
        within = {TWICE: 6e-4, SCALE: 4e-4}.get(term, 5e-5)
        np.testing.assert_allclose(found[term], np.atleast_1d(true), atol=within)


@pytest.mark.parametrize("make", [drops, cycles])
@pytest.mark.parametrize("seed", range(3))
def test_of_sound_sensors_nothing_is_sure(make, seed):
    assert sure_of(make(Faults(), seed=seed)) == {}


def test_a_delay_of_less_than_a_millisecond_shows_in_cycles():
    found = sure_of(cycles(Faults(delay=7e-4)))
    assert list(found) == [SKEW]
    assert found[SKEW][0] == pytest.approx(7e-4, abs=4e-5)


def test_a_bias_or_a_zero_is_left_to_every_model_of_the_leg():
    assert sure_of(drops(Faults(zero=0.03, bias=0.04))) == {}


@dataclass(frozen=True)
class Stopped(Knee):
    """A stop with spring and damper, beyond an angle of flexion."""

    at: float = -1.75  # rad
    spring: float = 0.0  # 1/s^2
    damper: float = 0.0  # 1/s

    def pull(self, angle, rate):
        depth = self.at - angle
        push = np.maximum(self.spring * depth - self.damper * rate, 0.0)
        return super().pull(angle, rate) + np.where(depth > 0, push, 0.0)


@pytest.mark.parametrize(
    ("rate", "stop", "seed"),
    [
        (100.0, Stopped(at=-1.6, spring=4e4, damper=40.0), 0),  # within two samples
        (100.0, Stopped(at=-1.6, spring=4e4, damper=40.0), 1),
        (200.0, Stopped(at=-1.6, spring=600.0, damper=60.0), 1),  # of a tenth of a second
        (400.0, Stopped(spring=9e3, damper=60.0), 0),
    ],
)
def test_a_stop_is_not_taken_for_an_encoder_that_errs_where_it_is(rate, stop, seed):
    starts = (-0.05, -0.3, -0.6, -0.7)
    recording = drops(Faults(scale=-0.015), stop, rate=rate, seed=seed, starts=starts)
    found = sure_of(recording)
    assert list(found) == [SCALE]
    assert found[SCALE][0] == pytest.approx(-0.015, abs=6e-4)
