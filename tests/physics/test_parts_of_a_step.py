"""A step is cut into as many parts as its terms need to be followed, by how long it is."""

import jax.numpy as jnp
import numpy as np
import pytest

import exoid
from exoid.physics.motion.parts_of_a_step import most_parts, parts_to_follow
from exoid.physics.terms.device.backlash import Backlash
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.terms.device.stribeck_friction import StribeckFriction
from exoid.physics.terms.muscle.stretch_reflex import StretchReflex
from exoid.physics.terms.tissue.hysteresis import Hysteresis

LEG = exoid.LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
TERMS = {
    Hysteresis: (0.3, 0.02),
    StretchReflex: (0.1, 0.5, 0.02, 0.01),
    StribeckFriction: (0.1, 0.2, 0.5),
}


@pytest.mark.parametrize("term", TERMS)
@pytest.mark.parametrize("rate", [200, 500])
def test_a_short_step_needs_fewer_parts(term, rate):
    def swing(parts):
        model = exoid.LegModel(LEG, exoid.NoTorque(), terms=(term(*map(jnp.asarray, TERMS[term])),))
        start = exoid.LegState(jnp.asarray(-0.1), jnp.zeros(()))
        return np.asarray(
            exoid.simulate(model, start, jnp.arange(2 * rate) / rate, parts=parts).angle
        )

    fewer = parts_to_follow([term], 1 / rate)
    assert fewer < most_parts([term]) == parts_to_follow([term], 0.01)
    # An encoder's count is 0.09 deg; the mean of a swing tells a hundredth of that.
    assert np.degrees(np.abs(swing(fewer) - swing(16))).max() < 1e-3


def test_where_things_meet_a_short_step_needs_as_many():
    assert parts_to_follow([HardStop], 0.001) == HardStop.substeps


BRIEF = {HardStop: (0.03, 1.2, -1.6, 2.0), Backlash: (0.015, 0.012, 0.5, 0.03, 0.02, 0.006, 1.5)}


@pytest.mark.parametrize("term", BRIEF)
def test_where_things_meet_a_long_step_needs_more(term):
    """In steps of 20 ms that are cut as those of 10 ms are, a stop is off by a degree, and a frame
    runs away.
    """

    def shown(parts):
        own = term(*map(jnp.asarray, BRIEF[term]))
        start, time = exoid.LegState(jnp.asarray(-0.1), jnp.zeros(())), jnp.arange(100) / 50
        model = exoid.LegModel(LEG, exoid.NoTorque(), terms=(own,))
        return np.asarray(exoid.simulate(model, start, time, parts=parts).shown_angle)

    parts = parts_to_follow([term], 0.02)
    assert parts > parts_to_follow([term], 0.01)
    assert np.abs(shown(parts) - shown(64)).max() < 1.5e-3  # rad, an encoder's count
