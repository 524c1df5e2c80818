"""Segments as the columns of one table, in exoid's own words and SI."""

from itertools import chain
from typing import Any

import numpy as np

from exoid.files.extras import require
from exoid.recordings.columns import CHANNELS, SEGMENT
from exoid.recordings.measured.segment import Segment


def flat(segments: tuple[Segment, ...]) -> dict[str, Any]:
    """`time_s`, `segment`, the channels that were measured, NaN where one was not, and the rest.

    **Raises** `ValueError` where an unknown column has the name of a known one.
    """
    sizes = [each.time.size for each in segments]
    measured = [each.channels() for each in segments]
    columns: dict[str, Any] = {
        name: np.concatenate(
            [
                each.get(field, np.full(size, np.nan))
                for each, size in zip(measured, sizes, strict=True)
            ]
        )
        for name, field in CHANNELS.items()
        if any(field in each for each in measured)
    }
    time = {"time_s": columns.pop("time_s"), SEGMENT: np.repeat(np.arange(len(sizes)), sizes)}
    texts = {
        name: [
            cell
            for each, size in zip(segments, sizes, strict=True)
            for cell in each.extra_columns.get(name, [""] * size)
        ]
        for name in chain(*(each.extra_columns for each in segments))
    }
    if twice := [name for name in texts if name in time | columns]:
        raise ValueError(f"column {twice[0]} is there twice. Delete or rename one.")
    return time | columns | texts


def frame_of(segments: tuple[Segment, ...]) -> Any:
    """The same as a data frame of pandas."""
    require("pandas", "a data frame is made")
    import pandas

    return pandas.DataFrame(flat(segments))
