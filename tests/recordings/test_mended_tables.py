"""What loggers are known to do to a table is undone, and what is not only that is refused."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from tests.swings import Oscillator

import exoid
from exoid.recordings.tables.mending.clock_overflow import going_on

STEP = 0.01  # s
TIME = STEP * np.arange(800)
LEG = Oscillator()
ANGLE, RATE = np.degrees(LEG.angle(TIME)), np.degrees(LEG.velocity(TIME))


def loaded(folder, time=TIME, angle=ANGLE, rate=RATE, segment=None, sensors=""):
    """What is loaded of a leg's table as a logger writes it."""
    path = folder / "leg.csv"
    path.with_suffix(".toml").write_text(f'[subject]\nkind = "leg"\n[sensors]\n{sensors}\n')
    segment = np.zeros(np.size(time), int) if segment is None else segment
    rows = zip(time, segment, angle, rate, strict=True)
    lines = [f"{t:.6g},{n},{a:.6g},{r:.6g}" for t, n, a, r in rows]
    path.write_text("\n".join(["time_s,segment,raw_angle_deg,raw_velocity_deg_s", *lines, ""]))
    return exoid.load(path, whole=True)


def angle_of(found, segment=0):
    return np.degrees(found.recording.segments[segment].best_angle)


@pytest.mark.parametrize(("zero", "least"), [(70.0, 0.0), (-120.0, -180.0), (250.0, 0.0)])
def test_an_encoder_that_passes_its_last_count_goes_on(tmp_path, zero, least):
    shown = (ANGLE + zero - least) % 360 + least
    twice = np.concatenate([shown, shown])
    segment = np.repeat([0, 1], TIME.size)
    found = loaded(
        tmp_path,
        np.tile(TIME, 2),
        twice,
        np.tile(RATE, 2),
        segment,
        sensors=f"angle_zero_deg = {zero}",
    )
    for number in range(2):
        np.testing.assert_allclose(angle_of(found, number), ANGLE, atol=1e-3)  # six digits
    if np.ptp(shown) > 180:
        assert any("whole turns are added" in note for note in found.notes)


def rig(folder, angle, said="", rate=200.0):
    """What is loaded of a rig's table of an angle [rad]."""
    path = folder / "rig.csv"
    path.with_suffix(".toml").write_text(f'[subject]\nkind = "rig"\n{said}\n')
    rows = [f"{n / rate:.6g},{each:.6f}" for n, each in enumerate(angle)]
    path.write_text("\n".join(["time_s,raw_angle_rad", *rows, ""]))
    return exoid.load(path, whole=True).recording.segments[0].best_angle


def pendulum(spin, *, rate=200.0):
    """The angle [rad] of one on a bench that is pushed where it hangs, at `spin` rad/s, for 9 s."""
    return solve_ivp(
        lambda _, now: [now[1], -40.0 * np.cos(now[0]) - 0.3 * now[1]],
        (0.0, 9.0),
        [-np.pi / 2, spin],
        t_eval=np.arange(0.0, 9.0, 1 / rate),
        rtol=1e-8,
    ).y[0]


@pytest.mark.parametrize("spin", [-11.0, 18.0, 60.0])  # 2 sqrt(40) = 12.6 go over the top
def test_a_rig_whose_encoder_passes_its_last_count_goes_on(tmp_path, spin):
    angle = pendulum(spin)
    shown = (angle + np.pi) % (2 * np.pi) - np.pi
    found = rig(tmp_path, shown, 'spring = "none"')
    np.testing.assert_allclose(np.diff(found), np.diff(angle), atol=2e-6)  # six digits
    assert abs(np.median(found)) < np.pi


def test_a_rig_without_a_spring_may_go_round_but_no_swing_is_taken_for_that(tmp_path):
    round_and_round = pendulum(18.0)
    assert np.ptp(round_and_round) > 14.0
    np.testing.assert_allclose(
        rig(tmp_path, round_and_round, 'spring = "none"'), round_and_round, atol=1e-6
    )
    with pytest.raises(ValueError, match='Then say kind = "rig", spring = "none"'):
        rig(tmp_path, round_and_round)
    with pytest.raises(ValueError, match="Is it in degrees"):
        rig(tmp_path, np.degrees(pendulum(3.0)), 'spring = "none"')


def test_other_jumps_beside_those_by_a_turn_are_refused_by_name(tmp_path):
    shown = (ANGLE + 70) % 360
    shown[400:420] = 180.0
    with pytest.raises(ValueError, match="Does the encoder pass 0 or 360 deg"):
        loaded(tmp_path, angle=shown)


def test_a_number_that_stands_for_none_is_none(tmp_path):
    angle, rate = ANGLE.copy(), RATE.copy()
    angle[5::37], rate[7::40] = -999, 9999
    found = loaded(tmp_path, angle=angle, rate=rate)
    segment = found.recording.segments[0]
    np.testing.assert_array_equal(np.isnan(segment.best_angle), angle == -999)
    np.testing.assert_array_equal(
        np.isnan(segment.channels()["raw_angular_velocity"]), rate == 9999
    )
    assert sum("far from all others" in note for note in found.notes) == 2


