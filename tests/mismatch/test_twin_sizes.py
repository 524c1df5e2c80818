"""How large a cause is by the name of its exact twin: as a fit with that finds it."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.mismatch.answer.diagnosis import Parameter, Suspect
from exoid.mismatch.conclude.twin_sizes import as_fitted, twin_sizes
from exoid.physics.leg import LegModel
from exoid.physics.sensing.clock_rate import ClockRate
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.terms.device.torque_bias import TorqueBias
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.physics.torque import NoTorque
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, leg

TONE = 1.6  # N m, as of muscles that do not relax
ALIKE = ["stiffness_rest_angle", "torque_bias"]


@pytest.fixture(scope="module")
def recording():
    model = LegModel(leg(), NoTorque(), np.asarray(0.0), (TorqueBias(jnp.asarray(TONE)),))
    drops = [Movement(np.radians(start), 6.0) for start in (-10.0, -45.0)]
    return record(model, drops, jax.random.key(3), subject=BODY)


@pytest.fixture(scope="module")
def rest(recording):
    return fit(recording, terms=(StiffnessRestAngle,), multistart=1)


@pytest.fixture(scope="module")
def tone(recording):
    return fit(recording, terms=(TorqueBias,), multistart=1)


def test_a_spring_slack_elsewhere_is_as_large_a_torque_as_a_fit_with_that_finds(rest, tone):
    inertia = rest.parameters["inertia"].value
    whole, ratio = twin_sizes(rest, ALIKE, inertia)
    assert (whole.name, whole.unit) == ("torque_bias.bias", "N m")
    assert (ratio.name, ratio.unit) == ("torque_bias.bias_over_inertia", "1/s^2")
    own = tone.of_terms["torque_bias.bias"], tone.of_terms["torque_bias.bias_over_inertia"]
    for found, known in zip((whole, ratio), own, strict=True):
        # one model in two forms, whose fits end within a part of their error of each other
        assert found.value == pytest.approx(known.value, abs=0.1 * known.standard_error)
        assert found.standard_error == pytest.approx(known.standard_error, rel=0.05)
    true = TONE / float(leg().inertia)
    assert abs(ratio.value - true) < 3 * ratio.standard_error < 0.2 * true


def test_a_torque_is_the_rest_angle_that_a_fit_with_that_finds(rest, tone):
    (found,) = twin_sizes(tone, ALIKE, tone.parameters["inertia"].value)
    known = rest.of_terms["stiffness_rest_angle.rest_angle"]
    assert (found.name, found.unit) == ("stiffness_rest_angle.rest_angle", "rad")
    assert found.value == pytest.approx(known.value, abs=0.1 * known.standard_error)
    assert found.standard_error == pytest.approx(known.standard_error, rel=0.05)


def test_only_twins_that_are_named_have_a_size(rest):
    assert twin_sizes(rest, ALIKE[:1], 0.4) == []


@pytest.mark.parametrize("size", [-0.2, 0.001, 0.04])
def test_the_twin_of_a_twin_is_as_large_as_itself(size):
    assert GyroScale.as_twin(ClockRate.as_twin(size)) == pytest.approx(size, rel=1e-12)
    # a gyro shows (1 + s) phi', by a slow clock phi' / (1 + k)
    assert 1 + ClockRate.as_twin(size) == pytest.approx(1 / (1 + size), rel=1e-12)


def test_suspects_have_the_sizes_of_the_fit_or_those_for_its_inertia():
    fitted = [Parameter("torque_bias.bias", 1.6, "N m", 0.1)]
    searched = [replace(fitted[0], value=1.2)]
    same = as_fitted(Suspect(["torque_bias"], [], searched), ["stiffness_rest_angle"], fitted, 2.0)
    assert same.parameters == fitted
    two = Suspect(["torque_bias", "hard_stop"], [], searched)
    (other,) = as_fitted(two, ["stiffness_rest_angle"], fitted, 2.0).parameters
    assert other.value == pytest.approx(2.4)


def test_a_rivals_torque_is_as_open_as_the_inertia_that_it_is_for():
    """A torque sensor's gain, known to 7 %, is in the fit's own size, and in that of a rival."""
    level = Parameter("coulomb_friction.level", 0.1, "N m", 0.001)
    rate = Parameter("zero_drift.rate", 0.1, "rad/s", 0.001)
    suspect = Suspect(["coulomb_friction", "zero_drift"], [], [level, rate])
    torque, other = as_fitted(suspect, ["coulomb_friction"], [], 2.0, doubt=0.07).parameters
    assert torque.value == pytest.approx(0.2)
    assert torque.standard_error == pytest.approx(np.hypot(0.002, 0.07 * 0.2))
    assert other == rate
