"""Which tables speak of a body: by its age or height, and by how heavy it is for its height."""

from typing import Literal

from exoid.physics.anatomy import children, de_leva, dumas, heavy, paper, winter
from exoid.physics.anatomy.body import Body
from exoid.physics.anatomy.table import Table

TableName = Literal["auto", "de_leva", "winter", "dumas", "child", "heavy", "paper"]

TABLES: dict[str, Table] = {
    each.name: each
    for each in (
        de_leva.TABLE,
        winter.TABLE,
        dumas.TABLE,
        children.TABLE,
        heavy.TABLE,
        paper.TABLE,
    )
}

# Where one table hands over to the next; between, both speak, and what they disagree about is added
# to the scatter.
GROWING = (15.0, 18.0)  # years
SMALL = (1.30, 1.55)  # m, where the age is unknown: a grown woman may be as small as a child
HEAVY = (27.0, 33.0)  # kg/m^2


def speaking(body: Body, table: TableName) -> list[tuple[Table, float]]:
    """The tables that are asked, and how much each of them counts.

    **Raises** `ValueError` where there is no table of this name.
    """
    if table == "auto":
        child = 1 - between(GROWING, body.age) if body.age else 1 - between(SMALL, body.height)
        stout = (1 - child) * between(HEAVY, body.mass_index)
        shares = {"child": child, "heavy": stout, "de_leva": 1 - child - stout}
        return [(TABLES[name], share) for name, share in shares.items() if share > 0]
    if table not in TABLES:
        raise ValueError(f"table is {table!r}; it can be auto, {', '.join(TABLES)}.")
    return [(TABLES[table], 1.0)]


def between(ends: tuple[float, float], value: float) -> float:
    """0 below, 1 above, straight between."""
    low, high = ends
    return min(max((value - low) / (high - low), 0.0), 1.0)
