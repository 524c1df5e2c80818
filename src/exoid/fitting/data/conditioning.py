"""Which chain of conditioning the data went through, so that the simulation goes through it too."""

import numpy as np

from exoid.fitting.data.conditioning_chain import Chain, MovingAverage, Raw, SteadyKalman
from exoid.fitting.data.movement import Movement, weightless, with_channels
from exoid.fitting.data.pace import LONGEST_STEP
from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.condition import moving_average

SETTLING_SAMPLES = 25  # in which the firmware's filter forgets how it was started
LONGEST_WINDOW = 0.5  # s, of the moving average: a leg swings to its other side in as much
ROUNDING = 1 + 1e-6  # of a step, as where gaps are bridged
EVEN = 0.05  # relative scatter of the steps up to which sampling counts as even


def conditioned(movements: list[Movement], smooth: int) -> tuple[Chain, list[Movement]]:
    """The chain that the simulation must pass, and the movements with it applied to their data.

    Raw channels need none. Channels that only the firmware's filter gave are met by a simulation
    that passes the same filter. A moving average (Eq. 3) is asked for by `smooth` > 1.

    **Raises** `ValueError` where a chain cannot be applied to the simulation as it was to the data.
    """
    filtered = [each.filtered for each in movements]
    if smooth > 1:
        if any(filtered):
            raise ValueError("the moving average needs raw channels: raw_angle_rad is missing.")
        return MovingAverage(smooth), [averaged(each, smooth) for each in movements]
    if not all(filtered) or any(each.angular_velocity is None for each in movements):
        return Raw(), movements
    chain = SteadyKalman(round(common_step(movements), 6), common_filter(movements))
    return chain, [settled(each) for each in movements]


def common_filter(movements: list[Movement]) -> str:
    """Which of the node's filters all movements went through."""
    filters = sorted({each.filter for each in movements})
    if len(filters) > 1:
        raise ValueError(
            f"filtered channels went through filters of {' and of '.join(filters)}, but one is "
            "simulated for all. Record the raw channels, or fit them apart."
        )
    return filters[0]


def common_step(movements: list[Movement]) -> float:
    """What the filter takes for its step [s] in all movements: it is one for all.

    A node's filter reckons with its own clock, and times may have been corrected since.
    """
    steps = [filter_step(each) for each in movements]
    if max(steps) - min(steps) > EVEN * min(steps):
        raise ValueError(
            f"filtered channels were sampled every {min(steps):.3g} s and every {max(steps):.3g} "
            "s, but one filter is simulated for all. Record the raw channels, or fit them apart."
        )
    return float(np.median(steps))


def filter_step(movement: Movement) -> float:
    """What its filter took for the time between two samples [s]."""
    step = even_step(movement)
    return step if movement.filter_step is None else movement.filter_step


def even_step(movement: Movement) -> float:
    """The one sample time [s] of a movement."""
    steps = np.diff(movement.segment.time)
    step = float(np.median(steps))
    if np.abs(steps - step).max() > EVEN * step or steps.max() > LONGEST_STEP * ROUNDING:
        raise ValueError(
            f"segment {movement.name} is not sampled evenly at {1 / LONGEST_STEP:g} Hz or more, so "
            "its filter cannot be applied to the simulation. Fit the raw channels unsmoothed, or "
            "cut the segment at its gaps."
        )
    return step


def averaged(movement: Movement, window: int) -> Movement:
    """Eq. 3 on the fitted channels, each mean stamped with the last sample of its window."""
    most = round(LONGEST_WINDOW / even_step(movement))
    if window > most:
        raise ValueError(
            f"segment {movement.name}: a moving average over {window} samples is longer than "
            f"{LONGEST_WINDOW:g} s and would leave no swing to fit. Choose at most {most}."
        )

    def mean(samples: Samples) -> Samples:
        return np.concatenate([np.full(window - 1, np.nan), moving_average(samples, window)])

    return with_channels(movement, mean)


def settled(movement: Movement) -> Movement:
    """Leave out the first free samples, in which the simulated filter has yet to settle."""
    first = int(np.argmax(~np.isnan(movement.angle)))
    count = first + min(SETTLING_SAMPLES, (movement.angle.size - first) // 4)
    return weightless(movement, np.arange(movement.angle.size) < count)
