"""What the user should know of the gyro: that it is late, or was not used."""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.recordings.signal.both_sensors.apart_in_scale import apart_in_scale
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

MOST = 0.5  # of the squares by which gyro and encoder differ, that their delay must explain
FILTERED = 0.01  # s, from where on a filter, which delays and smooths, shows another motion


def of_unused_gyro(movements: Sequence[Movement]) -> list[str]:
    """That a gyro stands beside an angle that went through a filter, which it did not."""
    unused = [
        each.name
        for each in movements
        if each.filtered
        and each.angular_velocity is None
        and each.segment.raw_angular_velocity is not None
    ]
    if not unused:
        return []
    return [
        f"the gyro of segment {', '.join(unused)} is not used: it is raw, and the angle beside it "
        "(angle_rad) is said to have gone through the node's filter. If it did not, call that "
        "column raw_angle_rad."
    ]


def of_late_gyro(movements: Sequence[Movement]) -> list[str]:
    """That it shows the leg at another time than the encoder, and what to do."""
    late = late_gyro(movements)
    if late is None:
        return []
    return [
        f"{lateness(late)}, which is most of how the two differ. Errors are widened for it; "
        f"{remedy(late)} estimates it, and 'exoid diagnose' asks whether it is that."
    ]


def lateness(late: float) -> str:
    """That a gyro is so late [s], in words."""
    when = "later" if late > 0 else "earlier"
    return f"the gyro shows the leg about {1000 * abs(late):.2g} ms {when} than the encoder"


def remedy(late: float) -> str:
    """The command that estimates by how much a gyro is so late."""
    if abs(late) < FILTERED:
        return "'exoid fit --with sensor_skew'"
    return (
        "'exoid fit --with butterworth_filter' (or first_order_filter, or for a mere delay "
        "sensor_skew)"
    )


def late_gyro(movements: Sequence[Movement]) -> float | None:
    """How much later [s] than the encoder a gyro shows the leg; None where that is not most of how
    the two differ beside the gyro's scale and bias, or where no raw gyro is there.

    A rate shown t_s late is v - t_s v' to first order, v the slope of the angle.
    """
    pairs = [pair_of(each) for each in movements if each.gyro_noise and not each.filtered]
    if not pairs:
        return None
    slope, rate, change = np.concatenate(pairs, axis=1)
    alike = np.stack([slope, np.ones_like(slope)], axis=1)
    before, _ = left_of(rate, alike)
    after, found = left_of(rate, np.column_stack([alike, -change]))
    return float(found[-1]) if after < (1 - MOST) * before else None


def left_of(rate: np.ndarray, columns: np.ndarray) -> tuple[float, np.ndarray]:
    """The sum of squares that least squares leave, and what they found."""
    found = np.linalg.lstsq(columns, rate, rcond=None)[0]
    return float(np.square(rate - columns @ found).sum()), found


def pair_of(each: Movement) -> np.ndarray:
    """The angle's slope, the gyro's rate and how that changes, smoothed alike, where both were
    measured.
    """
    assert each.angular_velocity is not None  # it has a gyro's noise
    time = each.segment.time
    slope = local_line(time, each.angle, SMOOTHING)[1]
    rate, change = local_line(time, each.angular_velocity, SMOOTHING)
    seen = ~np.isnan(each.angle) & ~np.isnan(each.angular_velocity)
    return np.stack([slope, rate, change])[:, seen]


def scale_of(movements: Sequence[Movement]) -> float | None:
    """By how much a raw gyro shows more than the encoder's slope; None where it is not a scale by
    which most of the movements differ.
    """
    raw = [each for each in movements if not each.filtered]
    found = [apart_in_scale(each.segment.time, each.angle, each.angular_velocity) for each in raw]
    told = [each for each in found if each is not None]
    return float(np.median(told)) if told and 2 * len(told) > len(raw) else None
