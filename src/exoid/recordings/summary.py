"""What a recording is, in a line for the prompt and in a small table for a notebook."""

from collections import Counter
from collections.abc import Iterable
from html import escape
from typing import Any

import numpy as np


def line(recording: Any) -> str:
    """How many segments of which kind, how long, which channels, and of whom."""
    segments = recording.segments
    count = f"{len(segments)} segment{'s' if len(segments) > 1 else ''}"
    kinds = Counter(recording.kind(number) or "of unknown kind" for number in range(len(segments)))
    parts = [
        f"{count} ({', '.join(f'{each} {kind}' for kind, each in kinds.items())})",
        f"{sum(each.duration for each in segments):.1f} s",
        f"{sum(each.time.size for each in segments)} samples",
        " + ".join(dict.fromkeys(name for each in segments for name in [*each.channels()][1:])),
        subject(recording.subject),
    ]
    return f"<Recording: {', '.join(parts)}>"


def page(recording: Any) -> str:
    """A row for each segment, as HTML."""
    rows = [
        (
            number,
            recording.kind(number) or "",
            f"{each.duration:.2f}",
            each.time.size,
            f"{recording.added_mass(number):g}",
            span(each),
        )
        for number, each in enumerate(recording.segments)
    ]
    head = ("segment", "kind", "s", "samples", "added kg", "angle, deg")
    return html_table(line(recording)[1:-1], head, rows)


def subject(one: Any) -> str:
    """Whose leg it is, as far as it is known."""
    known = [
        f"{value:g} {unit}"
        for value, unit in ((one.body_mass, "kg"), (one.height, "m"))
        if value is not None
    ]
    return ", ".join([one.kind or "subject unknown", *known])


def span(segment: Any) -> str:
    """The angle's range in degrees."""
    low, high = np.degrees([np.nanmin(segment.best_angle), np.nanmax(segment.best_angle)])
    return f"{low:.1f} .. {high:.1f}"


def html_table(title: str, head: Iterable[Any], rows: Iterable[Iterable[Any]]) -> str:
    """A title above a table, everything escaped."""
    cells = "".join(f"<th>{escape(str(each))}</th>" for each in head)
    body = "".join(
        f"<tr>{''.join(f'<td>{escape(str(each))}</td>' for each in row)}</tr>" for row in rows
    )
    return (
        f"<p>{escape(title)}</p><table><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table>"
    )
