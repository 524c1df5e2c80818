"""What a fit sees of the movements of recordings, in one shape."""

from collections.abc import Sequence

import jax
import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import make_interp_spline

from exoid.fitting.data.guide import guide_of
from exoid.fitting.data.movement import Movement
from exoid.fitting.data.observation import Clock, Observation
from exoid.fitting.data.pace import LONGEST_STEP, parts_of
from exoid.fitting.data.time_jitter import TimeJitter
from exoid.fitting.model.systematics import SOMEWHERE, apart, beside_unplaced
from exoid.physics.motion.step import Drive
from exoid.physics.term import Term
from exoid.physics.waves import cycle_shape
from exoid.recordings.measured.samples import Samples
from exoid.recordings.signal.condition import stands, torque_frequencies
from exoid.recordings.signal.local_line import interpolated

LITTLE = 0.01  # of a torque, that lines between its samples may lose
SPLINE = 5  # order of a smooth torque's spline
STANDS = 30  # samples in a row of one value: noise of a third of a step makes one of 1000 as long


def observe(
    movements: list[Movement], reading: str, terms: tuple[type[Term], ...] = ()
) -> Observation:
    """All movements in one shape; `reading` of Eq. 4 gives the torque its frequency, the fastest of
    the `terms` the parts of a step.
    """
    grids = [with_gaps_bridged(each.segment.time) for each in movements]
    size = bucket(max(grid.size for grid in grids))
    parts = parts_of(movements, terms)
    rows = [
        one_observation(movements, number, grid, size, reading, parts)
        for number, grid in enumerate(grids)
    ]
    return jax.tree.map(lambda *each: np.stack(each), *rows)


def bucket(size: int) -> int:
    """The shape that serves this many samples: one of a few, 256 or 384 times a power of two, so
    that a recording of a new length seldom needs compiling.
    """
    whole = 256
    while whole < size:
        whole = whole * 3 // 2 if whole % 3 else whole * 4 // 3
    return whole


def with_gaps_bridged(time: Samples) -> Samples:
    """The sample times, and more between them where they are farther apart than a safe step."""
    pieces = np.maximum(np.ceil(np.diff(time) / LONGEST_STEP - 1e-6), 1).astype(int)
    parts = [
        np.linspace(start, stop, count, endpoint=False)
        for start, stop, count in zip(time[:-1], time[1:], pieces, strict=True)
        if count > 1
    ]
    if not parts:
        return time
    return np.union1d(time, np.concatenate(parts))


def one_observation(
    movements: list[Movement],
    number: int,
    grid: Samples,
    size: int,
    reading: str,
    parts: int = 1,
) -> Observation:
    """What is seen of one of the movements, on this grid, padded to this size."""
    each = movements[number]
    own, recordings = each.segment.time, sorted({one.recording for one in movements})
    at = np.searchsorted(grid, own)
    step = np.median(np.diff(grid))
    time = np.concatenate([grid, grid[-1] + step * np.arange(1, size - grid.size + 1)])

    def placed(
        samples: Samples | None, noise: float, jitter: TimeJitter | None
    ) -> tuple[Samples, Samples]:
        value, weight = np.zeros(size), np.zeros(size)
        if samples is not None:
            known = ~np.isnan(samples)
            unit = np.full(own.size, noise) if jitter is None else jitter.noise(own, samples)
            value[at[known]], weight[at[known]] = samples[known], 1 / unit[known]
        return value, weight

    jitter = each.angle_jitter if each.divisor is None else None
    angle, angle_weight = placed(each.angle, each.residual_unit, jitter)
    if each.rounds_alike and each.divisor is None:
        angle_weight[at[standing(each.angle)]] = 0.0
    rate, rate_noise = each.angular_velocity, each.velocity_noise
    velocity, velocity_weight = placed(rate, rate_noise, each.gyro_jitter)
    guide, slope = guide_of(each)
    return Observation(
        time=time,
        angle=angle,
        angular_velocity=velocity,
        angle_weight=angle_weight,
        velocity_weight=velocity_weight,
        guide_angle=np.interp(time, own, guide),
        guide_velocity=np.interp(time, own, slope),
        cycle=staged(time, lambda at: cycle_torque(at - each.onset, each, reading)),
        torque=staged(time, lambda at: measured_torque(at, each)),
        torque_reach=np.asarray(each.systematics.torque_reach * (each.kind == "measured")),
        added_mass=np.asarray(each.added_mass),
        added_mass_distance=np.asarray(SOMEWHERE if each.unplaced else each.added_mass_distance),
        added_mass_moves=np.asarray(float(each.unplaced or not beside_unplaced(each, movements))),
        added_mass_extent=np.asarray(each.systematics.expected_extent),
        apart=np.asarray(apart(each, movements)),
        heavier=np.asarray(heavier(each, movements)),
        damped=np.asarray(1.0),
        stiffened=np.asarray(1.0),
        thigh_angle=np.asarray(each.thigh_angle),
        owner=np.asarray(recordings.index(each.recording)),
        clock=clock(each, number, reading),
        parts=parts,
    )


