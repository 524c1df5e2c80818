"""What one would take instead: a plain Kalman filter of what is unknown, extended or unscented, and
recursive least squares on differentiated signals. NumPy alone.

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
    """An extended Kalman filter; derivatives by differences."""
    return filtered(stretches, linear)


def unscented(stretches: list[Stretch]) -> Found:
    """An unscented one, its sigma points close to the mean."""
    return filtered(stretches, sigma)


def filtered(stretches: list[Stretch], through) -> Found:
    mean, covariance = MEAN.copy(), np.diag(DEVIATION**2)
    for one in stretches:
        mean, covariance = begun(mean, covariance, one)
        for angle, rate in zip(one.angle[1:], one.rate[1:], strict=True):
            mean, covariance, _ = through(lambda at, h=one.tick: moved(at, h), mean, covariance)
            covariance[1, 1] += ROUGH
            seen, spread, cross = through(shown, mean, covariance)
            gain = np.linalg.solve(spread + np.diag(NOISE), cross.T).T
            mean = mean + gain @ (np.array([angle, rate]) - seen)
            covariance = covariance - gain @ (spread + np.diag(NOISE)) @ gain.T
            covariance = (covariance + covariance.T) / 2
    return Found(mean[RATIOS], np.sqrt(np.maximum(np.diag(covariance)[RATIOS], 0.0)))


def begun(mean: np.ndarray, covariance: np.ndarray, one: Stretch):
    """Of a new movement nothing is known."""
    mean, covariance = mean.copy(), covariance.copy()
    mean[:2] = one.angle[0] - mean[5], one.rate[0] - mean[6]
    covariance[:2] = covariance[:, :2] = 0.0
    covariance[0, 0], covariance[1, 1] = DEVIATION[:2] ** 2
    return mean, covariance


def linear(function, mean, covariance):
    """Mean, covariance and covariance with what went in."""
    size = 1e-6 * DEVIATION
    points = mean[:, None] + np.hstack([np.diag(size), -np.diag(size)])
    each = function(points)
    slope = (each[:, : mean.size] - each[:, mean.size :]) / (2 * size)
    return function(mean[:, None])[:, 0], slope @ covariance @ slope.T, covariance @ slope.T


def sigma(function, mean, covariance):
    size = mean.size
    scale = SPREAD**2 * size
    values, vectors = np.linalg.eigh(covariance)
    root = vectors * np.sqrt(np.maximum(values, 0.0) * scale)
    points = mean[:, None] + np.hstack([np.zeros((size, 1)), root, -root])
    weights = np.full(2 * size + 1, 0.5 / scale)
    weights[0] = 1 - size / scale
    each = function(points)
    centre = each @ weights
    spread = weights.copy()
    spread[0] += 3 - SPREAD**2
    apart, away = each - centre[:, None], points - mean[:, None]
    return centre, (apart * spread) @ apart.T, (away * spread) @ apart.T


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
