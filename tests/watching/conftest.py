"""Samples of the bundled session: four bare and loaded drops of a simulated leg, then cycles."""

import numpy as np
import pytest

from exoid.cli.inputs.reading import EXAMPLE
from exoid.online.model.model import Model
from exoid.physics.anatomy import expected_leg
from exoid.recordings.can.logs.log_files import read_log
from exoid.recordings.live.decoding.node_stream import NodeStream
from exoid.recordings.live.decoding.stretch import take_all
from exoid.recordings.recording import Subject
from exoid.watching.estimate.leg import Leg, Person
from exoid.watching.estimate.load import Load, Mass

# What the bundled session was simulated with.
TRUTH = {
    "gravity_over_inertia": 4.5 * 0.26 * 9.80665 / 0.42,
    "stiffness_over_inertia": 2.6 / 0.42,
    "damping_over_inertia": 0.33 / 0.42,
    "inertia": 0.42,
}
LIKELY = 4.0  # standard errors, beyond which one draw in 16 000 lies
LOADED = 41.0, 57.0  # s, in which 1 kg is at the ankle
WEIGHT = Mass(1.0, 0.4)
SUBJECT = Subject(kind="leg", body_mass=74.0, height=1.78, added_mass_gyration=0.0)


@pytest.fixture(scope="session")
def readings():
    stream = NodeStream()
    take_all(stream, read_log(EXAMPLE).frames)
    return stream.drained()


@pytest.fixture(scope="session")
def person():
    return Person(SUBJECT, expected_leg(74.0, 1.78), Model())


@pytest.fixture
def leg(person):
    """One whose weight changes as that of the session does."""
    return Leg(person, Load((0.0, *LOADED), (Mass(), WEIGHT, Mass())))


@pytest.fixture(scope="session")
def told(readings, person):
    """Everything that is told of the session."""
    load = Load((0.0, *LOADED), (Mass(), WEIGHT, Mass()))
    return list(Leg(person, load).take(readings))


def until(readings, time):
    return [each for each in readings if each.time < time]


def nan_equal(one, other) -> bool:
    return bool(np.array_equal(np.array(one), np.array(other), equal_nan=True))
