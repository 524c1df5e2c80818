"""The pendulum test as JSON, for machines: the document's schema."""

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any

from exoid.pendulum.drops import Average, Drop, PendulumTest
from exoid.recordings.landmarks.measure import Measure
from exoid.report.document.plain_json import plain


def drops_document(
    test: PendulumTest, *, version: str, recordings: Sequence[Mapping[str, Any]]
) -> dict[str, Any]:
    """Every drop and the average in SI units and radians; null, with a reason, where not read."""
    return plain(
        {
            "exoid": version,
            "recordings": list(recordings),
            "drops": [drop(each) for each in test.drops],
            "average": {name: average(each) for name, each in test.average.items()},
            "left_out_of_average": test.left_out,
        }
    )


def drop(each: Drop) -> dict[str, Any]:
    """One segment."""
    return {
        "segment": each.name,
        "added_mass_kg": each.added_mass,
        "begins_s": each.segment.begins,
        "reason": each.reason,
        "measures": {name: measure(one) for name, one in each.measures.items()},
    }


def measure(each: Measure) -> dict[str, Any]:
    """One number, and where it is marked: sample, time in s, value on the curve in `unit`."""
    return {
        "title": each.title,
        "symbol": each.symbol,
        "unit": each.unit,
        "value": each.value,
        "standard_error": each.standard_error,
        "marks": [asdict(mark) for mark in each.marks],
        "reason": each.reason,
    }


def average(each: Average) -> dict[str, Any]:
    return {
        "title": each.title,
        "symbol": each.symbol,
        "unit": each.unit,
        "mean": each.mean,
        "standard_deviation": each.standard_deviation,
        "drops": each.drops,
    }
