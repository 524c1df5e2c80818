"""A serial port has one reader: two would each get half of the lines, and neither would know."""

from errno import EAGAIN, EBUSY
from typing import Any

URL = "://"  # a port of another kind, which a second opening may disturb


def check_free(channel: str) -> None:
    """Look before python-can writes to the port. **Raises** `OSError` where another holds it."""
    from serial import Serial

    if URL in channel:
        return
    try:
        Serial(channel.partition("@")[0], exclusive=True).close()
    except OSError as fault:
        if fault.errno in (EAGAIN, EBUSY):
            raise
        # What else is wrong with it python-can says when it opens the port.


def hold(port: Any) -> None:
    """Keep an open port from others until it is closed."""
    if URL not in str(port.port):
        port.exclusive = True
