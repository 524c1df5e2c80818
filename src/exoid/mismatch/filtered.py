"""A gyro or an encoder that comes late: by a while, or behind a filter, which also smooths.

To take one for the other leaves what magnets, clocks and torques then seem to explain.
"""

from dataclasses import replace
from functools import partial

import numpy as np

from exoid.fitting.data.observation import Observation
from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.screen.hypothesis import Optimum
from exoid.mismatch.screen.optimise import settle_free
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.sensors.agreement import Sure
from exoid.physics.sensing.butterworth_filter import ButterworthFilter
from exoid.physics.sensing.first_order_filter import FirstOrderFilter
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.sensing.sensor_skew import SensorSkew

FORMS = (SensorSkew, FirstOrderFilter, ButterworthFilter)  # in which one sensor comes late
LATE = 0.01  # s, below which a filter shows what a delay does
FORGETS = 6.0  # times it is late, after which a filter knows no more of what was before


def filtered(prepared: PreparedRecording, base: Optimum) -> tuple[PreparedRecording, Optimum]:
    """The same, a filter in every candidate where that leaves clearly less than a mere delay. What
    else the sensors surely seemed to do goes where a delay, or that filter, leaves less without it.
    """
    late = prepared.sensors.delay
    if abs(late) < LATE:
        return prepared, base
    seen = later(prepared.seen, FORGETS * abs(late))  # no more of what the filter shows of the hand
    own = replace(prepared, problem=replace(prepared.problem, observation=seen), common=())
    start = base.candidate.without(prepared.common)
    if GyroScale.replaces not in prepared.problem.owned:  # what every gyro has some of
        start = start.with_term(GyroScale, np.zeros(1))
    starts = [base.candidate, *(start.with_term(form, np.array([late])) for form in FORMS)]
    before, delayed, *others = side_by_side(partial(settle_free, own), starts)
    best = min(others, key=lambda one: one.square)
    if not yardstick(own, best).clear(delayed.square, best.square, 1):
        best = delayed
    as_before = best is delayed and {*prepared.common} <= {GyroScale, SensorSkew}
    if as_before or not best.square <= before.square:
        return prepared, base
    sensors = replace(own.sensors, sure=Sure())
    return replace(own, sensors=sensors, common=best.candidate.terms), best


def later(seen: Observation, seconds: float) -> Observation:
    """The same without what was measured in the first seconds of every segment."""
    time, weights = np.asarray(seen.time), (seen.angle_weight, seen.velocity_weight)
    measured = sum(np.asarray(each) for each in weights) > 0
    first = np.min(np.where(measured, time, np.inf), axis=1, keepdims=True)
    return seen.weighed(time >= first + seconds)
