"""What the node has said last of the leg, frame by frame."""

from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.node.config_crc import LEARNED, learning_crc
from exoid.recordings.can.node.learned import (
    ERRORS,
    FRICTION,
    LEARNING,
    OF_FRICTION,
    SIGNALS,
    VALUES,
)
from exoid.recordings.can.node.one_frame import unsigned, values_of
from exoid.recordings.can.node_estimate import CHANGED, UNEXPLAINED, NodeEstimate, word

DOUBTS = {
    UNEXPLAINED: "the node's model of a leg does not explain the movement: was it a free one?",
    CHANGED: "the node finds another leg than before, or another load, and learns it anew.",
}


class LastEstimate:
    """Takes the frames that belong together."""

    def __init__(self):
        self.known: NodeEstimate | None = None
        self.parts: dict[str, tuple[float, ...]] = {}  # the values of those that have come

    def see(self, plan: MessagePlan, data: bytes) -> list[str]:
        """One of them; after a lost one the next time counts. Returns what a person should know."""
        if list(self.parts) != list(LEARNED[: LEARNED.index(plan.name)]):
            self.parts = {}
        if plan.name != LEARNING:
            names = OF_FRICTION if plan.name == FRICTION else SIGNALS
            self.parts[plan.name] = values_of(plan, data, names)
            return []
        parts, self.parts = self.parts, {}
        if (
            len(parts) < len(LEARNED) - 1
            or unsigned(data, plan.signal("LearningCrc")) != learning_crc()
        ):
            return []
        trust, drops = (unsigned(data, plan.signal(name)) for name in ("Trust", "Drops"))
        ratio, error = parts[FRICTION]
        ratios, errors = (*parts[VALUES], ratio), (*parts[ERRORS], error)
        before, self.known = self.known, NodeEstimate(word(trust), drops, ratios, errors)
        news = before is not None and before.trust != self.known.trust
        return [DOUBTS[self.known.trust]] if news and self.known.trust in DOUBTS else []
