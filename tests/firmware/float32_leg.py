"""The firmware's filter of a free movement once more, in NumPy float32: of many legs at a time.

Each operation is one of the firmware's, in its order; a mask says in which legs it takes place.
"""

import numpy as np
from float32_sine import ONE, ZERO, F, turned
from float32_step import H2, Stepped, step_of

from exoid.recordings.filter.learning import LEARNING, UNKNOWNS

CURVE = F(0.01**2 / 8)  # s^2, by which the mean of two ticks is off its middle
ANGLE, RATE, BIAS, SCALE, AGE, EVEN, UPWARD = range(7)
LEVEL = 7  # the first of the equation of motion
UNKNOWN = len(UNKNOWNS)
OWN, SIZE = SCALE, SCALE + UNKNOWN


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
        step = step_of(mean[ANGLE].copy(), mean[RATE].copy(), mean[OWN:])
        for mine, value in (
            (mean[ANGLE], step.angle),
            (mean[RATE], step.rate),
            (self.acceleration, step.acceleration),
            (self.jerk, step.jerk),
        ):
            np.copyto(mine, value, where=where)
        for k in range(BIAS, SIZE):
            first = step.f00 * upper[ANGLE, k] + step.f01 * upper[RATE, k]
            second = step.f10 * upper[ANGLE, k] + step.f11 * upper[RATE, k]
            if k >= LEVEL:
                push, change = self.weighed(step.shown, k), self.weighed(step.turning, k)
                first = first + H2 * push
                second = second + (step.f01 * push + H2 * change)
            np.copyto(upper[ANGLE, k], first, where=where)
            np.copyto(upper[RATE, k], second, where=where)
        self.roughen(where, step)

    def weighed(self, weights, column: int):
        total = ZERO
        for k, weight in enumerate(weights, start=LEVEL):
            if k <= column and weight is not None:
                total = total + (weight * self.belief.upper[k, column] if k < column else weight)
        return total

    def roughen(self, where, f: Stepped):
        rough, (d0, d1) = F(LEARNING.roughness), self.belief.variance[:BIAS]
        both = self.belief.upper[ANGLE, RATE]
        w01, w11 = f.f00 * both + f.f01, f.f10 * both + f.f11
        determinant = f.f00 * f.f11 - f.f01 * f.f10
        p00 = f.f00 * f.f00 * d0 + w01 * w01 * d1
        p11 = f.f10 * f.f10 * d0 + w11 * w11 * d1 + rough
        p01 = f.f00 * f.f10 * d0 + w01 * w11 * d1
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
