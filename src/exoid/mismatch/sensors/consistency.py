"""Do encoder and gyro agree with each other? No leg model is needed to tell.

What only a sensor can have done is seen here first, so that no torque is ever blamed for it.
"""

from dataclasses import replace

import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.mismatch.sensors.agreement import DELAY, Consistency, SensorError
from exoid.mismatch.sensors.compare import Compared, Measured, compare, with_right_gyros
from exoid.mismatch.sensors.faults import USUAL, Fault
from exoid.mismatch.sensors.own_delays import own_delays, unsteady
from exoid.mismatch.sensors.smooth import Reference, smooth
from exoid.mismatch.sensors.strikes import beside, strikes
from exoid.mismatch.sensors.sure import Measuring, surely
from exoid.recordings.conventions.jumps import jumps

UNITS = dict(zip(USUAL, ("1", "rad/s", "s"), strict=True))
SHORTEST = 0.02  # of the usual step
CAUTION = 2.0  # times what is left, that a gyro is held to err beside the encoder


def consistency(seen: Observation, measuring: Measuring) -> Consistency:
    """Compare encoder and gyro over all segments; samples of weight 0 were not measured.

    What is sure is told by `measuring`: a `Yardstick`.
    """
    segments = [segment(seen, number) for number in range(seen.time.shape[0])]
    if not any(weights[:, 1].any() for _, _, weights in segments):
        return Consistency([], [smooth(*each) for each in segments])
    struck = [strikes(*each) | jumped(*each) for each in segments]
    usual = compare(segments, struck, USUAL)
    sure = surely(segments, struck, usual, measuring)
    others = tuple(one for one in sure.faults if one not in USUAL)
    found = compare(segments, struck, (*USUAL, *others)) if others else usual
    errors = [error_of(found, one) for one in USUAL]
    own = own_delays(segments, struck, np.asarray(seen.owner).tolist())
    errors = [
        replace(one, own=own, by_size=unsteady(segments, struck) if one.clear else [])
        if one.name == DELAY
        else one
        for one in errors
    ]
    return Consistency(errors, references(segments, found, errors), sure)


def jumped(time: np.ndarray, data: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """The steps in which the angle jumps, and those beside them."""
    seen, most = np.where(weights > 0, data, np.nan), float(weights[:, 0].max())
    found = jumps(time, seen[:, 0], seen[:, 1], 1 / most if most > 0 else np.inf)
    steps = np.isin(time[1:], [one.time for one in found])
    return beside(steps)


def error_of(found: Compared, one: Fault) -> SensorError:
    """One of the usual errors, as the joint estimate has it."""
    place = int(found.places((one,))[0])
    error = float(np.sqrt(found.covariance[place, place]))
    return SensorError(one.name, float(found.values[place]), error, UNITS[one])


def references(
    segments: list[Measured], found: Compared, errors: list[SensorError]
) -> list[Reference]:
    """The motion that the encoder shows and a gyro without its clear errors."""
    clear = {each.name for each in errors if each.clear}
    values = found.values.copy()
    values[found.places(tuple(one for one in USUAL if one.name not in clear))] = 0.0
    excess = float(np.sqrt(max(1.0, CAUTION * found.misfit)))  # of what remains between the sensors
    cleaned = with_right_gyros(segments, found.motions, found.faults, values)
    return [smooth(time, data, weights / [1.0, excess]) for time, data, weights in cleaned]


def segment(seen: Observation, number: int) -> Measured:
    """Time, data and weights of one segment, without the rows that fill up its shape."""
    each = (seen.angle_weight[number], seen.velocity_weight[number])
    weights = np.stack([np.asarray(one) for one in each], axis=1)
    count = int(np.flatnonzero(weights.any(axis=1))[-1]) + 1
    data = np.stack([seen.angle[number], seen.angular_velocity[number]], axis=1)
    return apart(np.asarray(seen.time[number])[:count]), data[:count], weights[:count]


def apart(time: np.ndarray) -> np.ndarray:
    """The times, none so near the one before that rounding would be larger than what a jerk does:
    those of a buffer that is emptied at once are microseconds apart.
    """
    least = SHORTEST * np.median(np.diff(time))
    if not (np.diff(time) < least).any():
        return time
    ramp = least * np.arange(time.size)
    return ramp + np.maximum.accumulate(time - ramp)
