"""Standard errors against linear models whose errors are known."""

import numpy as np
import pytest

from exoid.fit.uncertainty import Information, correlation_time, noise_scale, source

FIRST, SECOND = np.eye(2)
NONE = np.zeros((0, 2))


def line(count=50, noise=0.1):
    """The information of intercept and slope of a line measured at `count` places in [-1, 1]."""
    places = np.linspace(-1, 1, count)
    jacobian = np.stack([np.ones(count), places], axis=1) / noise
    return jacobian.T @ jacobian, places


def test_the_errors_of_a_line_are_the_textbooks():
    data, places = line()
    information = Information(data, np.zeros((2, 2)), NONE)
    assert information.standard_error(FIRST) == pytest.approx(0.1 / np.sqrt(50))
    assert information.standard_error(SECOND) == pytest.approx(0.1 / np.sqrt(places @ places))
    at_end = FIRST + SECOND
    assert information.standard_error(at_end) == pytest.approx(
        0.1 * np.sqrt(1 / 50 + 1 / (places @ places))
    )


def test_the_errors_of_a_line_are_the_scatter_of_its_fits():
    """Of 4000 fits; the scatter is known to 1.1 %, 4 sigma of which is allowed."""
    data, places = line()
    information = Information(data, np.zeros((2, 2)), NONE)
    noise = 0.1 * np.random.default_rng(1).normal(size=(4000, places.size))
    fits = noise @ np.stack([np.ones(50), places], axis=1) @ np.linalg.inv(data * 0.1**2)
    for direction in (FIRST, SECOND, FIRST - 2 * SECOND):
        assert np.std(fits @ direction) == pytest.approx(
            information.standard_error(direction), rel=0.045
        )


def test_a_prior_adds_its_information():
    prior = np.diag([1 / 0.02**2, 0.0])
    data, _ = line()
    information = Information(data, prior, NONE)
    expected = 1 / np.sqrt(50 / 0.1**2 + 1 / 0.02**2)
    assert information.standard_error(FIRST) == pytest.approx(expected)
    assert information.data_only(FIRST) == pytest.approx(0.1 / np.sqrt(50))


def test_what_nothing_determines_has_an_infinite_error():
    data = np.outer(FIRST + SECOND, FIRST + SECOND) * 100.0  # only the sum is measured
    information = Information(data, np.zeros((2, 2)), NONE)
    assert information.standard_error(FIRST) == np.inf
    assert information.standard_error(FIRST + SECOND) == pytest.approx(2 / np.sqrt(4 * 100.0) * 1.0)
    assert source(information, FIRST, np.inf, False) is None


def test_a_bound_that_holds_takes_a_direction_away():
    """With the first held, the sum tells the second: its error is that of the sum."""
    data = np.outer(FIRST + SECOND, FIRST + SECOND) * 100.0
    information = Information(data, np.zeros((2, 2)), FIRST[None])
    assert information.standard_error(FIRST) == 0
    assert information.standard_error(SECOND) == pytest.approx(0.1)
    assert source(information, FIRST, np.inf, True) == "bound"
    assert source(information, SECOND, np.inf, False) == "bound"  # the data alone could not


def test_a_bound_does_not_claim_what_the_data_tell_without_it():
    data, _ = line()
    information = Information(data, np.zeros((2, 2)), FIRST[None])
    assert source(information, SECOND, np.inf, False) == "data"


@pytest.mark.parametrize(
    ("deviation", "expected"),
    [(0.3, "data"), (0.03, "both"), (0.001, "prior")],  # of the prior; the data have 0.0141
)
def test_who_determined_a_value_is_whose_information_is_greater(deviation, expected):
    data, _ = line()
    information = Information(data, np.diag([1 / deviation**2, 0.0]), NONE)
    assert source(information, FIRST, deviation, False) == expected


def test_an_error_does_not_depend_on_the_units_of_its_quantity():
    data, _ = line()
    information = Information(data, np.zeros((2, 2)), NONE)
    assert information.standard_error(1000 * FIRST) == pytest.approx(
        1000 * information.standard_error(FIRST)
    )


def test_white_noise_of_the_declared_size_widens_nothing():
    """chi^2 per sample of 4000 is 1 within 4.5 %, so its root within 2.3 %."""
    residual = np.random.default_rng(0).normal(size=(2, 2000))
    assert noise_scale(list(residual), 7) < 1.05
    assert noise_scale(list(0.3 * residual), 7) == 1.0  # noise was declared too large


def test_white_noise_twice_the_declared_widens_by_two():
    """The autocorrelation of 2000 white samples is within 2.2 %: its sum adds a few per cent."""
    residual = 2 * np.random.default_rng(0).normal(size=(2, 2000))
    assert noise_scale(list(residual), 7) == pytest.approx(2.0, rel=0.1)


def test_the_correlation_time_is_that_of_an_autoregression():
    """x_i = a x_{i-1} + e: 1 + 2 sum a^k = (1 + a) / (1 - a), less what lies below 0.05."""
    generator, a = np.random.default_rng(3), 0.9
    noise = generator.normal(size=200_000)
    x = np.zeros_like(noise)
    for i in range(1, x.size):
        x[i] = a * x[i - 1] + noise[i]
    assert correlation_time(x) == pytest.approx((1 + a) / (1 - a) - 2 * 0.05 / (1 - a), rel=0.06)
    assert correlation_time(noise) == pytest.approx(1.0, abs=0.02)
