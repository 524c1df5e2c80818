"""What came of one tick of the node so far."""

from exoid.recordings.live.decoding.bits import Word


class Tick:
    """The frames of a tick; None for those that have not come."""

    __slots__ = ("fine", "number", "raw", "state", "time")

    def __init__(self, number: int, time: float):
        self.number, self.time = number, time  # time: s
        self.state: Word | None = None
        self.raw: Word | None = None
        self.fine: Word | None = None
