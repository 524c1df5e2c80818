"""Which segments are fitted where there are more than one fit takes."""

import numpy as np

from exoid.fitting.amount.part import Part


def spread(parts: list[Part], most: int) -> list[Part]:
    """At most so many, evenly over the session and over the ways in which they were recorded.

    A setup of few segments keeps them all: two loaded drops among a thousand bare ones tell more
    than any two of those.
    """
    if len(parts) <= most:
        return parts
    setups: dict[tuple, list[int]] = {}
    for at, part in enumerate(parts):
        setups.setdefault(setup(part), []).append(at)
    kept: list[int] = []
    groups = sorted(setups.values(), key=len)
    for turn, own in enumerate(groups):
        share = (most - len(kept)) // (len(groups) - turn)
        kept += [own[at] for at in evenly(len(own), share)]
    return [parts[at] for at in sorted(kept)]


def setup(part: Part) -> tuple:
    """What segments differ by on purpose."""
    recording, number = part.recording, part.number
    return (
        part.belongs,
        recording.kind(number),
        recording.added_mass(number),
        recording.added_mass_distance(number),
        recording.thigh_angle(number),
    )


def evenly(count: int, most: int) -> list[int]:
    """At most so many of the numbers below `count`, each from the middle of its share."""
    if count <= most:
        return list(range(count))
    return [int(at) for at in np.floor((np.arange(most) + 0.5) * count / most)]
