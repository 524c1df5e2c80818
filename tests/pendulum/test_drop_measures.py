"""The pendulum-test measures of simulated legs, whose gravity is not linear."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.optimize import brentq

from exoid.pendulum.definitions import logarithmic_decrement
from exoid.pendulum.drops import measure_drops
from exoid.physics.leg import GRAVITY, LegModel, LegParameters
from exoid.physics.torque import NoTorque
from exoid.recordings.landmarks.measure import NotAllowed
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from swings import NOISE, drop

LEG = {"mass": 4.5, "inertia": 0.44, "com_distance": 0.265, "damping": 0.45, "stiffness": 2.8}
MOMENT = LEG["mass"] * LEG["com_distance"] * GRAVITY
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000


@pytest.fixture(scope="module")
def resting():
    """Where m g l cos(phi) + c phi = 0."""
    return brentq(lambda phi: MOMENT * np.cos(phi) + LEG["stiffness"] * phi, -1.57, -0.5)


@pytest.fixture(scope="module")
def drops(resting):
    """From 12 deg above rest, and from near the horizontal; true, and as the sensors see them."""
    model = LegModel(LegParameters(**{k: jnp.asarray(v) for k, v in LEG.items()}), NoTorque())
    movements = [Movement(resting + 0.2, 11.0), Movement(-0.2, 11.0)]
    return [
        measure_drops(record(model, movements, jax.random.key(2), exact=exact))
        for exact in (True, False)
    ]


def test_a_small_swing_is_that_of_the_linear_leg(drops, resting):
    found = {name: each.value for name, each in drops[0].drops[0].measures.items()}
    stiffness = (LEG["stiffness"] - MOMENT * np.sin(resting)) / LEG["inertia"]
    decay = LEG["damping"] / LEG["inertia"] / 2
    period = 2 * np.pi / np.sqrt(stiffness - decay**2)
    assert found["plateau_angle"] == pytest.approx(resting, abs=2e-3)
    assert found["period"] == pytest.approx(period, rel=3e-3)  # of 0.2 rad: amplitude^2 / 16
    assert found["logarithmic_decrement_1"] == pytest.approx(decay * period, rel=0.02)
    assert found["relaxation_index"] == pytest.approx(1 + np.exp(-decay * period / 2), rel=0.02)


def test_a_large_swing_takes_longer_and_falls_with_gravity(drops):
    small, large = (each.measures for each in drops[0].drops)
    assert large["period"].value > 1.005 * small["period"].value
    pull = (MOMENT * np.cos(-0.2) + LEG["stiffness"] * -0.2) / LEG["inertia"]
    assert large["peak_flexion_acceleration"].value == pytest.approx(pull, rel=0.03)


def test_the_sensors_change_no_measure_by_more_than_their_noise(drops):
    true, seen = (test.drops[1].measures for test in drops)
    for name, each in seen.items():
        assert each.value is not None, each.reason
        room = LIKELY * each.standard_error + 1e-3 * abs(true[name].value)  # of the exact one's own
        assert abs(each.value - true[name].value) < room, name


def test_of_a_turn_that_is_no_swing_no_decrement_is_told(drops):
    """A hand that carries a leg leaves turns behind that noise puts on either side."""
    landmarks = drops[1].drops[1].landmarks
    flexion, extension, *later = landmarks.turns
    level = replace(landmarks, turns=[flexion, replace(extension, value=later[0].value), *later])
    with pytest.raises(NotAllowed, match="no swing to flexion: cycle 1 or the one after"):
        logarithmic_decrement(level, 1)


def test_a_recording_that_ends_as_the_leg_is_let_go_tells_nothing_and_is_no_fault():
    (found,) = measure_drops(drop(noise=NOISE, lasting=0.05)).drops
    assert not found.measured
    assert "fewer than 7 samples follow the release" in found.reason


@pytest.mark.parametrize(("lasting", "read"), [(0.45, False), (0.9, True)])
def test_where_a_drop_begins_tells_nothing_of_it_alone(lasting, read):
    """The first flexion of `swings.py` has its peak at 0.6 s."""
    test = measure_drops(drop(noise=NOISE, lasting=lasting))
    assert test.drops[0].measured == read
    assert ("start_angle" in test.average) == read
    assert (test.drops[0].reason is None) == read
