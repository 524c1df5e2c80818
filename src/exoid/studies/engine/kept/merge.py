"""What the steps of a study say of each recording, in one row."""

from collections import defaultdict
from collections.abc import Mapping

import pyarrow as pa


def merge(steps: Mapping[str, pa.Table]) -> pa.Table:
    """A row for every name in the tables of the steps: as the first has it that could read the
    recording, with the reasons of all that failed.
    """
    every = pa.concat_tables(steps.values())
    names, told, samples = (every[each].to_pylist() for each in ("name", "status", "samples"))
    first: dict[str, int] = {}
    for at in sorted(range(len(names)), key=lambda at: samples[at] is None):
        first.setdefault(names[at], at)
    rows = every.take(pa.array(first.values(), pa.int64()))
    failed = failures(steps)
    status = ["failed" if name in failed else told[at] for name, at in first.items()]
    reasons = [reason(failed.get(name, {}), samples[at] is not None) for name, at in first.items()]
    return with_column(with_column(rows, "status", status), "reason", reasons)


def with_column(rows: pa.Table, name: str, cells: list[str]) -> pa.Table:
    """The rows with other words in a column."""
    return rows.set_column(rows.schema.get_field_index(name), name, pa.array(cells, pa.string()))


def failures(steps: Mapping[str, pa.Table]) -> dict[str, dict[str, str]]:
    """By the name of every recording of which steps failed, why each did."""
    found: dict[str, dict[str, str]] = defaultdict(dict)
    for step, table in steps.items():
        for row in table.select(["name", "status", "reason"]).to_pylist():
            if row["status"] == "failed":
                found[row["name"]][step] = row["reason"]
    return found


def reason(failed: Mapping[str, str], read: bool) -> str:
    """Why steps failed, each by its name; of what no step could read, each reason once."""
    if not read:
        return " ".join(dict.fromkeys(failed.values()))
    return " ".join(f"{step}: {why}" for step, why in failed.items())
