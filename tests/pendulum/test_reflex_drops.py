"""What is read off drops in which a reflex acts."""

import re
from dataclasses import replace

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import cut
from hands import Knee
from reflexes import CHILD, measured, stretched, thrown


def read(segment):
    (drop,) = measure_drops(Recording((segment,), protocol=Protocol(kind="passive"))).drops
    return drop


def test_no_place_is_before_the_first_sample():
    """Of a record that begins as the leg is let go, whose release is found within 25 ms of it."""
    segment = thrown(CHILD, 1.0, 100.0)
    drop = read(cut(segment, slice(100, None)))
    times = [mark.time for each in drop.measures.values() for mark in each.marks]
    assert drop.landmarks.release.start.time < 0.0
    assert min(times) == 0.0


@pytest.mark.parametrize("strength", [0.0, 0.8, 1.0])
def test_of_a_leg_that_a_reflex_only_slows_down_no_halt_is_said(strength):
    assert read(thrown(CHILD, strength, 100.0)).halt is None


def test_a_shallow_reversal_that_is_no_turn_is_said():
    """By SciPy it turns back from -59.81 to -59.42 deg, and then falls to -75.43 deg."""
    drop = read(thrown(CHILD, 1.1, 100.0))
    assert abs(drop.landmarks.turns[0].value - np.radians(-75.43)) < np.radians(0.3)
    found = re.match(r"the leg halts at (\S+) deg, (\S+) s .* turns back by (\S+) deg", drop.halt)
    angle, after, back = map(float, found.groups())
    assert abs(angle + 59.81) < 0.3  # six errors of what four samples of 0.15 deg tell, and halts
    assert 0.30 < after < 0.40
    assert 0.1 < back < 0.8
    assert "counted beyond it" in drop.halt


def test_a_reversal_that_is_counted_is_said():
    """By SciPy it turns back from -53.52 to -43.95 deg, and then falls to -85.71 deg."""
    drop = read(thrown(CHILD, 1.5, 100.0))
    assert abs(drop.landmarks.turns[0].value - np.radians(-53.52)) < np.radians(0.3)
    found = re.search(r"turns back by (\S+) deg and then falls to (\S+) deg", drop.halt)
    back, lowest = map(float, found.groups())
    assert abs(back - 9.57) < 0.5
    assert abs(lowest + 85.71) < 0.3
    assert "counted to there" in drop.halt


def test_noise_is_no_halt():
    """Of markers with 1 deg of it, 24 drops."""
    noise = np.random.default_rng(4).normal(0, np.radians(1.0), (24, 700))
    plain = thrown(CHILD, 0.0, 60.0)
    halts = [
        read(replace(plain, raw_angle=plain.raw_angle + each[: plain.time.size])).halt
        for each in noise
    ]
    assert halts == [None] * 24


SPASTIC = Knee(27.0, 8.1, 1.49)


def falls(gain):
    """Of a leg whose reflex comes after 55 ms, three, and their lowest angle before they turn."""
    angles = [
        stretched(SPASTIC, np.radians(start), gain, 1.2, 0.055, 0.035) for start in (-8, -12, -5)
    ]
    halts = [angle[np.argmax(np.diff(angle) > 0)] for angle in angles]
    segments = [measured(each, 100.0, seed) for seed, each in enumerate(angles)]
    return Recording(tuple(segments), protocol=Protocol(kind="passive")), halts


def test_a_leg_that_its_reflex_turns_around_twice_is_left_alone():
    """It halts high up, where its later swings hardly tell how a free leg falls, and once more."""
    recording, halts = falls(24.3)
    for drop, halt in zip(measure_drops(recording).drops, halts, strict=True):
        index = drop.measures["relaxation_index"]
        assert index.value is not None, index.reason
        assert abs(drop.landmarks.turns[0].value - halt) < np.radians(0.4)  # noise of 0.15 deg
