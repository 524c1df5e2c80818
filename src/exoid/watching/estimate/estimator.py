"""Samples in, moments out: ten a second of the stream, and one at the end of every drop."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from exoid.online.model.model import Model
from exoid.online.model.sample import Sample
from exoid.online.model.trust import Phase, Trust
from exoid.online.outlook import Outlook
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.recordings.live.decoding.reading import Reading
from exoid.recordings.measured.segment import Segment
from exoid.watching.estimate.gyro_off import gyro_off
from exoid.watching.estimate.known import Changes, ratios_of, told_of
from exoid.watching.estimate.left_out import STRAYED, LeftOut, Strays
from exoid.watching.estimate.moment import Moment, Quantity, Unlike
from exoid.watching.estimate.online import at_begin, init, replay, segment_of
from exoid.watching.estimate.other_limb import OtherLimb, other_limb, strange_leg

EVERY = 0.1  # s of the stream between two moments
TOGETHER = 256  # samples that are handed over at once, at most
KEPT = 600.0  # s of samples: the longest drop
ROUNDING = 1e-6  # of a moment's number
COLUMNS, TORQUE = 6, 3  # columns of samples, and which of them is the torque

Rows = Float[np.ndarray, "row 6"]  # of samples
Row = Float[np.ndarray, "6"]


@dataclass(frozen=True, eq=False)
class Drop:
    """A free movement that has ended: its samples, and what is known after it."""

    number: int
    segment: Segment
    moment: Moment


class Estimator:
    """One leg, with whatever is on it, as one body.

    What it gives depends on the samples alone, not on when they come.
    """

    def __init__(self, expected: ExpectedLeg, model: Model, *, loaded: bool = False):
        self.expected, self.model = expected, model
        self.loaded = loaded  # what a mass tells is told of a whole leg
        self.asked = False  # was a movement that strayed asked whether it is of another limb?
        self.unlike: Unlike | None = None  # the leg that its body's tables expect
        self.marks: list[float] = []  # s, where the records of movements began
        self.belief = init(expected, model)
        self.mark: float | None = None  # number of the last moment
        self.drops = 0
        self.torque = False  # was any known?
        self.others: tuple[Quantity, ...] = ()
        self.rows: list[Rows] = []  # the last samples
        self.said: list[Outlook] = []  # and what was said after each of them
        self.strays = Strays()
        self.changes = Changes()

    def warm(self) -> None:
        """Have the programs compiled or loaded, and forget what they said."""
        nothing = np.full((1, COLUMNS), np.nan)
        replay(self.belief, Sample(*nothing.T), self.model)
        told_of(self.belief, self.model, torque=False)

    def take(self, readings: Sequence[Reading]) -> Iterator[Moment | Drop | LeftOut]:
        """What is to be told after these samples."""
        for part in parts_of(readings):
            rows = np.zeros((len(part), COLUMNS))
            rows[:, : TORQUE + 1] = [each[: TORQUE + 1] for each in part]
            self.torque = self.torque or bool(rows[:, TORQUE].any())
            yield from self.absorbed(rows)
            if part[-1].begins:
                self.belief = at_begin(self.belief, self.model)
                self.marks.append(part[-1].time)

    def absorbed(self, rows: Rows) -> Iterator[Moment | Drop | LeftOut]:
        """The rows up to the first that ends a drop, then the others."""
        while len(rows):
            belief, outlook = replay(self.belief, Sample(*rows.T), self.model)
            changes = np.flatnonzero(outlook.drops != self.drops)
            part = len(rows) if not changes.size else int(changes[0]) + 1
            if part < len(rows):
                belief, outlook = replay(self.belief, Sample(*rows[:part].T), self.model)
            self.belief = belief
            self.keep(rows[:part], outlook)
            yield from self.moments(rows[:part], outlook)
            yield from self.left_out(outlook)
            self.changes.look(outlook, part - 1)
            if changes.size:
                yield from self.ended(rows[part - 1], outlook, part - 1)
            self.changes.look(outlook, part)
            rows = rows[part:]

    def keep(self, rows: Rows, outlook: Outlook) -> None:
        """Remember the samples of the last drop."""
        self.rows.append(rows)
        self.said.append(outlook)
        while self.rows[-1][-1, 0] - self.rows[0][-1, 0] > KEPT:
            del self.rows[0], self.said[0]

    def left_out(self, outlook: Outlook) -> Iterator[LeftOut]:
        """The movements of which it is clear by now that they do not count."""
        if self.strays.is_as_before(outlook):
            return
        every = np.concatenate(self.rows)
        for left in self.strays.found(every[:, 0], every[:, 1], outlook):
            if left.why != STRAYED:
                yield left
            elif not self.is_other(every, left.begun):
                yield replace(left, gyro=gyro_off(every[every[:, 0] >= left.begun]))

    def is_other(self, rows: Rows, begun: float) -> bool:
        """Is it no whole leg, of which nothing was known? It is asked once, of the first movement
        that swung on, and followed as what it is from then on.
        """
        failed = self.strays.stand.trust == Trust.UNEXPLAINED
        if self.drops or self.asked or self.loaded or not failed:
            return False
        self.asked = True
        found = other_limb(self.expected, self.model, rows, begun, self.marks)
        return found is not None and self.becomes(found)

    def becomes(self, limb: OtherLimb) -> bool:
        """From here on it is followed as the limb that it is."""
        self.belief, self.unlike = limb.belief, limb.unlike
        self.strays.follow(limb.said)
        return True

    def moments(self, rows: Rows, outlook: Outlook) -> Iterator[Moment]:
        marks = np.floor(rows[:, 0] / EVERY + ROUNDING)
        before = np.concatenate([[np.nan if self.mark is None else self.mark], marks[:-1]])
        for at in np.flatnonzero(marks != before):
            yield self.moment(rows[at], outlook, int(at))
        self.mark = float(marks[-1])

    def moment(self, row: Row, outlook: Outlook, at: int) -> Moment:
        ratios = ratios_of(outlook, at)
        return Moment(
            time=float(row[0]),
            angle=float(row[1]),
            angular_velocity=float(row[2]),
            phase=Phase(int(outlook.phase[at])),
            trust=Trust(int(outlook.trust[at])),
            drops=int(outlook.rests[at]),
            ratios=ratios,
            as_loaded=ratios,
            others=self.others,
            begun=float(outlook.begun[at]),
            unlike=self.unlike,
            change=self.changes.open,
        )

    def ended(self, row: Row, outlook: Outlook, at: int) -> Iterator[Drop]:
        """The number of drops has changed: one has ended, or the leg is another one."""
        before, self.drops = self.drops, int(outlook.drops[at])
        if self.drops < before:
            self.changes.taken_back()
        if outlook.phase[at] == Phase.MOVING:
            self.changes.begun(outlook, at)
        every = np.concatenate(self.rows)
        if self.drops == before + 1 and (found := self.strange(every, outlook, at)) is not None:
            self.becomes(found)
            outlook, at = found.said, -1
        self.others = told_of(self.belief, self.model, torque=self.torque)
        if self.drops != before + 1:
            return
        begun, end = float(outlook.begun[at]), float(outlook.ended[at])
        segment = segment_of(Sample(*every.T), begun, end)
        change = self.changes.counted(outlook, at)
        moment = replace(self.moment(row, outlook, at), others=self.others, change=change)
        yield Drop(self.drops, segment, moment)

    def strange(self, rows: Rows, outlook: Outlook, at: int) -> OtherLimb | None:
        """The leg of the drops until now where it is none of its body's; asked until it is."""
        if self.loaded or self.unlike is not None:
            return None
        told = self.moment(rows[-1], outlook, at)
        return strange_leg(self.expected, self.model, rows, self.marks, told)


def parts_of(readings: Sequence[Reading]) -> Iterator[Sequence[Reading]]:
    """What is handed over at once: it ends where a movement's record begins."""
    first = 0
    for after, each in enumerate(readings, start=1):
        if each.begins or after - first == TOGETHER or after == len(readings):
            yield readings[first:after]
            first = after
