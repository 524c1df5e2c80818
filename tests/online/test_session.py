"""A session of drops, followed sample by sample."""

from itertools import pairwise

import numpy as np
import pytest

import exoid
from exoid import online
from exoid.online.belief import knowledge_of

DEPARTURE = 0.35  # s after its release within which a fall is seen: 2 degrees, and 80 ms of a hand


def truth(leg):
    return np.array([leg.gravity, leg.stiffness, leg.damping])


def test_every_drop_is_found_and_no_lift_is_taken_for_one(three):
    samples, _, free, _, said = three
    counted = samples.time[np.flatnonzero(np.diff(said.drops) == 1) + 1]
    assert said.drops[-1] == len(free)
    ends = np.array([end for _, end in free])
    assert (np.abs(counted - ends) < 1.0).all()  # s: at rest before it, or in a hand after it
    moving = said.phase == online.Phase.MOVING
    for begun, end in free:
        inside = (samples.time > begun + DEPARTURE) & (samples.time < counted[counted > begun][0])
        assert moving[inside & (samples.time < end - 0.5)].all()


def test_the_true_ratios_lie_within_four_standard_errors(three):
    _, leg, _, _, said = three
    assert (np.abs(said.ratios[-1] - truth(leg)) < 4 * said.errors[-1]).all()
    assert said.errors[-1][0] < 0.01 * leg.gravity  # a foot and the clock are in it


def test_trust_grows_from_waiting_to_enough(three):
    said = three[-1]
    order = [each for each in dict.fromkeys(said.trust.tolist())]
    assert order[0] == online.Trust.WAITING
    assert set(order) <= {0, 1, 2, 3}
    assert said.trust[-1] == online.Trust.ENOUGH


def test_a_replay_is_the_live_stream_to_the_last_bit(three, start):
    samples, _, _, belief, said = three
    now, at = start, []
    for row in np.stack([samples.time, samples.angle, samples.angular_velocity], 1).tolist():
        now, outlook = online.step(now, online.Sample(*row))
        at.append(outlook)
    assert np.array_equal(now.numbers, belief.numbers, equal_nan=True)
    assert np.array_equal(np.stack([each.ratios for each in at]), said.ratios)
    assert np.array_equal([each.unwhite for each in at], said.unwhite)


def test_pieces_of_any_length_give_the_same(three, start):
    samples, _, _, belief, _ = three
    now, edges = start, [0, 1, 8, 40, 41, 500, samples.time.size]
    for first, last in pairwise(edges):
        piece = online.Sample(
            samples.time[first:last],
            samples.angle[first:last],
            samples.angular_velocity[first:last],
        )
        now, _ = online.replay(now, piece)
    assert np.array_equal(now.numbers, belief.numbers, equal_nan=True)


def test_covariances_stay_positive(three):
    belief = three[3]
    known = knowledge_of(belief, online.Model())
    for root in known.filters.root:
        assert np.array_equal(root, np.tril(root))
        assert (np.abs(np.diag(root)) > 0).all()


def test_a_leg_that_never_moves_tells_nothing(start):
    time = np.arange(6000) * 0.01
    shaken = np.random.default_rng(1).standard_normal((2, time.size)) * [[7.5e-4], [2.6e-3]]
    held = online.Sample(time, -0.35 + shaken[0], 0.05 + shaken[1])
    _, said = online.replay(start, held)
    assert (said.trust == online.Trust.WAITING).all()
    assert np.array_equal(said.errors[-1], said.errors[0])


def test_a_hand_that_moves_the_leg_tells_nothing(start):
    time = np.arange(6000) * 0.01
    noise = np.random.default_rng(2).standard_normal((2, time.size)) * [[7.5e-4], [2.6e-3]]
    # 1.5 s there, 2.5 s of rest, 1.5 s back: a hand's smooth courses, as from angle to angle
    phase = np.clip(np.abs((time % 8.0) - 4.0) - 1.25, 0.0, 1.5) / 1.5
    angle = -0.9 + 0.8 * (1 - np.cos(np.pi * phase)) / 2
    moved = online.Sample(time, angle + noise[0], np.gradient(angle, time) + noise[1])
    _, said = online.replay(start, moved)
    assert said.drops[-1] == 0
    assert np.array_equal(said.errors[-1], said.errors[0])
    assert (said.phase == online.Phase.HELD).any()


def test_a_hand_that_lifts_the_leg_from_its_rest_makes_no_model_wrong(three):
    """No leg falls upwards, and a hand that stops at the top swings a little."""
    samples, _, _, belief, _ = three
    rng, time = np.random.default_rng(4), np.arange(600) * 0.01
    low = -0.8  # rad, from where it would fall
    begun = 3.0  # s, until when a hand lays it down
    lowered = (low - samples.angle[-1]) * smooth(np.clip(time, 0, 1))
    lifted = smooth(np.clip((time - begun) / 0.6, 0, 1)) * (0.0 - low)
    since = np.clip(time - begun - 0.5, 0, None)
    swing = 0.05 * np.exp(-since / 0.3) * np.sin(2 * np.pi * 3.0 * since)
    angle = samples.angle[-1] + lowered + lifted + swing
    rate = np.gradient(angle, time)
    seen = np.stack([angle, rate]) + rng.standard_normal((2, 600)) * [[7.5e-4], [2.6e-3]]
    hand = online.Sample(samples.time[-1] + 0.01 + time, *seen)
    _, said = online.replay(belief, hand)
    assert said.phase[time < begun][-1] == online.Phase.WAITING
    assert online.Trust.UNEXPLAINED not in said.trust
    assert online.Phase.MOVING not in said.phase[time >= begun]


def smooth(share):
    """From 0 to 1 as a hand goes."""
    return share**3 * (10 - 15 * share + 6 * share**2)


def test_a_drop_of_200_samples_a_second_tells_more_than_of_100(start, sure):
    from benchmarks.online import world

    def errors(tick):
        rng = np.random.default_rng(5)
        leg, sensors = world.draw_leg(rng), world.draw_sensors(rng)
        motion, _ = world.session(rng, [leg], tick=tick)
        time, angle, rate = world.measured(rng, motion, sensors, tick)
        _, said = online.replay(start, online.Sample(time, angle, rate), sure)
        assert (np.abs(said.ratios[-1] - truth(leg)) < 4 * said.errors[-1]).all()
        return said.errors[-1]

    gain = errors(0.01) / errors(0.005)
    assert (gain > 1.0).all()  # of gravity and stiffness zero and seat hide a part of it
    assert 1.2 < gain[2] < 1.7  # root two, and the legs are held at other angles


def test_a_leg_of_the_paper_has_no_prior_that_could_be_followed():
    expected = exoid.expected_leg(77.0, 1.80)
    broken = type(expected)(**{**vars(expected), "covariance": None})
    with pytest.raises(ValueError, match="says nothing of how m, l and J scatter"):
        online.init(broken)
