"""Files of other sensors than the node: noisier, slower, faster, without a gyro, cut short."""

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.online import world

from exoid import online
from exoid.cli.live.replay import of_recording
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.watching.estimate.expect import expected_of
from exoid.watching.estimate.leg import Leg, LegDrop, Person
from exoid.watching.estimate.load import Load
from exoid.watching.estimate.moment import Moment
from hands import Knee
from legs import fall
from reflexes import ADULT, stretched, thrown

SUBJECT = Subject(kind="leg", body_mass=77.0, height=1.80)
TICK = 1e-3  # s, of what is simulated
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000


def measured(motion, rate: float, noise: float, *, gyro: bool) -> Segment:
    """What sensors of that rate [Hz] and noise [deg] show of it."""
    rng = np.random.default_rng(11)
    at = np.arange(0, motion.shape[1], round(1 / rate / TICK))
    angle = motion[0, at] + noise * world.DEGREE * rng.standard_normal(at.size)
    turning = motion[1, at] + 0.5 * world.DEGREE * rng.standard_normal(at.size)
    return Segment(at * TICK, raw_angle=angle, raw_angular_velocity=turning if gyro else None)


def followed(segments) -> tuple[list[LegDrop], object]:
    """The drops that were seen, and the last moment."""
    recording = Recording(tuple(segments), SUBJECT)
    model = online.Model(node=online.node_of(recording))
    leg = Leg(Person(SUBJECT, expected_of(SUBJECT), model), Load())
    news = [each for part in of_recording(recording, 3000) for each in leg.take(part)]
    drops = [each for each in news if isinstance(each, LegDrop)]
    return drops, [each for each in news if isinstance(each, Moment)][-1]


def near(moment, leg) -> bool:
    truth = (leg.gravity, leg.stiffness, leg.damping)
    each = zip(moment.ratios, truth, strict=True)
    return all(abs(one.value - true) < LIKELY * one.error for one, true in each)


@pytest.mark.parametrize(
    ("rate", "noise", "gyro"),
    [(100, 0.15, True), (100, 0.15, False), (30, 0.15, False), (50, 0.3, True), (1000, 0.15, True)],
)
def test_drops_between_lifts_are_seen_whatever_the_sensors_scatter(rate, noise, gyro):
    rng = np.random.default_rng(5)
    leg = world.draw_leg(rng)
    motion, free = world.session(rng, [leg] * 2, seconds=6.0, tick=TICK)
    drops, last = followed([measured(motion, rate, noise, gyro=gyro)])
    assert len(drops) == len(free)
    assert last.believed
    assert near(last, leg)


@pytest.mark.parametrize("gyro", [True, False])
def test_segments_that_begin_as_the_hand_lets_go_are_drops(gyro):
    leg = world.draw_leg(np.random.default_rng(6))
    time = np.arange(0.0, 7.0, TICK)
    motions = [world.swing(leg, start, time, 0.0) for start in (-0.2, -0.5)]
    drops, last = followed([measured(each, 100, 0.15, gyro=gyro) for each in motions])
    moving = last.phase is online.Phase.MOVING
    assert len(drops) + moving == len(motions)
    assert near(last, leg)


def test_a_lift_at_the_begin_of_a_segment_is_no_drop():
    rng = np.random.default_rng(7)
    lifted = np.concatenate(
        [world.lift(-1.2, -0.3, 1.0, TICK), world.rest(rng, -0.3, TICK)], axis=1
    )
    drops, last = followed([measured(lifted, 100, 0.15, gyro=True)])
    assert not drops
    assert last.trust is online.Trust.WAITING


@pytest.mark.parametrize("strength", [0.3, 1.0])
def test_a_reflex_that_no_gyro_sees_is_not_explained_either(strength):
    """A muscle that pulls for 0.3 s: the leg swings on, by its angle alone."""
    drops, last = followed([thrown(ADULT, strength, 100)])
    assert not drops
    assert last.trust is online.Trust.UNEXPLAINED
    _, relaxed = followed([thrown(ADULT, 0.0, 100)])
    assert relaxed.trust is online.Trust.GOOD


