"""Legs that a muscle throws up in their first swing, and legs that a hand lifts there."""

import numpy as np
import pytest

from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.drops import find_drops
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import signal_of
from exoid.recordings.recording import Recording
from hands import Knee
from reflexes import ADULT, CHILD, START, measured, stretched, swung, thrown

LIFT, FAR = 0.35, np.radians(30.0)  # s that a hand takes to lift a leg, and how far


def lifted(knee, kept, hertz):
    """A hand takes it after 0.2 s, stops it in 0.1 s, lifts it, keeps it `kept` s, and lets go."""
    angle, rate = swung(knee, 0.0, START, 0.0, 0.0)[:, :200]
    x, up = np.arange(1, 101) / 100, np.arange(1, 1001 * LIFT) / (1000 * LIFT)
    stopped = angle[-1] + 0.1 * rate[-1] * (x - x**3 + x**4 / 2)
    carried = stopped[-1] + FAR * (10 * up**3 - 15 * up**4 + 6 * up**5)
    held = np.full(round(1000 * kept), carried[-1])
    again = swung(knee, 0.3 + LIFT + kept, carried[-1], 0.0, 0.0)[0]
    return measured(np.concatenate([angle, stopped, carried, held, again]), hertz)


def ended(segment):
    return find_free(signal_of(segment, Sensors()))


@pytest.mark.parametrize("hertz", [50.0, 100.0, 200.0])
@pytest.mark.parametrize("strength", [1.6, 2.2, 3.0])
@pytest.mark.parametrize("knee", [CHILD, ADULT])
def test_a_leg_that_its_reflex_throws_up_is_free_to_the_end(knee, strength, hertz):
    segment = thrown(knee, strength, hertz)
    found = ended(segment)
    assert found.ended != "caught"
    assert found.stop == segment.time.size


@pytest.mark.parametrize("hertz", [50.0, 100.0, 200.0])
@pytest.mark.parametrize("kept", [0.05, 0.1, 0.25])
@pytest.mark.parametrize("knee", [CHILD, ADULT])
def test_a_leg_that_a_hand_lifts_and_lets_fall_was_caught(knee, kept, hertz):
    segment = lifted(knee, kept, hertz)
    found = ended(segment)
    assert found.ended == "caught"
    assert segment.time[found.stop - 1] < 1.0 + 0.3 + LIFT + kept + 0.1  # its swings are left out


@pytest.mark.parametrize("seed", range(3))
def test_a_leg_that_rests_after_one_more_swing_is_free_to_the_end(seed):
    """It turns back by 2 deg, near its rest."""
    leg = Knee(27.0, 8.1, 1.49)
    angle = stretched(leg, np.radians(-10.0), 9.46, 1.2, 0.055, rise=0.035)
    assert ended(measured(angle, 100.0, seed, noise=0.05)).ended == "at rest"


def test_what_other_drops_tell_does_not_catch_it():
    segments = tuple(thrown(CHILD, strength, 100.0) for strength in (2.1, 2.2, 2.3))
    found = find_drops(Recording(segments)).values()
    assert [each.ended for each in found] == ["recording stopped"] * 3


def test_a_hand_that_takes_it_later_is_seen_all_the_same():
    """Stopped and kept at a turning point, two seconds after it was thrown."""
    segment = thrown(CHILD, 2.2, 100.0)
    angle, time = segment.raw_angle, segment.time
    after = int(np.searchsorted(time, 3.0))
    top = after + int(np.argmax(angle[after : after + 90]))
    noise = np.random.default_rng(1).normal(0, np.radians(0.15), time.size)
    kept = np.where(np.arange(time.size) > top, angle[top] + noise, angle)
    found = ended(Segment(time, raw_angle=kept))
    assert found.ended == "caught"
    assert 1.7 < time[found.stop - 1] < time[top] + 0.1
