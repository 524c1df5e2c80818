"""Why nothing may come of a node, and what to check."""

from exoid.recordings.can.node.which import MEASURED, messages_of

SILENT_SINCE = "it has fallen silent. Is it still powered, and on the bus?"


def why_silent(others: bool, bad: int, node: int) -> str:
    """Of a node that was never heard: whether `others` were, and how many lines were no frames."""
    if others:
        first, last = (messages_of(node)[name].identifier for name in (MEASURED[0], MEASURED[-1]))
        return (
            f"others come and are recorded, but none of 0x{first:X} to 0x{last:X}. Is this its "
            "bus, is it powered, and is that its id (exoid node find, --node)? Frames of another "
            "device need its DBC to be read."
        )
    if bad:
        return (
            f"{bad} line(s) came that are no frames. Is this the right channel, with an slcan "
            "adapter on it?"
        )
    return (
        "the bus is silent. Check that the node is powered, the bit rate, the wiring and the "
        "termination."
    )
