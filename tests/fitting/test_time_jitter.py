"""Samples whose times are off: seen in their noise, weighed, and told; by a solver of SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.fitting.data.segment import movement
from exoid.fitting.data.time_jitter import time_jitter
from exoid.report.words.diagnosis.sentences import sentences

GRAVITY, STIFFNESS, DAMPING = 27.752, 6.579, 1.0526  # over the inertia
CLOCK = 0.01 * np.arange(500)
STEP = np.radians(0.5)  # of a coarse encoder
NOISE, RATE_NOISE = np.radians(0.1), np.radians(0.2)


@pytest.fixture(scope="module")
def leg():
    """How a leg swings from three angles, at any time."""

    def slope(time, state):
        angle, rate = state
        return rate, -GRAVITY * np.cos(angle) - STIFFNESS * angle - DAMPING * rate

    starts = np.radians([-10.0, -25.0, -40.0])
    span, exact = (0.0, 6.0), {"rtol": 1e-9, "atol": 1e-10, "dense_output": True}
    return [solve_ivp(slope, span, [start, 0.0], **exact).sol for start in starts]


def recorded(leg, jitter: float, seed: int, stopped: float = 0.0, time=CLOCK) -> exoid.Recording:
    """Held for 0.3 s, then free; samples are taken `jitter` s from where their times say, and the
    gyro's are `stopped` [rad/s] lower from the third second on.
    """
    random, segments = np.random.default_rng(seed), []
    for swing in leg:
        taken = time + jitter * random.normal(size=time.size)
        angle, rate = swing(np.maximum(taken - 0.3, 0.0))
        angle = angle + NOISE * random.normal(size=time.size)
        rate = np.where(taken > 0.3, rate, 0.0) - stopped * (taken > 3.0)
        rate = rate + RATE_NOISE * random.normal(size=time.size)
        segments.append(exoid.Segment(time, raw_angle=angle, raw_angular_velocity=rate))
    subject = exoid.Subject(body_mass=72.0, height=1.75)
    return exoid.Recording(
        tuple(segments), subject=subject, protocol=exoid.Protocol(kind="passive")
    )


@pytest.mark.parametrize("jitter", [1e-3, 3e-3])
def test_times_that_are_off_are_told_in_milliseconds(leg, jitter):
    """Three drops tell a standard deviation to some 8 %: by a quarter in one of a thousand."""
    one = recorded(leg, jitter, 0)
    for channel in ("raw_angle", "raw_angular_velocity"):
        found = time_jitter(one, channel)
        assert found is not None
        assert found.jitter == pytest.approx(jitter, rel=0.25)


def test_noise_that_does_not_grow_is_no_jitter(leg):
    each = [recorded(leg, 0.0, seed) for seed in range(20)]
    assert {time_jitter(one, "raw_angle") for one in each} == {None}
    assert {time_jitter(one, "raw_angular_velocity") for one in each} == {None}


@pytest.mark.parametrize("noise", [0.01, 0.02])
def test_the_rounding_of_a_coarse_encoder_is_no_jitter(noise):
    """Of a leg that creeps back, in steps of 0.5 deg; with little noise, none shows at rest."""
    one = crept(noise, 0.0)
    assert {time_jitter(one(seed), "raw_angle") for seed in range(10)} == {None}


def test_jitter_shows_beside_rounding():
    """Few samples of such a leg are fast: they tell 5 ms to some 10 %."""
    found = time_jitter(crept(0.01, 5e-3)(0), "raw_angle")
    assert found is not None
    assert found.jitter == pytest.approx(5e-3, rel=0.33)
    assert found.steady > 0.999 * STEP / np.sqrt(12)


def crept(noise: float, jitter: float):
    """A very damped leg, held for 0.6 s, then free, by an encoder with steps of 0.5 deg whose
    `noise` is in degrees; samples are taken `jitter` s from where their times say.
    """

    def slope(_, state):
        angle, rate = state
        return rate, -24.0 * np.cos(angle) - 5.0 * angle - 8.0 * rate

    def recording(seed: int) -> exoid.Recording:
        random, segments, clock = np.random.default_rng(seed), [], 0.01 * np.arange(760)
        for start in np.radians([-15.0, -30.0, -50.0, -22.0]):
            swing = solve_ivp(slope, (0.0, 8.0), [start, 0.0], rtol=1e-9, dense_output=True).sol
            taken = clock + jitter * random.normal(size=clock.size)
            angle = swing(np.maximum(taken - 0.6, 0.0))[0]
            angle = angle + np.radians(noise) * random.normal(size=clock.size)
            segments.append(exoid.Segment(clock, raw_angle=np.round(angle / STEP) * STEP))
        return exoid.Recording(tuple(segments), subject=exoid.Subject(body_mass=72.0, height=1.75))

    return recording


def test_a_leg_that_strikes_is_no_jitter(leg):
    assert time_jitter(recorded(leg, 0.0, 0, stopped=1.0), "raw_angular_velocity") is None


def test_fast_samples_count_less_and_the_noise_is_that_of_all_of_them(leg):
    each = movement(recorded(leg, 1e-3, 0), 0, "0")
    assert each.angle_jitter is not None
    own = each.angle_jitter.noise(each.segment.time, each.angle)
    assert own.max() > 2 * own.min()
    assert each.angle_noise == pytest.approx(np.sqrt(np.mean(own**2)), rel=0.05)


def test_errors_hold_and_it_is_said(leg):
    """The mean square of 18 deviations is below 2.2 in 998 of 1000."""
    deviations = []
    for seed in range(6):
        found = exoid.fit(recorded(leg, 1e-3, seed), multistart=4)
        assert any("times are off by" in note for note in found.notes)
        for name, true in (
            ("gravity_over_inertia", GRAVITY),
            ("stiffness_over_inertia", STIFFNESS),
            ("damping_over_inertia", DAMPING),
        ):
            one = found.ratios[name]
            assert one.standard_error is not None
            deviations.append((one.value - true) / one.standard_error)
    assert np.mean(np.square(deviations)) < 2.2


def test_nothing_is_missing_where_only_times_are_off(leg):
    fast = CLOCK[:240]  # in which the leg swings most; other diagnoses have its programs
    found = exoid.diagnose(recorded(leg, 2e-3, 1, time=fast), multistart=4)
    assert found.verdict == "none"
    assert "Times are off by" in sentences(found)["Sensors"]
