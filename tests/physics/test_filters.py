"""A sensor behind a filter shows what SciPy's filter makes of the motion."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.signal import butter, lsim

from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.motion.simulate import simulate
from exoid.physics.sensing.butterworth_filter import ButterworthFilter
from exoid.physics.sensing.first_order_filter import FirstOrderFilter
from exoid.physics.state import LegState
from exoid.physics.torque import NoTorque

LEG = LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
TIME = jnp.arange(401) / 200
HELD = -0.2  # rad
FILTERS = {
    FirstOrderFilter: lambda lag: ([1.0], [lag, 1.0]),
    ButterworthFilter: lambda delay: butter(2, np.sqrt(2) / delay, analog=True),
}


def swing(*terms):
    begin = LegState(jnp.asarray(HELD), jnp.asarray(0.0))
    found = simulate(LegModel(LEG, NoTorque(), terms=terms), begin, TIME)
    return jax.tree.map(np.asarray, found)


@pytest.mark.parametrize("filtered", ["gyro", "encoder"])
@pytest.mark.parametrize("term", FILTERS)
@pytest.mark.parametrize("late", [0.015, 0.04])
def test_the_filtered_sensor_shows_what_scipy_makes_of_it_and_the_other_the_motion(
    term, late, filtered
):
    """SciPy takes the motion for straight between samples: an eighth of h^2 times 500 rad/s^3."""
    bare, found = swing(), swing(term(jnp.asarray(late if filtered == "gyro" else -late)))
    system = FILTERS[term](late)
    begins = HELD if filtered == "encoder" else 0.0
    true = bare.angle if filtered == "encoder" else bare.angular_velocity
    expected = begins + lsim(system, true - begins, np.asarray(TIME))[1]
    shown = {"encoder": found.shown_angle, "gyro": found.shown_velocity}
    other = {"encoder": bare.angular_velocity, "gyro": bare.angle}
    np.testing.assert_allclose(shown.pop(filtered), expected, atol=2e-3)
    np.testing.assert_allclose(*shown.values(), other[filtered], atol=1e-6)  # by finer steps


@pytest.mark.parametrize("term", FILTERS)
def test_a_filter_as_quick_as_nothing_shows_the_motion(term):
    bare = swing()
    for late in (1e-5, -1e-5):
        found = swing(term(jnp.asarray(late)))
        np.testing.assert_allclose(found.shown_angle, bare.angle, atol=1e-4)
        np.testing.assert_allclose(found.shown_velocity, bare.angular_velocity, atol=3e-4)
