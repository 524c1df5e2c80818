"""Encoder against gyro at a leg's pace: the clock of what moves more quickly is slowed down."""

from dataclasses import replace
from typing import TypeVar

import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.mismatch.sensors.agreement import Consistency, OwnValue, SensorError, Sure, SureError
from exoid.mismatch.sensors.consistency import consistency
from exoid.mismatch.sensors.sure import Measuring
from exoid.physics.parameter import declarations

POWERS = {"1": 0, "rad": 0, "rad/s": 1, "s": -1}  # of the slowed clock's seconds, by units


def compared_at_ease(seen: Observation, measuring: Measuring, slow: float) -> Consistency:
    """`consistency` of a recording whose every second is taken for `slow` of them."""
    found = consistency(
        replace(
            seen,
            time=seen.time * slow,
            angular_velocity=seen.angular_velocity / slow,
            velocity_weight=seen.velocity_weight * slow,
        ),
        measuring,
    )
    errors = [
        replace(
            scaled(each, slow ** POWERS[each.unit]),
            own=[scaled(one, 1 / slow) for one in each.own],
            by_size=[one / slow for one in each.by_size],
        )
        for each in found.errors
    ]
    references = [
        replace(
            each,
            angular_velocity=each.angular_velocity * slow,
            angular_acceleration=each.angular_acceleration * slow**2,
        )
        for each in found.references
    ]
    sure = Sure(tuple(hastened(each, slow) for each in found.sure.errors), found.sure.alike)
    return Consistency(errors, references, sure)


Told = TypeVar("Told", SensorError, OwnValue)


def scaled(each: Told, factor: float) -> Told:
    return replace(each, value=each.value * factor, standard_error=each.standard_error * factor)


def hastened(each: SureError, slow: float) -> SureError:
    """The error by the recording's own clock."""
    units = [declared.unit for _, declared in declarations(each.fault.term)]
    return replace(each, values=each.values * np.array([slow ** POWERS[one] for one in units]))