def test_a_gyro_that_passes_999_deg_a_second_loses_nothing(tmp_path):
    rate = np.linspace(-999, 999, TIME.size)
    segment = loaded(tmp_path, rate=rate).recording.segments[0]
    assert not np.isnan(segment.channels()["raw_angular_velocity"]).any()


def test_rows_that_stand_twice_are_taken_once_and_lines_still_count(tmp_path):
    row = np.sort(np.concatenate([np.arange(TIME.size), [3, 200, 500]]))
    found = loaded(tmp_path, TIME[row], ANGLE[row], RATE[row])
    np.testing.assert_allclose(angle_of(found), ANGLE, atol=1e-3)
    said = "3 rows are there twice, with the same time and values: taken once."
    assert any(note.endswith(said) for note in found.notes)
    time = TIME.copy()
    time[600] = 0.0
    with pytest.raises(ValueError, match="line 605: time_s must increase"):  # a header, three more
        loaded(tmp_path, time[row], ANGLE[row], RATE[row])


@pytest.mark.parametrize("rate", [101.0, 128.0, 250.0])
def test_times_that_were_rounded_until_some_are_alike_are_even(tmp_path, rate):
    taken = np.arange(900) / rate
    angle, speed = np.degrees(LEG.angle(taken)), np.degrees(LEG.velocity(taken))
    found = loaded(tmp_path, np.round(taken, 2), angle, speed)
    # a line through 900 times that are off by 10 ms / sqrt(12) is known to 3e-5 of its slope
    assert np.diff(found.recording.segments[0].time) == pytest.approx(1 / rate, rel=2e-4)
    assert any("times are rounded" in note for note in found.notes)


def test_rounded_times_of_a_table_with_a_gap_are_refused_with_a_way_out(tmp_path):
    taken = np.delete(np.arange(900) / 128, slice(300, 330))
    angle, speed = np.degrees(LEG.angle(taken)), np.degrees(LEG.velocity(taken))
    with pytest.raises(ValueError, match="give sample_rate_hz"):
        loaded(tmp_path, np.round(taken, 2), angle, speed)


@pytest.mark.parametrize("tick", [1e-6, 1e-3])
@pytest.mark.parametrize("began", [0.0, 3.0])  # s before it is full; 0 where it was set to 0 then
def test_a_clock_that_counts_to_two_to_the_32_goes_on(tick, began):
    full = 2**32 * tick
    shown = TIME + full - 3.0
    shown[shown >= full] -= full
    found = going_on(shown - (full - began))
    assert found is not None
    time, ticks = found
    np.testing.assert_allclose(np.diff(time), STEP, atol=1e-8)  # of times of 50 days
    assert ticks == {1e-6: "microseconds", 1e-3: "milliseconds"}[tick]


def test_a_full_clock_of_a_table_is_mended_and_said(tmp_path):
    shown = np.round((TIME + 4291.967296) * 1e6) % 2**32
    path = tmp_path / "leg.csv"
    path.with_suffix(".toml").write_text('[columns]\ntime_us = "micros"\n')
    rows = [f"{t:.0f},{a:.6g}" for t, a in zip(shown, ANGLE, strict=True)]
    path.write_text("\n".join(["micros,raw_angle_deg", *rows, ""]))
    found = exoid.load(path, whole=True)
    assert np.diff(found.recording.segments[0].time) == pytest.approx(STEP, abs=1e-6)
    assert any("a counter of 2^32 microseconds is full" in note for note in found.notes)


@pytest.mark.parametrize("behind", [-1.0, 1.5])  # s, of where a full clock would have gone on
def test_a_clock_that_begins_again_otherwise_is_refused_with_a_way_out(tmp_path, behind):
    time = np.where(TIME < 4.0, TIME + 4290.0, TIME + 4290.0 - 2**32 * 1e-6 + behind)
    assert going_on(time) is None
    with pytest.raises(ValueError, match=r"number them in a column segment|did the clock wrap"):
        loaded(tmp_path, np.where(TIME < 4.0, TIME, TIME - 4.0))


@pytest.mark.parametrize("turned", [True, False])
def test_an_angle_that_goes_over_to_another_unit_is_said(tmp_path, turned):
    shown = np.where((TIME < 4.0) == turned, ANGLE, np.radians(ANGLE))
    said = "from 4.00 s on the angle is 57.3 times as large or small"
    assert any(said in note for note in loaded(tmp_path, angle=shown).notes)
    assert not any("57.3" in note for note in loaded(tmp_path).notes)
    zeros = np.where(TIME < 4.0, ANGLE, 0.0)
    assert not any("57.3" in note for note in loaded(tmp_path, angle=zeros).notes)
