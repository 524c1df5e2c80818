"""How like a leg is to those that anatomy expects of its body: by J / (m l), which motion tells.

It is the length of the simple pendulum that swings as the leg does: g / (m l g / J).
"""

from math import hypot, log, sqrt

from exoid.physics.anatomy.expected import STRANGE, Expected, ExpectedLeg
from exoid.physics.gravity import GRAVITY


def pendulum_length(leg: ExpectedLeg) -> Expected:
    """J / (m l) [m]; how it scatters is unknown where values are weighed one by one."""
    length = leg.inertia.value / (leg.mass.value * leg.com_distance.value)
    scatter = None if leg.covariance is None else sqrt(leg.covariance[2][2]) * length
    return Expected(length, scatter)


def away(leg: ExpectedLeg, gravity: float, error: float = 0.0) -> float:
    """How much longer that of a leg with this m l g / J [1/s^2] is, in standard deviations of legs
    and of this `error`; negative where it is shorter, 0 where nothing is known of it.
    """
    usual = pendulum_length(leg)
    if usual.standard_deviation is None or gravity <= 0:
        return 0.0
    scatter = hypot(usual.standard_deviation / usual.value, error / gravity)
    return log(GRAVITY / gravity / usual.value) / scatter


def rate_of(leg: ExpectedLeg, gravity: float) -> Expected:
    """The sampling rate at which it is as expected, over the one that its times have: m l g / J
    [1/s^2] goes with the square.
    """
    usual = pendulum_length(leg)
    times = sqrt(GRAVITY / gravity / usual.value)
    return Expected(times, times * (usual.standard_deviation or 0.0) / usual.value / 2)


def off_rate(leg: ExpectedLeg, gravity: float, error: float = 0.0) -> float:
    """By which share of it the rate must be another to make it a leg of its body: too low where it
    is positive; 0 where more than one leg in a thousand are like it.
    """
    strange = abs(away(leg, gravity, error)) >= STRANGE
    return rate_of(leg, gravity).value - 1 if strange else 0.0
