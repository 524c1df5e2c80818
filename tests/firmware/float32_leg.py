"""The firmware's filter of a free movement once more, in NumPy float32: of many legs at a time.

Each operation is one of the firmware's, in its order; a mask says in which legs it takes place.
"""

from dataclasses import dataclass

import numpy as np
from float32_sine import ONE, ZERO, F, turned

from exoid.recordings.filter.learning import LEARNING, UNKNOWNS

H1, H2, H3 = (F(each) for each in (0.01, 0.01**2 / 2, 0.01**3 / 6))  # s, s^2, s^3
ANGLE, RATE, BIAS, SCALE, LEVEL, UPRIGHT, STIFFNESS, TORQUE, DAMPING = range(9)
OWN, SIZE = SCALE, DAMPING + 1
UNKNOWN = len(UNKNOWNS)
ALWAYS = F(1e30)


class Factored:
    """Means, D and U of U D U', by unknown and leg."""

    def __init__(self, size: int, legs: int):
        self.mean, self.variance = np.zeros((size, legs), F), np.zeros((size, legs), F)
        self.upper = np.zeros((size, size, legs), F)

    def put(self, where, other: "Factored"):
        for mine, given in zip(vars(self).values(), vars(other).values(), strict=True):
            np.copyto(mine, given, where=where)

    def covariance(self, row: int, column: int):
        total = ZERO
        for k in range(max(row, column), len(self.mean)):
            part = self.variance[k]
            part = part * self.upper[row, k] if k != row else part
            part = part * self.upper[column, k] if k != column else part
            total = total + part
        return total


@dataclass
class Measured:
    """Off by `innovation`, of the variance `noise`, believed up to a chi-square of `gate`."""

    innovation: np.ndarray
    noise: np.ndarray
    gate: np.float32


def correct(belief: Factored, where, slope, measured: Measured):
    """Which legs used a measurement; its innovation over the variance; its chi-square."""
    innovation, noise, gate = measured.innovation, measured.noise, measured.gate
    gain, total, sum_ = [], [], noise
    for k, each in enumerate(slope):
        gain.append(each * belief.variance[k])
        sum_ = sum_ + each * gain[k]
        total.append(sum_)
    used = where & ~(innovation * innovation > gate * sum_)
    inverse = ONE / total[0]
    first = belief.variance[0] * noise * inverse
    np.copyto(belief.variance[0], first, where=used & (slope[0] != 0))
    for k in range(1, len(slope)):
        own, pull = gain[k], -slope[k] * inverse
        inverse = ONE / total[k]
        narrowed = belief.variance[k] * total[k - 1] * inverse
        np.copyto(belief.variance[k], narrowed, where=used)
        for row in range(k):
            old = belief.upper[row, k].copy()
            np.copyto(belief.upper[row, k], old + pull * gain[row], where=used)
            gain[row] = gain[row] + own * old
    weighed = innovation * inverse
    for k in range(len(slope)):
        np.copyto(belief.mean[k], belief.mean[k] + gain[k] * weighed, where=used)
    return used, weighed, innovation * weighed


