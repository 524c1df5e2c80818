"""A hand that sways as it keeps a leg lets go when it lets go, not when it sways."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import BPoly

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.landmarks.release import find_release
from exoid.recordings.landmarks.track import track_of
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.drops import find_drops
from exoid.recordings.recording import Recording
from exoid.recordings.splitting.split import cut_table
from hands import ADULT

STEP = 0.01  # s
LIFT, HOLD, FREE = 1.5, 1.2, 7.0  # s
TURN = 2 * np.pi * 0.7  # rad/s, of a hand that sways
NOISE = 1e-3, 5e-3  # rad, rad/s


def kept(at: float, sway: float, phase: float) -> np.ndarray:
    """Angle and speed of a leg in a hand that sways: (channel, sample)."""
    turned = TURN * np.arange(0.0, HOLD, STEP) + phase
    return np.stack([at + sway * np.sin(turned), sway * TURN * np.cos(turned)])


def unsteady(turn: float, sway: float, seed: int) -> tuple[Segment, float]:
    """A drop out of a hand that sways at two frequencies [rad/s, rad], and when it was let go [s].

    The leg goes on as the hand moved it: at its speed, without what the hand did against gravity.
    """
    rng = np.random.default_rng(seed)
    phases, time = rng.uniform(0, 2 * np.pi, (2, 1)), np.arange(0.0, HOLD + FREE, STEP)
    turns, sizes = turn * np.array([[1.0], [2.3]]), sway / 1.5 * np.array([[1.0], [0.5]])
    until = time[time <= HOLD]
    hold = np.stack(
        [
            (sizes * np.sin(turns * until + phases)).sum(0) + rng.uniform(-0.7, -0.2),
            (sizes * turns * np.cos(turns * until + phases)).sum(0),
        ]
    )
    free = solve_ivp(
        lambda _, y: (y[1], ADULT.pull(*y)),
        (until[-1], time[-1]),
        hold[:, -1],
        t_eval=time[time > HOLD],
        rtol=1e-8,
    )
    leg = np.concatenate([hold, free.y], axis=1)
    angle, speed = leg + np.array([NOISE]).T * rng.normal(size=leg.shape)
    return Segment(time, raw_angle=angle, raw_angular_velocity=speed), until[-1]


def session(sway: float, seed: int) -> tuple[Recording, list[float]]:
    """Three drops, and when each leg was let go [s]: from a hold that sways [rad]."""
    rng, leg, releases = np.random.default_rng(seed), np.array([[-1.4], [0.0]]), []
    for start in np.radians([-20.0, -42.0, -30.0]):
        hold = kept(start, sway, rng.uniform(0, 2 * np.pi))
        path = BPoly.from_derivatives([0.0, LIFT], [leg[:, -1], hold[:, 0]])
        time = np.arange(0.0, LIFT, STEP)
        leg = np.concatenate([leg, [path(time), path.derivative()(time)], hold], axis=1)
        releases.append(STEP * (leg.shape[1] - 1))
        free = solve_ivp(
            lambda _, y: (y[1], ADULT.pull(*y)),
            (0.0, FREE),
            leg[:, -1],
            t_eval=np.arange(STEP, FREE, STEP),
            rtol=1e-8,
        )
        leg = np.concatenate([leg, free.y], axis=1)
    angle, speed = leg + np.array([NOISE]).T * rng.normal(size=leg.shape)
    segment = Segment(STEP * np.arange(angle.size), raw_angle=angle, raw_angular_velocity=speed)
    return Recording((segment,), Subject(kind="leg"), Protocol(), Sensors()), releases


@pytest.mark.parametrize("sway", [0.3, 1.0, 1.5, 2.5])
@pytest.mark.parametrize("seed", range(5))
def test_a_drop_begins_where_a_hand_that_sways_lets_go(sway, seed):
    recording, releases = session(np.radians(sway), seed)
    cut = cut_table(recording).recording
    assert set(cut.protocol.kind) == {"passive"}
    drops = find_drops(cut)
    # A hand that sways bends the hold by up to a degree: 3 ms of a fall.
    for number, (segment, release) in enumerate(zip(cut.segments, releases, strict=True)):
        begun, error = drops[number].release, drops[number].release_error
        assert segment.begins + begun == pytest.approx(release, abs=3 * error + 3e-3)
        free = segment.begins + segment.time[drops[number].free]
        assert release <= free < release + 0.2


@pytest.mark.parametrize("gyro", [True, False])
@pytest.mark.parametrize("hertz", [0.9, 1.2, 1.8])
@pytest.mark.parametrize("seed", range(5))
def test_a_hand_that_sways_as_fast_as_a_small_swing_has_not_let_go(gyro, hertz, seed):
    """At up to 20 deg/s; its acceleration, up to a third of a fall's, moves the release by less
    than half of the 50 ms in which the leg falls by a degree.
    """
    segment, release = unsteady(2 * np.pi * hertz, np.radians(1.5), seed)
    if not gyro:
        segment = replace(segment, raw_angular_velocity=None)
    recording = Recording((segment,), Subject(kind="leg"), Protocol(kind="passive"), Sensors())
    extent = find_drops(recording)[0]
    assert extent.held_until is not None
    assert extent.release == pytest.approx(release, abs=0.025)
    assert segment.time[extent.free] >= release
    assert extent.ended == "recording stopped"


@pytest.mark.parametrize("first", [0.0, 0.05, 0.1])
def test_a_free_leg_that_turns_around_at_the_begin_of_a_record_is_not_in_a_hand(first):
    """It rises by up to 4 deg and falls, as evenly as a leg out of a hand does not."""
    time = np.arange(0.0, FREE, STEP)
    free = solve_ivp(
        lambda _, y: (y[1], ADULT.pull(*y)), (0.0, FREE), [-0.5, 20 * first], t_eval=time, rtol=1e-8
    )
    angle, speed = free.y + np.array([NOISE]).T * np.random.default_rng(1).normal(size=free.y.shape)
    segment = Segment(time, raw_angle=angle, raw_angular_velocity=speed)
    recording = Recording((segment,), Subject(kind="leg"), Protocol(kind="passive"), Sensors())
    assert find_drops(recording)[0].held_until is None


@pytest.mark.parametrize("sway", [0.3, 1.5, 2.5])
@pytest.mark.parametrize("seed", range(3))
def test_the_angle_at_which_it_let_go_is_as_unsure_as_the_hand_moves_it(sway, seed):
    recording, releases = session(np.radians(sway), seed)
    (log,), cut = recording.segments, cut_table(recording).recording
    for number, release in enumerate(releases):
        extent = find_drops(cut)[number]
        start = find_release(track_of(cut.segments[number], NOISE[0]), extent).start
        there = log.raw_angle[round(release / STEP)]
        assert abs(start.value - there) < 3 * np.hypot(start.error, NOISE[0])
        assert start.error < np.radians(sway)


def test_of_a_hand_that_keeps_still_the_angle_is_as_sure_as_its_noise():
    cut = cut_table(session(0.0, 0)[0]).recording
    for number, extent in find_drops(cut).items():
        start = find_release(track_of(cut.segments[number], NOISE[0]), extent).start
        assert start.error < NOISE[0]  # twenty samples do not tell it from one that moves by that
