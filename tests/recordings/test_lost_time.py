"""Time that a clock does not know of, and motions that break off without it."""

from dataclasses import replace
from typing import Literal

import numpy as np
import pytest

import exoid
from exoid.recordings.conventions.left_out.breaks import breaks
from exoid.recordings.conventions.left_out.lost_time import TIME_LOST, without_lost_time
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.measured.samples import Samples

STEP = 0.01
TIME: Samples = STEP * np.arange(800, dtype=np.float64)
NOISE = 1e-3  # rad, of the angle; a gyro's is twice as much a second


def swing(damping: float = 0.6, seed: int = 0, speed: float = 5.0) -> tuple[Samples, Samples]:
    """A leg that is held for 1 s, let go, and swings about -1.2 rad, as both sensors show it."""
    since = np.maximum(TIME - 1.0, 0.0)
    fall, phase = np.exp(-damping * since / 2), speed * since
    angle = 0.9 * fall * (np.cos(phase) + damping / 2 / speed * np.sin(phase)) - 1.2
    rate = -0.9 * fall * (speed + damping**2 / 4 / speed) * np.sin(phase)
    random = np.random.default_rng(seed)
    return (
        angle + NOISE * random.normal(size=TIME.size),
        rate + 2 * NOISE * random.normal(size=TIME.size),
    )


def without(samples: Samples, at: int, count: int) -> Samples:
    """What is left where a clock counts rows, and some are lost."""
    return np.delete(samples, np.arange(at, at + count))


@pytest.mark.parametrize("gyro", [True, False])
@pytest.mark.parametrize(("at", "lost"), [(170, 30), (230, 60), (280, 210), (330, 35)])
def test_a_leg_that_is_elsewhere_and_at_another_speed_has_lost_time(at, lost, gyro):
    angle, rate = (without(each, at, lost) for each in swing(seed=at))
    assert breaks(TIME[: angle.size], angle, rate if gyro else None).tolist() == [at]


@pytest.mark.parametrize("gyro", [True, False])
@pytest.mark.parametrize("speed", [4.0, 6.0, 8.0])
def test_a_whole_swing_has_not(speed, gyro):
    for seed in range(5):
        angle, rate = swing(seed=seed, speed=speed)
        assert breaks(TIME, angle, rate if gyro else None).size == 0


@pytest.mark.parametrize("gyro", [True, False])
def test_a_gap_of_which_the_clock_tells_is_none(gyro):
    time, angle, rate = (without(each, 230, 60) for each in (TIME, *swing()))
    assert breaks(time, angle, rate if gyro else None).size == 0


@pytest.mark.parametrize("late", [-0.008, 0.0, 0.008])
@pytest.mark.parametrize("gyro", [True, False])
def test_a_stop_is_none_whether_or_not_its_gyro_is_late(gyro, late):
    angle, rate = swing()
    at = int(np.argmax(angle < -1.5))  # from there on back, with half the speed
    back = np.arange(1, 60)
    angle[at + 1 : at + 60] = angle[at] - 0.5 * rate[at] * STEP * back + 9.0 * (STEP * back) ** 2
    angle, rate = angle[: at + 30], rate[: at + 30]
    rate[at + 1 :] = np.gradient(angle, STEP)[at + 1 :]
    times = TIME[: angle.size]
    shown = np.interp(times - late, times, rate)
    assert breaks(times, angle, shown if gyro else None).size == 0


def test_a_wild_sample_is_none():
    for at in range(150, 400, 7):
        angle, _ = swing(seed=at)
        angle[at] += 0.15
        assert breaks(TIME, angle, None).size == 0


def recorded(angle: Samples, rate: Samples, kind: Literal["leg", "rig"] = "leg") -> exoid.Recording:
    segment = exoid.Segment(
        TIME[: angle.size], raw_angle=angle, raw_angular_velocity=rate, begins=20.0
    )
    return exoid.Recording((segment,), subject=exoid.Subject(kind=kind))


def test_the_piece_in_which_the_leg_goes_farthest_is_kept_and_it_is_said():
    angle, rate = (without(each, 230, 60) for each in swing())
    found, (note,) = without_lost_time(recorded(angle, rate))
    assert found.segments[0].time.size == 230
    assert note.startswith(f"{TIME_LOST} at 22.30 s, in segment 0")
    assert "20.00 to 22.29 s of it are used" in note
    angle, rate = (without(each, 110, 110) for each in swing())  # hardly let go yet
    found, _ = without_lost_time(recorded(angle, rate))
    assert found.segments[0].begins == pytest.approx(21.1)


def test_what_a_rig_does_and_what_is_whole_stays():
    angle, rate = (without(each, 230, 60) for each in swing())
    rig = recorded(angle, rate, kind="rig")
    assert without_lost_time(rig) == (rig, ())
    whole = recorded(*swing())
    assert without_lost_time(whole) == (whole, ())


def test_missing_samples_of_either_sensor_hide_no_loss():
    angle, rate = (without(each, 330, 35) for each in swing())
    angle[3::7], rate[100:110] = np.nan, np.nan
    _, (note,) = without_lost_time(recorded(angle, rate))
    assert note.startswith(f"{TIME_LOST} at 23.30 s")


@pytest.mark.parametrize("gyro", [True, False])
def test_a_drop_is_read_up_to_where_time_is_lost(tmp_path, gyro):
    angle, rate = (without(each, 330, 35) for each in swing())
    whole = exoid.Recording(
        (exoid.Segment(TIME, raw_angle=swing()[0]),), protocol=exoid.Protocol(kind="passive")
    )
    (segment,) = recorded(angle, rate).segments
    segment = segment if gyro else replace(segment, raw_angular_velocity=None)
    write_table(replace(whole, segments=(replace(segment, begins=0.0),)), tmp_path / "lost.csv")
    with pytest.warns(UserWarning, match=TIME_LOST):
        (lost,) = exoid.measure_drops(tmp_path / "lost.csv").drops
    (right,) = exoid.measure_drops(whole).drops
    read, true = (each.measures["period"].value for each in (lost, right))
    assert read == pytest.approx(true, abs=4e-3)  # s, four errors of a period; 0.2 s are lost
    assert lost.measures["time_to_rest"].value is None
