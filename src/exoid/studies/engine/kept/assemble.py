"""The two tables of a study, from what its steps kept."""

from collections.abc import Mapping, Sequence
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from exoid.files.replacing import replacing
from exoid.studies.dataset.entry import Dataset
from exoid.studies.dataset.recording_of import person_of
from exoid.studies.engine.kept.merge import merge
from exoid.studies.engine.kept.parts import named, quantities_beside
from exoid.studies.engine.kept.tables import QUANTITIES, RECORDINGS

ROWS = 1 << 18  # of a group in a file
Rows = Sequence[Mapping[str, object]]


def assemble(
    results: Path,
    folders: Mapping[str, Path],
    names: Mapping[str, str],
    dataset: Dataset,
    others: Mapping[str, Rows],
) -> pa.Table:
    """Write `recordings.parquet` and `quantities.parquet`; the recordings are returned.

    `folders` has the parts of every step, `names` those that recordings now have by their key,
    `others` the rows of recordings that have no part of a step, or, under "", of any. The order is
    that of names and steps: whatever the order of computing was, the files are the same to the last
    byte.
    """
    steps = {"": pa.Table.from_pylist(list(others[""]), RECORDINGS)}
    quantities = [QUANTITIES.empty_table()]
    for step, folder in folders.items():
        lost = pa.Table.from_pylist(list(others.get(step, ())), RECORDINGS)
        found = named(folder, names)
        own = [renamed(pq.read_table(part), keys) for part, keys in found.items()]
        steps[step] = pa.concat_tables([lost, *own])
        quantities += [
            renamed(pq.read_table(quantities_beside(part)), keys) for part, keys in found.items()
        ]
    settings = " ".join(folder.name for folder in folders.values())
    whole = merge(steps).sort_by("name").drop_columns(["key"])
    whole = whole.append_column("settings", pa.repeat(settings, whole.num_rows))
    whole = with_participants(whole, dataset)
    # The sort is stable: of every name, rows stay in the order of steps, and of each as it told.
    each = pa.concat_tables(quantities).sort_by("name").drop_columns(["key"])
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
