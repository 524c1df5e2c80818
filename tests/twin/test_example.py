"""The recording that comes with the package is the one its script describes."""

from pathlib import Path

import numpy as np
import pytest

import exoid
from exoid.recordings.loading.can_log import read_can_log
from exoid.recordings.sidecar import read_sidecar
from exoid.recordings.splitting.split import split

FOLDER = Path(exoid.__file__).parent / "example"


@pytest.fixture(scope="module")
def example():
    subject, protocol, sensors, notes = read_sidecar(FOLDER / "session.toml")
    assert not notes
    recording, _ = read_can_log(
        FOLDER / "session.blf", subject=subject, protocol=protocol, sensors=sensors, strict=True
    )
    return split(recording)


def test_it_holds_four_drops_and_six_cycles(example):
    kinds = [example.kind(number) for number in range(len(example.segments))]
    assert kinds == ["passive"] * 4 + ["active"] * 6
    assert [example.added_mass(number) for number in range(5)] == [0.0, 0.0, 0.0, 1.0, 0.0]
    assert example.subject.added_mass_gyration == 0.0  # the twin's mass is a point
    assert all(1.1 < example.cycle_period(number) < 1.4 for number in range(4, 10))


def test_every_segment_rests_moves_down_and_ends_before_the_leg_is_caught(example):
    for segment in example.segments:
        rest = segment.time < 0.95
        assert np.abs(segment.angular_velocity[rest]).max() < np.radians(1.5)
        assert segment.angle.min() < segment.angle[0] - np.radians(50)
        # a hand that stops the leg within 30 ms takes more than any swing or muscle does here
        assert np.abs(segment.angular_acceleration).max() < 45


def test_it_is_small():
    assert (FOLDER / "session.blf").stat().st_size < 400_000
