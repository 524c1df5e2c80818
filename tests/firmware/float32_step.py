"""How the firmware moves a leg in two ticks, in NumPy float32: of many legs at a time."""

from typing import Any, NamedTuple

import numpy as np
from float32_sine import ONE, F, turned

from exoid.recordings.filter.learning import LEARNING

H1, H2, H3, H4 = (F(each) for each in (0.02, 0.02**2 / 2, 0.02**3 / 6, 0.02**4 / 24))  # s, s^2, ..
HALF = F(0.01)  # s of a step
LEVEL, UPRIGHT, STIFFNESS, TORQUE, DAMPING, FRICTION = range(4, 10)  # of UNKNOWNS


class Stepped(NamedTuple):
    """Motion after a step; how it follows from that before; and what the unknowns do."""

    angle: Any
    rate: Any
    acceleration: Any
    jerk: Any
    f00: Any
    f01: Any
    f10: Any
    f11: Any
    shown: list[Any]
    turning: list[Any]


def rubbed(rate, free, friction):
    """Mean way of dry friction in a step, and by how much it damps."""
    change = HALF * (free - np.where(rate < 0, -friction, friction))
    reach = np.maximum(np.abs(change), F(LEARNING.least_turn))
    middle = rate + change
    turns = np.abs(middle) < reach
    way = np.where(turns, middle / reach, np.where(middle > 0, ONE, -ONE))
    return way, np.where(turns, friction / reach, F(0))


def step_of(angle, rate, unknowns) -> Stepped:
    level, upright, stiffness, torque, damping, friction = unknowns[LEVEL : FRICTION + 1]
    sine, cosine = turned(angle)
    slope = level * sine - upright * cosine - stiffness
    bend = level * cosine + upright * sine
    free = torque - bend - stiffness * angle - damping * rate
    way, more = rubbed(rate, free, friction)
    a, drag = free - friction * way, damping + more
    jerk = slope * rate - damping * a
    snap = bend * rate * rate + slope * a - damping * jerk
    crackle = F(3) * bend * rate * a - (slope + stiffness) * rate * rate * rate
    crackle = crackle + slope * jerk - damping * snap
    return Stepped(
        angle + H1 * rate + H2 * a + H3 * jerk + H4 * snap,
        rate + H1 * a + H2 * jerk + H3 * snap + H4 * crackle,
        a + H1 * jerk,
        jerk + H1 * snap,
        ONE + H2 * slope,
        H1 - H2 * drag + H3 * slope,
        H1 * slope + H2 * (bend * rate - drag * slope),
        ONE - H1 * drag + H2 * (slope + drag * drag),
        [-cosine, -sine, -angle, np.full_like(rate, ONE), -rate, -way],
        [sine * rate, -cosine * rate, -rate, None, -a, None],
    )
