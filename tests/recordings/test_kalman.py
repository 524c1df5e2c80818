"""The firmware's filter against independent forms of the same estimate."""

import jax.numpy as jnp
import numpy as np
import pytest

from exoid.recordings.declared.sensors import FILTERS
from exoid.recordings.filter.constants import DESIGNS, OF_NODE, UNBIASED
from exoid.recordings.filter.kalman import filter

STEP = 0.01  # s
SEEN = np.array([[1.0, 0, 0, 0], [0, 1, 0, 1]])  # the angle; the velocity and the gyro's bias
BOTH = pytest.mark.parametrize("design", [OF_NODE, UNBIASED])


def transition(step):
    return np.array([[1, step, step**2 / 2, 0], [0, 1, step, 0], [0, 0, 1, 0], [0, 0, 0, 1]])


def motion_of_the_model(samples=600, seed=0, step=STEP, design=OF_NODE):
    """States and measurements drawn from the very model the filter assumes."""
    rng = np.random.default_rng(seed)
    steps = np.broadcast_to(step, samples - 1)
    states = [np.array([0.1, 0.2, 0.0, rng.normal() * design.start_variance[3] ** 0.5])]
    for each in steps:
        kick = rng.normal(size=4) * np.sqrt(design.process_noise)
        states.append(transition(each) @ states[-1] + kick)
    truth = np.array(states)
    noise = rng.normal(size=(samples, 2)) * np.sqrt(design.measurement_noise)
    return steps, truth, truth @ SEEN.T + noise


def dense_filter(steps, measured, design):
    """The textbook filter with matrices: both measurements at once, P = (I - K H) P."""
    r, q, unknown = (
        np.diag(design.measurement_noise),
        np.diag(design.process_noise),
        design.start_variance,
    )
    state = np.array([*measured[0], 0.0, 0.0])
    covariance = np.diag([r[0, 0], r[1, 1] + unknown[3], *unknown[2:]])
    covariance[1, 3] = covariance[3, 1] = -unknown[3]
    found = [(state, covariance)]
    for step, z in zip(steps, measured[1:], strict=True):
        a = transition(step)
        state, covariance = a @ state, a @ covariance @ a.T + q
        gain = covariance @ SEEN.T @ np.linalg.inv(SEEN @ covariance @ SEEN.T + r)
        state = state + gain @ (z - SEEN @ state)
        covariance = (np.eye(4) - gain @ SEEN) @ covariance
        found.append((state, covariance))
    return tuple(np.array(each) for each in zip(*found, strict=True))


def filter_of_three_states(steps, measured):
    """The textbook filter of a gyro without bias."""
    h, r, q = np.eye(2, 3), np.diag(OF_NODE.measurement_noise), np.diag(OF_NODE.process_noise[:3])
    state = np.array([*measured[0], 0.0])
    covariance = np.diag([*OF_NODE.measurement_noise, OF_NODE.start_variance[2]])
    found = [state]
    for step, z in zip(steps, measured[1:], strict=True):
        a = transition(step)[:3, :3]
        state, covariance = a @ state, a @ covariance @ a.T + q
        gain = covariance @ h.T @ np.linalg.inv(h @ covariance @ h.T + r)
        state = state + gain @ (z - h @ state)
        covariance = (np.eye(3) - gain @ h) @ covariance
        found.append(state)
    return np.array(found)


def states_of(found):
    return np.column_stack([found.state, found.bias])


@BOTH
def test_it_is_the_textbook_filter(design):
    steps, _, measured = motion_of_the_model(design=design)
    found = filter(steps, *measured.T, design)
    state, covariance = dense_filter(steps, measured, design)
    np.testing.assert_allclose(states_of(found), state, atol=1e-10)
    np.testing.assert_allclose(found.covariance, covariance, atol=1e-10)


def test_it_is_the_textbook_filter_when_the_steps_differ():
    uneven = np.random.default_rng(1).uniform(0.002, 0.05, 299)
    steps, _, measured = motion_of_the_model(300, step=uneven)
    state, _ = dense_filter(steps, measured, OF_NODE)
    np.testing.assert_allclose(states_of(filter(steps, *measured.T)), state, atol=1e-10)


