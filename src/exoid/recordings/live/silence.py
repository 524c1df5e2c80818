"""Why nothing may come of a node, and what to check."""

from exoid.files.counted import counted
from exoid.recordings.can.node.which import MEASURED, messages_of

CHECK = (
    "Is this the node's port or bus, and is the node powered and flashed? On CAN check also the "
    "bit rate, the wiring and the termination."
)
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
        return something_else(bad)
    return f"nothing comes. {CHECK}"


def something_else(bad: int) -> str:
    """Of a channel on which so many lines came, and no frame."""
    return (
        f"{counted(bad, 'line')} came, no frames: something else speaks there. Is this the right "
        "port, and does the node run the firmware of exoid?"
    )
