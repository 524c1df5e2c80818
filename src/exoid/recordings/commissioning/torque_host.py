"""A host that lets a node command a torque, for as long as it lives."""

import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass

import can

from exoid.recordings.commissioning.commands import ALLOW, command
from exoid.recordings.commissioning.ear import Ear
from exoid.recordings.commissioning.node_state import NodeState
from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import CanBusError

OFF, ARM, ENABLE = range(3)  # what a host may wish
DISABLED, ARMED, ENABLED = range(3)  # what a node permits itself
INTERVAL = 0.02  # s between two frames; a node that hears none for 0.1 s is disabled
ARMING = 2.0  # s in which a node is armed that has no doubt
LEAVING = 0.2  # s in which a node that is asked to is disabled
NUMBERS = 16
DOUBTS = (
    *("its encoder does not answer", "its encoder sees no magnet", "its magnet is weak or strong"),
    *("its inertial sensor does not answer", "its gyro is saturated", "its state is saturated"),
    *("its filter has just started", "it was late or has lost a frame"),
    *("its angle is stale: encoder and gyro do not agree, or have just begun to be heard",),
    *("it holds no whole parameters", "its torque is no finite number"),
    *("it did not hear this host", "a host has switched it off"),
)


@dataclass(frozen=True)
class Commanded:
    """What a node told last of its torque."""

    torque: float  # N m
    permit: int
    doubts: tuple[str, ...]


class TorqueHost:
    """Arms a node, enables it, and keeps saying so. `limit` [N m] is in steps of 0.25."""

    def __init__(self, bus: LiveBus, to: NodeState, limit: float):
        self.bus = bus
        self.to = to
        self.limit = limit
        self.number = 0
        self.told: Commanded | None = None  # last

    def arm(self) -> None:
        """**Raises** `CanBusError` where it is not armed, with what stands against it."""
        if self.keep_saying(ARM, ARMING, lambda now: now.permit != ARMED):
            told = self.told
            why = "; ".join(told.doubts) if told else "it tells no torque: is its firmware older?"
            raise CanBusError(f"{self.to} is not armed: {why}.")

    def enable(self, seconds: float, tell: Callable[[Commanded], object]) -> Commanded | None:
        """Have the torque commanded for so long; what ended it before, or None.

        `tell` is called with all that the node tells.
        """

        def goes_on(now: Commanded) -> bool:
            tell(now)
            return now.permit != DISABLED

        return None if self.keep_saying(ENABLE, seconds, goes_on) else self.told

    def stop(self) -> None:
        """The torque is 0; if the bus is gone, because the node hears nothing any more."""
        with suppress(CanBusError):
            self.keep_saying(OFF, LEAVING, lambda now: now.permit != DISABLED)

    def keep_saying(self, wish: int, seconds: float, goes_on: Callable[[Commanded], bool]) -> bool:
        """Whether the time was over before what the node told ended it."""
        end, due = time.monotonic() + seconds, 0.0
        while (now := time.monotonic()) < end:
            if now >= due:
                self.say(wish)
                due = now + INTERVAL
            told = self.heard(self.bus.receive())
            if told is not None and not goes_on(told):
                return False
        return True

    def say(self, wish: int) -> None:
        self.number = (self.number + 1) % NUMBERS
        said = {"Wish": wish, "Number": self.number, "Limit": self.limit}
        self.bus.send(command(ALLOW, self.to.serial, **said))

    def heard(self, message: can.Message | None) -> Commanded | None:
        """What a frame says of this node's torque."""
        ear = Ear()
        if message is not None:
            ear.hear(message)
        told = ear.torques.get(self.to.node)
        if told is None:
            return None
        self.told = commanded(told)
        return self.told


def commanded(told: Mapping[str, float]) -> Commanded:
    bits = int(told["Doubts"])
    doubts = tuple(words for bit, words in enumerate(DOUBTS) if bits >> bit & 1)
    return Commanded(told["Torque"], int(told["Permit"]), doubts)
