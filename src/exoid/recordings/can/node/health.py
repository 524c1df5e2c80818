"""What EXO_HEALTH tells: why the node started, and what it had to set up again."""

from exoid.files.counted import counted
from exoid.recordings.can.sort import MessageFrames

HEALTH = "EXO_HEALTH"
PASSIVE = 128  # errors, from which on a controller no longer stops the frames of others
CHECK = "Check the bit rate, the wiring, and that both ends of the bus carry 120 ohm"
CONDITIONS = {  # by the signal: from which count on, and what it then means
    "WatchdogReset": (
        1,
        "the node's watchdog has reset it (WatchdogReset): it had taken no sample for 125 ms",
    ),
    "BrownOutReset": (
        1,
        "the node's supply has dipped and reset it (BrownOutReset). Check battery and cable",
    ),
    "TransmitErrors": (
        PASSIVE,
        f"the node's CAN controller counts many errors of sending (TransmitErrors). {CHECK}",
    ),
    "ReceiveErrors": (
        PASSIVE,
        f"the node's CAN controller counts many errors of hearing (ReceiveErrors). {CHECK}",
    ),
    "CanOff": (
        1,
        "the node's CAN controller has left the bus for its errors (CanOff). Check whether its "
        "lines are shorted",
    ),
}


def health_lines(health: MessageFrames | None) -> tuple[str, ...]:
    """What a person should know of the node's health over a whole log."""
    if health is None or not health.order.size:
        return ()
    lines = [
        line for name, (least, line) in CONDITIONS.items() if health.values(name).max() >= least
    ]
    releases, starts = (int(health.values(name).max()) for name in ("BusReleases", "CanStarts"))
    if releases:
        lines.append(
            f"the node released its sensors' bus {counted(releases, 'time')} after a failed "
            "transfer"
        )
    if starts > 1:
        lines.append(f"the node set its CAN controller up {starts} times")
    return tuple(lines)
