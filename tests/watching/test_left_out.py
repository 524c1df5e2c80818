"""Movements that do not count: each is told with its reason, and no number rests on it."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.online.model.trust import Phase, Trust
from exoid.physics.leg import GRAVITY
from exoid.recordings.live.decoding.reading import Reading
from exoid.watching.board import Board, Ended
from exoid.watching.estimate.gyro_off import gyro_off
from exoid.watching.estimate.left_out import STRAYED, TORN, LeftOut, is_falling
from exoid.watching.estimate.leg import Leg, LegDrop
from exoid.watching.estimate.load import Load
from exoid.watching.estimate.moment import Moment
from exoid.watching.estimate.other_limb import other_limb
from legs import ADULT, drop

STUMP = (63.6, 28.0, 1.6)  # of a transtibial stump, ratios as of `ADULT`
HELD = 1.0  # s before each drop
APART = 20.0  # s from one drop to the next
LIKELY = 4.0  # standard errors


def stream(*segments):
    """Drops one after the other, each held before it, and none of them lifted."""
    found = []
    for number, segment in enumerate(segments):
        angle, rate = segment.raw_angle, segment.raw_angular_velocity
        held = int(HELD / 0.01)
        still = np.random.default_rng(number).normal(0.0, 8e-4, held)
        time = number * APART + 0.01 * np.arange(held + angle.size)
        angles = np.concatenate([angle[0] + still, angle])
        rates = np.concatenate([still, rate])
        rows = zip(*(each.tolist() for each in (time, angles, rates)), strict=True)
        found += [Reading(at, phi, speed, 0.0) for at, phi, speed in rows]
    return found


def followed(person, readings):
    told = list(Leg(person, Load()).take(readings))
    moments = [each for each in told if isinstance(each, Moment)]
    drops = [each for each in told if isinstance(each, LegDrop)]
    return moments, drops, [each for each in told if isinstance(each, LeftOut)]


def swings(leg=ADULT, **how):
    return [drop(leg, start, seed=seed, duration=13.0, **how) for seed, start in enumerate(STARTS)]


STARTS = (-0.2, -0.4, -0.3)  # rad


def test_of_sound_drops_none_is_left_out(person):
    _, drops, left = followed(person, stream(*swings()))
    assert len(drops) == 3
    assert left == []


@pytest.mark.parametrize(("length", "why"), [(30, TORN), (15, STRAYED)])
def test_a_drop_with_a_hole_is_left_out_and_it_is_said_why(person, length, why):
    """A hole is seen in the time, or, where a logger counts its rows, in the motion alone."""
    every = stream(*swings())
    hole = next(n for n, each in enumerate(every) if each.time > APART + HELD + 0.9)
    rest = every[hole + length :]
    if why == STRAYED:
        rest = [each._replace(time=each.time - 0.01 * length) for each in rest]
    moments, drops, left = followed(person, every[:hole] + rest)
    assert [each.why for each in left] == [why]
    assert left[0].begun == pytest.approx(APART + HELD, abs=0.2)
    assert [each.number for each in drops] == [1, 2]
    assert abs(moments[-1].ratios[0].value - ADULT[0]) < LIKELY * moments[-1].ratios[0].error


def test_a_stump_is_followed_and_called_no_whole_leg(person):
    moments, drops, left = followed(person, stream(*swings(STUMP)))
    assert len(drops) == 3
    assert left == []
    assert moments[-1].unlike
    for each, truth in zip(moments[-1].ratios, STUMP, strict=True):
        assert abs(each.value - truth) < LIKELY * each.error, each


def test_a_whole_leg_is_no_other_limb(person):
    rows = np.zeros((300, 6))
    rows[:, :4] = [each[:4] for each in stream(*swings()[:1])[:300]]
    assert other_limb(person.expected, person.model, rows, HELD) is None


YOUNG = (36.0, 8.0, 1.1)  # J / (m l) is eight of an adult's standard deviations off


@pytest.mark.parametrize("held", [True, False])
def test_a_leg_that_none_of_its_body_moves_like_is_followed_by_no_table(person, held):
    """Where the hold is not seen, the record begins as the leg is let go."""
    readings = stream(*swings(YOUNG))
    if not held:
        cut = [each for each in readings if each.time % APART >= HELD - 0.005]
        firsts = [at for at, each in enumerate(cut) if each.time % APART < HELD + 0.005]
        readings = [each._replace(begins=at in firsts) for at, each in enumerate(cut)]
    moments, drops, left = followed(person, readings)
    assert len(drops) == 3
    assert left == []
    found = drops[0].moment.unlike
    assert found is not None
    assert found.length == pytest.approx(GRAVITY / YOUNG[0], rel=0.01)
    for each, truth in zip(moments[-1].ratios, YOUNG, strict=True):
        assert abs(each.value - truth) < LIKELY * each.error, each


def test_a_leg_as_its_body_has_it_is_none_that_the_tables_are_put_aside_for(person):
    moments, _, _ = followed(person, stream(*swings()))
    assert moments[-1].unlike is None


def ended(number: int, begun: float) -> Ended:
    moment = Moment(begun + 8.0, -1.3, 0.0, Phase.DONE, Trust.GOOD, number, (), (), begun=begun)
    return Ended(0.0, moment, begun + 7.0)


def test_the_drops_that_count_are_those_that_were_not_taken_back():
    board, left = Board(), LeftOut(22.0, 18.0, STRAYED, falling=False)
    board.movements = (ended(1, 2.0), ended(2, 18.0), left, ended(2, 34.0))
    assert [each.moment.begun for each in board.ended] == [2.0, 34.0]
    board.movements = (*board.movements, ended(1, 50.0))  # of another leg
    assert [each.moment.begun for each in board.ended] == [50.0]


@pytest.mark.parametrize(("scale", "late"), [(0.87, 0), (1.0, 2)])
def test_a_gyro_that_differs_from_the_encoder_is_named(person, scale, late):
    """By 13 %, or by two samples: 20 ms."""
    first = [
        replace(
            each,
            raw_angular_velocity=scale
            * np.concatenate([np.zeros(late), each.raw_angular_velocity])[: each.time.size],
        )
        for each in swings()
    ]
    moments, drops, left = followed(person, stream(*first))
    assert moments[-1].trust is Trust.UNEXPLAINED
    assert not drops
    found = next(each.gyro for each in left if each.gyro is not None)
    assert found.scale == pytest.approx(scale, abs=0.02)
    assert found.late == pytest.approx(0.01 * late, abs=2e-3)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("noise", [(8e-4, 3e-3), (5e-3, 0.02)])
def test_sensors_that_agree_are_not_named_whatever_leads_the_leg(seed, noise):
    """A muscle through cycles, for 3 s; none of 1080 such and of drops was in another simulator."""
    random = np.random.default_rng(seed)
    time, turning = np.arange(0.0, 3.0, 0.01), random.uniform(2.0, 6.0)
    angle = -0.7 + 0.4 * np.cos(turning * time) + noise[0] * random.standard_normal(time.size)
    rate = 0.03 - 0.4 * turning * np.sin(turning * time)
    rows = np.zeros((time.size, 6))
    rows[:, :3] = np.column_stack([time, angle, rate + noise[1] * random.standard_normal(300)])
    assert gyro_off(rows) is None


def test_a_hand_is_thought_of_where_every_movement_strays_in_its_first_fall():
    board, left = Board(), LeftOut(3.9, 3.7, STRAYED, falling=True)
    assert not board.falls_astray
    board.movements = (left, replace(left, begun=20.0))
    assert board.falls_astray
    board.movements = (left, replace(left, begun=20.0, falling=False))
    assert not board.falls_astray


def test_a_leg_falls_until_it_has_come_back_by_two_degrees():
    way = -0.2 - 0.01 * np.arange(100)
    back = way[-1] + 0.01 * np.arange(8)
    assert is_falling(way)
    assert is_falling(np.append(way, back[:3]))
    assert not is_falling(np.append(way, back))
