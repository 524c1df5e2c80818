"""The noise of an angle that a motor moves more quickly than a leg swings."""

import numpy as np
import pytest
from scipy.signal import butter, filtfilt

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.clean import clean

NOISE = 1e-4  # rad
INERTIA, DAMPING, FRICTION = 0.021, 0.035, 0.11  # kg m^2, N m s/rad, N m: a motor's axis
STEP = 5e-4  # s


def drive(time):
    """Two sines [N m]."""
    return 0.45 * np.sin(2 * np.pi * 0.9 * time) + 0.25 * np.sin(2 * np.pi * 2.3 * time + 1)


def turned(rate, friction):
    """Time, angle and torque of an axis that sticks where the torque is below its dry friction."""
    time = np.arange(0, 10, STEP)
    angle, velocity, angles = 0.0, 0.0, np.empty(time.size)
    for at, torque in enumerate(drive(time).tolist()):
        angles[at] = angle
        pull = torque - DAMPING * velocity
        way = np.sign(velocity or pull)
        sticks = velocity == 0 and abs(pull) <= friction
        faster = 0.0 if sticks else velocity + STEP * (pull - friction * way) / INERTIA
        faster = 0.0 if friction and faster * velocity < 0 else faster
        angle, velocity = angle + STEP * (velocity + faster) / 2, faster
    each = round(1 / rate / STEP)
    return time[::each], angles[::each], drive(time[::each])


def cleaned(time, angle, torque, **sensors):
    segment = Segment(time, raw_angle=angle, applied_torque=torque)
    rig = Subject(kind="rig", gravity="none", spring="none")
    return clean(Recording((segment,), rig, sensors=Sensors(**sensors))).angle


def shaken(size, seed=0):
    return NOISE * np.random.default_rng(seed).normal(size=size)


@pytest.mark.parametrize("friction", [0.0, FRICTION])
@pytest.mark.parametrize("rate", [100, 200, 500, 1000])
@pytest.mark.parametrize("bits", [None, 14])
def test_a_motor_that_is_quicker_than_a_leg_is_not_called_smoothed(rate, friction, bits):
    """Of 16 bits its rounding is a third of the noise, of 14 bits it is more."""
    time, angle, torque = turned(rate, friction)
    shown = angle + shaken(time.size)
    step = 2 * np.pi / 2**bits if bits else 0.0
    found = cleaned(time, np.round(shown / step) * step if bits else shown, torque)
    assert found.alike_over == 0
    assert found.level == pytest.approx(np.hypot(NOISE, step / np.sqrt(12)), rel=0.15)


def test_a_camera_too_slow_to_tell_a_quick_motion_from_smoothed_errors_claims_none():
    time, angle, torque = turned(25, FRICTION)
    assert cleaned(time, angle + shaken(time.size), torque).alike_over == 0


@pytest.mark.parametrize("how", ["mean", "Butterworth", "lines"])
def test_an_angle_of_a_motor_that_was_smoothed_is_told(how):
    time, angle, torque = turned(200, FRICTION)
    noise, fewer = np.radians(0.5), 7 if how == "lines" else 1
    if how == "lines":
        few = time[::fewer]
        smooth = np.interp(time, few, angle[::fewer] + noise / NOISE * shaken(few.size))
    else:
        filters = {"mean": (np.ones(10) / 10, 1.0), "Butterworth": butter(2, 10 / 100)}
        smooth = filtfilt(*filters[how], angle + noise / NOISE * shaken(time.size))
    found = cleaned(time, smooth, torque)
    assert 0.02 < found.alike_over < 0.11
    assert 0.3 < found.level / (noise * np.sqrt(fewer)) < 3  # fewer samples tell less


def test_white_noise_that_is_declared_is_not_overruled_by_how_something_moves():
    """By a slow camera nothing but the sidecar tells a quick motion from errors that are alike."""
    time, angle, _ = turned(1000, FRICTION)
    alone = Segment(time, raw_angle=angle + shaken(time.size))  # no torque says that a motor acts
    found = [
        clean(Recording((alone,), sensors=Sensors(angle_noise=declared))).angle
        for declared in (NOISE, None)
    ]
    assert found[0].level == pytest.approx(NOISE, rel=0.1)
    assert [each.alike_over > 0 for each in found] == [False, True]


def rattling(rate):
    """Time, angle and torque of a motor whose load hangs in a play of 1 deg."""
    time, step = np.arange(0, 6, 1e-4), 1e-4
    motor = load = fast = swing = 0.0
    angles = np.empty(time.size)
    for at, torque in enumerate((1.2 * np.sin(2 * np.pi * 0.9 * time)).tolist()):
        angles[at] = motor
        beyond = load - motor - np.clip(load - motor, -0.0087, 0.0087)
        push = 4000 * beyond + 2.0 * (swing - fast) * (beyond != 0)
        fast += step * (torque + push - 0.05 * fast - 0.1 * np.sign(fast)) / 0.03
        swing += step * (-push - 3.0 * np.sin(load)) / 0.1
        motor, load = motor + step * fast, load + step * swing
    each = round(1 / rate / 1e-4)
    return time[::each], angles[::each], 1.2 * np.sin(2 * np.pi * 0.9 * time[::each])


@pytest.mark.parametrize("bits", [12, 14])
def test_an_angle_on_the_steps_of_its_encoder_was_smoothed_by_nobody(bits):
    """A motor that rattles in its play scattered by 50 times its steps, "smoothed"."""
    time, angle, torque = rattling(200)
    step = 2 * np.pi / 2**bits
    shown = np.round((angle + shaken(time.size)) / step) * step
    found = cleaned(time, shown, torque, encoder_counts=2.0**bits)
    assert found.alike_over == 0
    assert cleaned(time, shown, torque).level >= found.level  # where nobody says what its steps are
