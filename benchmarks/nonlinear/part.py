"""A recording's first part, on which a model is made, and what of it comes later."""

from dataclasses import replace

from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import cut

EARLY = 0.6  # of a single segment


def first_part(recording: Recording) -> Recording:
    """The first segment of several; of a single one its beginning."""
    first = recording.segments[0]
    if len(recording.segments) == 1:
        first = cut(first, slice(0, int(EARLY * first.time.size)))
    return replace(recording, segments=(first,))


def later_part(recording: Recording) -> Recording:
    """The other segments; of a single one its end, on a clock of its own."""
    only, *others = recording.segments
    if others:
        return replace(recording, segments=tuple(others))
    later = cut(only, slice(int(EARLY * only.time.size), only.time.size))
    return replace(recording, segments=(later,))
