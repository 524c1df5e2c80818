"""Downloading the parameters of a torque to a node."""

from exoid.recordings.commissioning.commands import LOAD
from exoid.recordings.commissioning.dialogue import ROUNDS, Dialogue, NotWholeError
from exoid.recordings.commissioning.ear import Ear
from exoid.recordings.commissioning.node_state import NodeState
from exoid.recordings.commissioning.told_parameters import HeldParameters
from exoid.recordings.commissioning.torque_parameters import PART, PARTS, TorqueParameters
from exoid.recordings.live.channel.address import CanBusError

TELLING = 2.0  # s in which a node that tells twenty a second has told all of them


def download(dialogue: Dialogue, to: NodeState, parameters: TorqueParameters) -> HeldParameters:
    """Have a node command its torque by these; what it then holds, as it tells it.

    It takes them over all at once or not at all, and commands no torque until it is armed anew.

    **Raises** `CanBusError` where it does not take them, or tells other ones.
    """
    parameters.check()
    for left in reversed(range(ROUNDS)):
        try:
            send(dialogue, to, parameters)
            break
        except NotWholeError:
            if not left:
                raise
    return told(dialogue, to, parameters.crc)


def send(dialogue: Dialogue, to: NodeState, parameters: TorqueParameters) -> None:
    """Part by part, each of which is acknowledged; last their CRC."""
    data = parameters.data
    pairs = [int.from_bytes(data[PART * at : PART * (at + 1)], "little") for at in range(PARTS)]
    for place, pair in enumerate([*pairs, parameters.crc]):
        dialogue.order(to, LOAD, Place=place, Data=pair)


def told(dialogue: Dialogue, to: NodeState, crc: int) -> HeldParameters:
    """What the node tells that it holds."""
    ear = Ear()

    def held() -> HeldParameters | None:
        parameters = ear.parameters.get(to.node)
        found = parameters and parameters.held()
        return found if found and found.crc == crc else None

    dialogue.listen(ear, TELLING, lambda: held() is not None)
    found = held()
    if found is None or not found.whole:
        raise CanBusError(
            f"{to} has acknowledged the parameters, but does not tell them. exoid node show says "
            "what it holds; repeat the command."
        )
    return found
