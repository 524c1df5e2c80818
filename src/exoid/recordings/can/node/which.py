"""Which of the nodes of a bus has sent a frame, by its identifier."""

from dataclasses import replace
from functools import cache

import numpy as np

from exoid.recordings.can.dbc import exoid_messages, node_stride
from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.frames import Frames
from exoid.recordings.can.node.config_crc import COMMANDED, LEARNED, RECORDED, config_crc
from exoid.recordings.can.node.rows import FINE, SAMPLED, TIME

MEASURED = (TIME, *SAMPLED, FINE)
FIRST = "EXO_TIME", "EXO_TELL"  # what has the lowest identifiers: of nodes, of commands


@cache
def node_count() -> int:
    """How many nodes a bus can have."""
    first, command = (exoid_messages()[name].identifier for name in FIRST)
    return (command - first) // node_stride()


@cache
def messages_of(node: int) -> dict[str, MessagePlan]:
    """What the node of this id sends, by the names of exoid.dbc."""
    plans = exoid_messages()
    commands = plans[FIRST[1]].identifier
    return {
        name: replace(plan, identifier=plan.identifier + node * node_stride())
        for name, plan in plans.items()
        if plan.identifier < commands
    }


@cache
def senders() -> dict[int, tuple[int, MessagePlan]]:
    """Node id and message by identifier."""
    return {
        plan.identifier: (node, plan)
        for node in range(node_count())
        for plan in messages_of(node).values()
    }


def nodes_in(frames: Frames) -> list[int]:
    """The ids of the nodes whose frames these are, from the lowest on.

    Other devices may use the same identifiers. The node 0 is believed at its word; every other one
    has to tell this exoid's ConfigCrc.
    """
    sampled = [messages_of(0)[name].identifier for name in SAMPLED]
    found = [0] if np.isin(frames.identifier, sampled).any() else []
    others = range(1, node_count())
    return found + [node for node in others if told_crc(frames, node) == config_crc()]


def told_crc(frames: Frames, node: int) -> int | None:
    """The ConfigCrc of a node; None where it does not tell its time."""
    plan = messages_of(node)[TIME]
    clear = (frames.identifier == plan.identifier) & (frames.flags == 0)
    data = frames.data[clear & (frames.length == plan.length)]
    return int(np.median(plan.values(data, "ConfigCrc"))) if data.size else None


def read_by(frames: Frames, node: int) -> list[MessagePlan]:
    """The messages by which the node is read.

    Only a node that is known to send settings and heartbeat, what it learns, and a torque, is
    believed to be their sender.
    """
    own = (*RECORDED, FINE, *LEARNED, *COMMANDED)
    names = own if told_crc(frames, node) == config_crc() else MEASURED
    return [messages_of(node)[name] for name in names]
