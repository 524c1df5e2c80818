"""Values that a fast logger writes again, and such as are alike by themselves."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.recordings.conventions.left_out.held_values import without_held

TIME = np.linspace(0.0, 4.99, 500)
LEG = solve_ivp(
    lambda _, y: [y[1], -27.0 * np.cos(y[0]) - 4.0 * y[0] - 0.6 * y[1]],
    (0.0, 5.0),
    [np.radians(-15.0), 0.0],
    dense_output=True,
    rtol=1e-9,
).sol
ANGLE, RATE = LEG(TIME)
RANDOM = np.random.default_rng(1)
NOISE = np.radians(0.08)


def recorded(angle: np.ndarray, rate: np.ndarray | None = None) -> exoid.Recording:
    return exoid.Recording((exoid.Segment(TIME, raw_angle=angle, raw_angular_velocity=rate),))


@pytest.mark.parametrize("often", [2, 3, 5])
def test_an_angle_that_stands_more_than_once_is_taken_once(often):
    measured = ANGLE[::often] + NOISE * RANDOM.normal(size=ANGLE[::often].size)
    made, (note,) = without_held(recorded(np.repeat(measured, often)[: TIME.size]))
    assert made.segments[0].time == pytest.approx(TIME[::often])
    assert made.segments[0].best_angle.tolist() == measured.tolist()
    assert note.startswith(f"values of the angle stand {often} times in a row")


def test_a_gyro_of_another_rate_leaves_the_angle_whole():
    taken = np.arange(-0.1, 5.0, 1 / 52)
    latest = np.searchsorted(taken, TIME, "right") - 1
    rate = (LEG(np.maximum(taken, 0))[1] + 0.005 * RANDOM.normal(size=taken.size))[latest]
    angle = ANGLE + NOISE * RANDOM.normal(size=TIME.size)
    made, (note,) = without_held(recorded(angle, rate))
    assert note.startswith("values of the gyro come at 52 Hz and stand 2 times")
    (segment,) = made.segments
    assert segment.best_angle.tolist() == angle.tolist()
    assert segment.raw_angular_velocity is not None
    kept = ~np.isnan(segment.raw_angular_velocity)
    first = np.concatenate([[True], latest[1:] != latest[:-1]])
    assert kept.tolist() == first.tolist()
    # late by up to 10 ms of 27 rad/s^2, 0.078 rad/s rms, but for the noise of 0.005 rad/s
    moved = kept & (TIME > 0.2) & (TIME < 2.0)
    assert np.std(segment.raw_angular_velocity[moved] - RATE[moved]) < 2 * 0.005


@pytest.mark.parametrize("step", [0.09, 0.3, 1.5, 3.0])
def test_an_encoder_whose_steps_are_coarse_is_left_alone(step):
    """It repeats values by itself, where it moves by less than its step."""
    for noise in (0.0, 0.3 * step):
        seen = np.degrees(ANGLE) + noise * RANDOM.normal(size=TIME.size)
        recording = recorded(np.radians(step * np.round(seen / step)))
        assert without_held(recording) == (recording, ())


def test_a_leg_at_rest_and_samples_lost_now_and_then_are_left_alone():
    rest = np.concatenate([np.full(200, ANGLE[0]), ANGLE[:300]])
    lost = ANGLE.copy()
    for at in range(60, 480, 40):
        lost[at : at + 5] = lost[at]
    for each in (rest, lost):
        recording = recorded(each)
        assert without_held(recording) == (recording, ())


def test_words_beside_go_with_their_samples():
    segment = recorded(np.repeat(ANGLE[::2], 2)).segments[0]
    words = tuple(map(str, range(TIME.size)))
    recording = exoid.Recording((replace(segment, extra_columns={"note": words}),))
    made, _ = without_held(recording)
    assert made.segments[0].extra_columns["note"] == words[::2]