def test_a_bias_that_is_known_to_be_nothing_leaves_the_filter_of_three_states():
    steps, _, measured = motion_of_the_model()
    found = filter(steps, *measured.T, UNBIASED)
    np.testing.assert_allclose(found.state, filter_of_three_states(steps, measured), atol=1e-10)
    assert (found.bias == 0).all()


def test_a_sidecar_can_name_every_design():
    assert tuple(DESIGNS) == FILTERS


def test_the_covariance_is_positive_and_settles_within_a_second():
    steps, _, measured = motion_of_the_model()
    covariance = filter(steps, *measured.T).covariance
    assert (np.linalg.eigvalsh(covariance) > 0).all()
    assert (covariance == jnp.swapaxes(covariance, -1, -2)).all()
    variance = np.diagonal(covariance, axis1=1, axis2=2)[:, :3]
    # After 1 s a milliradian a second of the bias is not yet known: a tenth of the velocity's own.
    np.testing.assert_allclose(variance[100], variance[-1], rtol=0.12)


def test_innovations_of_the_models_own_data_are_white_with_the_predicted_variance():
    samples = 4000
    steps, _, measured = motion_of_the_model(samples, seed=2)
    found = filter(steps, *measured.T)
    normalised = np.asarray(found.innovation / jnp.sqrt(found.innovation_variance))[50:]
    four_sigma = 4 / np.sqrt(len(normalised))
    assert (abs(normalised.mean(axis=0)) < four_sigma).all()
    assert (abs((normalised**2).mean(axis=0) - 1) < np.sqrt(2) * four_sigma).all()
    for lag in (1, 2, 5):
        assert (abs((normalised[lag:] * normalised[:-lag]).mean(axis=0)) < four_sigma).all()
    assert abs((normalised[:, 0] * normalised[:, 1]).mean()) < four_sigma


def test_a_missing_measurement_skips_its_own_update_only():
    steps, _, measured = motion_of_the_model(300, seed=5)
    gap = measured.copy()
    gap[100:110, 0] = np.nan
    whole, holed = filter(steps, *measured.T), filter(steps, *gap.T)
    assert jnp.isfinite(holed.state).all()
    np.testing.assert_array_equal(np.isnan(holed.innovation[1:, 0]), np.isnan(gap[1:, 0]))
    assert jnp.isfinite(holed.innovation[1:, 1]).all()
    assert holed.covariance[109, 0, 0] > 2 * whole.covariance[109, 0, 0]
    np.testing.assert_allclose(holed.state[200:], whole.state[200:], atol=1e-5)


def test_a_swing_at_one_hertz_lags_in_acceleration_only():
    time = np.arange(0, 8, STEP)
    phase = 2 * np.pi * time
    exact = np.stack([np.sin(phase), np.cos(phase), -np.sin(phase)], axis=1)
    exact *= 0.5 * np.array([1, 2 * np.pi, 4 * np.pi**2])
    found = np.asarray(filter(np.diff(time), exact[:, 0], exact[:, 1]).state)
    quarter = round(0.25 / STEP)
    ahead, settled = np.roll(exact, -quarter, axis=0), slice(200, 700)
    lag = -np.arctan2(
        (found * ahead)[settled].sum(axis=0), (found * exact)[settled].sum(axis=0)
    ) / (2 * np.pi)
    assert (abs(lag[:2]) < 1e-3).all()
    assert 0.004 < lag[2] < 0.012  # an estimate of acceleration from a rate cannot be immediate


def test_a_bias_is_told_by_an_encoder_alone_and_its_error_is_the_believed_one():
    """Drawn from the model: the normalised error of the bias has variance 1; 30 draws, 5 sigma."""
    found = []
    for seed in range(30):
        steps, truth, measured = motion_of_the_model(1000, seed=seed)
        told = filter(steps, *measured.T)
        deviation = float(np.sqrt(told.covariance[-1, 3, 3]))
        found.append((float(told.bias[-1]) - truth[-1, 3]) / deviation)
        blind = filter(steps, np.full(1000, np.nan), measured[:, 1])
        assert float(np.sqrt(blind.covariance[-1, 3, 3])) > 100 * deviation
    assert np.mean(np.square(found)) == pytest.approx(1, abs=5 * np.sqrt(2 / 30))
