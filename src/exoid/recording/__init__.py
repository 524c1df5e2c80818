"""What was measured. Called, this folder is `exoid.recording`: a recording from arrays in memory.

A package hides any function of its name, so it is made to be that function too.
"""

import sys
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from exoid.recording.recording import Recording


class Room(ModuleType):
    """The folder, which can be called as `recording_of`."""

    def __call__(self, data: Any = None, /, **named: Any) -> "Recording":
        from exoid.recording.frame import recording_of

        return recording_of(data, **named)


sys.modules[__name__].__class__ = Room
