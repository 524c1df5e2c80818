"""A node on a serial cable: slcan lines on one end of a pseudo terminal, a port at the other."""

import fcntl
import os
import pty
import select
import sys
import termios
import threading
import time
import tty
from contextlib import suppress
from pathlib import Path

import can

KEPT = 0.7  # s within which a recorder on a busy machine has kept what it read
NO_WAIT = {"sleep_after_open": 0}  # s that python-can gives an Arduino to start


def line(message: can.Message) -> bytes:
    return f"t{message.arbitration_id:03X}{message.dlc}{message.data.hex()}\r".encode()


def numbered(count: int, identifier: int = 0x200) -> list[can.Message]:
    """Frames of somebody else, each with its number."""
    return [
        can.Message(arbitration_id=identifier, is_extended_id=False, data=at.to_bytes(8, "big"))
        for at in range(count)
    ]


class Cable:
    """A serial port at `path` that can be pulled out and plugged in again."""

    def __init__(self, path: Path):
        self.path = path
        self.plug_in()

    def plug_in(self) -> None:
        self.out = threading.Event()
        self.streams: list[threading.Thread] = []
        self.end, self.port = pty.openpty()
        tty.setraw(self.end)
        tty.setraw(self.port)
        os.set_blocking(self.end, False)
        self.path.unlink(missing_ok=True)
        self.path.symlink_to(os.ttyname(self.port))

    def pull_out(self) -> None:
        self.out.set()
        for thread in self.streams:
            thread.join()
        for each in (self.port, self.end):
            with suppress(OSError):
                os.close(each)
        self.path.unlink(missing_ok=True)

    def send(self, *messages: can.Message) -> None:
        self.write(b"".join(map(line, messages)))

    def write(self, content: bytes) -> None:
        while content and not self.out.is_set():
            with suppress(BlockingIOError):  # nobody reads: the port takes no more for now
                content = content[os.write(self.end, content) :]

    def heard(self) -> bytes:
        """What the other side has written: it waits until the other side has opened the port."""
        select.select([self.end], [], [])
        return os.read(self.end, 100)

    def heard_out(self) -> None:
        """Take all that the other side has written: a terminal hands it on in parts."""
        self.heard()
        while select.select([self.end], [], [], KEPT)[0]:
            os.read(self.end, 100)

    def taken(self) -> None:
        """Wait until the other side has read all that was sent, and had time to keep it."""
        while int.from_bytes(fcntl.ioctl(self.port, termios.FIONREAD, bytes(4)), sys.byteorder):
            time.sleep(0.01)
        time.sleep(KEPT)

    def let_go(self, sending: threading.Thread) -> None:
        """What is still sent goes nowhere: the other side has ended."""
        while sending.is_alive():
            termios.tcflush(self.port, termios.TCIFLUSH)
            time.sleep(0.01)

    def stream(self, messages: list[can.Message], rate: float) -> threading.Thread:
        """Send so many frames a second, each at its own time."""

        def run() -> None:
            begin = time.perf_counter()
            for number, message in enumerate(messages):
                if self.out.wait(max(0.0, begin + number / rate - time.perf_counter())):
                    return
                self.send(message)

        thread = threading.Thread(target=run, daemon=True)
        self.streams.append(thread)
        thread.start()
        return thread
