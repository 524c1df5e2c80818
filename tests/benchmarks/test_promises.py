"""What a plan promises, in a world that shares no code with exoid's simulation."""

import numpy as np
import pytest
from benchmarks.promises import trial
from benchmarks.promises.situations import SITUATIONS

from exoid.physics.anatomy.knee import LOG_SCATTER


@pytest.mark.proof
@pytest.mark.parametrize("leg", [3, 11])
def test_an_added_mass_of_unknown_place_does_not_lead_a_fit_away(leg, monkeypatch):
    # tied to the motion, a mass far off passed for a leg without inertia, 28 errors from the truth
    monkeypatch.setattr(trial, "RELAXED", np.full(2, 1 / LOG_SCATTER))
    found = trial.tried(SITUATIONS[0], np.random.default_rng((0, 0, leg)))
    assert abs(found.error) < 3 * found.promised
    assert abs(found.error) < 3 * found.quoted
