"""Do two nodes send with the same ids? Then the counters of one message alternate."""

from collections import deque

from exoid.recordings.can.device_clock import COUNTER

REMEMBERED = 50  # frames
ENOUGH = 20  # of them; one node that loses frames never carries on the count before last


class Alternation:
    """The counters of one message, frame by frame."""

    def __init__(self):
        self.last: tuple[int, bytes] | None = None
        self.before: int | None = None
        self.odd: deque[bool] = deque(maxlen=REMEMBERED)

    def add(self, counter: int, data: bytes) -> None:
        """A frame that repeats the last one, byte for byte, was doubled on its way: no sign."""
        if self.last is not None and data != self.last[1]:
            follows = (counter - self.last[0]) % COUNTER == 1
            resumes = self.before is not None and (counter - self.before) % COUNTER == 1
            self.odd.append(counter == self.last[0] or (resumes and not follows))
            self.before = self.last[0]
        self.last = (counter, data)

    def follow(self, counters: list[int], data: bytes, count: int) -> None:
        """So many frames that go on from the last one: the last two counters, the last data."""
        before = counters[0] if len(counters) > 1 else None
        self.before = before if before is not None or self.last is None else self.last[0]
        self.last = (counters[-1], data)
        self.odd.extend([False] * min(count, REMEMBERED))

    @property
    def found(self) -> bool:
        return sum(self.odd) >= ENOUGH
