"""What is read off drops in which a reflex acts."""

from exoid.pendulum.drops import measure_drops
from exoid.recordings.recording import Protocol, Recording
from exoid.recordings.signal.condition import cut
from reflexes import CHILD, thrown


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
