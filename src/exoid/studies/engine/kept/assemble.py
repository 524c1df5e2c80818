"""The two tables of a study, from what its batches kept."""

from collections.abc import Iterable, Mapping
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from exoid.files.replacing import replacing
from exoid.studies.dataset.entry import Dataset
from exoid.studies.dataset.recording_of import person_of
from exoid.studies.engine.kept.parts import quantities_beside
from exoid.studies.engine.kept.tables import QUANTITIES, RECORDINGS

ROWS = 1 << 18  # of a group in a file


def assemble(
    results: Path,
    found: Mapping[Path, Mapping[str, str]],
    others: Iterable[Mapping[str, object]],
    dataset: Dataset,
) -> pa.Table:
    """Write `recordings.parquet` and `quantities.parquet`; the recordings are returned.

    `found` are the keys to take from every part, each with the name that its recording now has;
    `others` the rows of recordings that have no part. The order is that of names: whatever the
    order of computing was, the files are the same to the last byte.
    """
    recordings, quantities = [RECORDINGS.empty_table()], [QUANTITIES.empty_table()]
    for part, names in found.items():
        recordings.append(renamed(pq.read_table(part), names))
        quantities.append(renamed(pq.read_table(quantities_beside(part)), names))
    recordings.append(pa.Table.from_pylist(list(others), RECORDINGS))
    whole = pa.concat_tables(recordings).sort_by("name").drop_columns(["key"])
    whole = with_participants(whole, dataset)
    order = [("name", "ascending"), ("order", "ascending")]
    each = pa.concat_tables(quantities).sort_by(order).drop_columns(["key", "order"])
    put(results / "quantities.parquet", each)
    put(results / "recordings.parquet", whole)  # last: whose quantities are there, too
    return whole


def renamed(table: pa.Table, names: Mapping[str, str]) -> pa.Table:
    """The rows of these keys, under the names that their recordings have now."""
    wanted = [key in names for key in table["key"].to_pylist()]
    chosen = table.filter(pa.array(wanted, pa.bool_()))
    name = pa.array([names[key] for key in chosen["key"].to_pylist()], pa.string())
    return chosen.set_column(chosen.schema.get_field_index("name"), "name", name)


def with_participants(table: pa.Table, dataset: Dataset) -> pa.Table:
    """With the other columns of the table of participants."""
    names = dict.fromkeys(name for each in dataset.participants.values() for name in each.more)
    people = [person_of(each or "", dataset).more for each in table["participant"].to_pylist()]
    for name in names:
        cells = [each.get(name) for each in people]
        numbers = all(isinstance(each, float | None) for each in cells)
        words = [None if each is None else str(each) for each in cells]
        column = pa.array(cells, pa.float64()) if numbers else pa.array(words, pa.string())
        table = table.append_column(f"participant_{name}", column)
    return table


def put(path: Path, table: pa.Table) -> None:
    """Write a table in the place of what was there, whole."""
    with replacing(path) as part:
        pq.write_table(table, part, compression="zstd", row_group_size=ROWS)
