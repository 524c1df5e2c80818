"""Two recordings that say the same."""

import numpy as np

from exoid.recordings.recording import Recording, known


def assert_same(one: Recording, other: Recording) -> None:
    """Every sample, bit for bit, every known key, and what is kept of the unknown ones."""
    assert len(one.segments) == len(other.segments)
    for mine, theirs in zip(one.segments, other.segments, strict=True):
        assert mine.channels().keys() == theirs.channels().keys()
        for name, samples in mine.channels().items():
            np.testing.assert_array_equal(samples, theirs.channels()[name])
        assert mine.extra_columns == theirs.extra_columns
    for table in ("subject", "protocol", "sensors"):
        mine, theirs = getattr(one, table), getattr(other, table)
        for entry in known(mine):
            np.testing.assert_equal(getattr(mine, entry.name), getattr(theirs, entry.name))
        assert mine.extra_keys == theirs.extra_keys
    assert one.extra_tables == other.extra_tables
