"""The torque's command of the firmware once more, in NumPy float32: of many nodes at a time.

Each operation is one of the firmware's, in its order; a mask says in which nodes it takes place.
"""

from dataclasses import dataclass, fields

import numpy as np
from float32_node import GYRO_STEP, STEP
from float32_sine import ONE, ZERO, F, turned

from exoid.recordings.commissioning.torque_parameters import TorqueParameters

FINE_TURN = 65536
FINE_STEP = F(2 * np.pi / FINE_TURN)
NAMES = tuple(each.name for each in fields(TorqueParameters))
OFF, ARM, ENABLE = range(3)  # wishes
DISABLED, ARMED, ENABLED = range(3)  # permits
ANGLE_STALE, NO_PARAMETERS, NOT_FINITE = (1 << bit for bit in (8, 9, 10))
HOST_SILENT, SWITCHED_OFF = 1 << 11, 1 << 12
LONGEST_UNHEARD, SETTLING = 10, 50  # ticks
FADING, APART = F(0.98), F(0.1)


@dataclass(frozen=True, eq=False)
class Heard:
    """What each node measures at a tick, and what it hears of a host."""

    count: np.ndarray
    gyro: np.ndarray
    angle: np.ndarray
    velocity: np.ndarray
    bias: np.ndarray
    faults: np.ndarray
    hears: np.ndarray
    wish: np.ndarray
    number: np.ndarray
    limit: np.ndarray
    acceleration: np.ndarray


def way(velocity):
    slow = velocity * F(10)
    smooth = slow * (F(1.5) - F(0.5) * slow * slow)
    return np.where(slow >= ONE, ONE, np.where(slow <= -ONE, -ONE, smooth))


def wanted_torque(leg, angle, velocity, acceleration):
    """Not finite where there is no angle to go by."""
    reached = (angle > F(-8)) & (angle < F(8))
    weight = leg["gravity"] * turned(np.where(reached, angle, ZERO) + leg["thigh_angle"])[1]
    torque = leg["inertia"] * acceleration
    torque = torque + leg["gravity_share"] * weight
    torque = torque + leg["stiffness_share"] * (leg["stiffness"] * angle)
    torque = torque + leg["damping_share"] * (leg["damping"] * velocity)
    torque = torque + leg["friction_share"] * (leg["friction"] * way(velocity))
    return np.where(reached, torque, F(np.inf))


def limited(wanted, before, limit, step):
    torque = np.where(wanted > before + step, before + step, wanted)
    torque = np.where(torque < before - step, before - step, torque)
    torque = np.where(torque > limit, limit, torque)
    return np.where(torque < -limit, -limit, torque)


class TorqueNodes:
    """One leg in each node, by the names of its parameters."""

    def __init__(self, leg: dict[str, np.ndarray]):
        self.leg = leg
        size = leg["gravity"].size
        whole = {"unheard": LONGEST_UNHEARD, "number": -1, "wish": OFF, "arming": 0}
        whole |= {"permit": DISABLED, "cut_by": 0, "count": 0, "settled": 0}
        for name, value in whole.items():
            setattr(self, name, np.full(size, value))
        self.apart, self.torque, self.acceleration, self.allowed = np.zeros((4, size), F)

    def tick(self, now: Heard):
        """Torque, permit and doubts of each node."""
        self.hear(now)
        self.watch(now)
        with np.errstate(invalid="ignore", over="ignore"):
            wanted = wanted_torque(self.leg, now.angle, now.velocity, self.acceleration)
            trusted = (self.settled >= SETTLING) & (self.apart < APART) & (self.apart > -APART)
            doubts = now.faults | np.where(trusted, 0, ANGLE_STALE)
            doubts = doubts | np.where(wanted - wanted == ZERO, 0, NOT_FINITE)
            self.judge(doubts)
            limit = np.where(self.leg["limit"] < self.allowed, self.leg["limit"], self.allowed)
            given = limited(wanted, self.torque, limit, self.leg["rate_limit"] * STEP)
        self.torque = np.where(self.permit == ENABLED, given, ZERO)
        return self.torque, self.permit, self.cut_by

    def hear(self, now: Heard):
        self.wish[now.hears & (now.wish == OFF)] = OFF
        counts = now.hears & (now.number != self.number)
        self.number[counts] = now.number[counts]
        self.unheard[counts] = 0
        self.wish[counts] = now.wish[counts]
        self.arming[counts] = now.wish[counts] == ARM
        self.acceleration[counts] = now.acceleration[counts]
        armed = counts & (now.wish == ARM)
        self.allowed[armed] = now.limit[armed].astype(F) * F(0.25)

    def watch(self, now: Heard):
        sound, rate = now.faults == 0, now.gyro.astype(F) * GYRO_STEP - now.bias
        goes_on = sound & (self.settled > 0)
        counts = (now.count - self.count + FINE_TURN // 2) % FINE_TURN - FINE_TURN // 2
        moved = counts.astype(F) * FINE_STEP
        with np.errstate(invalid="ignore"):
            apart = np.where(goes_on, FADING * self.apart + (moved - rate * STEP), ZERO)
        self.apart = np.where(sound, apart, self.apart)
        self.settled = np.where(sound, np.minimum(self.settled + 1, SETTLING), 0)
        self.count = now.count

    def judge(self, doubts):
        self.unheard = np.minimum(self.unheard + 1, LONGEST_UNHEARD + 1)
        doubts = doubts | np.where(self.unheard > LONGEST_UNHEARD, HOST_SILENT, 0)
        doubts = doubts | np.where(self.wish == OFF, SWITCHED_OFF, 0)
        doubted, arming = doubts != 0, self.arming != 0
        told = doubted & (arming | (self.permit != DISABLED))
        enables = (self.wish == ENABLE) & (self.permit == ARMED)
        self.cut_by = np.where(told, doubts, np.where(~doubted & arming, 0, self.cut_by))
        cases = [doubted, arming, enables]
        self.permit = np.select(cases, [DISABLED, ARMED, ENABLED], self.permit)
        self.arming[:] = 0
