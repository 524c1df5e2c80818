"""Standard errors against linear models whose errors are known."""

import numpy as np
import pytest

from exoid.fitting.misfit.uncertainty import HELD, Information, Pressed, second_moment

FIRST, SECOND = np.eye(2)
NONE = np.zeros((0, 2))
TILTED = np.array([[400.0, 250.0], [250.0, 300.0]])
CLOSE = 1e-4  # relative: the vague belief of 0.01 beside the smallest information here, 100


def line(count=50, noise=0.1):
    """The information of intercept and slope of a line measured at `count` places in [-1, 1]."""
    places = np.linspace(-1, 1, count)
    jacobian = np.stack([np.ones(count), places], axis=1) / noise
    return jacobian.T @ jacobian, places


def test_the_errors_of_a_line_are_the_textbooks():
    data, places = line()
    information = Information(data, np.zeros((2, 2)), NONE)
    assert information.standard_error(FIRST) == pytest.approx(0.1 / np.sqrt(50), rel=CLOSE)
    assert information.standard_error(SECOND) == pytest.approx(
        0.1 / np.sqrt(places @ places), rel=CLOSE
    )
    at_end = FIRST + SECOND
    assert information.standard_error(at_end) == pytest.approx(
        0.1 * np.sqrt(1 / 50 + 1 / (places @ places)), rel=CLOSE
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
    assert information.standard_error(FIRST) == pytest.approx(expected, rel=CLOSE)


def test_what_nothing_determines_has_an_infinite_error():
    data = np.outer(FIRST + SECOND, FIRST + SECOND) * 100.0  # only the sum is measured
    information = Information(data, np.zeros((2, 2)), NONE)
    assert information.standard_error(FIRST) == np.inf
    assert information.standard_error(FIRST + SECOND) == pytest.approx(0.1, rel=CLOSE)
    assert information.shares(FIRST) is None


@pytest.mark.parametrize("largest", [1e2, 1e12, 1e15])
def test_what_nothing_determines_stays_so_beside_what_is_told_to_seven_digits(largest):
    """Of 100 mixtures of told and untold coordinates rounding made 27 seem told, beside 1e15."""
    for seed in range(100):
        random = np.random.default_rng(seed)
        sizes = 10 ** random.uniform(0.0, np.log10(largest) / 2, 7)
        told = np.zeros((9, 9))
        told[:7, :7] = np.diag(sizes) @ np.cov(random.normal(size=(7, 20))) @ np.diag(sizes)
        mixed = np.linalg.qr(random.normal(size=(9, 9)))[0]
        information = Information(mixed.T @ told @ mixed, np.zeros((9, 9)), np.zeros((0, 9)))
        assert all(np.isinf(information.standard_error(mixed[row])) for row in (7, 8))


def test_a_bound_that_holds_takes_a_direction_away():
    """With the first held, the sum tells the second: its error is that of the sum."""
    data = np.outer(FIRST + SECOND, FIRST + SECOND) * 100.0
    information = Information(data, np.zeros((2, 2)), FIRST[None])
    assert information.standard_error(FIRST) == 0
    assert information.standard_error(SECOND) == pytest.approx(0.1, rel=CLOSE)
    assert information.shares(FIRST) == HELD
    assert information.shares(SECOND) == HELD  # the data alone could not


def test_a_bound_does_not_claim_what_the_data_tell_without_it():
    data, _ = line()
    information = Information(data, np.zeros((2, 2)), FIRST[None])
    shares = information.shares(SECOND)
    assert shares is not None
    assert shares.source == "data"
    assert shares.data == pytest.approx(1.0)  # intercept and slope are independent here


@pytest.mark.parametrize(
    ("deviation", "expected"),
    [(0.3, "data"), (0.03, "both"), (0.001, "prior")],  # of the prior; the data have 0.0141
)
def test_who_determined_a_value_is_whose_information_is_greater(deviation, expected):
    data, _ = line()
    information = Information(data, np.diag([1 / deviation**2, 0.0]), NONE)
    shares = information.shares(FIRST)
    assert shares is not None
    assert shares.source == expected
    # Of one number the shares of the precision are those of the information.
    assert shares.prior == pytest.approx(deviation**-2 / (deviation**-2 + data[0, 0]), rel=CLOSE)
    assert shares.data + shares.prior + shares.bound == pytest.approx(1.0)


def test_what_a_prior_tells_of_another_value_is_the_priors():
    """The data know the sum very well, the prior only the first: the second is its doing."""
    data = np.outer(FIRST + SECOND, FIRST + SECOND) * 1e8
    information = Information(data, np.diag([100.0, 0.0]), NONE)
    shares = information.shares(SECOND)
    assert shares is not None
    assert shares.source == "prior"
    assert information.standard_error(SECOND) == pytest.approx(0.1, rel=2 * CLOSE)


def test_a_bound_has_the_share_by_which_it_lowers_the_variance():
    """Two values of correlation 0.8: with one held the variance of the other falls to 0.36."""
    covariance = np.array([[1.0, 0.8], [0.8, 1.0]]) / 1e4
    information = Information(np.linalg.inv(covariance), np.zeros((2, 2)), FIRST[None])
    shares = information.shares(SECOND)
    assert shares is not None
    assert shares.bound == pytest.approx(0.64, rel=CLOSE)
    assert shares.source == "bound"


def test_an_error_does_not_depend_on_the_units_of_its_quantity():
    data, _ = line()
    information = Information(data, np.zeros((2, 2)), NONE)
    assert information.standard_error(1000 * FIRST) == pytest.approx(
        1000 * information.standard_error(FIRST)
    )


def test_what_leans_a_little_on_what_nobody_knows_keeps_an_error_within_reason():
    """One part in fifty of an unknown: its error is that part of the vague belief's ten steps."""
    data = np.diag([1e6, 1e-9])
    information = Information(data, np.zeros((2, 2)), NONE)
    assert information.standard_error(SECOND) == np.inf
    leaning = 100.0 * FIRST + 0.02 * SECOND
    assert information.standard_error(leaning) == pytest.approx(np.hypot(0.1, 0.2), rel=CLOSE)


@pytest.mark.parametrize("pressure", [0.0, 3.0, 30.0])
def test_a_limit_that_is_leant_against_leaves_what_lies_within(pressure):
    """The scatter about the end point of draws within the limit, of both coordinates; 20 000 are
    known to 1 %, 4 sigma of which is allowed.
    """
    root = np.linalg.cholesky(np.linalg.inv(TILTED))
    centre = np.linalg.solve(TILTED, -pressure * FIRST)  # pulls beyond: the end point is (0, y)
    held = centre - np.linalg.inv(TILTED) @ FIRST * centre[0] / np.linalg.inv(TILTED)[0, 0]
    draws = np.zeros((0, 2))
    rng = np.random.default_rng(2)
    while len(draws) < 20_000:
        more = centre + rng.normal(size=(400_000, 2)) @ root.T
        draws = np.concatenate([draws, more[more[:, 0] > 0]])
    beyond = np.array([pressure * np.linalg.inv(TILTED)[0, 0]])
    pressed = Pressed(-FIRST[None], beyond, np.array([np.inf]))
    information = Information(TILTED, np.zeros((2, 2)), NONE, pressed=pressed)
    for direction in (FIRST, SECOND):
        scatter = np.sqrt(np.mean(((draws - held) @ direction) ** 2))
        assert information.standard_error(direction) == pytest.approx(scatter, rel=0.04)


def test_the_second_moment_of_half_a_bell_is_the_integrals():
    for slope in (0.0, 0.3, 4.0, 290.0, 310.0):
        there = np.linspace(0, 40 / (1 + slope), 200_001)
        density = np.exp(-slope * there - there**2 / 2)
        expected = np.trapezoid(there**2 * density, there) / np.trapezoid(density, there)
        assert second_moment(slope) == pytest.approx(expected, rel=1e-4)


def test_a_narrow_window_leaves_no_more_than_its_width():
    window = Pressed(-FIRST[None], np.zeros(1), np.array([0.01]))
    information = Information(TILTED, np.zeros((2, 2)), NONE, pressed=window)
    assert information.standard_error(FIRST) == pytest.approx(0.01 / np.sqrt(3), rel=1e-3)
