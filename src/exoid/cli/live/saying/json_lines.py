"""A line of JSON for every moment, for other programs, as it comes."""

import json
import sys
from collections.abc import Callable, Iterable
from contextlib import suppress
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any, TextIO

from exoid.files.system_errors import told

if TYPE_CHECKING:
    from exoid.watching.estimate.moment import Moment, Quantity

STDOUT = Path("-")


class JsonLines:
    """Writes to a file, or to the standard output; every line is there when it is written.

    Where no more can be written, that is told, and the rest goes on without.
    """

    def __init__(self, path: Path, tell: Callable[[str], None]):
        self.path, self.tell = path, tell
        self.fault: OSError | None = None
        self.file: TextIO = (
            sys.stdout if path == STDOUT else path.open("w", encoding="utf-8", buffering=1)
        )

    def __call__(self, moment: "Moment") -> None:
        if self.fault is not None:
            return
        try:
            self.file.write(json.dumps(document(moment), allow_nan=False) + "\n")
            self.file.flush()
        except OSError as fault:
            self.fault = fault
            self.tell(f"{self.path} gets no more lines: {told(fault)} All else goes on.")

    @property
    def lost(self) -> bool:
        """Is it not whole, though its reader has not seen enough?"""
        return self.fault is not None and not isinstance(self.fault, BrokenPipeError)

    def close(self) -> None:
        if self.file is not sys.stdout:
            with suppress(OSError):  # what could not be written is still to be
                self.file.close()


def document(moment: "Moment") -> dict[str, Any]:
    """A moment in SI units; null where a number is missing, or cannot be believed."""
    others = {each.name: each for each in moment.others}
    return {
        "time_s": round(moment.time, 6),
        "state": {
            "phase": moment.phase.name.lower(),
            "angle_rad": number(moment.angle),
            "velocity_rad_s": number(moment.angular_velocity),
            "drops": moment.drops,
        },
        "trust": moment.trust.name.lower(),
        "ratios": listed(moment.ratios, moment.believed),
        "absolute": listed(
            [each for name, each in others.items() if "." not in name], moment.believed
        ),
        "terms": listed([each for name, each in others.items() if "." in name], moment.believed),
    }


def listed(quantities: Iterable["Quantity"], believed: bool) -> dict[str, dict[str, Any]]:
    return {
        each.name: {
            "value": number(each.value) if believed else None,
            "standard_error": number(each.error) if believed else None,
            "if_slack": each.if_slack if believed else None,
            "unit": each.unit,
        }
        for each in quantities
    }


def number(value: float) -> float | None:
    return value if isfinite(value) else None
