"""The firmware's filter of a free movement once more, in NumPy float32: of many legs at a time.

Each operation is one of the firmware's, in its order; a mask says in which legs it takes place.
"""

import numpy as np
from float32_sine import ONE, ZERO, F, turned

from exoid.recordings.filter.learning import LEARNING, UNKNOWNS

H1, H2, H3, H4 = (F(each) for each in (0.02, 0.02**2 / 2, 0.02**3 / 6, 0.02**4 / 24))  # s, s^2, ..
HALF, CURVE = F(0.01), F(0.01**2 / 8)  # s of a look; s^2, of its mean about its middle
ANGLE, RATE, BIAS, SCALE, AGE, EVEN, UPWARD = range(7)
LEVEL, UPRIGHT, STIFFNESS, TORQUE, DAMPING, FRICTION = range(7, 13)
OWN, SIZE = SCALE, FRICTION + 1
UNKNOWN = len(UNKNOWNS)


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


def correct(belief: Factored, where, slope, innovation, noise):
    """Which legs used a measurement; its innovation over the variance; its chi-square."""
    gain, total = [each * belief.variance[k] for k, each in enumerate(slope)], []
    seen = ZERO
    for k, each in enumerate(slope):
        seen = seen + each * gain[k]
    noise = noise + F(LEARNING.doubt) * seen
    sum_ = noise
    for k, each in enumerate(slope):
        sum_ = sum_ + each * gain[k]
        total.append(sum_)
    used = where & ~(innovation * innovation > F(LEARNING.gate) * sum_)
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
        self.acceleration, self.jerk = np.zeros(legs, F), np.zeros(legs, F)

    def open(self, where, leg: Factored, angle, shown):
        new, own = Factored(SIZE, angle.size), leg.mean
        sine, cosine = turned(angle)
        rate, age = shown / (ONE + own[SCALE - OWN]), own[AGE - OWN]
        error = own[EVEN - OWN] * cosine + own[UPWARD - OWN] * sine
        new.mean[:OWN] = angle - age * rate - error, rate, np.zeros_like(rate)
        new.variance[ANGLE] = F(LEARNING.angle_variance)
        new.variance[RATE] = F(LEARNING.rate_variance)
        new.variance[BIAS] = F(LEARNING.bias) * F(LEARNING.bias)
        new.mean[OWN:] = leg.mean
        new.variance[OWN:] = leg.variance * F(LEARNING.fading)
        upper = new.upper
        upper[OWN:, OWN:] = leg.upper
        upper[ANGLE, RATE] = -age
        for k in range(BIAS, SIZE):
            upper[RATE, k] = -ONE if k == BIAS else -rate * self.column(upper, SCALE, k)
            error = rate * self.column(upper, AGE, k) + cosine * self.column(upper, EVEN, k)
            upper[ANGLE, k] = -age * upper[RATE, k] - (error + sine * self.column(upper, UPWARD, k))
        self.belief.put(where, new)
        for each in (self.acceleration, self.jerk):
            np.copyto(each, ZERO, where=where)

    @staticmethod
    def column(upper, row: int, column: int):
        return upper[row, column] if row < column else F(row == column)

    def predict(self, where):
        mean, upper = self.belief.mean, self.belief.upper
        sine, cosine = turned(mean[ANGLE])
        angle, rate, level, upright = mean[ANGLE].copy(), mean[RATE], mean[LEVEL], mean[UPRIGHT]
        damping, friction = mean[DAMPING], mean[FRICTION]
        slope = level * sine - upright * cosine - mean[STIFFNESS]
        bend = level * cosine + upright * sine
        free = mean[TORQUE] - bend - mean[STIFFNESS] * angle - damping * rate
        change = HALF * (free - np.where(rate < 0, -friction, friction))
        middle, reach = rate + change, np.maximum(np.abs(change), F(LEARNING.least_turn))
        way, turns = middle / reach, np.abs(middle) < reach
        way = np.where(turns, way, np.where(middle > 0, ONE, -ONE))
        drag = np.where(turns, damping + friction / reach, damping)
        a = free - friction * way
        jerk = slope * rate - damping * a
        snap = bend * rate * rate + slope * a - damping * jerk
        f00, f01 = ONE + H2 * slope, H1 - H2 * drag + H3 * slope
        f10 = H1 * slope + H2 * (bend * rate - drag * slope)
        f11 = ONE - H1 * drag + H2 * (slope + drag * drag)
        shown = [-cosine, -sine, -angle, np.full_like(rate, ONE), -rate, -way]
        turning = [sine * rate, -cosine * rate, -rate, None, -a, None]
        new_angle = angle + H1 * rate + H2 * a + H3 * jerk + H4 * snap
        crackle = F(3) * bend * rate * a - (slope + mean[STIFFNESS]) * rate * rate * rate
        crackle = crackle + slope * jerk - damping * snap
        new_rate = rate + H1 * a + H2 * jerk + H3 * snap + H4 * crackle
        for mine, value in (
            (mean[ANGLE], new_angle),
            (mean[RATE], new_rate),
            (self.acceleration, a + H1 * jerk),
            (self.jerk, jerk + H1 * snap),
        ):
            np.copyto(mine, value, where=where)
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
        rate, age, noise = mean[RATE].copy(), mean[AGE].copy(), F(LEARNING.angle_variance)
        sine, cosine = turned(mean[ANGLE])
        slope = [np.full_like(angle, ONE), upper[ANGLE, RATE] + age]
        slope += [upper[ANGLE, k] + age * upper[RATE, k] for k in range(BIAS, SIZE)]
        for row, weight in ((AGE, rate), (EVEN, cosine), (UPWARD, sine)):
            slope[row] = slope[row] + weight
            for k in range(row + 1, SIZE):
                slope[k] = slope[k] + weight * upper[row, k]
        error = mean[EVEN] * cosine + mean[UPWARD] * sine
        expected = mean[ANGLE] + age * rate + error + CURVE * self.acceleration
        return correct(self.belief, where, slope, angle - expected, np.full_like(angle, noise))

    def see_rate(self, where, measured):
        mean, upper = self.belief.mean, self.belief.upper
        gain, rate = ONE + mean[SCALE], mean[RATE].copy()
        slope = [np.zeros_like(rate), gain, gain * upper[RATE, BIAS] + ONE]
        slope += [gain * upper[RATE, SCALE] + upper[BIAS, SCALE] + rate]
        slope += [
            gain * upper[RATE, k] + upper[BIAS, k] + rate * upper[SCALE, k]
            for k in range(SCALE + 1, SIZE)
        ]
        wander = F(LEARNING.wander_variance) * self.acceleration * self.acceleration
        expected = gain * (rate + CURVE * self.jerk) + mean[BIAS]
        noise = F(LEARNING.rate_variance) + wander
        return correct(self.belief, where, slope, measured - expected, noise)

    @property
    def leg(self) -> Factored:
        """What is believed of the leg, which later ticks move."""
        found = Factored(UNKNOWN, self.acceleration.size)
        found.mean, found.variance = self.belief.mean[OWN:], self.belief.variance[OWN:]
        found.upper = self.belief.upper[OWN:, OWN:]
        return found
