"""What one would take instead: a plain Kalman filter of what is unknown, extended or unscented, by
filterpy, and recursive least squares on differentiated signals, by NumPy.

All are told when the leg is free, which the estimator of exoid has to find by itself.
"""

from typing import NamedTuple

import numpy as np

RATIOS = slice(2, 5)  # of a row: angle, rate, gravity, stiffness, damping, zero, bias
MEAN = np.array([0.0, 0.0, 26.5, 6.6, 0.8, 0.0, 0.0])
DEVIATION = np.array([0.1, 2.0, 0.93, 33.0, 4.0, np.radians(3.0), np.radians(5.0)])
NOISE = np.array([0.00087**2, 0.0026**2 + (0.0007 * 10) ** 2])  # with the gyro's age at 10 rad/s^2
ROUGH = 1e-10  # (rad/s)^2 a step
SPREAD = 1e-3  # of the sigma points


class Found(NamedTuple):
    """The three ratios and their standard errors."""

    values: np.ndarray
    errors: np.ndarray


class Stretch(NamedTuple):
    """Samples of a leg that moves freely."""

    angle: np.ndarray
    rate: np.ndarray
    tick: float


def pull(rows: np.ndarray) -> np.ndarray:
    angle, rate, gravity, stiffness, damping = rows[:5]
    return -gravity * np.cos(angle) - stiffness * angle - damping * rate


def moved(rows: np.ndarray, tick: float) -> np.ndarray:
    """Rows (unknown, point) a tick later, by Runge-Kutta of order four."""

    def slope(at):
        found = np.zeros_like(at)
        found[0], found[1] = at[1], pull(at)
        return found

    a = slope(rows)
    b = slope(rows + tick / 2 * a)
    c = slope(rows + tick / 2 * b)
    return rows + tick / 6 * (a + 2 * b + 2 * c + slope(rows + tick * c))


def shown(rows: np.ndarray) -> np.ndarray:
    return np.stack([rows[0] + rows[5], rows[1] + rows[6]])


def extended(stretches: list[Stretch]) -> Found:
    """filterpy's extended Kalman filter; derivatives by differences."""
    from filterpy.kalman import ExtendedKalmanFilter

    own = ExtendedKalmanFilter(dim_x=MEAN.size, dim_z=2)
    own.predict_x = lambda u=0: setattr(own, "x", once(moved, own.x, own.tick))

    def step(tick: float, seen: np.ndarray) -> None:
        own.tick, own.F = tick, slope_of(lambda rows: moved(rows, tick), own.x)
        own.predict()
        own.update(seen, lambda at: slope_of(shown, at), lambda at: once(shown, at))

    return filtered(own, step, stretches)


def unscented(stretches: list[Stretch]) -> Found:
    """filterpy's unscented one, its sigma points close to the mean."""
    from filterpy.kalman import MerweScaledSigmaPoints, UnscentedKalmanFilter

    points = MerweScaledSigmaPoints(MEAN.size, alpha=SPREAD, beta=2.0, kappa=0.0, sqrt_method=root)
    own = UnscentedKalmanFilter(
        MEAN.size,
        2,
        dt=0.01,
        hx=lambda at: once(shown, at),
        fx=lambda at, dt: once(moved, at, dt),
        points=points,
    )

    def step(tick: float, seen: np.ndarray) -> None:
        own.predict(dt=tick)
        own.update(seen)

    return filtered(own, step, stretches)


def filtered(own, step, stretches: list[Stretch]) -> Found:
    """What a filter of filterpy says after all stretches."""
    own.x, own.P = MEAN.copy(), np.diag(DEVIATION**2)
    own.Q, own.R = np.diag(ROUGH * (np.arange(MEAN.size) == 1)), np.diag(NOISE)
    for one in stretches:
        own.x, own.P = begun(own.x, own.P, one)
        for seen in np.stack([one.angle[1:], one.rate[1:]], axis=1):
            step(one.tick, seen)
            own.P = (own.P + own.P.T) / 2
    return Found(own.x[RATIOS], np.sqrt(np.maximum(np.diag(own.P)[RATIOS], 0.0)))


def begun(mean: np.ndarray, covariance: np.ndarray, one: Stretch):
    """Of a new movement nothing is known."""
    mean, covariance = mean.copy(), covariance.copy()
    mean[:2] = one.angle[0] - mean[5], one.rate[0] - mean[6]
    covariance[:2] = covariance[:, :2] = 0.0
    covariance[0, 0], covariance[1, 1] = DEVIATION[:2] ** 2
    return mean, covariance


def once(function, row: np.ndarray, *given: float) -> np.ndarray:
    """A function of rows (unknown, point), of one row."""
    return function(row[:, None], *given)[:, 0]


def slope_of(function, row: np.ndarray) -> np.ndarray:
    size = 1e-6 * DEVIATION
    points = row[:, None] + np.hstack([np.diag(size), -np.diag(size)])
    each = function(points)
    return (each[:, : row.size] - each[:, row.size :]) / (2 * size)


def root(covariance: np.ndarray) -> np.ndarray:
    """Upper: rounding may make one negative by a little, which a triangle does not forgive."""
    values, vectors = np.linalg.eigh((covariance + covariance.T) / 2)
    return (vectors * np.sqrt(np.maximum(values, 0.0))).T


def least_squares(stretches: list[Stretch]) -> Found:
    """phi'' = -A cos - B sin - c phi + o - d phi', phi'' by differences of the gyro."""
    information, right, squares, count = np.zeros((5, 5)), np.zeros(5), 0.0, 0
    for one in stretches:
        angle, rate = one.angle[1:-1], one.rate[1:-1]
        turned = (one.rate[2:] - one.rate[:-2]) / (2 * one.tick)
        table = np.stack([-np.cos(angle), -np.sin(angle), -angle, np.ones_like(angle), -rate], 1)
        for row, value in zip(table, turned, strict=True):
            information += np.outer(row, row)
            right += row * value
            squares, count = squares + value**2, count + 1
    found = np.linalg.solve(information, right)
    variance = (squares - right @ found) / (count - 5)
    covariance = variance * np.linalg.inv(information)
    gravity = np.hypot(found[0], found[1])
    slope = np.zeros((3, 5))
    slope[0, :2] = found[:2] / gravity
    slope[1, 2] = slope[2, 4] = 1.0
    values = np.array([gravity, found[2], found[4]])
    return Found(values, np.sqrt(np.diag(slope @ covariance @ slope.T)))
