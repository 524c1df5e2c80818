"""Is missing physics found where it is? Half of the recordings are of knees that rub."""

import argparse
from dataclasses import replace
from pathlib import Path

import pyarrow.parquet as pq

from .asked import run
from .silence import name_of
from .visit import hold_visit
from .world import World, draw_person
from .write import put, put_people

FRICTION = ("coulomb_friction",)


def diagnosed(world: World, options: argparse.Namespace, folder: Path) -> list[str]:
    """What was found of either half, by name."""
    people, visits = [], []
    for number in range(options.diagnosed):
        import numpy as np

        draw = np.random.default_rng([options.seed, number, 7])
        rubs = number % 2
        each = draw_person(replace(world, friction=float(rubs)), number, draw)
        people.append(each)
        visits.append(hold_visit(replace(world, bad=0.0), each, (0, 0), draw))
    put_people(people, folder / "study")
    for each in visits:
        put(each, folder / "study")
    seconds = run(folder / "study", folder / "results", options.workers, "diagnose")
    rows = pq.read_table(folder / "results" / "quantities.parquet").to_pylist()
    causes: dict[str, list[str]] = {}
    for row in rows:
        if row["quantity"] == "missing_physics":
            causes.setdefault(row["name"], []).append(row["note"])
    lines = [f"{len(visits)} recordings diagnosed in {seconds:.0f} s"]
    for each in visits:
        size = f"friction {each.person.friction:.3f} m l g" if each.person.rubs else "nothing"
        lines.append(f"  {size:24} {', '.join(causes.get(name_of(each), ['failed']))}")
    return lines
