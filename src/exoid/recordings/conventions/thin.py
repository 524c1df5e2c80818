"""Samples that come faster than anything on a leg: means over a millisecond are fitted."""

from dataclasses import replace

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.measured.samples import block_means, block_size
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

FINEST = 1e-3  # s; an angle that bends by 300 rad/s^2 departs from its mean by 1e-5 rad


def thinned(recording: Recording) -> tuple[Recording, Notes]:
    """The recording with at most 2000 samples a second, and what was averaged, said.

    A declared noise stays what it is: that of neighbours may be one error.
    """
    counts = [block_size(float(np.median(np.diff(s.time))), FINEST) for s in recording.segments]
    if max(counts) == 1:
        return recording, ()
    segments = [of_means(*each) for each in zip(recording.segments, counts, strict=True)]
    note = (
        f"sampled faster than a leg moves: means over {max(counts)} samples are used. 'exoid "
        "convert' keeps all."
    )
    return replace(recording, segments=tuple(segments)), (note,)


def of_means(segment: Segment, count: int) -> Segment:
    """A segment of the means over `count` samples each; of words, the one in the middle."""
    blocks = segment.time.size // count
    if count == 1 or blocks < 2:
        return segment
    channels = {name: block_means(each, count) for name, each in segment.channels().items()}
    words = {
        name: cells[count // 2 :: count][:blocks] for name, cells in segment.extra_columns.items()
    }
    return replace(segment, **channels, extra_columns=words)
