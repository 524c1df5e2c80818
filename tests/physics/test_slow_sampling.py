"""What yields or answers quickly is carried by the steps of a slow camera, and its derivatives."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.state import LegState
from exoid.physics.terms.muscle.stretch_reflex import StretchReflex
from exoid.physics.terms.tissue.hysteresis import Hysteresis
from exoid.physics.torque import NoTorque

LEG = LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
QUICK = {Hysteresis: (0.3, 0.004), StretchReflex: (0.1, 0.5, 0.02, 0.01)}


@pytest.mark.parametrize("term", QUICK)
@pytest.mark.parametrize("rate", [25, 30, 50])
def test_a_motion_and_its_derivatives_do_not_run_away(term, rate):
    def shown(values, finer=1):
        time = jnp.arange(3 * rate * finer) / (rate * finer)
        start = LegState(jnp.asarray(-0.1), jnp.zeros(()))
        model = LegModel(LEG, NoTorque(), terms=(term(*values),))
        return simulate(model, start, time).angle[::finer]

    values = jnp.array(QUICK[term])
    missed = np.asarray(shown(values) - shown(values, 8))
    assert np.abs(missed).max() < 1.5e-3  # rad, an encoder's count
    each = np.asarray(jax.jit(jax.jacfwd(shown))(values))
    fine = np.asarray(jax.jit(jax.jacfwd(lambda values: shown(values, 8)))(values))
    assert np.abs(each - fine).max() < 0.25 * np.abs(fine).max()
