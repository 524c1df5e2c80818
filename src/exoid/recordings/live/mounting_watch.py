"""Does somebody change, while it is recorded, how the angle is measured?"""

import numpy as np

from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.node.commissioned import Mounting, changed


class MountingWatch:
    """The node's settings, frame by frame."""

    def __init__(self):
        self.last: Mounting | None = None

    def see(self, plan: MessagePlan, data: bytes) -> str | None:
        """What changed since the last EXO_SETTINGS, in a sentence."""
        frame = np.frombuffer(data, np.uint8).reshape(1, -1)
        zero, turned = (int(plan.values(frame, name)[0]) for name in ("Zero", "Reversed"))
        before, self.last = self.last, Mounting(zero, bool(turned))
        if before is None or before == self.last:
            return None
        return (
            f"{changed(before, self.last)} was changed: angles before and after it do not mean the "
            "same. End this recording and begin another one."
        )
