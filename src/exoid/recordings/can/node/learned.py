"""What the node says it has learned of the leg: EXO_RATIOS and the frames that follow it."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from exoid.recordings.can.node.config_crc import LEARNED, learning_crc
from exoid.recordings.can.node_estimate import NodeEstimate, word
from exoid.recordings.can.sort import MessageFrames
from exoid.recordings.filter.learning import RATIOS

VALUES, ERRORS, FRICTION, LEARNING = LEARNED
SIGNALS = tuple(name.capitalize() for name in RATIOS[:-1])  # of VALUES and of ERRORS
OF_FRICTION = "Friction", "Error"  # the last ratio, in a frame of its own


@dataclass(frozen=True, eq=False)
class Course:
    """What a node told, time after time."""

    order: Int[np.ndarray, " told"]  # places in the log
    trust: Int[np.ndarray, " told"]
    phase: Int[np.ndarray, " told"]
    drops: Int[np.ndarray, " told"]
    ratios: Float[np.ndarray, "told 5"]
    errors: Float[np.ndarray, "told 5"]

    @property
    def last(self) -> NodeEstimate | None:
        """What it told at last; None where it told nothing."""
        if not self.order.size:
            return None
        return NodeEstimate(
            word(int(self.trust[-1])),
            int(self.drops[-1]),
            tuple(self.ratios[-1].tolist()),
            tuple(self.errors[-1].tolist()),
        )


def course_of(messages: dict[str, MessageFrames]) -> Course:
    """Every time at which all the frames came, one behind the other, of a node that learns by the
    numbers of this exoid.
    """
    learning = messages[LEARNING]
    rows = rows_of(messages)
    rows = rows[learning.values("LearningCrc")[rows[:, -1]] == learning_crc()]
    values, errors, friction, last = rows.T
    trust, phase, drops = (
        learning.values(name)[last].astype(int) for name in ("Trust", "Phase", "Drops")
    )
    ratio, error = (messages[FRICTION].values(name)[friction] for name in OF_FRICTION)
    return Course(
        learning.order[last],
        trust,
        phase,
        drops,
        np.column_stack([*(messages[VALUES].values(name)[values] for name in SIGNALS), ratio]),
        np.column_stack([*(messages[ERRORS].values(name)[errors] for name in SIGNALS), error]),
    )


def rows_of(messages: dict[str, MessageFrames]) -> Int[np.ndarray, "told 4"]:
    """Which frames of each message belong together."""
    parts = [messages[name] for name in LEARNED]
    sizes = [each.order.size for each in parts]
    at = np.argsort(np.concatenate([each.order for each in parts]))
    kind = np.repeat(np.arange(len(parts)), sizes)[at]
    row = np.concatenate([np.arange(size) for size in sizes])[at]
    together = np.arange(max(at.size - len(parts) + 1, 0))[:, None] + np.arange(len(parts))
    whole = (kind[together] == np.arange(len(parts))).all(axis=1)
    return row[together[whole]]