def test_one_slow_drop_does_not_explain_a_leg_whose_reflex_a_fast_one_tripped():
    def drop(start, gain):
        swings = stretched(Knee(26.2, 3.8, 1.77), start, gain, 1.7, 0.075)
        angle = np.concatenate([np.full(round(1 / TICK), start), swings])
        return measured(np.stack([angle, np.gradient(angle, TICK)]), 50, 0.15, gyro=False)

    fast, slow = drop(-0.52, 1.6), drop(-0.72, 0.4)
    drops, last = followed([fast, slow])
    assert len(drops) == 1
    assert last.trust is online.Trust.UNEXPLAINED
    _, recovered = followed([fast, slow, slow])
    assert recovered.believed


@pytest.mark.parametrize(("rate", "lasting"), [(100, 1.2), (30, 0.8), (25, 0.8), (25, 1.2)])
def test_a_leg_that_a_hand_lowers_is_no_drop_by_its_angle_alone(rate, lasting):
    """At 25 Hz it is back at rest before a model has had the samples to fail by."""
    rng = np.random.default_rng(8)
    lowered = np.concatenate(
        [world.rest(rng, -0.3, TICK), world.lift(-0.3, -1.2, lasting, TICK)], axis=1
    )
    still = np.concatenate([lowered, world.rest(rng, -1.2, TICK)], axis=1)
    drops, last = followed([measured(still, rate, 0.15, gyro=False)])
    assert not drops
    assert last.trust is online.Trust.WAITING
    assert last.begun > 0.0  # it left its hold as one does that is let go


CAMERA = 25, np.radians(0.3)  # Hz, rad
LEG = (26.3, 4.7, 0.85)  # m l g / J and c / J [1/s^2], d / J [1/s]


def filmed(seed: int) -> list[Segment]:
    """Two drops from a hold, as a camera shows them."""
    rate, noise = CAMERA
    rng, found = np.random.default_rng(seed), []
    for start in np.radians([-15.0, -30.0]):
        swing = fall(LEG, float(start), duration=8.0, step=1 / rate)[1]
        angle = np.concatenate([np.full(rate, start), swing])
        scattered = angle + noise * rng.standard_normal(angle.size)
        found.append(Segment(np.arange(angle.size) / rate, raw_angle=scattered))
    return found


@pytest.mark.parametrize("draws", [8, pytest.param(24, marks=pytest.mark.proof)])
def test_by_the_angle_of_a_camera_alone_no_number_leans_to_one_side(draws):
    """The mean of 24, over their errors, scatters by 1 / sqrt(24) = 0.2, their size by 0.14."""
    lasts = [followed(filmed(seed))[1] for seed in range(draws)]
    more = np.sqrt(24 / draws)
    assert all(each.believed for each in lasts)
    off = [
        [(one.value - true) / one.error for one, true in zip(each.ratios, LEG, strict=True)]
        for each in lasts
    ]
    assert np.abs(np.mean(off, axis=0)) == pytest.approx(0.0, abs=0.7 * more)
    assert np.sqrt(np.mean(np.square(off), axis=0)) == pytest.approx(1.0, abs=0.45 * more)


def test_a_movement_is_foreseen_with_the_sensors_that_are_there():
    """Else a drop that tells a camera nothing new would be worth it to a gyro."""
    from exoid.watching.beside.movement import Movement, samples_of

    model = online.Model(node=online.node_of(Recording(tuple(filmed(0)), SUBJECT)))
    samples = samples_of(Movement(-0.3), online.init(expected_of(SUBJECT), model), model, 0.0)
    assert np.isnan(samples.angular_velocity).all()
    assert np.diff(samples.time) == pytest.approx(1 / CAMERA[0])


def test_another_noise_needs_no_program_of_its_own():
    from exoid.online.program import without_sensing

    noisy = replace(online.Node(), angle_noise=0.01, period=0.04)
    assert without_sensing(online.Model(node=noisy)) == without_sensing(online.Model())
