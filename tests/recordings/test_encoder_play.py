"""Play between legs that SciPy moves and their encoders, and faults of sensors that are none."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.recordings.signal.both_sensors.clean import clean

TIME = np.linspace(0.0, 5.0, 501)
FINE = 10  # steps of the motion in one between samples
HELD = 0.4  # s
NOISE = np.radians([0.06, 0.2])  # rad, rad/s


def moved(start: float) -> tuple[np.ndarray, np.ndarray]:
    """Angle and rate of a leg that is let go from `start` [deg]."""
    time = np.linspace(0.0, 5.0, FINE * 500 + 1)
    legs = solve_ivp(
        lambda _, y: [y[1], -27.0 * np.cos(y[0]) - 4.0 * y[0] - 0.6 * y[1]],
        (0.0, 5.0),
        [np.radians(start), 0.0],
        t_eval=np.maximum(time - HELD, 0.0)[time >= HELD],
        rtol=1e-9,
    )
    before = np.count_nonzero(time < HELD)
    angle, rate = (np.concatenate([np.full(before, each[0]), each]) for each in legs.y)
    return angle, rate


def behind(angle: np.ndarray, play: float, first: float) -> np.ndarray:
    """What a pin in a slot of the width `play` shows, `first` of half of it ahead at first."""
    shown, now = np.empty_like(angle), angle[0] + first * play / 2
    for number, each in enumerate(angle):
        now = min(max(now, each - play / 2), each + play / 2)
        shown[number] = now
    return shown


def recorded(
    play: float, seed: int = 0, *, scale: float = 1.0, late: int = 0, magnet: float = 0.0
) -> exoid.Recording:
    """Three drops; a gyro that is `late` by so many fine steps, a magnet off its centre [rad]."""
    random, segments = np.random.default_rng(seed), []
    for start in (-15.0, -25.0, -35.0):
        angle, rate = moved(start)
        shown = behind(angle, play, random.uniform(-1, 1)) + magnet * np.sin(angle)
        seen = shown[::FINE] + NOISE[0] * random.normal(size=TIME.size)
        turns = (
            scale * np.roll(rate, late)[::FINE] + 0.01 + NOISE[1] * random.normal(size=TIME.size)
        )
        segments.append(exoid.Segment(TIME, raw_angle=seen, raw_angular_velocity=turns))
    return exoid.Recording(tuple(segments))


@pytest.mark.parametrize("width", [0.3, 0.8, 2.0])
def test_play_is_told_within_its_error_and_taken_out(width):
    """Beside other faults; what is left of the encoder follows the leg to its noise."""
    recording = recorded(np.radians(width), scale=1.01, late=15, magnet=0.003)
    found = clean(recording)
    play = found.angle.play
    assert play is not None
    # The gyro turns by 1 % more than the leg, and so it tells the play.
    assert abs(play.width - np.radians(width)) < 4 * play.standard_error + 0.01 * play.width
    for start, each in zip((-15.0, -25.0, -35.0), found.recording.segments, strict=True):
        true = moved(start)[0][::FINE]
        off = each.best_angle - true - 0.003 * np.sin(true)
        # Where in its slot a pin began is sought to an eighth of half the play.
        assert np.std(off) < 1.1 * np.hypot(NOISE[0], play.width / 16)


@pytest.mark.parametrize("seed", range(6))
def test_sensors_without_play_have_none(seed):
    """Sound ones, a gyro that is late, one of a wrong scale, a magnet off its centre."""
    for scale, late, magnet in ((1.0, 0, 0.0), (1.0, 60, 0.0), (1.05, 0, 0.0), (1.0, 0, 0.02)):
        found = clean(recorded(0.0, seed, scale=scale, late=late, magnet=magnet))
        assert found.angle.play is None


def test_a_fit_says_it_and_has_the_leg_right():
    found = exoid.fit(recorded(np.radians(0.8)), multistart=4)
    (said,) = [each for each in found.notes if "play between the two" in each]
    assert said.startswith("the encoder stands still over 0.80 ±")
    for name, true in (("damping_over_inertia", 0.6), ("gravity_over_inertia", 27.0)):
        ratio = found.ratios[name]
        assert ratio.value is not None
        assert ratio.standard_error is not None
        assert abs(ratio.value - true) < 4 * ratio.standard_error
