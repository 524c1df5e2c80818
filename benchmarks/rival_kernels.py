"""The motion and the misfit that all rivals share, as a Python loop and compiled by numba.

Half the sum of squares of the residuals in angle and angular velocity, each divided by its
sensor's noise; RK4 at the sample times; one set of ratios, an amplitude for each cycle, an initial
state for each segment: x = (m l g / J, c / J, d / J, each tau / J, each initial state).
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numba import njit

from problem import ANGLE_NOISE, VELOCITY_NOISE, Problem, torque_shape

# reassociation and fused multiply-add let the loops use vector instructions; NaN stays NaN
compiled = njit(cache=True, nogil=True, error_model="numpy", fastmath={"reassoc", "contract"})


def python_residuals(x: np.ndarray, problem: Problem) -> np.ndarray:
    """Residuals at x = (m l g / J, c / J, d / J, each tau / J, each initial state)."""
    gravity, stiffness, damping = x[:3]
    amplitudes = iter(x[3 : x.size - 2 * len(problem)])
    states = x[x.size - 2 * len(problem) :].reshape(-1, 2)
    residuals = []
    for segment, state in zip(problem, states, strict=True):
        amplitude = next(amplitudes) if segment.frequency else 0.0

        def rate(t, s, segment=segment, amplitude=amplitude):
            torque = amplitude * np.sin(2 * np.pi * segment.frequency * t)
            if t <= segment.period / 2:
                torque = -torque
            load = gravity * np.cos(s[0]) + stiffness * s[0] + damping * s[1]
            return np.array([s[1], torque - load])

        path = integrate(rate, segment.time, state)
        residuals.append((path[:, 0] - segment.angle) / ANGLE_NOISE)
        residuals.append((path[:, 1] - segment.angular_velocity) / VELOCITY_NOISE)
    return np.concatenate(residuals)


def integrate(rate: Callable, time: np.ndarray, state: np.ndarray) -> np.ndarray:
    """RK4 at the sample times."""
    path = np.empty((time.size, state.size))
    path[0] = state
    for i in range(time.size - 1):
        t, s, h = time[i], path[i], time[i + 1] - time[i]
        k1 = rate(t, s)
        k2 = rate(t + h / 2, s + h / 2 * k1)
        k3 = rate(t + h / 2, s + h / 2 * k2)
        k4 = rate(t + h, s + h * k3)
        path[i + 1] = s + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return path


class Data(NamedTuple):
    """A problem as flat arrays: segment k holds samples first[k] to first[k + 1]."""

    angle: np.ndarray
    velocity: np.ndarray
    step: np.ndarray  # time to the next sample
    torque: np.ndarray  # Eq. 10 at unit amplitude: at the sample, half a step and a step later
    first: np.ndarray
    amplitude: np.ndarray  # which amplitude drives segment k; -1 in a drop


def flatten(problem: Problem) -> Data:
    active = np.array([segment.frequency > 0 for segment in problem])
    steps = [np.diff(segment.time, append=segment.time[-1]) for segment in problem]
    torques = [
        torque_shape(segment.time[:, None] + np.outer(step, [0.0, 0.5, 1.0]), segment)
        for segment, step in zip(problem, steps, strict=True)
    ]
    return Data(
        np.concatenate([segment.angle for segment in problem]),
        np.concatenate([segment.angular_velocity for segment in problem]),
        np.concatenate(steps),
        np.concatenate(torques),
        np.cumsum([0, *(step.size for step in steps)]),
        np.where(active, np.cumsum(active) - 1, -1),
    )


@compiled
def compiled_residuals(x, data):
    """`python_residuals`, compiled; angle and velocity alternate."""
    states = x[x.size - 2 * data.amplitude.size :]
    r = np.empty(2 * data.angle.size)
    for k in range(data.amplitude.size):
        p, w = states[2 * k], states[2 * k + 1]
        drive = x[3 + data.amplitude[k]] if data.amplitude[k] >= 0 else 0.0
        for i in range(data.first[k], data.first[k + 1]):
            r[2 * i] = (p - data.angle[i]) / ANGLE_NOISE
            r[2 * i + 1] = (w - data.velocity[i]) / VELOCITY_NOISE
            h, u = data.step[i], data.torque[i]
            a1 = drive * u[0] - x[0] * np.cos(p) - x[1] * p - x[2] * w
            p2, w2 = p + h / 2 * w, w + h / 2 * a1
            a2 = drive * u[1] - x[0] * np.cos(p2) - x[1] * p2 - x[2] * w2
            p3, w3 = p + h / 2 * w2, w + h / 2 * a2
            a3 = drive * u[1] - x[0] * np.cos(p3) - x[1] * p3 - x[2] * w3
            p4, w4 = p + h * w3, w + h * a3
            a4 = drive * u[2] - x[0] * np.cos(p4) - x[1] * p4 - x[2] * w4
            p += h / 6 * (w + 2 * w2 + 2 * w3 + w4)
            w += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    return r


@compiled
def reduced_residuals(x, data):
    """Residuals and Jacobian after a rotation: the same norm and the same steps in few rows.

    Each segment depends on the leg, its own amplitude and its own state only, so QR goes first
    over the samples of a segment (7 rows remain), then over the segments.
    """
    segments = data.amplitude.size
    local = x.size - 2 * segments
    columns = np.zeros((x.size + 1, 7 * segments))
    for k in range(segments):
        triangle = triangularise(sensitivities(k, x, data))
        rows = slice(7 * k, 7 * k + 7)
        columns[:3, rows] = triangle[:3]
        if data.amplitude[k] >= 0:
            columns[3 + data.amplitude[k], rows] = triangle[3]
        columns[local + 2 * k : local + 2 * k + 2, rows] = triangle[4:6]
        columns[-1, rows] = triangle[6]
    if segments > 1:
        columns = triangularise(columns)
    return columns[-1].copy(), columns[:-1].T.copy()


@compiled
def sensitivities(k, x, data):
    """Of segment k, over its samples: the derivatives by m l g / J, c / J, d / J, tau / J and the
    initial state (rows 0 to 5), and the residuals (row 6); angle and velocity alternate."""
    first, samples = data.first[k], data.first[k + 1] - data.first[k]
    state = x[x.size - 2 * (data.amplitude.size - k) :]
    drive = x[3 + data.amplitude[k]] if data.amplitude[k] >= 0 else 0.0
    p, w = state[0], state[1]
    out = np.empty((7, 2 * samples))
    dp, dw = np.zeros(6), np.zeros(6)
    dp[4], dw[5] = 1.0, 1.0
    forces, slopes = np.zeros((4, 6)), np.empty(4)
    for i in range(samples):
        for q in range(6):
            out[q, 2 * i] = dp[q] / ANGLE_NOISE
            out[q, 2 * i + 1] = dw[q] / VELOCITY_NOISE
        out[6, 2 * i] = (p - data.angle[first + i]) / ANGLE_NOISE
        out[6, 2 * i + 1] = (w - data.velocity[first + i]) / VELOCITY_NOISE
        h = data.step[first + i]
        p, w = step(p, w, h, drive, data.torque[first + i], x, forces, slopes)
        step_derivatives(dp, dw, h, x[2], forces, slopes)
    return out


@compiled
def step(p, w, h, drive, torque, x, forces, slopes):
    """One RK4 step; keeps each stage's partial derivatives of the angular acceleration."""
    p_rate, w_rate, p_sum, w_sum = 0.0, 0.0, 0.0, 0.0
    for stage in range(4):
        reach = 0.0 if stage == 0 else h if stage == 3 else h / 2
        weight = h / 6 if stage in (0, 3) else h / 3
        u = torque[(stage + 1) // 2]
        ps, ws, cosine = p + reach * p_rate, w + reach * w_rate, np.cos(p + reach * p_rate)
        p_rate, w_rate = ws, drive * u - x[0] * cosine - x[1] * ps - x[2] * ws
        p_sum, w_sum = p_sum + weight * p_rate, w_sum + weight * w_rate
        slopes[stage] = x[0] * np.sin(ps) - x[1]
        forces[stage, 0], forces[stage, 1] = -cosine, -ps
        forces[stage, 2], forces[stage, 3] = -ws, u
    return p + p_sum, w + w_sum


@compiled
def step_derivatives(dp, dw, h, damping, forces, slopes):
    """The derivative of `step`, for all parameters at once."""
    for q in range(6):
        p, w = dp[q], dw[q]
        a1 = slopes[0] * p - damping * w + forces[0, q]
        w2 = w + h / 2 * a1
        a2 = slopes[1] * (p + h / 2 * w) - damping * w2 + forces[1, q]
        w3 = w + h / 2 * a2
        a3 = slopes[2] * (p + h / 2 * w2) - damping * w3 + forces[2, q]
        w4 = w + h * a3
        a4 = slopes[3] * (p + h * w3) - damping * w4 + forces[3, q]
        dp[q] = p + h / 6 * (w + 2 * w2 + 2 * w3 + w4)
        dw[q] = w + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)


@compiled
def triangularise(columns):
    """R of a Householder QR of `columns.T`, as R.T; `columns` is overwritten."""
    n, samples = columns.shape
    lower = np.zeros((n, n))
    for j in range(n):
        v = columns[j]
        norm = 0.0
        for i in range(j, samples):
            norm += v[i] * v[i]
        pivot = -np.copysign(np.sqrt(norm), v[j])
        lower[j, j] = pivot
        v[j] -= pivot
        half = -pivot * v[j]
        for k in range(j + 1, n):
            column = columns[k]
            if half > 0:  # not a column of zeros, which is a drop's torque
                dot = 0.0
                for i in range(j, samples):
                    dot += v[i] * column[i]
                dot /= half
                for i in range(j, samples):
                    column[i] -= dot * v[i]
            lower[k, j] = column[j]
    return lower
