"""What the drops of a recording tell of each other, by legs that SciPy moves."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.pendulum.drops import measure_drops
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.drops import find_drops
from exoid.recordings.motion.extent import Motionless
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import signal_of
from hands import Device, Hand, Knee, dropped

STIFF = Knee(33.0, 16.0, 2.8)
GYRO = Device(125.0, 1e-3, 3e-3)
CAMERA = Device(60.0, np.radians(0.5), None)
FREE = (Hand(-0.35), Hand(-0.5), Hand(-0.25))


def together(device, *hands, knee=STIFF):
    """One recording of drops, and when each hand began to let go [s]."""
    made = [dropped(knee, hand, device, seed=seed) for seed, hand in enumerate(hands)]
    segments = tuple(recording.segments[0] for recording, _ in made)
    return replace(made[0][0], segments=segments), [release for _, release in made]


@pytest.mark.proof
@pytest.mark.parametrize("device", [GYRO, CAMERA])
@pytest.mark.parametrize("after", [0.8, 1.3])
def test_a_leg_that_is_caught_near_its_rest_is_known_by_the_other_drops(device, after):
    """Alone it seems to have come to rest."""
    recording, releases = together(device, *FREE, Hand(-0.1, stop=after))
    segment = recording.segments[3]
    assert find_free(signal_of(segment, recording.sensors)).ended == "at rest"
    found = find_drops(recording)[3]
    assert found.ended == "caught"
    lasted = segment.time[found.stop - 1] - releases[3]
    assert 0.3 < lasted < after + 0.03  # half a swing is free for sure


@pytest.mark.parametrize("device", [GYRO, CAMERA])
def test_what_nobody_caught_ends_as_it_does_alone(device):
    recording, _ = together(device, *FREE)
    for segment, found in zip(recording.segments, find_drops(recording).values(), strict=True):
        assert found.stop == find_free(signal_of(segment, recording.sensors)).stop


def test_of_one_drop_it_is_the_same_answer():
    recording, _ = together(GYRO, FREE[0])
    assert find_drops(recording)[0] == find_free(
        signal_of(recording.segments[0], recording.sensors)
    )


def test_a_short_hold_is_one_where_other_drops_were_held():
    """By itself it may be play or a soft cuff in a recording that begins at its release."""
    recording, releases = together(GYRO, *FREE, Hand(-0.4, hold=0.04))
    assert find_free(signal_of(recording.segments[3], recording.sensors)).free == 0
    found, time = find_drops(recording)[3], recording.segments[3].time
    assert releases[3] + 0.04 < time[found.free] < releases[3] + 0.25


def test_drops_with_another_mass_tell_nothing_of_this_leg():
    recording, _ = together(GYRO, *FREE, Hand(-0.1, stop=0.8))
    subject = replace(recording.subject, added_mass=(0.0, 0.0, 0.0, 1.0))
    assert find_drops(replace(recording, subject=subject))[3].ended == "at rest"


def test_a_segment_in_which_nothing_moves_does_not_keep_the_others():
    recording, _ = together(GYRO, *FREE)
    first = recording.segments[0]
    still = Segment(first.time, raw_angle=np.full(first.time.size, -0.3))
    still = replace(still, raw_angular_velocity=0 * first.time)
    found = find_drops(replace(recording, segments=(still, *recording.segments[1:])))
    assert isinstance(found[0], Motionless)
    assert [each.ended for each in (found[1], found[2])] == ["at rest", "at rest"]


def test_no_pendulum_measure_is_read_off_where_the_hand_holds_it():
    recording, _ = together(GYRO, *FREE, Hand(-0.1, stop=0.8))
    plateaus = [each.measures["plateau_angle"] for each in measure_drops(recording).drops]
    assert [each.value is None for each in plateaus] == [False, False, False, True]
    assert "stopped or moved" in plateaus[3].reason
    alone = measure_drops(replace(recording, segments=recording.segments[3:])).drops[0]
    assert alone.measures["plateau_angle"].value is not None
