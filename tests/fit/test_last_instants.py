"""Drops that a hand ends unseen: the leg is stopped softly near where it would rest, and kept."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fit.estimate import fit
from exoid.recording.recording import Recording
from hands import ADULT, Device, Hand, dropped

CAMERA = Device(60.0, np.radians(0.3), None)
STARTS = 4
TRUTH = {
    "gravity_over_inertia": ADULT.gravity,
    "stiffness_over_inertia": ADULT.stiffness,
    "damping_over_inertia": ADULT.damping,
}


def session(*stops: float) -> Recording:
    """A drop for every time after the release at which a hand stops the leg."""
    each = [
        dropped(ADULT, Hand(start=-0.3 - 0.1 * n, stop=stop), CAMERA, lasting=5.0, seed=n)[0]
        for n, stop in enumerate(stops)
    ]
    return replace(each[0], segments=tuple(one.segments[0] for one in each))


def test_one():
    for stop in (2.2,2.4,2.6, 2.8, 3.0, 3.2):
        r = fit(session(np.inf, stop, np.inf), multistart=STARTS)
        print(stop, [m.kept for m in r.basis.problem.movements],[m.extent.ended for m in r.basis.problem.movements], r.disturbance.kinds['passive'].cause, [(r.ratios[k].value-v)/r.ratios[k].standard_error for k,v in TRUTH.items()])
    assert 0
