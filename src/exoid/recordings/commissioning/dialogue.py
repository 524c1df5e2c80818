"""Asking the nodes of a bus, and telling one of them what to do."""

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from math import degrees

from exoid.files.counted import counted
from exoid.recordings.commissioning.commands import EVERYBODY, SET_ZERO, TELL, command
from exoid.recordings.commissioning.ear import Ear
from exoid.recordings.commissioning.node_state import NodeState
from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import CanBusError
from exoid.recordings.live.silence import CHECK, something_else

ROUNDS = 3  # a frame may be lost: how often a question is asked
PATIENCE = 0.4  # s for an answer, which takes a node 20 ms
STILLNESS = 0.3  # s for which a knee must be still before its angle is taken
STILL = 0.05  # rad/s, a few times the noise of the filtered rate

NOT_WHOLE = "NotWhole"
REASONS = {
    "NoAngle": "has no angle: its encoder does not answer or sees no magnet. Nothing was changed; "
    "check cable and magnet.",
    "NotPossible": "cannot do that: its CAN controller's crystal is too slow for the bit rate. "
    "Nothing was changed; choose a lower one.",
    "NotStored": "could not store it: it counts until the power goes. Repeat it; if that does not "
    "help, the flash is worn.",
    NOT_WHOLE: "did not get the parameters in one piece and keeps those before. Repeat it.",
    "NotPlausible": "does not take these parameters for a leg's and keeps those before.",
}


class NotWholeError(CanBusError):
    """Parts of the parameters did not come in their order."""


class Dialogue:
    """Questions and answers over a bus."""

    def __init__(self, bus: LiveBus):
        self.bus = bus

    def find(self) -> list[NodeState]:
        """The nodes that answer, by their ids.

        **Raises** `CanBusError` where none does, with what to check.
        """
        ear = Ear()
        for _ in range(ROUNDS):
            self.bus.send(command(TELL, EVERYBODY))
            self.listen(ear, PATIENCE, lambda: False)
        if not ear.settings:
            raise CanBusError(self.silence(ear))
        return ear.nodes()

    def order(self, to: NodeState, name: str, **values: float | int) -> NodeState:
        """Have a node do something; what it tells of itself afterwards.

        **Raises** `CanBusError` where it does not answer, or could not do it.
        """
        sent = command(name, to.serial, **values)
        for _ in range(ROUNDS):
            ear = Ear()
            self.bus.send(sent)

            def answered(ear: Ear = ear) -> bool:
                reply = ear.reply(to.serial, sent.arbitration_id)
                return reply is not None and to.serial in ear.settings

            if self.listen(ear, PATIENCE, answered):
                refuse(to, ear.reply(to.serial, sent.arbitration_id) or {})
                now = next(state for state in ear.nodes() if state.serial == to.serial)
                return replace(now, health=now.health or to.health)  # which it tells by the second
        raise CanBusError(
            f"{to} does not answer to {name}. Is it still powered, and does another device on the "
            "bus hold it busy? exoid node find says who answers."
        )

    def zero(self, to: NodeState, angle: float) -> NodeState:
        """Let the angle of a knee that is held still be `angle` [rad].

        **Raises** `CanBusError` for a knee that moves or is not seen, and as `order` does.
        """
        ear = Ear()
        self.listen(ear, STILLNESS, lambda: False)
        if to.node not in ear.speeds:
            raise CanBusError(
                f"{to} answers, but sends no EXO_STATE, which tells whether the knee is still: its "
                "angle was not taken. exoid node show says whether its sensors answer; check "
                "their cables and the load of the bus, and repeat."
            )
        fastest = max(ear.speeds[to.node])
        if fastest > STILL:
            raise CanBusError(
                f"the knee of {to} moves at {degrees(fastest):.0f} deg/s: its angle was not taken. "
                "Hold it still and repeat."
            )
        return self.order(to, SET_ZERO, Angle=angle)

    def listen(self, ear: Ear, seconds: float, enough: Callable[[], bool]) -> bool:
        """Hear what comes, until it is enough or the time is over; whether it was enough."""
        end = time.monotonic() + seconds
        while not enough():
            if time.monotonic() >= end:
                return False
            message = self.bus.receive()
            if message is not None:
                ear.hear(message)
        return True

    def silence(self, ear: Ear) -> str:
        """Why no node may have answered."""
        where = f"no node answers on {self.bus.address}"
        if ear.speeds:
            ids = ", ".join(map(str, sorted(ear.speeds)))
            return (
                f"{where}, but one sends (id {ids}): its firmware is older than these commands. "
                "Flash it with the firmware of this exoid."
            )
        if ear.others:
            return (
                f"{where}, but {counted(ear.others, 'frame')} of others came. Is this its bus, and "
                "is the node powered?"
            )
        if self.bus.bad:
            return f"{where}: {something_else(self.bus.bad)}"
        return f"{where} at {self.bus.address.bitrate} bit/s. {CHECK}"


def refuse(to: NodeState, reply: Mapping[str, float]) -> None:
    """Raise where the node could not do what it was told."""
    for signal, reason in REASONS.items():
        if reply.get(signal):
            kind = NotWholeError if signal == NOT_WHOLE else CanBusError
            raise kind(f"{to} {reason}")
