"""Which quantities have pictures: the first, of which each shows something new."""

from collections.abc import Sequence

from exoid.studies.statistics.asked import Answer

# A variant has hardly another picture than what it is a variant of.
VARIANTS = {
    "expected_relaxation_index": "relaxation_index",
    "normalised_relaxation_index": "relaxation_index",
}


def pictured(each: Sequence[Answer]) -> list[Answer]:
    """Without variants of what is among them."""
    names = {one.quantity for one in each}
    return [one for one in each if VARIANTS.get(one.quantity) not in names]
