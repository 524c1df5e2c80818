"""What a search found, made up: candidates that leave so much of a mismatch."""

from dataclasses import replace
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np

from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum, Products
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.search.found import Found
from exoid.physics.parameter import declarations
from exoid.physics.scale import AS_A_LEG

SAMPLES = 1000
NOTHING = Hypothesis((), (), np.zeros(4))


def leaving(square, of=NOTHING):
    """A candidate that leaves so much, its unknowns without errors."""
    size = of.unknowns.size + 1
    usual = np.zeros((size, size))
    usual[-1, -1] = square
    return Optimum(of, Products(np.zeros((1, size, size)), usual), motion=None)


def explaining(square, *terms):
    """Terms that leave so much, with values of no matter."""
    values = tuple(np.zeros(len(dict(declarations(term)))) for term in terms)
    return leaving(square, replace(NOTHING, terms=terms, values=values))


def sprung(stiffness):
    """Where a leg has such a c / J."""
    return SimpleNamespace(shared=SimpleNamespace(stiffness=stiffness))


def found_of(singles, pairs=(), pinned=()):
    """A search that found these, of a mismatch of a hundred times the noise; of a leg whose spring
    is as stiff whatever explains it.
    """
    measure = Yardstick(SAMPLES, scale=1.0)
    prepared = Mock(spec=PreparedRecording, scale=AS_A_LEG, rig=False, has_gyro=True)
    prepared.coordinates = lambda candidate: sprung(4.0)
    prepared.bounds = lambda candidate: np.outer(
        [-np.inf, np.inf], np.ones(candidate.unknowns.size)
    )
    prepared.numbers = SimpleNamespace(shared=SimpleNamespace(log_inertia=0))
    return Found(
        prepared, leaving(101_000.0), NOTHING, singles, list(pairs), list(pinned), [], measure
    )
