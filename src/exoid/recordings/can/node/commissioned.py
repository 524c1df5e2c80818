"""How a node was commissioned when it recorded, and what changed of that meanwhile."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from jaxtyping import Float, Int

from exoid.recordings.can.node.rows import MISSING, STATE, Rows
from exoid.recordings.can.sort import MessageFrames

SETTINGS, HEARTBEAT = "EXO_SETTINGS", "EXO_HEARTBEAT"
PARTS = ("VersionMajor", "VersionMinor", "VersionPatch")


@dataclass(frozen=True)
class Mounting:
    """How the encoder sits on the leg, as the node says it."""

    zero: int  # count of the encoder where the knee is fully extended
    reversed: bool  # the count falls while the knee extends

    def __str__(self) -> str:
        return f"zero {self.zero}, the encoder's count {direction(self.reversed)} in extension"


def direction(reversed: bool) -> str:
    """What the encoder's count does while the knee extends."""
    return "falls" if reversed else "rises"


def changed(before: Mounting, after: Mounting) -> str:
    """What was changed, in words."""
    parts = []
    if before.zero != after.zero:
        parts.append(f"the zero from {before.zero} to {after.zero}")
    if before.reversed != after.reversed:
        words = (direction(each.reversed) for each in (before, after))
        parts.append("the direction from {} to {}".format(*words))
    return " and ".join(parts)


def commissioned_lines(
    node: int, messages: dict[str, MessageFrames], found: list[Rows]
) -> tuple[str, ...]:
    """What the settings and heartbeats of a log say; nothing where it has no settings."""
    settings = messages.get(SETTINGS)
    if settings is None or not settings.order.size:
        return ()
    serials, which = np.unique(settings.values("Serial").astype(int), return_inverse=True)
    settings = settings.where(which == np.bincount(which).argmax())
    time = times_of(settings.order, found)
    zero, turned, stored = (
        settings.values(name).astype(int) for name in ("Zero", "Reversed", "Commissioned")
    )
    new = np.flatnonzero(np.diff(zero * 2 + turned, prepend=-1))
    mountings = tuple((float(time[at]), Mounting(int(zero[at]), bool(turned[at]))) for at in new)
    version = version_in(messages[HEARTBEAT])
    firmware = f", firmware {version}" if version else ""
    built_in = "" if stored[-1] else " (not commissioned: as it was built)"
    return (
        f"node {node}: {mountings[0][1]}{firmware}{built_in}",
        *(change_line(at, before, after) for (_, before), (at, after) in pairwise(mountings)),
        *several_lines(node, serials.tolist()),
    )


def several_lines(node: int, serials: list[int]) -> list[str]:
    """What to say where nodes share an id."""
    if len(serials) < 2:
        return []
    names = ", ".join(f"{serial:08X}" for serial in serials)
    return [
        f"{len(serials)} nodes with the id {node} sent (serials {names}): nobody can tell their "
        "samples apart. Give each its own id (exoid node set) and record again."
    ]


def change_line(at: float, before: Mounting, after: Mounting) -> str:
    """What a recording is worth whose angles were measured in two ways."""
    return (
        f"{changed(before, after)} was changed in the recording, at {at:.2f} s: angles before and "
        "after it do not mean the same. Use one side of it (segment_start_s and segment_end_s of "
        "the sidecar), or record again."
    )


def times_of(order: Int[np.ndarray, " frame"], found: list[Rows]) -> Float[np.ndarray, " frame"]:
    """The time of the last sample before each place of the log, the first one's before that."""
    places = np.concatenate([rows.frame[STATE] for rows in found])
    time = np.concatenate([rows.time for rows in found])[places != MISSING]
    if not time.size:
        return np.zeros(order.size)
    return time[np.maximum(np.searchsorted(places[places != MISSING], order) - 1, 0)]


def version_in(heartbeats: MessageFrames) -> str | None:
    """The firmware's version, as most heartbeats tell it."""
    if not heartbeats.order.size:
        return None
    return ".".join(str(int(np.median(heartbeats.values(part)))) for part in PARTS)
