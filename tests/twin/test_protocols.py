"""A virtual session: its log, its marks, its filter, its frames."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from cantools.database import load_file

from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.torque import NoTorque
from exoid.recordings.can.dbc import EXOID_DBC
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.signal.condition import best_velocity
from exoid.recordings.splitting.split import split
from exoid.twin.motion import Movement, perform
from exoid.twin.protocols import record, session
from exoid.twin.sensors import Encoder, SensorKit
from node_frames import frames

KEY = jax.random.key(3)
MOVEMENTS = (
    Movement(np.radians(-12), 5.0),
    Movement(np.radians(-30), 5.0, added_mass=1.0, added_mass_distance=0.4),
    Movement(np.radians(-6), 1.19, amplitude=-4.0),
)


@pytest.fixture(scope="module")
def model():
    values = {"mass": 4.5, "inertia": 0.42, "com_distance": 0.26, "damping": 0.33, "stiffness": 2.6}
    return LegModel(LegParameters(**{k: jnp.array(v) for k, v in values.items()}), NoTorque())


@pytest.fixture(scope="module")
def recording(model):
    return session(model, MOVEMENTS, KEY, subject=Subject(kind="leg", body_mass=74.0))


@pytest.fixture(scope="module")
def truth(model):
    return perform(model, MOVEMENTS, "1/T", 0.01)


def test_the_raw_channels_are_the_motion_within_the_noise(recording, truth):
    log, course = recording.segments[0], truth.course
    assert np.std(log.raw_angle - course.angle) == pytest.approx(8.7e-4, rel=0.05)
    assert np.std(log.raw_angular_velocity - course.angular_velocity) == pytest.approx(
        1.8e-3, rel=0.05
    )


def test_the_filtered_angle_and_rate_lag_by_less_than_a_millisecond(recording, truth):
    """Error against true rate, by regression over a drop: error = -lag * rate."""
    log, course = recording.segments[0], truth.course
    part = slice(truth.start[0] + 120, truth.end[0])
    for found, true, rate in (
        (log.angle, course.angle, course.angular_velocity),
        (log.angular_velocity, course.angular_velocity, course.angular_acceleration),
    ):
        error, slope = (found - true)[part], np.asarray(rate)[part]
        assert abs(error @ slope / (slope @ slope)) < 1e-3


def test_the_filter_takes_noise_away(recording, truth):
    log, course = recording.segments[0], truth.course
    rms = lambda found, true: np.sqrt(np.mean((found - true) ** 2))  # noqa: E731
    assert rms(log.angle, course.angle) < 0.5 * rms(log.raw_angle, course.angle)


def test_the_leg_rests_for_a_second_between_the_mark_and_the_release(recording):
    for segment in split(recording).segments:
        moving = np.abs(best_velocity(segment)) > np.radians(2)
        assert segment.time[np.flatnonzero(moving)[0]] == pytest.approx(1.0, abs=0.05)


def test_the_added_mass_changes_the_period_as_a_compound_pendulum_would(model, truth):
    """Small swings about rest: omega^2 = (c - m l g sin(rest)) / J, G cos(rest) = -c rest."""
    for number, load in ((0, 0.0), (1, 1.0)):
        weight = (4.5 * 0.26 + load * 0.4) * 9.81
        inertia = 0.42 + load * 0.4**2
        rest = -1.3
        for _ in range(50):  # a contraction
            rest = -np.arccos(np.clip(-2.6 * rest / weight, -1, 1))
        omega = np.sqrt((2.6 - weight * np.sin(rest)) / inertia)
        angle = np.asarray(truth.course.angle[truth.end[number] - 300 : truth.end[number]])
        crossings = np.flatnonzero(np.diff(np.sign(angle - rest)))
        period = 2 * np.mean(np.diff(crossings)) * 0.01
        assert period == pytest.approx(2 * np.pi / omega, rel=0.03)


def test_the_recording_says_what_was_done(recording):
    protocol, subject = recording.protocol, recording.subject
    assert protocol.kind == ("passive", "passive", "active")
    assert protocol.torque_frequency == "1/T"
    assert subject.added_mass == (0.0, 1.0, 0.0)
    assert subject.body_mass == 74.0
    parts = split(recording)
    assert [parts.cycle_period(n) for n in range(3)] == [None, None, 1.19]
    assert recording.sensors.angle_noise == pytest.approx(np.radians(0.043))


def test_the_session_splits_the_same_without_its_marks(recording):
    unmarked = replace(recording, protocol=Protocol(), subject=Subject())
    found = split(unmarked)
    assert found.protocol.kind == recording.protocol.kind
    assert found.protocol.cycle_period[2] == pytest.approx(1.19, abs=0.05)


def test_record_is_the_session_cut_at_its_marks(model, recording):
    for one, other in zip(
        record(model, MOVEMENTS, KEY).segments, split(recording).segments, strict=True
    ):
        np.testing.assert_array_equal(one.raw_angle, other.raw_angle)


def test_the_frames_decode_back_to_the_log(recording):
    log = recording.segments[0]
    log = replace(log, **{name: s[:700] for name, s in log.channels().items()})
    database = load_file(EXOID_DBC)
    sent = list(frames(log, np.random.default_rng(0), epoch=1e9, jitter=3e-4, config_crc=77))
    found = {name: [] for name in ("EXO_TIME", "EXO_STATE", "EXO_RAW", "EXO_ACC")}
    for _, identifier, data in sent:
        message = database.get_message_by_frame_id(identifier)
        found[message.name].append(message.decode(data))
    column = lambda message, name: np.array([f[name] for f in found[message]])  # noqa: E731
    for message, signal, channel, step in (
        ("EXO_STATE", "Angle", log.angle, 2**-12),
        ("EXO_STATE", "AngularVelocity", log.angular_velocity, 2**-10),
        ("EXO_STATE", "AngularAcceleration", log.angular_acceleration, 2**-5),
        ("EXO_RAW", "Angle", log.raw_angle, 1e-9),  # the counts themselves: nothing is lost
        ("EXO_RAW", "GyroY", log.raw_angular_velocity, 1e-9),
        ("EXO_ACC", "AccelX", log.raw_acceleration_x, 1e-6),
        ("EXO_ACC", "AccelZ", log.raw_acceleration_z, 1e-6),
    ):
        np.testing.assert_allclose(column(message, signal), channel, atol=step / 2 * (1 + 1e-9))
    assert (column("EXO_STATE", "Counter") == np.arange(700) % 256).all()
    assert (column("EXO_RAW", "Counter") == np.arange(700) % 16).all()
    assert column("EXO_STATE", "FilterReset").nonzero()[0].tolist() == [0]
    clock = column("EXO_TIME", "DeviceTime")
    assert clock.size == 70
    assert (np.diff(clock) == 100_000).all()
    times = np.array([time for time, *_ in sent])
    assert (np.diff(times) >= 0).all()
    assert abs(times[-1] - times[0] - log.time[-1]) < 0.01


def test_a_lost_encoder_sample_is_flagged_in_its_frame(model):
    kit = SensorKit(encoder=Encoder(missing=0.05))
    log = session(model, MOVEMENTS[:1], KEY, kit=kit).segments[0]
    state = load_file(EXOID_DBC).get_message_by_name("EXO_STATE")
    sent = frames(log, np.random.default_rng(0), epoch=0.0, jitter=1e-4, config_crc=0)
    flags = [state.decode(data)["EncoderFault"] for _, i, data in sent if i == state.frame_id]
    np.testing.assert_array_equal(np.array(flags, dtype=bool), np.isnan(log.raw_angle))
    assert np.isfinite(log.angle).all()


def test_a_log_without_raw_channels_cannot_be_sent(recording):
    log = replace(recording.segments[0], raw_angle=None)
    with pytest.raises(ValueError, match="the node sends raw_angle"):
        next(frames(log, np.random.default_rng(0), epoch=0.0, jitter=1e-4, config_crc=0))
