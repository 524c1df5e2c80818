"""What the node says it has learned of the leg: EXO_RATIOS, EXO_RATIO_ERRORS, EXO_LEARNING."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int

from exoid.recordings.can.node.config_crc import LEARNED, learning_crc
from exoid.recordings.can.node_estimate import NodeEstimate, word
from exoid.recordings.can.sort import MessageFrames
from exoid.recordings.filter.learning import RATIOS

VALUES, ERRORS, LEARNING = LEARNED
SIGNALS = tuple(name.capitalize() for name in RATIOS)


@dataclass(frozen=True, eq=False)
class Course:
    """What a node told, time after time."""

    order: Int[np.ndarray, " told"]  # places in the log
    trust: Int[np.ndarray, " told"]
    phase: Int[np.ndarray, " told"]
    drops: Int[np.ndarray, " told"]
    ratios: Float[np.ndarray, "told 4"]
    errors: Float[np.ndarray, "told 4"]

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
    """Every time at which all three frames came, one behind the other, of a node that learns by the
    numbers of this exoid.
    """
    parts = [messages[name] for name in LEARNED]
    order = np.concatenate([each.order for each in parts])
    kind = np.repeat(np.arange(len(parts)), [each.order.size for each in parts])
    row = np.concatenate([np.arange(each.order.size) for each in parts])
    at = np.argsort(order)
    order, kind, row = order[at], kind[at], row[at]
    first = np.flatnonzero((kind[:-2] == 0) & (kind[1:-1] == 1) & (kind[2:] == 2))
    values, errors, learning = (row[first + k] for k in range(len(parts)))
    ours = messages[LEARNING].values("LearningCrc")[learning] == learning_crc()
    values, errors, learning = values[ours], errors[ours], learning[ours]
    trust, phase, drops = (
        messages[LEARNING].values(name)[learning].astype(int)
        for name in ("Trust", "Phase", "Drops")
    )
    return Course(
        order[first[ours] + 2],
        trust,
        phase,
        drops,
        np.stack([messages[VALUES].values(name)[values] for name in SIGNALS], axis=1),
        np.stack([messages[ERRORS].values(name)[errors] for name in SIGNALS], axis=1),
    )
