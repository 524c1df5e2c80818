"""The firmware's filter against independent forms of the same estimate."""

import jax.numpy as jnp
import numpy as np

from exoid.recordings.filter.kalman import (
    MEASUREMENT_NOISE,
    PROCESS_NOISE,
    START_VARIANCE,
    filter,
)

STEP = 0.01  # s


def transition(step):
    return np.array([[1, step, step**2 / 2], [0, 1, step], [0, 0, 1]])


def motion_of_the_model(samples=600, seed=0, step=STEP):
    """States and measurements drawn from the very model the filter assumes."""
    rng = np.random.default_rng(seed)
    steps = np.broadcast_to(step, samples - 1)
    states = [np.array([0.1, 0.2, 0.0])]
    for each in steps:
        kick = rng.normal(size=3) * np.sqrt(PROCESS_NOISE)
        states.append(transition(each) @ states[-1] + kick)
    truth = np.array(states)
    measured = truth[:, :2] + rng.normal(size=(samples, 2)) * np.sqrt(MEASUREMENT_NOISE)
    return steps, truth, measured


def dense_filter(steps, measured):
    """The textbook filter with matrices: both measurements at once, P = (I - K H) P."""
    h, r, q = np.eye(2, 3), np.diag(MEASUREMENT_NOISE), np.diag(PROCESS_NOISE)
    state = np.array([*measured[0], 0.0])
    covariance = np.diag([*MEASUREMENT_NOISE, START_VARIANCE[2]])
    found = [(state, covariance)]
    for step, z in zip(steps, measured[1:], strict=True):
        a = transition(step)
        state, covariance = a @ state, a @ covariance @ a.T + q
        gain = covariance @ h.T @ np.linalg.inv(h @ covariance @ h.T + r)
        state = state + gain @ (z - h @ state)
        covariance = (np.eye(3) - gain @ h) @ covariance
        found.append((state, covariance))
    return tuple(np.array(each) for each in zip(*found, strict=True))


def firmware_float32(steps, measured):
    """The firmware's arithmetic, one float32 operation after the other."""
    f = np.float32
    q, r = [f(v) for v in PROCESS_NOISE], [f(v) for v in MEASUREMENT_NOISE]
    x = [f(measured[0, 0]), f(measured[0, 1]), f(0)]
    p00, p01, p02, p11, p12, p22 = r[0], f(0), f(0), r[1], f(0), f(START_VARIANCE[2])
    found = [x]
    for step, z in zip(steps.astype(f), measured[1:].astype(f), strict=True):
        half = f(0.5) * step * step
        b00 = p00 + step * p01 + half * p02
        b01 = p01 + step * p11 + half * p12
        b02 = p02 + step * p12 + half * p22
        b11 = p11 + step * p12
        b12 = p12 + step * p22
        x = [x[0] + step * x[1] + half * x[2], x[1] + step * x[2], x[2]]
        p00 = b00 + step * b01 + half * b02 + q[0]
        p01, p02, p12 = b01 + step * b02, b02, b12
        p11, p22 = b11 + step * b12 + q[1], p22 + q[2]
        for row in (0, 1):
            c0, c1, c2 = (p00, p01, p02) if row == 0 else (p01, p11, p12)
            inverse = f(1) / ((c0 if row == 0 else c1) + r[row])
            g0, g1, g2 = c0 * inverse, c1 * inverse, c2 * inverse
            e = z[row] - x[row]
            x = [x[0] + g0 * e, x[1] + g1 * e, x[2] + g2 * e]
            p00, p01, p02 = p00 - g0 * c0, p01 - g0 * c1, p02 - g0 * c2
            p11, p12, p22 = p11 - g1 * c1, p12 - g1 * c2, p22 - g2 * c2
        found.append(x)
    return np.array(found)


def test_it_is_the_textbook_filter():
    steps, _, measured = motion_of_the_model()
    found = filter(steps, *measured.T)
    state, covariance = dense_filter(steps, measured)
    np.testing.assert_allclose(found.state, state, atol=1e-10)
    np.testing.assert_allclose(found.covariance, covariance, atol=1e-10)


def test_it_is_the_textbook_filter_when_the_steps_differ():
    uneven = np.random.default_rng(1).uniform(0.002, 0.05, 299)
    steps, _, measured = motion_of_the_model(300, step=uneven)
    state, _ = dense_filter(steps, measured)
    np.testing.assert_allclose(filter(steps, *measured.T).state, state, atol=1e-10)


def test_float32_agrees_with_the_firmware_to_its_contract():
    steps, _, measured = motion_of_the_model(3000)
    steps = steps.astype(np.float32)
    found = filter(steps, *measured.astype(np.float32).T).state
    assert found.dtype == jnp.float32
    off = np.abs(found - firmware_float32(steps, measured)).max(axis=0)
    size = np.abs(measured[:, 0]).max()  # rounding grows with the angle this free motion reaches
    assert (off < np.array([1e-6, 2e-6, 5e-4]) * max(1.0, size)).all()


def test_the_covariance_is_positive_and_settles_within_a_quarter_of_a_second():
    steps, _, measured = motion_of_the_model()
    covariance = filter(steps, *measured.T).covariance
    assert (np.linalg.eigvalsh(covariance) > 0).all()
    assert (covariance == jnp.swapaxes(covariance, -1, -2)).all()
    np.testing.assert_allclose(covariance[25], covariance[-1], rtol=1e-2)


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
