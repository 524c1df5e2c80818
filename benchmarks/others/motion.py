"""The motion: Runge-Kutta of order four in small steps, dry friction with its own events."""

from typing import NamedTuple

import numpy as np
from numba import njit
from scipy.interpolate import CubicHermiteSpline

from .leg import Physics

TICK = 2.5e-4  # s
REFLEX_RISE = 0.03  # s, in which the muscle follows


class Motion(NamedTuple):
    """Of one stretch, at every tick from its begin to its end."""

    time: np.ndarray  # s
    angle: np.ndarray  # rad
    rate: np.ndarray  # rad/s
    acceleration: np.ndarray  # rad/s^2
    hand: np.ndarray  # N m, what a hand does to the leg
    memory: tuple[float, float]  # at the end: stretch of the Maxwell spring, drive of the reflex

    def angle_at(self, time: np.ndarray) -> np.ndarray:
        return CubicHermiteSpline(self.time, self.angle, self.rate)(time)

    def rate_at(self, time: np.ndarray) -> np.ndarray:
        return CubicHermiteSpline(self.time, self.rate, self.acceleration)(time)


@njit(cache=True)
def pull(p, angle, rate, stretch, drive):
    """Every torque on the leg in N m but dry friction and a hand."""
    depth = p.stop_angle - angle
    stop = 0.0
    if depth > 0.0:
        stop = max(0.0, p.stop_stiffness * depth - p.stop_damping * rate)
    return (
        -p.weight * np.cos(angle + p.tilt)
        - p.stiffness * (angle - p.rest_angle)
        - p.damping * rate
        - p.drag * rate * abs(rate)
        - p.cubic * angle**3
        - p.maxwell_stiffness * stretch
        + p.reflex_gain * drive
        + stop
    )


@njit(cache=True)
def held(grip, y, hand):
    """What the hand does: support, and a spring and damper about where it is."""
    weight, support, target = hand
    return weight * (support + grip[0] * (target - y[0]) - grip[1] * y[1])


@njit(cache=True)
def slope(p, y, push, felt, sign):
    """d/dt of angle, rate, stretch and drive; `felt` is the rate that the reflex feels now."""
    net = pull(p, y[0], y[1], y[2], y[3]) + push - p.friction * sign
    drive = (max(0.0, -felt - p.reflex_threshold) - y[3]) / REFLEX_RISE
    return (y[1], net / p.inertia, y[1] - y[2] / p.maxwell_time, drive)


@njit(cache=True)
def along(y, k, h):
    return (y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2], y[3] + h * k[3])


@njit(cache=True)
def step(p, y, grip, hands, felt, sign, h):
    """One step of order four; hands and felt rates at its begin, middle and end."""
    a = slope(p, y, held(grip, y, hands[0]), felt[0], sign)
    z = along(y, a, h / 2)
    b = slope(p, z, held(grip, z, hands[1]), felt[1], sign)
    z = along(y, b, h / 2)
    c = slope(p, z, held(grip, z, hands[1]), felt[1], sign)
    z = along(y, c, h)
    d = slope(p, z, held(grip, z, hands[2]), felt[2], sign)
    mean = (
        (a[0] + 2 * b[0] + 2 * c[0] + d[0]) / 6,
        (a[1] + 2 * b[1] + 2 * c[1] + d[1]) / 6,
        (a[2] + 2 * b[2] + 2 * c[2] + d[2]) / 6,
        (a[3] + 2 * b[3] + 2 * c[3] + d[3]) / 6,
    )
    return along(y, mean, h)


@njit(cache=True)
def way(p, y, push):
    """The direction that dry friction opposes: 0 where it holds the leg."""
    if p.friction == 0.0:
        return 0.0
    if y[1] != 0.0:
        return np.sign(y[1])
    net = pull(p, y[0], 0.0, y[2], y[3]) + push
    return 0.0 if abs(net) <= p.friction else np.sign(net)


@njit(cache=True)
def rub(p, y, grip, hands, felt, h):
    """A step with dry friction: it is cut where the leg comes to a stop."""
    sign = way(p, y, held(grip, y, hands[0]))
    if sign == 0.0:  # held: only the memories go on
        drive = y[3] + h * (max(0.0, -felt[1] - p.reflex_threshold) - y[3]) / REFLEX_RISE
        return (y[0], 0.0, y[2] * np.exp(-h / p.maxwell_time), drive)
    after = step(p, y, grip, hands, felt, sign, h)
    if after[1] * sign >= 0.0:
        return after
    share = y[1] / (y[1] - after[1])
    stop = step(p, y, grip, hands, felt, sign, share * h)
    stop = (stop[0], 0.0, stop[2], stop[3])
    sign = way(p, stop, held(grip, stop, hands[2]))
    if sign == 0.0:
        return stop
    return step(p, stop, grip, hands, felt, sign, (1 - share) * h)


@njit(cache=True)
def march(p, start, grip, hands, past, h):
    """Angle, rate, acceleration and hand's torque at every tick, and the state at the end.

    `hands` has a row for every half tick; `past` the rates of the ticks before, the present last.
    """
    n = (hands.shape[0] - 1) // 2
    before = past.size - 1
    rates = np.empty(before + n + 1)
    rates[: before + 1] = past
    out = np.empty((4, n + 1))
    y = start
    for i in range(n + 1):
        row = (hands[2 * i, 0], hands[2 * i, 1], hands[2 * i, 2])
        push = held(grip, y, row)
        sign = way(p, y, push)
        stuck = p.friction > 0.0 and sign == 0.0
        out[0, i], out[1, i], out[3, i] = y[0], y[1], push
        out[2, i] = 0.0 if stuck else slope(p, y, push, 0.0, sign)[1]
        if i == n:
            break
        middle = (hands[2 * i + 1, 0], hands[2 * i + 1, 1], hands[2 * i + 1, 2])
        last = (hands[2 * i + 2, 0], hands[2 * i + 2, 1], hands[2 * i + 2, 2])
        at = before + i - p.reflex_delay / h
        felt = (recall(rates, at), recall(rates, at + 0.5), recall(rates, at + 1.0))
        if p.friction > 0.0:
            y = rub(p, y, grip, (row, middle, last), felt, h)
        else:
            y = step(p, y, grip, (row, middle, last), felt, 0.0, h)
        rates[before + i + 1] = y[1]
    return out, y, rates[n:]


@njit(cache=True)
def recall(rates, at):
    """Between two ticks; what was before all memory is rest."""
    low = int(np.floor(at))
    if low < 0:
        return 0.0
    return rates[low] + (at - low) * (rates[low + 1] - rates[low])


def swing_freely(physics: Physics, start: tuple[float, float], duration: float, tick: float):
    """The motion from an angle and a rate, without a hand and without memories."""
    ticks = int(np.ceil(duration / tick)) + 1
    y = (float(start[0]), float(start[1]), 0.0, 0.0)
    free, past = np.zeros((2 * ticks + 1, 3)), np.zeros(int(physics.reflex_delay / tick) + 3)
    out, end, _ = march(physics, y, (0.0, 0.0), free, past, tick)
    return Motion(tick * np.arange(ticks + 1), *out, (end[2], end[3]))


def static_torque(physics: Physics, angle: float) -> float:
    """What a hand must bring to hold the leg still, in N m; Maxwell's spring has relaxed."""
    return -float(pull(physics, angle, 0.0, 0.0, 0.0))
