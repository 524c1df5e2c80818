"""Drops in which a muscle pulls for a moment, as in a reflex to stretch, by SciPy."""

import numpy as np
from scipy.integrate import solve_ivp

from exoid.recordings.measured.segment import Segment
from hands import Knee

CHILD, ADULT = Knee(40.0, 12.0, 1.55), Knee(27.5, 6.0, 1.1)
START, LASTING = np.radians(-15.0), 5.0
BURST = (0.1, 0.3)  # s after the release when a muscle begins to pull, and for how long


def swung(knee, begin, angle, rate, strength):
    """Angle and rate at every millisecond; the muscle's torque over the inertia is at most
    `strength` times gravity's.
    """
    since, lasting = BURST

    def slope(t, y):
        x = (t - since) / lasting
        pulled = strength * knee.gravity * np.sin(np.pi * x) ** 2 if 0 < x < 1 else 0.0
        return y[1], knee.pull(*y) + pulled

    time = np.arange(begin, LASTING, 1e-3)
    found = solve_ivp(slope, (begin, LASTING), (angle, rate), t_eval=time, rtol=1e-9, max_step=0.01)
    return found.y


def measured(angle, hertz, seed=0, noise=0.15):
    """What a goniometer of so much noise [deg] sees of a leg that was held for a second before."""
    angle = np.concatenate([np.full(1000, angle[0]), angle])
    time = np.arange(0.0, angle.size * 1e-3 - 1e-3, 1 / hertz)
    noise = np.random.default_rng(seed).normal(0, np.radians(noise), time.size)
    return Segment(time, raw_angle=np.interp(time, 1e-3 * np.arange(angle.size), angle) + noise)


def thrown(knee, strength, hertz):
    return measured(swung(knee, 0.0, START, 0.0, strength)[0], hertz)


STEP = 2e-4  # s


def stretched(knee, start, gain, threshold, delay, rise=0.0, lasting=LASTING, slack=0.0):
    """Angle at every millisecond of a leg whose muscle pulls by `gain` [1/s] times how much faster
    than `threshold` [rad/s] it was stretched `delay` s ago, behind two lags of `rise` s; its spring
    is `slack` there [rad].
    """
    every, late = round(1e-3 / STEP), round(delay / STEP)
    share = STEP / max(rise, STEP)
    angle, rate, rates, seen = start, 0.0, np.zeros(round(lasting / STEP)), []
    active = pulled = 0.0
    for number in range(rates.size):
        rates[number] = rate
        before = rates[number - late] if number >= late else 0.0
        active += share * (gain * max(0.0, -before - threshold) - active)
        pulled += share * (active - pulled)
        rate += STEP * (knee.pull(angle, rate) + knee.stiffness * slack + pulled)
        angle += STEP * rate
        if number % every == 0:
            seen.append(angle)
    return np.array(seen)
