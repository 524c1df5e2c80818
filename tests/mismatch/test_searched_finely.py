"""A search follows what acts briefly as finely as a fit that has it."""

from dataclasses import replace

import jax.numpy as jnp
import numpy as np

from exoid.mismatch.rehearsal import for_no_leg
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.many_free import release
from exoid.physics.leg import LegModel
from exoid.physics.motion.simulate import simulate
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.torque import NoTorque
from fit_cases import coordinates_of, exact, leg, one, state

STOP = np.array([0.012, 1.2, -1.6, 0.4])  # s, rad, rad, 1
TIME, BEGUN = np.arange(150) * 0.01, (-0.2, -0.5)  # s; rad and rad/s


def test_a_leg_that_meets_a_stop_moves_as_in_a_fit():
    """In as many parts of a step; in half as many it is off by a degree behind the stop."""
    model = LegModel(leg(), NoTorque(), terms=(HardStop(*map(jnp.asarray, STOP)),))
    fitted = np.asarray(simulate(model, state(*BEGUN), jnp.asarray(TIME)).angle)
    assert fitted.min() < STOP[2]
    prepared = for_no_leg([("drop", one(exact(model, state(*BEGUN), TIME)))])
    at = replace(coordinates_of(leg(), [(0.0, *BEGUN)]), mounting=prepared.like.mounting)
    _, shown = release(prepared, Hypothesis((HardStop,), (STOP,), prepared.point(at)))
    assert prepared.problem.movements[0].segment.time.size == TIME.size
    # rad: of the same steps only rounding differs, and is magnified by every strike.
    assert np.abs(shown[0, : TIME.size, 0] - fitted).max() < 1e-6
