"""A sensor behind a filter shows what SciPy's filter makes of the motion."""

from dataclasses import replace

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
from exoid.twin.motion import Movement, perform

LEG = LegParameters(*map(jnp.asarray, (4.5, 0.42, 0.26, 0.33, 2.6)))
TIME = jnp.arange(401) / 200
SLOW = jnp.arange(101) / 50
HELD = -0.2  # rad
FILTERS = {
    FirstOrderFilter: lambda lag: ([1.0], [lag, 1.0]),
    ButterworthFilter: lambda delay: butter(2, np.sqrt(2) / delay, analog=True),
}


def swing(*terms, time=TIME):
    begin = LegState(jnp.asarray(HELD), jnp.asarray(0.0))
    found = simulate(LegModel(LEG, NoTorque(), terms=terms), begin, time)
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


@pytest.mark.parametrize("term", FILTERS)
@pytest.mark.parametrize("late", [0.005, 0.015, -0.015])
def test_steps_of_a_fiftieth_of_a_second_carry_a_filter(term, late):
    """A tenth of a second after the release both steps show the same to a fiftieth of what it does:
    a filter that is quicker than a step is coarse only while it begins.
    """
    fine, coarse = (swing(term(jnp.asarray(late)), time=each) for each in (TIME, SLOW))
    bare = swing()
    for name in ("shown_angle", "shown_velocity"):
        does = np.abs(getattr(fine, name) - getattr(bare, name)).max()
        apart = getattr(coarse, name) - getattr(fine, name)[::4]
        assert np.abs(apart[5:]).max() <= 0.02 * does + 1e-4


def test_a_simulated_session_shows_a_filtered_gyro():
    """SciPy takes the motion for straight between samples, also where a hand catches the leg."""
    model = LegModel(LEG, NoTorque(), terms=(FirstOrderFilter(jnp.asarray(0.04)),))
    drop = [Movement(-0.3, 2.0)]
    found, bare = (
        perform(each, drop, "1/T", 0.01).course for each in (model, replace(model, terms=()))
    )
    time = 0.01 * np.arange(bare.angle.size)
    expected = lsim(([1.0], [0.04, 1.0]), np.asarray(bare.angular_velocity), time)[1]
    np.testing.assert_allclose(found.angular_velocity, expected, atol=0.05)
    np.testing.assert_allclose(found.angle, bare.angle)
