"""What the user should know of the gyro: that it is late, or was not used."""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.recordings.signal.both_sensors.apart_in_scale import apart_in_scale
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

MOST = 0.5  # of the squares by which gyro and encoder differ, that their delay must explain
# Of a delay, by which it differs from larger to smaller swings: no more than 0.1 of a gyro that is
# late, 0.3 and more of a thigh that rocks on as the leg's swing becomes smaller.
UNSTEADY = 0.25
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
    if (no_delay := of_rocking(movements)) is not None:
        return [f"{no_delay}. Errors are widened for it."]
    return [
        f"{lateness(late)}, which is most of how the two differ. Errors are widened for it; "
        f"{remedy(late)} estimates it, and 'exoid diagnose' asks whether it is that. Where the "
        "encoder shows the knee and the gyro the leg in space, a thigh that rocks looks alike."
    ]


def how_late(movements: Sequence[Movement]) -> str | None:
    """How late it is, and what estimates that; None where it is not."""
    late = late_gyro(movements)
    if late is None:
        return None
    return of_rocking(movements) or f"{lateness(late)}, and {remedy(late)} estimates that"


def of_rocking(movements: Sequence[Movement]) -> str | None:
    """That gyro and encoder lie apart in time as no delay does; None where one may."""
    larger, smaller = (late_by(each) for each in in_halves(movements))
    if abs(larger - smaller) <= UNSTEADY * max(abs(larger), abs(smaller)):
        return None
    return (
        f"the gyro seems {1000 * larger:.2g} ms late in the larger swings and "
        f"{1000 * smaller:.2g} ms in the smaller ones (below 0: early), as no delay is: as where "
        "the thigh moves under an encoder that shows the knee (strap it down, or put a gyro on "
        "it), or where play or soft tissue is between a sensor and the leg"
    )


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
    pairs = pairs_of(movements)
    if not pairs:
        return None
    slope, rate, _ = together = np.concatenate(pairs, axis=1)
    before, _ = left_of(rate, np.stack([slope, np.ones_like(slope)], axis=1))
    after, late = left_late(together)
    return late if after < (1 - MOST) * before else None


def in_halves(movements: Sequence[Movement]) -> tuple[np.ndarray, np.ndarray]:
    """`pair_of` all of them, of the larger and of the smaller swings; each tell half of a delay."""
    pairs = pairs_of(movements)
    told = [np.cumsum(change**2) for _, _, change in pairs]
    first = np.concatenate([each < each[-1] / 2 for each in told])
    together = np.concatenate(pairs, axis=1)
    return together[:, first], together[:, ~first]


def pairs_of(movements: Sequence[Movement]) -> list[np.ndarray]:
    """Of those with a raw gyro."""
    return [pair_of(each) for each in movements if each.gyro_noise and not each.filtered]


def late_by(pair: np.ndarray) -> float:
    """How late a gyro is by least squares [s]."""
    return left_late(pair)[1]


def left_late(pair: np.ndarray) -> tuple[float, float]:
    """The squares that scale, bias and a delay leave, and the delay [s]."""
    slope, rate, change = pair
    left, found = left_of(rate, np.stack([slope, np.ones_like(slope), -change], axis=1))
    return left, float(found[-1])


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
