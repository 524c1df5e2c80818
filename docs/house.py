"""Draws the house of exoid, rooms on floors and who imports whom: `python docs/house.py`.

The floors are the layers of `pyproject.toml`, the arrows the imports of `src/exoid`. An arrow that
others imply is left out.
"""

import tomllib
from functools import cache
from pathlib import Path

import grimp

HOME = Path(__file__).parents[1]
PICTURE = HOME / "docs" / "house.svg"

ROW, SPACE, MARGIN = 26, 8, 34  # px: a room inside a room, between two of them, between floors
LETTER, BORDER = 7.2, 14  # px: the width of a letter, around a name
WIDTH = 1000  # px

Box = tuple[float, float, float, float]  # left, top, width, height
Imports = dict[str, set[str]]  # of every room, the rooms that it imports


@cache
def house() -> grimp.ImportGraph:
    """All of exoid's modules, and what each imports."""
    return grimp.build_graph("exoid")


def packages() -> list[str]:
    """Every room at any depth: the packages below exoid."""
    found = house().modules
    return sorted(each for each in found if each != "exoid" and house().find_children(each))


def rooms_in(home: str) -> list[str]:
    """The rooms directly in `home`."""
    return [each for each in packages() if each.rpartition(".")[0] == home]


def imports_in(home: str) -> Imports:
    """Which of the rooms directly in `home` imports which."""
    rooms, depth = rooms_in(home), home.count(".") + 2
    found: Imports = {room: set() for room in rooms}
    for room in rooms:
        for module in {room, *house().find_descendants(room)}:
            for other in house().find_modules_directly_imported_by(module):
                found[room].add(".".join(other.split(".")[:depth]))
        found[room] &= set(rooms) - {room}
    return found


def implied(imports: Imports, room: str, other: str) -> bool:
    """Is the import also made by way of a third room?"""
    return any(reaches(imports, third, other) for third in imports[room] - {other})


def reaches(imports: Imports, room: str, other: str) -> bool:
    """Does a room import another, directly or not?"""
    return other in imports[room] or any(reaches(imports, each, other) for each in imports[room])


def depth(imports: Imports, room: str) -> int:
    """How many rooms lie below, each importing the next."""
    return max((1 + depth(imports, each) for each in imports[room]), default=0)


def floors() -> list[list[str]]:
    """The rooms of every floor, from the top: the first contract of `pyproject.toml`."""
    settings = tomllib.loads((HOME / "pyproject.toml").read_text(encoding="utf-8"))
    layers = settings["tool"]["importlinter"]["contracts"][0]["layers"]
    return [[each.strip() for each in layer.split("|")] for layer in layers]


def rows_of(room: str) -> list[list[str]]:
    """The rooms in a room, in rows: each imports only from rows below."""
    imports = imports_in(room)
    rows: dict[int, list[str]] = {}
    for each in imports:
        rows.setdefault(depth(imports, each), []).append(each)
    return [rows[level] for level in sorted(rows, reverse=True)]


def name_of(room: str) -> str:
    """The last part of its name."""
    return room.rpartition(".")[2]


def width_of(room: str) -> float:
    """Of a room without rooms in it."""
    return LETTER * len(name_of(room)) + BORDER


def row_width(row: list[str]) -> float:
    """Of rooms side by side."""
    return sum(map(width_of, row)) + SPACE * (len(row) - 1)


def size_of(room: str) -> tuple[float, float]:
    """Width and height of a room with the rooms in it."""
    rows = rows_of(room)
    width = max([1.3 * width_of(room), *map(row_width, rows)])
    return width + 2 * SPACE, ROW + len(rows) * (ROW + SPACE) + SPACE


def places() -> dict[str, Box]:
    """Where the rooms of all floors stand."""
    found: dict[str, Box] = {}
    top = float(MARGIN)
    for floor in floors():
        sizes = [size_of(room) for room in floor]
        gap = (WIDTH - sum(width for width, _ in sizes)) / (len(floor) + 1)
        height, left = max(height for _, height in sizes), gap
        for room, (width, own) in zip(floor, sizes, strict=True):
            found[room] = (left, top + height - own, width, own)
            left += width + gap
        top += height + 1.5 * MARGIN
    return found


def draw_room(room: str, box: Box) -> list[str]:
    """A room and the rooms in it."""
    left, top, width, _ = box
    lines = [rectangle("outer", box), text(left + width / 2, top + ROW - 8, name_of(room), "name")]
    for level, row in enumerate(rows_of(room)):
        x, y = left + (width - row_width(row)) / 2, top + ROW + level * (ROW + SPACE) + SPACE / 2
        for inner in row:
            lines.append(rectangle("inner", (x, y, width_of(inner), ROW)))
            lines.append(text(x + width_of(inner) / 2, y + ROW - 9, name_of(inner), "part"))
            x += width_of(inner) + SPACE
    return lines


def rectangle(look: str, box: Box) -> str:
    left, top, width, height = box
    return (
        f'<rect class="{look}" x="{left:.0f}" y="{top:.0f}" width="{width:.0f}" '
        f'height="{height:.0f}" rx="5"/>'
    )


def text(x: float, y: float, words: str, look: str) -> str:
    return f'<text class="{look}" x="{x:.0f}" y="{y:.0f}">{words}</text>'


def arrow(above: Box, below: Box, share: float) -> str:
    """From the lower edge of a room, at `share` of its width, to the upper edge of another."""
    x, y = above[0] + above[2] * share, above[1] + above[3]
    aim, end = below[0] + below[2] / 2, below[1] - 3
    bend = (end - y) / 2
    points = (x, y), (x, y + bend), (aim, end - bend), (aim, end)
    begin, *curve = (f"{across:.0f} {down:.0f}" for across, down in points)
    return f'<path d="M{begin} C{" ".join(curve)}"/>'


def arrows(boxes: dict[str, Box]) -> list[str]:
    """One for each import between floors that no others imply."""
    imports, found = imports_in("exoid"), []
    for room in boxes:
        shown = [each for each in imports[room] if not implied(imports, room, each)]
        shown.sort(key=lambda each: (boxes[each][0] + boxes[each][2] / 2, boxes[each][1]))
        for at, other in enumerate(shown, start=1):
            found.append(arrow(boxes[room], boxes[other], at / (len(shown) + 1)))
    return found


STYLE = """
text { font-family: system-ui, sans-serif; text-anchor: middle; fill: #1b2a38 }
.name { font-size: 15px; font-weight: 600 } .part { font-size: 12px }
.outer { fill: #eef3f7; stroke: #35566f } .inner { fill: #ffffff; stroke: #9fb4c4 }
path { fill: none; stroke: #b0512a; stroke-width: 1.5; marker-end: url(#tip) }
"""
TIP = (
    '<marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" '
    'orient="auto"><polygon points="0,0 8,4 0,8" fill="#b0512a"/></marker>'
)


def picture() -> str:
    """The house as SVG."""
    boxes = places()
    height = max(top + own for _, top, _, own in boxes.values()) + MARGIN
    return "\n".join(
        [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:.0f}">',
            "<title>The rooms of exoid on their floors, and who imports whom</title>",
            f"<style>{STYLE}</style>",
            f"<defs>{TIP}</defs>",
            '<rect width="100%" height="100%" fill="#ffffff"/>',
            *arrows(boxes),
            *(line for room, box in boxes.items() for line in draw_room(room, box)),
            "</svg>\n",
        ]
    )


if __name__ == "__main__":
    PICTURE.write_text(picture(), encoding="utf-8")