def heavier(each: Movement, movements: Sequence[Movement]) -> float:
    """What it bears beyond the least mass of a fit, over the most that its recording has so."""
    most = max(one.borne for one in movements if one.recording == each.recording)
    return each.borne / most if most > 0 else 0.0


def standing(samples: Samples) -> NDArray[np.bool_]:
    """Which samples of every long stand on one value are not its middle: what a coarse encoder
    rounds off at rest is one error, in however many samples.
    """
    found = np.zeros(samples.size, dtype=bool)
    for first, last in stands(samples, STANDS):
        found[first : last + 1] = True
        found[(first + last) // 2] = False
    return found


def staged(time: Samples, torque) -> Drive:
    """A torque at the begin, middle and end of every step."""
    return Drive(torque(time[:-1]), torque((time[:-1] + time[1:]) / 2), torque(time[1:]))


def cycle_torque(time: Samples, each: Movement, reading: str) -> Samples:
    """Eq. 10 for unit amplitude at `time` since the onset, 0 where nothing is voluntary."""
    if not each.voluntary:
        return np.zeros_like(time)
    frequency = torque_frequencies(each.period)[reading]
    return cycle_shape(time, each.period, frequency, xp=np)


def measured_torque(time: Samples, each: Movement) -> Samples:
    """The torque that was measured [N m]."""
    torque, own = each.segment.applied_torque, each.segment.time
    if each.kind != "measured" or torque is None:
        return np.zeros_like(time)
    return between(time, own, interpolated(own, torque))


def between(time: Samples, own: Samples, torque: Samples) -> Samples:
    """A torque at `time` from its samples at their `own`, linear between these.

    Where these are few for it and it is smooth, a spline of order five: a line loses
    (omega h)^2 / 12 of what has the frequency omega, 13 % at five samples a period.
    """
    if is_curved(torque):
        return make_interp_spline(own, torque, k=SPLINE)(np.minimum(time, own[-1]))
    return np.interp(time, own, torque)


def is_curved(torque: Samples) -> bool:
    """Is more lost by lines between its samples than a curve through them makes up?"""
    return lost_by_lines(torque) > LITTLE and is_smooth(torque)


def lost_by_lines(samples: Samples) -> float:
    """The share of what varies that lines between samples lose."""
    bends, varies = np.diff(samples, 2), np.std(samples)
    return float(np.sqrt(np.mean(bends**2)) / (12 * varies)) if bends.size and varies else 0.0


def is_smooth(samples: Samples) -> bool:
    """Is a sample better told by six around it than by a line through its neighbours? What was
    held from sample to sample, or is noise, is not.
    """
    if samples.size < 8:
        return False
    line, six = np.diff(samples, 2) / 2, np.diff(samples, 6) / 20
    return bool(np.mean(six**2) < np.mean(line**2))


def clock(each: Movement, number: int, reading: str) -> Clock:
    """The cycle of a movement, and its number among the others."""
    if not each.voluntary:
        return Clock(np.asarray(1.0), np.asarray(0.0), np.asarray(0.0), np.asarray(float(number)))
    frequency = torque_frequencies(each.period)[reading]
    return Clock(*map(np.asarray, (each.period, frequency, each.onset, float(number))))
