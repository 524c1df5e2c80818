"""Which frames of a log are of use: every frame under exactly one heading."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Int

from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.frames import ERROR, EXTENDED, FD, REMOTE, UNEVEN, Frames
from exoid.recordings.can.quality import FrameCounts


@dataclass(frozen=True, eq=False)
class MessageFrames:
    """The good frames of one message, and their places in the log."""

    plan: MessagePlan
    order: Int[np.ndarray, " frame"]
    frames: Frames


@dataclass(frozen=True, eq=False)
class SortedFrames:
    """The good frames by message, and how many there were of every other kind."""

    messages: dict[str, MessageFrames]
    counts: FrameCounts


HEADINGS = ("foreign", "extended", "used", "wrong_length", "fd", "remote", "error")


def sort_frames(frames: Frames, plans: Iterable[MessagePlan]) -> SortedFrames:
    """Part the frames into good ones, by message, and those that are only counted."""
    plans = tuple(plans)
    known = np.isin(frames.identifier, [plan.identifier for plan in plans])
    # A known id is in the wrong format until a plan with this format is found.
    heading = np.where(known, HEADINGS.index("extended"), HEADINGS.index("foreign"))
    ours = {plan.name: carries(plan, frames) for plan in plans}
    for plan in plans:
        uneven = (frames.flags & UNEVEN > 0) | (frames.length != plan.length)
        heading[ours[plan.name] & uneven] = HEADINGS.index("wrong_length")
        heading[ours[plan.name] & ~uneven] = HEADINGS.index("used")
    for name, flag in (("fd", FD), ("remote", REMOTE)):
        heading[known & (frames.flags & flag > 0)] = HEADINGS.index(name)
    heading[frames.flags & ERROR > 0] = HEADINGS.index("error")
    used = heading == HEADINGS.index("used")
    counts = np.bincount(heading, minlength=len(HEADINGS)).tolist()
    return SortedFrames(
        {plan.name: chosen(plan, ours[plan.name] & used, frames) for plan in plans},
        FrameCounts(read=len(frames), **dict(zip(HEADINGS, counts, strict=True))),
    )


def carries(plan: MessagePlan, frames: Frames) -> Bool[np.ndarray, " frame"]:
    """Which frames have the id of this message, in its format."""
    extended = (frames.flags & EXTENDED > 0) == plan.extended
    return (frames.identifier == plan.identifier) & extended


def chosen(plan: MessagePlan, mask: Bool[np.ndarray, " frame"], frames: Frames) -> MessageFrames:
    return MessageFrames(plan, np.flatnonzero(mask), frames.where(mask))
