"""From the counts of a tick's frames to what the sensors showed, as `samples` has it of a log."""

from math import nan

from exoid.recordings.can.device_clock import nearest_tick
from exoid.recordings.can.node.rows import FINE, RAW, STATE
from exoid.recordings.can.node.samples import ENCODER, GYRO, RAW_LIMIT
from exoid.recordings.can.node.which import messages_of
from exoid.recordings.live.decoding.bits import Word, mask_of, reader_of
from exoid.recordings.live.decoding.tick import Tick


class Counts:
    """Encoder and gyro in SI units, faulty ones NaN; the encoder on the filtered angle's turn."""

    def __init__(self):
        plans = messages_of(0)  # those of any other node lie alike
        state, raw, fine = plans[STATE], plans[RAW], plans[FINE]
        self.filtered_angle, self.filtered_rate = (
            reader_of(state, name) for name in ("Angle", "AngularVelocity")
        )
        self.encoder, self.gyro = reader_of(raw, "Angle"), reader_of(raw, "GyroY")
        self.in_full = reader_of(fine, "Angle")
        self.no_angle, self.no_rate = mask_of(state, ENCODER), mask_of(state, GYRO)
        self.of_state, self.of_rate = state.signal("Angle"), state.signal("AngularVelocity")
        self.of_raw, self.of_gyro = raw.signal("Angle"), raw.signal("GyroY")
        self.of_fine = fine.signal("Angle")
        self.turn, self.finer = (
            2**self.of_raw.length,
            2 ** (self.of_fine.length - self.of_raw.length),
        )
        self.expected = 0.0  # rad, where the encoder was last

    def agree(self, raw: Word, fine: Word) -> bool:
        """Is EXO_RAW the nearest count to that of EXO_FINE?"""
        return (self.in_full(fine) + self.finer // 2) // self.finer % self.turn == self.encoder(raw)

    def measured(self, tick: Tick) -> tuple[float, float]:
        """Angle [rad] and rate [rad/s] before the filter."""
        state, raw = tick.state, tick.raw
        if raw is None:
            return nan, nan
        if state is not None:
            self.expected = self.filtered_angle(state) * self.of_state.scale
        count = self.gyro(raw)
        bad = abs(count) >= RAW_LIMIT or (state is not None and state & self.no_rate)
        rate = nan if bad else count * self.of_gyro.scale + self.of_gyro.offset
        if state is not None and state & self.no_angle:
            return nan, rate
        self.expected = self.angle(raw, tick.fine)
        return self.expected, rate

    def angle(self, raw: Word, fine: Word | None) -> float:
        """On the turn of where it is expected."""
        if fine is not None and self.agree(raw, fine):
            signal, count, turn = self.of_fine, self.in_full(fine), self.turn * self.finer
        else:
            signal, count, turn = self.of_raw, self.encoder(raw), self.turn
        near = round((self.expected - signal.offset) / signal.scale)
        return nearest_tick(count, near, turn) * signal.scale + signal.offset

    def filtered(self, state: Word) -> tuple[float, float]:
        """Angle [rad] and rate [rad/s] as the node's filter believes them."""
        angle, rate = self.filtered_angle(state), self.filtered_rate(state)
        return (
            nan if state & self.no_angle else angle * self.of_state.scale,
            nan if state & self.no_rate else rate * self.of_rate.scale,
        )
