"""A recording from a data frame, from a mapping of arrays, or from arrays by keyword.

`exoid.recording(frame, subject={"body_mass": 77, "height": 1.8})`,
`exoid.recording(time_s=..., raw_angle_deg=...)`. A keyword is a column of exoid's table, such as
`time_s`, `raw_angle_deg`, `segment`, or a channel in SI (`time`, `angle`, `raw_angular_velocity`);
its value is an array, a list, a Series, or the name of a column of the data. What no keyword names
is taken where its name is a common one, with a warning that says how it was understood. `subject`,
`protocol` and `sensors` are those classes, or mappings of their fields or of a sidecar's keys;
`whole`, `flip`, `zero` and `columns` mean what they do in `exoid.load`.

This is also the folder of all that reads recordings, which can be called: a package hides any
function of its name.
"""

import sys
from inspect import Signature, signature
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from exoid.recording.recording import Recording


class Room(ModuleType):
    """The folder, which can be called as `recording_of`."""

    @property
    def __signature__(self) -> Signature:
        from exoid.recording.frame import recording_of

        return signature(recording_of)

    def __call__(self, data: Any = None, /, **named: Any) -> "Recording":
        from exoid.recording.frame import recording_of

        return recording_of(data, **named)


sys.modules[__name__].__class__ = Room
