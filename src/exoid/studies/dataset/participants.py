"""The table of participants: who they are, and what else a study knows of them."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from unicodedata import normalize

from exoid.files.text_file import naming, read_text
from exoid.files.visible import visible
from exoid.physics.anatomy.body.doubt import POUND
from exoid.studies.dataset.entry import Participant, Said
from exoid.studies.dataset.tables.cells import Row, rows_of

ENDINGS = (".csv", ".tsv", ".parquet", ".xlsx")
IDS = (
    *("participant_id", "id", "participant", "subject_id", "subject"),
    *("patient_id", "patient", "proband", "probanden_id", "code"),
)
MISSING = ("", "n/a", "na", "nan", "none", "-", "?")
NUMBER = re.compile(r"[+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][+-]?\d+)?", re.ASCII)
CODE = re.compile(r"0\d+")  # 007 is a name


# What columns call a quantity, and the sizes of its units; the first stands unless one is said.
KILOGRAMS = {"kg": 1.0, "g": 1e-3, "lb": POUND, "lbs": POUND}
METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "in": 0.0254, "inch": 0.0254}
YEARS = {
    **dict.fromkeys(("years", "year", "yr", "y", "jahre", "j", "ans", "anni"), 1.0),
    **dict.fromkeys(("months", "month", "monate", "mois", "mesi"), 1 / 12),
}
QUANTITIES = {
    "body_mass": (
        (
            *("body_mass", "bodymass", "body_weight", "weight", "mass"),
            *("körpermasse", "körpergewicht", "gewicht", "poids", "peso"),
        ),
        KILOGRAMS,
    ),
    "height": (
        (
            *("height", "body_height", "stature"),
            *("körpergröße", "größe", "groesse", "taille", "talla", "altezza"),
        ),
        METRES,
    ),
    "age": (("age", "alter", "âge", "edad", "età"), YEARS),
}


@dataclass(frozen=True)
class Column:
    """A column under the name that the table gives it, and what of a person it tells."""

    name: str
    field: str  # of `Participant`; empty: one of its further columns
    size: float = 0.0  # of its unit in SI or years; 0: its cells are words


@dataclass(frozen=True)
class Table:
    """Participants by their id, and what is wrong with the table, one line each."""

    participants: Mapping[str, Participant] = field(default_factory=dict)
    problems: tuple[str, ...] = ()


def read_participants(path: Path) -> Table:
    """Who stands in a table; a cell that cannot be read is not told, and a problem.

    **Raises** `ValueError` in one line where there is no table to be read.
    """
    with naming(path):
        rows = rows_of(path)
        columns = columns_of(rows, units_beside(path)) if rows else []
    problems: list[str] = []
    people: dict[str, Participant] = {}
    for row in rows:
        person = person_of(row, columns, problems)
        known = people.get(person.id)
        if not person.id:
            problems.append(f"{row.place} has no id. Give one, or delete the row.")
        else:
            people[person.id] = person if known is None else agreed(known, person, row, problems)
    return Table(people, tuple(visible(f"{path.name}: {each}") for each in problems))


def columns_of(rows: list[Row], units: Mapping[str, str]) -> list[Column]:
    """What each column of the table means."""
    names = [*rows[0].cells]
    key = next((each for wanted in IDS for each in names if plain(each) == wanted), None)
    if key is None:
        raise ValueError(
            "has no column id. Name the one that says who it is participant_id. It holds: "
            f"{', '.join(names)[:200]}."
        )
    found = [Column(key, "id")]
    for name in names:
        quantity = known_as(name, units.get(name, ""))
        if quantity is not None and all(each.field != quantity.field for each in found):
            found.append(quantity)
        elif name != key:
            cells = [row.cells[name] for row in rows if not is_missing(row.cells[name])]
            found.append(Column(name, "", float(bool(cells) and all(map(is_number, cells)))))
    return found


def known_as(name: str, said: str) -> Column | None:
    """A quantity of a person by the name of its column, its unit in that name or said elsewhere."""
    for quantity, (names, units) in QUANTITIES.items():
        for each in names:
            unit = plain(name).removeprefix(each).lstrip("_") if plain(name) != each else said
            if plain(name).startswith(each) and (unit.lower() in units or not unit):
                return Column(name, quantity, units.get(unit.lower(), 1.0))
    return None


def person_of(row: Row, columns: list[Column], problems: list[str]) -> Participant:
    told: dict[str, float | None] = {}
    more: dict[str, Said] = {}
    for column in columns[1:]:
        cell = row.cells[column.name]
        number = float(cell.replace(",", ".")) * column.size if NUMBER.fullmatch(cell) else None
        if column.field:
            told[column.field] = number
        else:
            more[column.name] = None if is_missing(cell) else number if column.size else cell
        if column.field and number is None and not is_missing(cell):
            problems.append(
                f"{row.place}, column {column.name}: {cell[:40]!r} is not a number. Write a number "
                "alone, its unit in the column's name; leave the cell empty where it is unknown."
            )
    return Participant(id_of(row.cells[columns[0].name]), **told, more=MappingProxyType(more))


def id_of(cell: str) -> str:
    """As the names of files have it, without the `sub-` of BIDS."""
    return "" if is_missing(cell) else visible(cell.removeprefix("sub-"))


def agreed(one: Participant, other: Participant, row: Row, problems: list[str]) -> Participant:
    """Of a person who stands in the table twice, what both rows say."""
    differ = [name for name in QUANTITIES if getattr(one, name) != getattr(other, name)]
    with_values = [f"{name} {getattr(one, name)} and {getattr(other, name)}" for name in differ]
    said = f", with {', '.join(with_values)}" if differ else ""
    problems.append(
        f"{row.place}: {one.id} stands there twice{said}. Keep one row; what differs from day to "
        "day belongs into the sidecar of each recording."
    )
    return replace(one, **dict.fromkeys(differ))


def units_beside(path: Path) -> dict[str, str]:
    """What NAME.json beside the table, as BIDS has it, says of the units of its columns."""
    beside = path.with_suffix(".json")
    if not beside.is_file():
        return {}
    try:
        document = json.loads(read_text(beside))
    except (ValueError, RecursionError) as fault:
        raise ValueError(f"{beside.name} beside it is no JSON. Mend or delete it.") from fault
    entries = document.items() if isinstance(document, dict) else ()
    units = {name: each.get("Units") for name, each in entries if isinstance(each, dict)}
    return {name: unit for name, unit in units.items() if isinstance(unit, str)}


def plain(name: str) -> str:
    """A name in lower case, its words by underlines: `Height [cm]` is height_cm."""
    return re.sub(r"[\W_]+", "_", normalize("NFC", name).lower()).strip("_")


def is_missing(cell: str) -> bool:
    return cell.lower() in MISSING


def is_number(cell: str) -> bool:
    return bool(NUMBER.fullmatch(cell)) and not CODE.fullmatch(cell)
