"""A hand that lifts a leg by a few degrees, once it hangs still, has no part in the drop before."""

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.splitting.split import cut_table
from swings import HOLD, NOISE, Oscillator, recorded

STEP, SECONDS = 0.01, 8.0  # s, and from release to lift
LEG = Oscillator(rest=-1.1, amplitude=0.57, frequency=5.6, decay=1.5)  # as of a spastic leg


def lifted(degrees, lasting, seed, start=None):
    """Hold, drop, and a hand that lifts the leg softly and keeps it [rad]."""
    leg = LEG if start is None else Oscillator(LEG.rest, start - LEG.rest, 5.6, 1.5)
    drop = leg.angle(np.arange(-HOLD, SECONDS, STEP))
    share = np.arange(0.0, lasting, STEP) / lasting
    lift = np.radians(degrees) * (10 * share**3 - 15 * share**4 + 6 * share**5)
    kept = np.full(60, drop[-1] + np.radians(degrees))
    angle = np.concatenate([drop, drop[-1] + lift, kept])
    return angle + NOISE * np.random.default_rng(seed).normal(size=angle.size)


def read(angle):
    (found,) = measure_drops(recorded(angle, STEP * np.arange(angle.size))).drops
    return {name: each.value for name, each in found.measures.items()}, found


@pytest.mark.parametrize("degrees", [4.0, 8.0, 20.0])
@pytest.mark.parametrize("lasting", [0.8, 2.5])
def test_a_drop_ends_before_a_hand_lifts_the_leg(degrees, lasting):
    """The leg was said to come to rest up to 9 s after its release, on the lift."""
    with_lift, found = read(lifted(degrees, lasting, 0))
    alone, _ = read(lifted(degrees, lasting, 0)[: int((HOLD + SECONDS) / STEP)])
    assert with_lift["time_to_rest"] == pytest.approx(alone["time_to_rest"], abs=0.01)
    assert with_lift["plateau_angle"] == pytest.approx(LEG.rest, abs=np.radians(0.02))
    assert found.landmarks is not None
    assert found.landmarks.track.time[-1] < HOLD + SECONDS + 0.2 * lasting


def test_a_small_lift_between_drops_is_left_out_by_name():
    """It goes less far than a fifth of the first drop, and a second one begins from there."""
    first = lifted(8.0, 2.5, 1)
    second = lifted(25.0, 1.5, 2, first[-1])
    angle = np.concatenate([first, second])
    log = Segment(STEP * np.arange(angle.size), raw_angle=angle)
    found = cut_table(Recording((log,), Subject(kind="leg")))
    (note,) = found.notes
    said = [float(each.split()[0]) for each in note.split("a lift from ")[1:]]
    begun = HOLD + SECONDS
    assert said == pytest.approx([begun, first.size * STEP + begun], abs=1.0)
    for segment, begins in zip(found.recording.segments, (0.0, first.size * STEP), strict=True):
        assert segment.begins + segment.time[-1] < begins + begun + 0.3


def test_a_sensor_that_drifts_lifts_no_leg():
    """By 5 deg in a minute at rest: no hand is as slow."""
    angle = lifted(0.0, 50.0, 3)
    angle += np.radians(5.0) * np.arange(angle.size) / angle.size
    log = Segment(STEP * np.arange(angle.size), raw_angle=angle)
    assert not cut_table(Recording((log,), Subject(kind="leg"))).notes
