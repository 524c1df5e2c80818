"""Does the node tell, while it is recorded, that it is not well?"""

from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.node.health import CONDITIONS
from exoid.recordings.can.node.one_frame import unsigned


class HealthWatch:
    """The node's health, frame by frame."""

    def __init__(self):
        self.told: set[str] = set()

    def see(self, plan: MessagePlan, data: bytes) -> list[str]:
        """What this EXO_HEALTH says that none before it did, in sentences."""
        found = {
            name: f"{sentence}."
            for name, (least, sentence) in CONDITIONS.items()
            if name not in self.told and unsigned(data, plan.signal(name)) >= least
        }
        self.told |= found.keys()
        return list(found.values())
