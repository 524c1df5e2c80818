"""Which tables speak of a body: by its age or height, and by how heavy it is for its height."""

from typing import Literal

from exoid.physics.anatomy import paper
from exoid.physics.anatomy.body.size import Body
from exoid.physics.anatomy.tables import children, de_leva, dumas, heavy, winter
from exoid.physics.anatomy.tables.table import Scatter, Table

TableName = Literal["auto", "de_leva", "winter", "dumas", "child", "heavy", "paper"]

# All tables of adults speak alike; each of them is the shape of children and of heavy people too.
ADULTS = (de_leva.TABLE, winter.TABLE, dumas.TABLE)
CHILDREN, HEAVY = tuple(map(children.of, ADULTS)), tuple(map(heavy.of, ADULTS))
TABLES: dict[str, tuple[Table, ...]] = {
    **{each.name: (each,) for each in (*ADULTS, paper.TABLE)},
    "child": CHILDREN,
    "heavy": HEAVY,
}
# By how much the tables of adults differ about one and the same body, where one speaks for all.
DISAGREEMENT = Scatter(mass=0.04, com_distance=0.06, radius=0.025)

# Where one table hands over to the next; between, both speak, and what they disagree about is added
# to the scatter.
GROWING = (15.0, 18.0)  # years
SMALL = (1.30, 1.55)  # m, where the age is unknown: a grown woman may be as small as a child
STOUT = (27.0, 33.0)  # kg/m^2


def speaking(body: Body, table: TableName) -> list[tuple[Table, float]]:
    """The tables that are asked, and how much each of them counts.

    **Raises** `ValueError` where there is no table of this name.
    """
    if table == "auto":
        child = 1 - between(GROWING, body.age) if body.age else 1 - between(SMALL, body.height)
        stout = (1 - child) * between(STOUT, body.mass_index)
        shares = ((CHILDREN, child), (HEAVY, stout), (ADULTS, 1 - child - stout))
    elif table in TABLES:
        shares = ((TABLES[table], 1.0),)
    else:
        raise ValueError(f"table is {table!r}; it can be auto, {', '.join(TABLES)}.")
    return [(each, share / len(many)) for many, share in shares if share > 0 for each in many]


def between(ends: tuple[float, float], value: float) -> float:
    """0 below, 1 above, straight between."""
    low, high = ends
    return min(max((value - low) / (high - low), 0.0), 1.0)
