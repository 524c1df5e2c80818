"""What is wrong with a bus or its port, in our words.

The operating system tells it by a number, which stands somewhere behind what python-can and
pyserial raise; their own words are for programmers.
"""

import errno
import re
import sys
from collections.abc import Iterator
from enum import StrEnum

from exoid.files.library_faults import plain

WINDOWS_NUMBER = re.compile(r"Error\((\d+),")  # pyserial quotes the error there

FULL = re.compile("buffer full|timeout|timed out", re.IGNORECASE)  # what python-can has no type for


class Fault(StrEnum):
    """What can be wrong."""

    ABSENT = "it is not there"
    FORBIDDEN = "this user may not use it"
    HELD = "another program reads it"
    UNPLUGGED = "it was unplugged, or has no power"
    NO_PORT = "it is no serial port"
    DOWN = "it is switched off"
    FULL = "what is sent stays in its buffer"
    UNKNOWN = "there is no such interface"
    NO_DRIVER = "its driver is missing here"
    UNFIT = "its driver knows no such channel, bit rate or option"


NUMBERS = {
    errno.ENOENT: Fault.ABSENT,
    errno.ENODEV: Fault.ABSENT,
    errno.ENXIO: Fault.ABSENT,
    errno.EACCES: Fault.FORBIDDEN,
    errno.EPERM: Fault.FORBIDDEN,
    errno.EBUSY: Fault.HELD,
    errno.EAGAIN: Fault.HELD,
    errno.EIO: Fault.UNPLUGGED,
    errno.EBADF: Fault.UNPLUGGED,
    errno.ENOTTY: Fault.NO_PORT,
    errno.EISDIR: Fault.NO_PORT,
    errno.EINVAL: Fault.UNFIT,
    errno.ENETDOWN: Fault.DOWN,
    errno.ENOBUFS: Fault.FULL,
    errno.ETIMEDOUT: Fault.FULL,
    errno.EAFNOSUPPORT: Fault.NO_DRIVER,
}
LOST = (Fault.ABSENT, Fault.NO_PORT)  # what a bus cannot have been that was open


def fault_of(raised: BaseException) -> Fault | str:
    """What is wrong, by what was raised; what no number and no type tells in its driver's words."""
    number = next(filter(None, map(number_of, chain(raised))), None)
    if number == errno.EACCES and sys.platform == "win32":
        return Fault.HELD  # there every user may use a port, and only one program at a time
    if number in NUMBERS:
        return NUMBERS[number]
    if FULL.search(str(raised)):
        return Fault.FULL
    if any(isinstance(each, ImportError | NotImplementedError) for each in chain(raised)):
        return Fault.NO_DRIVER
    if isinstance(raised, OSError) and type(raised) is OSError and number is None:
        return Fault.NO_DRIVER  # a library of the system that was not found
    if any(isinstance(each, ValueError | TypeError) for each in chain(raised)):
        return Fault.UNFIT
    return f'its driver says "{plain(str(raised)) or type(raised).__name__}"'


def loss_of(raised: BaseException) -> Fault | str:
    """What became of a bus that was open, by what was raised when it was used."""
    found = fault_of(raised)
    told = any(number_of(each) for each in chain(raised)) or not is_serial(raised)
    return Fault.UNPLUGGED if found in LOST or not told else found


def is_serial(raised: BaseException) -> bool:
    """Does it come from pyserial? Without a number it then means that nothing is there any more."""
    return any(type(each).__module__.startswith("serial") for each in chain(raised))


def chain(raised: BaseException) -> Iterator[BaseException]:
    """It, and one by one what led to it."""
    found: BaseException | None = raised
    while found is not None:
        yield found
        found = found.__cause__ or found.__context__


def number_of(raised: BaseException) -> int | None:
    """The operating system's number of an error, if it tells one."""
    if isinstance(raised, OSError) and raised.errno is not None:
        return raised.errno
    if type(raised).__module__ == "termios" and isinstance(raised.args[0], int):
        return raised.args[0]
    quoted = WINDOWS_NUMBER.search(str(raised)) if isinstance(raised, OSError) else None
    return int(quoted[1]) if quoted else None
