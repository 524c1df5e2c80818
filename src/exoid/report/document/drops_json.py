"""The pendulum test as JSON, for machines: the document's schema."""

from collections.abc import Mapping, Sequence
from typing import Any

from exoid.pendulum.drop import Drop, PendulumTest
from exoid.report.document.plain_json import plain, shown


def drops_document(
    test: PendulumTest, *, version: str, recordings: Sequence[Mapping[str, Any]]
) -> dict[str, Any]:
    """Every drop and the average in SI units and radians; null, with a reason, where not read."""
    return plain(
        {
            "exoid": version,
            "recordings": list(recordings),
            "drops": [drop(each) for each in test.drops],
            "average": {name: shown(each, ["name"]) for name, each in test.average.items()},
            "left_out_of_average": test.left_out,
        }
    )


def drop(each: Drop) -> dict[str, Any]:
    """One segment. A measure is marked at a sample, its time in s, and a value on the curve."""
    return {
        "segment": each.name,
        "added_mass_kg": each.added_mass,
        "begins_s": each.segment.begins,
        "reason": each.reason,
        "note": each.note,
        "halt": each.halt,
        "measures": {name: shown(one, ["name"]) for name, one in each.measures.items()},
    }
