"""From a live bus to a log file, frame by frame, until somebody says enough."""

from collections.abc import Callable

import can

from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.log_file import LogFile, Unkept
from exoid.recordings.live.watch import Watch


def record(
    bus: LiveBus,
    log: LogFile | Unkept,
    watch: Watch,
    going: Callable[[], bool],
    hear: Callable[[can.Message], None] = lambda message: None,
) -> None:
    """Write every frame that comes and is wanted, as long as `going`; `hear` gets each, too.

    That is asked at least every 50 ms.

    **Raises** `CanLogError` when the disk takes no more. The bus may go and come back.
    """
    while going():
        message = bus.receive()
        if message is not None:
            if watch.is_wanted(message):
                log.write(message)
                watch.see(message)
                hear(message)
            continue
        log.save()
        if bus.gone is None:
            watch.check_silence(bus.bad)
