"""Another leg, the same leg, and a leg that the model does not explain."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import exoid
from exoid import online
from exoid.online.belief import knowledge_of
from exoid.online.movement.end import unexplained

LEAST = 0.88  # held: of legs with and without a foot, two root mean square errors hold 92 %


def test_a_leg_that_grows_by_forty_percent_is_found_in_its_first_drop(play, start):
    samples, leg, free = play(21, legs=lambda leg: [leg, leg, leg.heavier(0.4), leg.heavier(0.4)])
    _, said = online.replay(start, samples)
    changed = samples.time[said.trust == online.Trust.CHANGED]
    assert free[2][0] < changed[0] < free[2][0] + 2.0
    assert said.drops[-1] == said.rests[-1] == 2  # of the new leg
    other = leg.heavier(0.4)
    truth = np.array([other.gravity, other.stiffness, other.damping])
    assert (np.abs(said.ratios[-1] - truth) < 4 * said.errors[-1]).all()
    assert said.trust[-1] in (online.Trust.GOOD, online.Trust.ENOUGH)


def test_the_same_leg_is_not_taken_for_another(three):
    said = three[-1]
    assert not (said.trust == online.Trust.CHANGED).any()
    assert said.change[-1] < 0  # the belief foresaw the drop better than anatomy did


def test_a_leg_that_differs_a_little_from_its_drops_before_is_as_its_last_one_told(play, start):
    """A knee that is stiffer by 2 % of m l g / J: no other leg, but a hundred errors away."""
    samples, leg, free = play(
        22, legs=lambda leg: [leg, leg, *[replace(leg, stiffness=leg.stiffness + 0.5)] * 2]
    )
    _, said = online.replay(start, samples)
    assert not (said.trust == online.Trust.CHANGED).any()
    assert said.drops[-1] == len(free)
    counted = np.flatnonzero(np.diff(said.drops) == 1) + 1
    assert said.rests[counted].tolist() == [1, 2, 1, 2]  # on the last ones alone
    truth = np.array([leg.gravity, leg.stiffness + 0.5, leg.damping])
    for drops in (3, 4):
        at = np.flatnonzero(said.drops == drops)[0]
        assert (np.abs(said.ratios[at] - truth) < 4 * said.errors[at]).all()
    assert said.change[-1] < 0  # the belief foresaw the last one


def test_a_drop_that_is_taken_back_leaves_the_numbers_to_those_before_it(start):
    known = knowledge_of(start, online.Model())
    alone = replace(known.verdict, drops=np.asarray(3), rests=np.asarray(1))
    done = np.asarray(int(online.Phase.DONE))
    course = replace(known.course, rested=np.asarray(2))
    said = replace(known, verdict=alone, phase=done, course=course)
    left = unexplained(jax.tree.map(jnp.asarray, said)).verdict
    assert (int(left.drops), int(left.rests)) == (2, 2)


def test_friction_that_the_model_lacks_is_told_and_not_believed(play, start):
    samples, _, _ = play(23, legs=lambda leg: [replace(leg, friction=1.5)] * 2)
    _, said = online.replay(start, samples)
    assert (said.trust == online.Trust.UNEXPLAINED).any()
    assert said.drops[-1] == 0
    assert np.array_equal(said.errors[-1], said.errors[0])


@pytest.mark.slow
def test_intervals_hold_the_truth_of_forty_legs(play, start, sure):
    squares, outside = [], 0
    for seed in range(100, 140):
        samples, leg, _ = play(seed, 1)
        _, said = online.replay(start, samples, sure)
        if said.drops[-1] != 1:
            continue
        off = said.ratios[-1] - np.array([leg.gravity, leg.stiffness, leg.damping])
        outside += int(np.sum(np.abs(off) > 1.96 * said.errors[-1]))
        squares.append((off / said.errors[-1]) ** 2)
    assert len(squares) >= 39
    # The mean square of 40 legs is within 1 +- 4 sqrt(2 / 40) where errors are as large as said.
    assert (np.abs(np.mean(squares, axis=0) - 1) < 4 * np.sqrt(2 / len(squares))).all()
    assert outside <= 16  # of 120; 6 are expected, and G and c go together


@pytest.mark.proof
def test_ninety_five_percent_intervals_hold_so_many_of_three_hundred_legs(start):
    from benchmarks.online.coverage import FRICTION, answers

    for friction in (0.0, FRICTION):
        every = [one for seed in range(300) for one in answers(seed, friction, others=False)]
        for method, drops in {(one.method, one.drops) for one in every}:
            mine = [one for one in every if (one.method, one.drops) == (method, drops)]
            inside = np.mean([np.abs(one.off) < 1.96 * one.errors for one in mine], axis=0)
            assert len(mine) > 290
            assert ((inside > LEAST) & (inside < 0.99)).all(), (method, drops, inside)


def test_expected_legs_are_where_a_belief_begins(start):
    leg = exoid.expected_leg(77.0, 1.80)
    known = online.estimates(start)
    gravity = leg.mass.value * leg.com_distance.value * 9.81
    assert known["gravity"].value == pytest.approx(gravity)
    assert known["inertia"].value == pytest.approx(leg.inertia.value)
    relative = leg.inertia.standard_deviation / leg.inertia.value
    assert known["inertia"].error == pytest.approx(relative * leg.inertia.value, rel=1e-6)
