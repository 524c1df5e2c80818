"""The values of the node's samples: angle unwrapped, faulty samples missing, all in SI units."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from exoid.recordings.can.decode import SignalPlan, raw_values
from exoid.recordings.can.device_clock import nearest_tick
from exoid.recordings.can.node.rows import ACC, FINE, MISSING, RAW, STATE, Rows
from exoid.recordings.can.sort import MessageFrames

RAW_LIMIT = 32767  # counts; a 16-bit number that reached its end

STATUS = (
    "EncoderFault",
    "MagnetMissing",
    "MagnetStrength",
    "ImuFault",
    "GyroSaturated",
    "StateSaturated",
    "FilterReset",
    "Overrun",
)
ENCODER = ("EncoderFault", "MagnetMissing")
IMU = ("ImuFault",)
GYRO = ("ImuFault", "GyroSaturated")
# Which status bits take a sample out of which channel. The filter carries on over a fault, but
# what it then says of that quantity is its own prediction, not a measurement.
MASKS = {
    "angle": ENCODER,
    "angular_velocity": GYRO,
    "angular_acceleration": GYRO,
    "raw_angle": ENCODER,
    "raw_angular_velocity": GYRO,
    "raw_acceleration_x": IMU,
    "raw_acceleration_z": IMU,
}
SOURCES = {
    "angle": (STATE, "Angle"),
    "angular_velocity": (STATE, "AngularVelocity"),
    "angular_acceleration": (STATE, "AngularAcceleration"),
    "raw_angular_velocity": (RAW, "GyroY"),
    "raw_acceleration_x": (ACC, "AccelX"),
    "raw_acceleration_z": (ACC, "AccelZ"),
}

Values = Float[np.ndarray, " row"]


@dataclass(frozen=True, eq=False)
class Samples:
    """The channels of a log, and how often each status bit was set."""

    channels: dict[str, Values]
    faults: tuple[tuple[str, int], ...]
    encoder_counts: int  # a turn


def samples_of(messages: dict[str, MessageFrames], found: list[Rows]) -> Samples:
    """All channels of which at least one value was measured, by their `Segment` names."""
    places = {name: np.concatenate([rows.frame[name] for rows in found]) for name in found[0].frame}
    picked = {name: Picked(messages[name], places[name]) for name in places}
    status = {bit: picked[STATE].values(bit) > 0 for bit in STATUS}
    channels = {channel: picked[name].values(signal) for channel, (name, signal) in SOURCES.items()}
    for channel, (name, signal) in SOURCES.items():
        channels[channel][picked[name].at_limit(signal)] = np.nan
    encoder = counted(picked[RAW], picked[FINE])
    valid = picked[RAW].there & ~(status["EncoderFault"] | status["MagnetMissing"])
    channels["raw_angle"] = unwrapped_angle(encoder, valid, channels["angle"])
    for channel, bits in MASKS.items():
        channels[channel][np.logical_or.reduce([status[bit] for bit in bits])] = np.nan
    measured = {name: values for name, values in channels.items() if np.isfinite(values).any()}
    faults = tuple((bit, int(status[bit].sum())) for bit in STATUS)
    return Samples(measured, faults, encoder.per_turn)


class Picked:
    """The frames of one message, one for each sample; some are missing."""

    def __init__(self, message: MessageFrames, places: Int[np.ndarray, " row"]):
        self.plan = message.plan
        self.there = places != MISSING
        self.data = message.frames.data[np.searchsorted(message.order, places[self.there])]

    def values(self, signal: str) -> Values:
        """A signal in its unit; NaN where the frame is missing."""
        return spread(self.plan.values(self.data, signal), self.there, np.nan)

    def counts(self, signal: str) -> Int[np.ndarray, " row"]:
        """A signal as it was sent; 0 where the frame is missing."""
        return spread(
            raw_values(self.data, self.plan.signal(signal)).astype(np.int64), self.there, 0
        )

    def at_limit(self, signal: str) -> Bool[np.ndarray, " row"]:
        """Samples cut off at the end of their range: true values lie beyond."""
        return np.abs(self.counts(signal)) >= RAW_LIMIT


def spread(values: np.ndarray, there: Bool[np.ndarray, " row"], missing) -> np.ndarray:
    """The values at the rows that have one."""
    rows = np.full(there.size, missing, dtype=values.dtype)
    rows[there] = values
    return rows


@dataclass(frozen=True, eq=False)
class Counted:
    """The encoder's counts, all in those of one signal."""

    signal: SignalPlan
    counts: Int[np.ndarray, " row"]
    per_turn: int  # of the encoder, which may count in steps of the signal's


def counted(raw: Picked, fine: Picked) -> Counted:
    """The counts in full where the node sends them, and else those of EXO_RAW.

    EXO_FINE is believed where EXO_RAW is the nearest count to it: a foreign frame of the same
    identifier is not, and no log of a node that sends none is read in another way for it.
    """
    coarse, signal = raw.plan.signal("Angle"), fine.plan.signal("Angle")
    finer = 2 ** (signal.length - coarse.length)
    in_full, in_raw = fine.counts("Angle"), raw.counts("Angle")
    nearest = (in_full + finer // 2) // finer % 2**coarse.length
    agrees = fine.there & raw.there & (nearest == in_raw)
    if 2 * agrees.sum() <= fine.there.sum():
        return Counted(coarse, in_raw, 2**coarse.length)
    bits = int(np.median(fine.counts("EncoderBits")[agrees]))
    return Counted(signal, np.where(agrees, in_full, in_raw * finer), 2**bits)


def unwrapped_angle(encoder: Counted, valid: Bool[np.ndarray, " row"], filtered: Values) -> Values:
    """The encoder's angle without its jumps of a turn [rad].

    Every count is taken on the turn of the filtered angle: so one damaged count moves no other.
    """
    signal = encoder.signal
    counts, turn = encoder.counts[valid], 2**signal.length
    known = np.flatnonzero(np.isfinite(filtered))
    if known.size:
        expected = np.interp(np.flatnonzero(valid), known, filtered[known])
        expected_counts = np.rint((expected - signal.offset) / signal.scale).astype(np.int64)
        counts = nearest_tick(counts, expected_counts, turn)
    else:
        counts = np.unwrap(counts, period=turn)
    return spread(counts * signal.scale + signal.offset, valid, np.nan)
