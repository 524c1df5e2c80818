"""What the nodes of a bus say, gathered frame by frame."""

from collections.abc import Iterator, Mapping
from dataclasses import replace

import can
import numpy as np

from exoid.recordings.can.decode import MessagePlan
from exoid.recordings.can.node.commissioned import HEARTBEAT, SETTINGS
from exoid.recordings.can.node.health import HEALTH
from exoid.recordings.can.node.rows import STATE
from exoid.recordings.can.node.which import senders
from exoid.recordings.commissioning.node_state import Health, NodeState, health_of, state_of
from exoid.recordings.commissioning.told_parameters import ToldParameters

REPLY = "EXO_REPLY"
PARAMETER = "EXO_PARAMETER"
TORQUE = "EXO_TORQUE"


class Ear:
    """Settings by serial, health and speeds by node id, and the replies to commands."""

    def __init__(self):
        self.settings: dict[int, tuple[int, Mapping[str, float]]] = {}
        self.beats: dict[int, Mapping[str, float]] = {}
        self.healths: dict[int, Mapping[str, float]] = {}
        self.speeds: dict[int, list[float]] = {}  # rad/s, magnitudes
        self.parameters: dict[int, ToldParameters] = {}
        self.torques: dict[int, Mapping[str, float]] = {}  # the last of each node
        self.replies: list[Mapping[str, float]] = []
        self.others = 0  # frames that are no node's

    def hear(self, message: can.Message) -> None:
        """Take in a frame, of whomever it is."""
        if message.is_extended_id or message.is_remote_frame or message.is_error_frame:
            return
        node, plan = senders().get(message.arbitration_id, (0, None))
        if plan is None or len(message.data) != plan.length:
            self.others += 1
            return
        if plan.name == STATE:
            speed = abs(values_of(plan, message)["AngularVelocity"])
            self.speeds.setdefault(node, []).append(speed)
        elif plan.name == SETTINGS:
            values = values_of(plan, message)
            self.settings[int(values["Serial"])] = (node, values)
        elif plan.name == HEARTBEAT:
            self.beats[node] = values_of(plan, message)
        elif plan.name == HEALTH:
            self.healths[node] = values_of(plan, message)
        elif plan.name == PARAMETER:
            self.parameters.setdefault(node, ToldParameters()).hear(values_of(plan, message))
        elif plan.name == TORQUE:
            self.torques[node] = values_of(plan, message)
        elif plan.name == REPLY:
            self.replies.append(values_of(plan, message))

    def nodes(self) -> list[NodeState]:
        """Who has told its settings, by node id."""
        return sorted(self.told(), key=lambda state: (state.node, state.serial))

    def told(self) -> Iterator[NodeState]:
        """A node that only measures tells none."""
        for node, values in self.settings.values():
            parameters = self.parameters.get(node)
            held = parameters and parameters.held()
            yield replace(state_of(node, values, self.health(node)), parameters=held)

    def health(self, node: int) -> Health | None:
        """How the node of this id is, once it has told all of it."""
        if node not in self.beats or node not in self.healths:
            return None
        return health_of(self.beats[node], self.healths[node])

    def reply(self, serial: int, command: int) -> Mapping[str, float] | None:
        """What a node said of a command with that identifier."""
        for each in self.replies:
            if (each["Serial"], each["Command"]) == (serial, command):
                return each
        return None


def values_of(plan: MessagePlan, message: can.Message) -> Mapping[str, float]:
    """The signals of one frame, in their units."""
    frame = np.frombuffer(bytes(message.data), np.uint8).reshape(1, -1)
    return {name: float(values[0]) for name, values in plan.decode(frame).items()}
