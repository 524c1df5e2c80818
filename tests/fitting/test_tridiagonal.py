"""A process beside white noise: the tridiagonal way is the plain one."""

import numpy as np
import pytest

from exoid.fitting.misfit.disturbance.tridiagonal import LEAST, tridiagonal
from exoid.fitting.misfit.gram_matrices import matern

NODES, COLUMNS = 24, 5
TIMES = np.linspace(0.0, 3.0, NODES)
CORRELATED = np.array([0.05, 0.8])  # s
RATIOS = np.logspace(-6, 6, 7)


def made(seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Two processes that move a segment, and its rows."""
    draw = np.random.default_rng(seed)
    effect = np.triu(draw.normal(size=(NODES, NODES)))
    return effect @ matern(TIMES, CORRELATED) @ effect.T, draw.normal(size=(NODES, COLUMNS))


def dense(process: np.ndarray, rows: np.ndarray, ratio: float) -> tuple[float, np.ndarray]:
    whole = np.eye(NODES) + ratio * process
    return np.linalg.slogdet(whole)[1], rows.T @ np.linalg.solve(whole, rows)


@pytest.mark.parametrize("number", range(len(CORRELATED)))
@pytest.mark.parametrize("at", range(2))
def test_every_segment_process_and_ratio_is_as_the_whole_matrix_has_it(at: int, number: int):
    segments = [made(1), made(2)]
    spread, inside = tridiagonal(*map(list, zip(*segments, strict=True))).beside_noise(RATIOS)
    processes, rows = segments[at]
    determinants, quadratic = zip(
        *(dense(processes[number], rows, ratio) for ratio in RATIOS), strict=True
    )
    # I + ratio P has a condition of up to 1e9 here, which costs nine of sixteen digits
    np.testing.assert_allclose(spread[at, number], determinants, rtol=1e-7, atol=1e-7)
    np.testing.assert_allclose(inside[at, number], quadratic, rtol=1e-6, atol=1e-6)


def test_each_process_may_have_ratios_of_its_own():
    processes, rows = made(3)
    found = tridiagonal([processes], [rows])
    own = np.array([[0.1, 3.0], [7.0, 20.0]])
    spread, inside = found.beside_noise(own)
    for number, ratios in enumerate(own):
        each, told = found.beside_noise(ratios)
        np.testing.assert_allclose(spread[:, number], each[:, number])
        np.testing.assert_allclose(inside[:, number], told[:, number])


def test_one_process_needs_no_axis_of_its_own():
    processes, rows = made(4)
    spread, inside = tridiagonal([processes[0]], [rows]).beside_noise(RATIOS)
    several, told = tridiagonal([processes], [rows]).beside_noise(RATIOS)
    np.testing.assert_allclose(spread, several[:, 0])
    np.testing.assert_allclose(inside, told[:, 0])


def test_a_process_that_drowns_all_noise_leaves_no_determinant_that_is_rounding():
    process = np.ones((NODES, NODES))  # one direction; of the others nothing is told
    spread, inside = tridiagonal([process], [np.eye(NODES)]).beside_noise(np.array([1e20]))
    floor = LEAST * 1e20 * NODES  # of the white noise then
    grown = np.log(floor) * (NODES - 1) + np.log(floor + 1e20 * NODES)
    assert spread[0, 0] == pytest.approx(grown, rel=1e-3)  # of 2e-16 beside 1e-14
    assert np.isfinite(inside).all()
