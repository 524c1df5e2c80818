"""Refuses what is declared of a recording where it cannot be true."""

from exoid.files.counted import counted
from exoid.recordings.declared.entry import check_word, known
from exoid.recordings.declared.unit_hint import unit_hint


def check_entries(table, segments: int) -> None:
    """Refuses an entry that cannot be true, or that is not one for each segment."""
    for entry in known(table):
        check_entry(entry.metadata, getattr(table, entry.name), segments)


def check_entry(meta, value, segments: int | None) -> None:
    """Refuses an entry that cannot be true; its count only where `segments` is known."""
    if value is None:
        return
    key = meta["key"]
    values = value if isinstance(value, tuple) else (value,)
    if isinstance(value, tuple) and segments is not None and len(value) != segments:
        raise ValueError(
            f"{key} lists {counted(len(value), 'value')} for {counted(segments, 'segment')}. "
            "Give one for each."
        )
    for each in values:
        check_word(meta, each)
        if isinstance(value, tuple) and each != each:
            continue  # nan in a list: this segment has none, as a passive one has no period
        if "lower" in meta and not meta["lower"] <= each <= meta["upper"]:
            raise ValueError(
                f"{key} is {each:g} {meta['unit']}; it must lie between "
                f"{meta['lower']:g} and {meta['upper']:g}."
                f"{unit_hint(key, meta['unit'], each, (meta['lower'], meta['upper']))}"
            )
