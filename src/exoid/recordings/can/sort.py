"""Which frames of a log are of use: every frame under exactly one heading."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.frames import ERROR, EXTENDED, FD, REMOTE, UNEVEN, Frames
from exoid.recordings.can.quality import FrameCounts


@dataclass(frozen=True, eq=False)
class MessageFrames:
    """The good frames of one message, and their places in the log."""

    plan: MessagePlan
    order: Int[np.ndarray, " frame"]
    frames: Frames

    def values(self, name: str) -> Float[np.ndarray, " frame"]:
        """A signal of every frame, in its unit."""
        return self.plan.values(self.frames.data, name)

    def where(self, chosen: Bool[np.ndarray, " frame"]) -> "MessageFrames":
        """The frames that a mask chooses."""
        return MessageFrames(self.plan, self.order[chosen], self.frames.where(chosen))


@dataclass(frozen=True, eq=False)
class SortedFrames:
    """The good frames by message, and how many there were of every other kind."""

    messages: dict[str, MessageFrames]
    counts: FrameCounts


def sort_frames(frames: Frames, plans: Iterable[MessagePlan]) -> SortedFrames:
    """Part the frames into good ones, by message, and those that are only counted."""
    plans = tuple(plans)
    ours = {plan.name: carries(plan, frames) for plan in plans}
    length = np.select(list(ours.values()), [plan.length for plan in plans], -1)
    known = np.isin(frames.identifier, [plan.identifier for plan in plans])
    # Every frame stands under the first heading that fits; a known id that no plan carries is in
    # the wrong format.
    headings = {
        "error": frames.flags & ERROR > 0,
        "remote": known & (frames.flags & REMOTE > 0),
        "fd": known & (frames.flags & FD > 0),
        "used": (frames.length == length) & (frames.flags & UNEVEN == 0),
        "wrong_length": length >= 0,
        "extended": known,
        "foreign": ~known,
    }
    heading = np.select(list(headings.values()), range(len(headings)))
    counts = np.bincount(heading, minlength=len(headings)).tolist()
    used = heading == list(headings).index("used")
    return SortedFrames(
        {
            plan.name: MessageFrames(
                plan, np.flatnonzero(ours[plan.name] & used), frames.where(ours[plan.name] & used)
            )
            for plan in plans
        },
        FrameCounts(read=len(frames), **dict(zip(headings, counts, strict=True))),
    )


def carries(plan: MessagePlan, frames: Frames) -> Bool[np.ndarray, " frame"]:
    """Which frames have the id of this message, in its format."""
    extended = (frames.flags & EXTENDED > 0) == plan.extended
    return (frames.identifier == plan.identifier) & extended