class LegFilter:
    """One free movement of each leg."""

    def __init__(self, legs: int):
        self.belief = Factored(SIZE, legs)
        self.acceleration = np.zeros(legs, F)

    def open(self, where, leg: Factored, angle, rate):
        new = Factored(SIZE, angle.size)
        new.mean[:OWN] = angle - F(LEARNING.late) * rate, rate, np.zeros_like(rate)
        new.variance[ANGLE] = F(LEARNING.angle_variance)
        new.variance[RATE] = F(LEARNING.first_rate) * F(LEARNING.first_rate)
        new.variance[BIAS] = F(LEARNING.bias) * F(LEARNING.bias)
        new.mean[OWN:] = leg.mean
        new.variance[OWN:] = leg.variance * F(LEARNING.fading)
        new.upper[OWN:, OWN:] = leg.upper
        self.belief.put(where, new)
        np.copyto(self.acceleration, ZERO, where=where)
        self.see_rate(where, rate, ALWAYS)

    def predict(self, where):
        mean, upper = self.belief.mean, self.belief.upper
        sine, cosine = turned(mean[ANGLE])
        angle, rate, level, upright = mean[ANGLE].copy(), mean[RATE], mean[LEVEL], mean[UPRIGHT]
        damping = mean[DAMPING]
        slope = level * sine - upright * cosine - mean[STIFFNESS]
        bend = level * cosine + upright * sine
        a = mean[TORQUE] - bend - mean[STIFFNESS] * angle - damping * rate
        jerk = slope * rate - damping * a
        snap = bend * rate * rate + slope * a - damping * jerk
        f00, f01 = ONE + H2 * slope, H1 - H2 * damping
        f10 = H1 * slope + H2 * (bend * rate - damping * slope)
        f11 = ONE - H1 * damping + H2 * (slope + damping * damping)
        shown = [-cosine, -sine, -angle, np.full_like(rate, ONE), -rate]
        turning = [sine * rate, -cosine * rate, -rate, None, -a]
        new_angle = angle + H1 * rate + H2 * a + H3 * jerk
        new_rate = rate + H1 * a + H2 * jerk + H3 * snap
        np.copyto(mean[ANGLE], new_angle, where=where)
        np.copyto(mean[RATE], new_rate, where=where)
        np.copyto(self.acceleration, a + H1 * jerk, where=where)
        for k in range(BIAS, SIZE):
            first = f00 * upper[ANGLE, k] + f01 * upper[RATE, k]
            second = f10 * upper[ANGLE, k] + f11 * upper[RATE, k]
            if k >= LEVEL:
                push, change = self.weighed(shown, k), self.weighed(turning, k)
                first = first + H2 * push
                second = second + (f01 * push + H2 * change)
            np.copyto(upper[ANGLE, k], first, where=where)
            np.copyto(upper[RATE, k], second, where=where)
        self.roughen(where, f00, f01, f10, f11)

    def weighed(self, weights, column: int):
        total = ZERO
        for k, weight in enumerate(weights, start=LEVEL):
            if k <= column and weight is not None:
                total = total + (weight * self.belief.upper[k, column] if k < column else weight)
        return total

    def roughen(self, where, f00, f01, f10, f11):
        rough, (d0, d1) = F(LEARNING.roughness), self.belief.variance[:BIAS]
        both = self.belief.upper[ANGLE, RATE]
        w01, w11 = f00 * both + f01, f10 * both + f11
        determinant = f00 * f11 - f01 * f10
        p00 = f00 * f00 * d0 + w01 * w01 * d1
        p11 = f10 * f10 * d0 + w11 * w11 * d1 + rough
        p01 = f00 * f10 * d0 + w01 * w11 * d1
        inverse = ONE / p11
        narrow = (determinant * determinant * d0 * d1 + rough * p00) * inverse
        for at, value in ((d0, narrow), (d1, p11), (both, p01 * inverse)):
            np.copyto(at, value, where=where)

    def see_angle(self, where, angle):
        mean, upper = self.belief.mean, self.belief.upper
        late, noise = F(LEARNING.late), np.full_like(angle, F(LEARNING.angle_variance))
        slope = [np.full_like(angle, ONE), upper[ANGLE, RATE] + late]
        slope += [upper[ANGLE, k] + late * upper[RATE, k] for k in range(BIAS, SIZE)]
        expected = mean[ANGLE] + late * mean[RATE]
        measured = Measured(angle - expected, noise, F(LEARNING.gate))
        return correct(self.belief, where, slope, measured)

    def see_rate(self, where, measured, gate=F(LEARNING.gate)):  # noqa: B008
        mean, upper = self.belief.mean, self.belief.upper
        gain, rate = ONE + mean[SCALE], mean[RATE].copy()
        slope = [np.zeros_like(rate), gain, gain * upper[RATE, BIAS] + ONE]
        slope += [gain * upper[RATE, SCALE] + upper[BIAS, SCALE] + rate]
        slope += [
            gain * upper[RATE, k] + upper[BIAS, k] + rate * upper[SCALE, k]
            for k in range(LEVEL, SIZE)
        ]
        wander = F(LEARNING.wander_variance) * self.acceleration * self.acceleration
        expected = gain * rate + mean[BIAS]
        noise = F(LEARNING.rate_variance) + wander
        return correct(self.belief, where, slope, Measured(measured - expected, noise, gate))

    @property
    def leg(self) -> Factored:
        """What is believed of the leg, which later ticks move."""
        found = Factored(UNKNOWN, self.acceleration.size)
        found.mean, found.variance = self.belief.mean[OWN:], self.belief.variance[OWN:]
        found.upper = self.belief.upper[OWN:, OWN:]
        return found
