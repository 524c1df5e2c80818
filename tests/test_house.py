"""The house that CONTRIBUTING.md describes: rooms of a size to survey, one above the other."""

import ast
import importlib.util
import tomllib
from collections.abc import Iterable, Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import grimp
import pytest

import exoid

ROOT = Path(__file__).parents[1]
MOST = 12  # modules of a room
LONGEST = 15  # modules, each of which imports the next when it is loaded
VERBS = {name for name in exoid.__all__ if name.islower()}


@pytest.fixture(scope="module")
def house():
    """The script that draws it."""
    found = importlib.util.spec_from_file_location("house", ROOT / "docs" / "house.py")
    assert found is not None
    assert found.loader is not None
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module


def rooms_of(graph: grimp.ImportGraph) -> set[str]:
    """The packages below exoid."""
    return {each for each in graph.modules if "." in each and graph.find_children(each)}


def crowded(graph: grimp.ImportGraph) -> set[str]:
    """Rooms with more modules than can be surveyed; a room in a room is none of its modules."""
    rooms = rooms_of(graph)
    return {each for each in rooms if len(graph.find_children(each) - rooms) > MOST}


def circle(graph: grimp.ImportGraph) -> list[str]:
    """Rooms that import each other, the first of them once more at the end."""
    rooms = rooms_of(graph)
    below = {
        room: {
            room_of(other, rooms)
            for module in modules_in(graph, room, rooms)
            for other in graph.find_modules_directly_imported_by(module)
        }
        - {room, "exoid"}
        for room in rooms
    }
    try:
        TopologicalSorter(below).prepare()
    except CycleError as fault:
        return fault.args[1]
    return []


def modules_in(graph: grimp.ImportGraph, room: str, rooms: set[str]) -> Iterable[str]:
    """Those of a room itself, with what its `__init__` says."""
    return {room, *graph.find_children(room)} - (rooms - {room})


def room_of(module: str, rooms: set[str]) -> str:
    return module if module in rooms else module.rpartition(".")[0]


def named_as_verbs(graph: grimp.ImportGraph) -> set[str]:
    """Rooms right below exoid that would hide a function of their name."""
    return {each for each in rooms_of(graph) if each.removeprefix("exoid.") in VERBS}


def imported_at_once(body: list[ast.stmt]) -> Iterator[ast.Import | ast.ImportFrom]:
    """Not those within functions, nor those for type checkers alone."""
    for each in body:
        if isinstance(each, ast.Import | ast.ImportFrom):
            yield each
        elif isinstance(each, ast.If) and ast.unparse(each.test).endswith("TYPE_CHECKING"):
            yield from imported_at_once(each.orelse)
        elif isinstance(each, ast.If | ast.With | ast.Try | ast.ClassDef):
            yield from imported_at_once(each.body)


def imports_of(home: Path) -> dict[str, set[str]]:
    """Of every module below the folder `home`, the others that are loaded with it."""
    files = {
        ".".join(path.relative_to(home.parent).with_suffix("").parts).removesuffix(
            ".__init__"
        ): path
        for path in home.rglob("*.py")
    }
    found: dict[str, set[str]] = {}
    for module, path in files.items():
        named = set()
        for each in imported_at_once(ast.parse(path.read_text(encoding="utf-8")).body):
            if isinstance(each, ast.ImportFrom):
                inside = {f"{each.module}.{alias.name}" for alias in each.names}
                named |= inside & files.keys() or {each.module}
            else:
                named |= {alias.name for alias in each.names}
        found[module] = named & files.keys() - {module, home.name}
    return found


def longest_chain(imports: dict[str, set[str]]) -> list[str]:
    """From the top; there may be no circle."""
    chains: dict[str, list[str]] = {}
    for module in TopologicalSorter(imports).static_order():
        below = [chains[each] for each in sorted(imports[module])]
        chains[module] = [module, *max(below, key=len, default=[])]
    return max(chains.values(), key=len)


def test_no_module_stands_on_a_long_chain_of_others():
    chain = longest_chain(imports_of(ROOT / "src" / "exoid"))
    assert len(chain) <= LONGEST, " -> ".join(chain)


def test_a_chain_is_what_is_loaded_with_a_module(tmp_path):
    home = tmp_path / "tower"
    (home / "cellar").mkdir(parents=True)
    written = {
        "__init__.py": "",
        "cellar/__init__.py": "",
        "cellar/floor.py": "import os",
        "wall.py": "from tower.cellar import floor",
        "roof.py": "from tower.wall import floor\nimport tower.cellar.floor",
        "flag.py": "if TYPE_CHECKING:\n    import tower.roof\ndef wave():\n    import tower.roof",
    }
    for name, text in written.items():
        (home / name).write_text(text, encoding="utf-8")
    assert longest_chain(imports_of(home)) == ["tower.roof", "tower.wall", "tower.cellar.floor"]
    (home / "cellar" / "floor.py").write_text("import tower.roof", encoding="utf-8")
    with pytest.raises(CycleError):
        longest_chain(imports_of(home))


def test_no_room_is_crowded_hides_a_function_or_imports_what_imports_it():
    graph = grimp.build_graph("exoid")
    assert len(rooms_of(graph)) > 40
    assert crowded(graph) == set()
    assert named_as_verbs(graph) == set()
    assert circle(graph) == []


def test_a_worse_house_is_told():
    graph = grimp.build_graph("exoid")
    for at in range(MOST):
        graph.add_module(f"exoid.twin.more_{at}")
    graph.add_module("exoid.plan")
    graph.add_module("exoid.plan.step")
    graph.add_import(
        importer="exoid.recordings.signal.noise", imported="exoid.recordings.can.decode"
    )
    assert crowded(graph) == {"exoid.twin"}
    assert named_as_verbs(graph) == {"exoid.plan"}
    assert {"exoid.recordings.signal", "exoid.recordings.can"} <= {*circle(graph)}


def test_the_floors_of_the_picture_hold_every_room_once(house):
    drawn = [room for floor in house.floors() for room in floor]
    assert sorted(drawn) == sorted(house.rooms_in("exoid"))


def test_the_picture_is_that_of_the_imports(house):
    assert house.PICTURE.read_text(encoding="utf-8") == house.picture(), "run: python docs/house.py"


def test_contributing_names_every_room_right_below_exoid(house):
    words = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    assert [
        each for each in house.rooms_in("exoid") if f"`{house.name_of(each)}`" not in words
    ] == []


def test_the_contracts_know_every_room():
    """A room that no contract names could import whatever it likes within its floor."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    named = set()
    for contract in settings["tool"]["importlinter"]["contracts"]:
        for container in contract.get("containers", [""]):
            for layer in contract["layers"]:
                named |= {f"{container}.{each.strip()}".lstrip(".") for each in layer.split("|")}
    rooms = {each for each in rooms_of(grimp.build_graph("exoid")) if each.count(".") <= 2}
    assert rooms - named - {"exoid.example"} == set()
