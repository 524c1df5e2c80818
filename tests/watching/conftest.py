"""Samples of the bundled session: four bare and loaded drops of a simulated leg, then cycles."""

import pytest
from bundled_session import LOADED, SUBJECT, WEIGHT

from exoid.cli.inputs.reading import EXAMPLE
from exoid.online.model.model import Model, Node
from exoid.physics.anatomy import expected_leg
from exoid.recordings.can.logs.log_files import read_log
from exoid.recordings.live.decoding.node_stream import NodeStream
from exoid.recordings.live.decoding.stretch import take_all
from exoid.watching.estimate.leg import Leg, Person
from exoid.watching.estimate.load import Load, Mass


@pytest.fixture(scope="session")
def readings():
    stream = NodeStream()
    take_all(stream, read_log(EXAMPLE).frames)
    return stream.drained()


@pytest.fixture(scope="session")
def person():
    """On a seat and with a clock that are declared: errors hold what drops tell."""
    node = Node(slant=0.0, clock_declared=True)
    return Person(SUBJECT, expected_leg(74.0, 1.78), Model(node=node))


@pytest.fixture
def leg(person):
    """One whose weight changes as that of the session does."""
    return Leg(person, Load((0.0, *LOADED), (Mass(), WEIGHT, Mass())))


@pytest.fixture(scope="session")
def told(readings, person):
    """Everything that is told of the session."""
    load = Load((0.0, *LOADED), (Mass(), WEIGHT, Mass()))
    return list(Leg(person, load).take(readings))
