"""Does somebody change, while it is recorded, how the angle is measured?"""

import numpy as np

from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.node.commissioned import Mounting, changed

READ = ("Serial", "Zero", "Reversed")


class MountingWatch:
    """The node's settings, frame by frame."""

    def __init__(self):
        self.last: dict[int, Mounting] = {}  # by serial: two nodes may share an id

    def see(self, plan: MessagePlan, data: bytes) -> list[str]:
        """What changed since the last EXO_SETTINGS, in a sentence."""
        frame = np.frombuffer(data, np.uint8).reshape(1, -1)
        serial, zero, turned = (int(plan.values(frame, name)[0]) for name in READ)
        now = Mounting(zero, bool(turned))
        before, self.last[serial] = self.last.get(serial, now), now
        if before == now:
            return []
        return [
            f"{changed(before, now)} was changed: angles before and after it do not mean the "
            "same. End this recording and begin another one."
        ]
