"""What the user should know of the gyro: that it is late, or was not used."""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.physics.leg import GRAVITY
from exoid.recordings.signal.both_sensors.apart_in_scale import apart_in_scale
from exoid.recordings.signal.condition import SMOOTHING
from exoid.recordings.signal.local_line import local_line

MOST = 0.5  # of the squares by which gyro and encoder differ, that their delay must explain
# Of a delay, by which it differs from larger to smaller swings: no more than 0.1 of a gyro that is
# late, 0.3 and more of a thigh that rocks on as the leg's swing becomes smaller.
UNSTEADY = 0.25
REACHES = np.arange(0.05, 0.5, 0.1)  # m, from the knee to an accelerometer
# Of the squares that a delay leaves, what an angle does that is fused: of such angles 0.36 to 1.17,
# of gyros that are late, or filtered, 1.0 and more, of thighs that move under the encoder 0.94.
CLEARLY, HARDLY = 0.85, 1.2
FUSED = (
    "gyro and angle differ as where the angle is fused from gyro and accelerometer (by the filter "
    "of a phone or IMU): it follows what the accelerometer takes for the vertical, which a swing "
    "deceives, so that neither is late, and no term here makes it good. Measure the angle by an "
    "encoder, or have the filter trust its gyro for longer"
)
LIKE_FUSED = "an angle that is fused from gyro and accelerometer looks alike, too"
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
    if (no_delay := of_no_delay(movements)) is not None:
        return [f"{no_delay}. Errors are widened for it."]
    fused = f", and {LIKE_FUSED}" if left_fused(movements) < HARDLY else ""
    return [
        f"{lateness(late)}, which is most of how the two differ. Errors are widened for it; "
        f"{remedy(late)} estimates it, and 'exoid diagnose' asks whether it is that. Where the "
        "encoder shows the knee and the gyro the leg in space, a thigh that rocks looks alike"
        f"{fused}."
    ]


def how_late(movements: Sequence[Movement]) -> str | None:
    """How late it is, and what estimates that; None where it is not."""
    late = late_gyro(movements)
    if late is None:
        return None
    fused = f" ({LIKE_FUSED})" if left_fused(movements) < HARDLY else ""
    estimated = f"{lateness(late)}, and {remedy(late)} estimates that{fused}"
    return of_no_delay(movements) or estimated


def of_no_delay(movements: Sequence[Movement]) -> str | None:
    """That gyro and angle differ in time, but as no delay does; None where it may be one."""
    return FUSED if left_fused(movements) < CLEARLY else of_rocking(movements)


def left_fused(movements: Sequence[Movement]) -> float:
    """The squares that an angle y leaves which is fused from gyro and accelerometer, over those
    that a delay leaves; infinite where the gyro is early, as beside such an angle none is.

    A complementary filter of the time constant T has y' = v + (a - y) / T, with the angle a that
    the accelerometer takes for the vertical.
    """
    pairs = pairs_of(movements)
    slope, rate, _ = together = np.concatenate(pairs, axis=1)
    delay, late = left_late(together)
    raw = [each for each in movements if each.gyro_noise and not each.filtered]
    left = np.inf
    for reach in REACHES:
        pulled = np.concatenate([pulled_by_tilt(each, reach) for each in raw])
        squares, found = left_of(rate, np.stack([slope, np.ones_like(slope), -pulled], axis=1))
        left = min(left, squares if found[-1] > 0 and late > 0 else np.inf)
    return left / delay


def pulled_by_tilt(each: Movement, reach: float) -> np.ndarray:
    """What an accelerometer so far [m] from the joint takes for the angle, less the angle, smoothed
    and cut as `pair_of`.
    """
    assert each.angular_velocity is not None  # it has a gyro's noise
    time, rate, angle = each.segment.time, each.angular_velocity, each.angle + each.thigh_angle
    change = local_line(time, rate, SMOOTHING)[1]
    along = GRAVITY * np.sin(angle) - reach * rate**2
    across = GRAVITY * np.cos(angle) + reach * change
    off = np.arctan2(along, across) - angle
    off = local_line(time, np.arctan2(np.sin(off), np.cos(off)), SMOOTHING)[0]
    return off[told_by(each)]


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
    """The angle's slope, the gyro's rate and how that changes, smoothed alike, where both tell."""
    assert each.angular_velocity is not None  # it has a gyro's noise
    time = each.segment.time
    slope = local_line(time, each.angle, SMOOTHING)[1]
    rate, change = local_line(time, each.angular_velocity, SMOOTHING)
    return np.stack([slope, rate, change])[:, told_by(each)]


def told_by(each: Movement) -> np.ndarray:
    """Where both were measured, but for the ends: of a line around a sample half is missing there,
    and a gyro that is late does not show yet that the leg was let go.
    """
    assert each.angular_velocity is not None  # it has a gyro's noise
    time = each.segment.time
    seen = ~np.isnan(each.angle) & ~np.isnan(each.angular_velocity)
    if not seen.any():
        return seen
    first, last = time[seen][[0, -1]]
    return seen & (time >= first + SMOOTHING / 2) & (time <= last - SMOOTHING / 2)


def scale_of(movements: Sequence[Movement]) -> float | None:
    """By how much a raw gyro shows more than the encoder's slope; None where it is not a scale by
    which most of the movements differ.
    """
    raw = [each for each in movements if not each.filtered]
    found = [apart_in_scale(each.segment.time, each.angle, each.angular_velocity) for each in raw]
    told = [each for each in found if each is not None]
    return float(np.median(told)) if told and 2 * len(told) > len(raw) else None
