"""Drops that a hand ends unseen: the leg is stopped softly near where it would rest, and kept."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.recordings.recording import Recording
from hands import Device, Hand, Knee, dropped

STIFF = Knee(27.0, 30.0, 2.0)
CAMERA = Device(60.0, np.radians(0.3), None)
STARTS = 4
TRUTH = {
    "gravity_over_inertia": STIFF.gravity,
    "stiffness_over_inertia": STIFF.stiffness,
    "damping_over_inertia": STIFF.damping,
}


def session(*stops: float) -> Recording:
    """A drop for every time after the release at which a hand stops the leg."""
    each = [
        dropped(STIFF, Hand(start=-0.3 - 0.1 * n, stop=stop), CAMERA, lasting=5.0, seed=n)[0]
        for n, stop in enumerate(stops)
    ]
    return replace(each[0], segments=tuple(one.segments[0] for one in each))


def kept(result):
    return [each.kept for each in result.basis.problem.movements]


def check_truth(result):
    for name, truth in TRUTH.items():
        found = result.ratios[name]
        assert abs(found.value - truth) < 4 * found.standard_error


@pytest.mark.proof
@pytest.mark.parametrize("stop", [1.6, 2.0])
def test_a_hand_that_keeps_one_leg_near_its_rest_moves_no_number(stop):
    result = fit(session(np.inf, stop, np.inf), multistart=STARTS)
    assert result.basis.problem.movements[1].extent.ended == "at rest"  # it looks like one
    first, second, third = kept(result)
    assert (first, third) == (None, None)
    assert 0 < second / CAMERA.rate < stop
    assert result.disturbance.kinds["passive"].cause is None
    assert any("stops the leg" in note for note in result.notes)
    check_truth(result)


@pytest.mark.proof
def test_one_leg_that_is_left_alone_tells_what_hands_did_to_all_others():
    result = fit(session(2.0, np.inf, 2.0, 2.0), multistart=STARTS)
    first, alone, *others = kept(result)
    assert alone is None
    assert all(each is not None for each in (first, *others))
    check_truth(result)


@pytest.mark.proof
def test_legs_that_rest_by_themselves_keep_their_rest():
    result = fit(session(np.inf, np.inf), multistart=STARTS)
    assert kept(result) == [None, None]
    check_truth(result)


@pytest.mark.proof
def test_a_single_drop_has_nobody_to_contradict_it():
    result = fit(session(2.0), multistart=STARTS)
    assert kept(result) == [None]
