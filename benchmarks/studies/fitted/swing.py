"""Legs that are let go, all at once: a pendulum by Runge-Kutta of order four in NumPy."""

from dataclasses import dataclass

import numpy as np

STEP = 0.0025  # s


@dataclass(frozen=True, eq=False)
class Ratios:
    """Of every drop, over J: m l g, stiffness and dry friction [1/s^2], damping [1/s]."""

    gravity: np.ndarray
    stiffness: np.ndarray
    damping: np.ndarray
    friction: np.ndarray


def swing(of: Ratios, start: np.ndarray, steps: int) -> tuple[np.ndarray, np.ndarray]:
    """Angle [rad] and angular velocity [rad/s] from the release on, (drop, step).

    phi'' = -m l g / J cos(phi) - c / J phi - d / J phi' - f / J sign(phi')

    Where a leg turns within a step, that is parted in two; where friction holds it there, it stays.
    """
    state = np.stack([start, np.zeros_like(start)])
    way, free = np.sign(pull(of, state)), np.ones(start.size)
    states = [state]
    for _ in range(steps):
        after = advance(of, state, way, STEP * free)
        turns = way * after[1] < 0
        if turns.any():
            share = np.where(turns, state[1] / np.where(turns, state[1] - after[1], 1.0), 1.0)
            at = advance(of, state, way, STEP * free * share)
            held = turns & (np.abs(pull(of, at)) <= of.friction)
            at[1, held] = 0.0
            free = np.where(held, 0.0, free)
            way = np.where(turns, np.sign(pull(of, at)), way)
            after = advance(of, at, way, STEP * free * (1.0 - share))
        state = after
        states.append(state)
    angle, rate = np.stack(states, axis=2)
    return angle, rate


def pull(of: Ratios, state: np.ndarray) -> np.ndarray:
    """What moves a leg that rests, over J [1/s^2]."""
    return -of.gravity * np.cos(state[0]) - of.stiffness * state[0]


def advance(of: Ratios, state: np.ndarray, way: np.ndarray, by: np.ndarray) -> np.ndarray:
    """The state `by` seconds later, while every leg goes its `way`."""

    def slope(each: np.ndarray) -> np.ndarray:
        resisted = of.damping * each[1] + of.friction * way
        return np.stack([each[1], pull(of, each) - resisted])

    first = slope(state)
    second = slope(state + by / 2 * first)
    third = slope(state + by / 2 * second)
    fourth = slope(state + by * third)
    return state + by / 6 * (first + 2 * second + 2 * third + fourth)
