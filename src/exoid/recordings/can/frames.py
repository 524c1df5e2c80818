"""The frames of a log as columns, and what kept the rest of it from being read."""

from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

import numpy as np
from jaxtyping import Float, Shaped, UInt8, UInt32

from exoid.recordings.can.decode import FrameData

# What sets a frame apart from a plain data frame with an 11-bit id.
EXTENDED = 1
REMOTE = 2
ERROR = 4
FD = 8
UNEVEN = 16  # its length field says otherwise than its data


class CanLogError(ValueError):
    """A log that cannot be used, in one line: what is wrong, where, and what to do."""


Same = TypeVar("Same", bound="Columns")


class Columns:
    """What has arrays of one length for its fields."""

    def where(self: Same, chosen: Shaped[np.ndarray, " row"]) -> Same:
        """The rows that a mask or an index array chooses."""
        return type(self)(**{name: column[chosen] for name, column in vars(self).items()})

    def followed_by(self: Same, *others: Same) -> Same:
        """These rows, then those of the others."""
        each = [vars(one) for one in (self, *others)]
        return type(self)(**{name: np.concatenate([one[name] for one in each]) for name in each[0]})


@dataclass(frozen=True, eq=False)
class Frames(Columns):
    """Frames in the order of the log, one row each."""

    time: Float[np.ndarray, " frame"]  # s, the recording computer's clock
    identifier: UInt32[np.ndarray, " frame"]
    flags: UInt8[np.ndarray, " frame"]
    length: UInt8[np.ndarray, " frame"]
    data: FrameData

    def __len__(self) -> int:
        return self.time.size


@dataclass(frozen=True, eq=False)
class Log:
    """What could be read of a log file, and what kept the rest from being read."""

    path: Path
    frames: Frames
    stopped: str | None = None  # what of the file could not be read, and why
    announced: int | None = None  # objects the file's header counts; BLF only
    found: int | None = None  # objects that are there; BLF only
