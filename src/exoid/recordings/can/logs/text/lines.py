"""The lines of a text log, as python-can's readers take them: none that is damaged among them."""

from pathlib import Path

from exoid.files.counted import counted
from exoid.recordings.can.logs.text.asc import asc_check, is_event
from exoid.recordings.can.logs.text.candump import candump_check
from exoid.recordings.can.logs.text.own_csv import csv_check
from exoid.recordings.can.logs.text.sound import Sound
from exoid.recordings.can.logs.text.trc import trc_check

CHECKS = {".asc": asc_check, ".log": candump_check, ".csv": csv_check, ".trc": trc_check}
MOST_DAMAGED = 1000  # lines; a file with more is another kind of file


class Lines:
    """The lines of a text log with the number of the last, and what is left out of them.

    python-can's readers take a byte of one digit for a byte and read past a ninth one; a line that
    is not written as its format writes frames never comes to them. A last line without its end was
    cut inside a frame: it is left out, too.
    """

    def __init__(self, path: Path, kind: str):
        text = path.read_text(encoding="utf-8", errors="replace")
        complete = text.rfind("\n") + 1
        self.lines = text[:complete].split("\n")[:-1]
        self.first = self.lines[0] if self.lines else text
        self.sound: Sound = CHECKS[kind](self.lines)
        self.number = 0
        self.damaged: list[str] = []
        # ASC's reader takes the first line below a header for its end, were it a frame.
        self.begun = kind != ".asc"
        self.blank_first = False
        rest = text[complete:].strip()
        self.cut = f"line {len(self.lines) + 1} is cut short and left out" if rest else None

    def __iter__(self) -> "Lines":
        return self

    def __next__(self) -> str:
        if self.blank_first:
            self.blank_first = False
            return "\n"
        while self.number < len(self.lines) and len(self.damaged) < MOST_DAMAGED:
            line = self.lines[self.number]
            if not self.begun and is_event(line):
                self.begun = True
                return "\n"
            self.number += 1
            if self.sound(line):
                return line + "\n"
            self.leave_out("no frame of this format")
        raise StopIteration

    def leave_out(self, fault: str) -> bool:
        """Count the last line among the damaged ones, and say whether to go on."""
        self.damaged.append(f"line {self.number} ({fault})")
        return len(self.damaged) < MOST_DAMAGED

    def close(self) -> None:
        """The readers close what they have read; there is nothing to close."""


def told(damaged: list[str], cut: str | None) -> str | None:
    """What was left out of a text log, in words."""
    faults = (
        [f"{counted(len(damaged), 'damaged line')} left out, first {damaged[0]}"] if damaged else []
    )
    if len(damaged) >= MOST_DAMAGED:
        faults.append("and what follows them not read")
    return "; ".join([*faults, *([cut] if cut else [])]) or None
