"""Hands teach the node nothing, and the one that catches a leg spoils nothing."""

import numpy as np
import pytest
from learner_runs import covered, play, share_of_gravity
from simulated_legs import Legs, Motion, caught, held, joined, moved

HANDS = 100  # legs
GOOD, ENOUGH = 2, 3  # of trust


def hand_motions(legs: Legs, rng: np.random.Generator) -> dict[str, Motion]:
    """What hands do to legs that never move freely."""
    high, low = rng.uniform(-0.5, 0.1, legs.size), rng.uniform(-1.9, -1.2, legs.size)
    wait = held(high, 0.8)
    swing = 0.4 * rng.uniform(0.5, 2, legs.size)
    time = np.arange(800)[:, None] * 0.01
    shaking = [np.sin(20 * time) * size * np.ones(legs.size) for size in (0.01, 0.2, -4.0)]
    found = {
        "held": held(high, 8.0),
        "shaken": [a + b for a, b in zip(held(high, 8.0), shaking, strict=True)],
    }
    for duration in (0.5, 0.8, 1.2, 2.0, 4.0):
        down, up = moved(high, low, duration), moved(low, high, duration)
        found[f"lowered in {duration} s"] = joined(wait, down, held(low, 1.0))
        found[f"to and fro in {duration} s"] = joined(wait, down, up, down, up, held(high, 1.0))
        found[f"lifted in {duration} s"] = joined(held(low, 0.8), up, held(high, 1.0))
    for hertz in (0.3, 0.5, 0.7, 0.9):
        w = 2 * np.pi * hertz
        turn = [high - swing * (1 - np.cos(w * time)), -swing * w * np.sin(w * time)]
        found[f"swung at {hertz} Hz"] = joined(wait, [*turn, -swing * w**2 * np.cos(w * time)])
    return found


def test_no_hand_is_taken_for_a_leg():
    """Whatever it does, no ratio is told to 5 %, no drop counts, and nothing is called good."""
    rng = np.random.default_rng(14)
    legs = Legs.drawn(HANDS, rng)
    for what, motion in hand_motions(legs, rng).items():
        told = play(legs, motion, rng)
        assert share_of_gravity(told).min() > 0.05, what
        assert not told["drops"].any(), what
        assert not np.isin(told["trust"], [GOOD, ENOUGH]).any(), what


@pytest.mark.parametrize("after", [0.3, 0.6, 1.0, 1.7, 2.5])
def test_a_hand_that_catches_the_leg_spoils_nothing(after):
    """However soon it does: what is told was learned before it, and stays true."""
    rng = np.random.default_rng(15)
    legs = Legs.drawn(HANDS, rng)
    start = rng.uniform(-0.5, 0.1, legs.size)
    drop = legs.drop(start, after)
    stopped = caught(drop, 0.3)
    back = moved(stopped[0][-1], start, 1.0)
    told = play(legs, joined(held(start, 0.8), drop, stopped, back, held(start, 1.0)), rng)
    assert np.all(covered(legs, told[-1]) > 0.87)  # 95 % less four standard deviations of 100 legs
    assert np.all(told["drops"][-1] == 0) if after < 0.7 else np.mean(told["drops"][-1] == 1) > 0.95
