"""Is missing physics found where it is? Half of the recordings are of knees that rub."""

import argparse
from collections import defaultdict
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq

from .asked import run
from .silence import name_of
from .visit import Visit, hold_visit
from .world import DEVICES, World, draw_person
from .write import put, put_people

DROPS = 3  # of a recording: a diagnosis of five takes minutes where its programs are to be compiled


def diagnosed(world: World, options: argparse.Namespace, folder: Path) -> list[str]:
    """What was found of every recording; of one kind of device, so that programs are shared."""
    visits = [rubbing(world, options.seed, number) for number in range(options.diagnosed)]
    put_people([each.person for each in visits], folder / "study")
    for each in visits:
        put(each, folder / "study")
    seconds = run(folder / "study", folder / "results", options.workers, "diagnose")
    causes = causes_of(folder / "results")
    lines = [f"{len(visits)} recordings diagnosed in {seconds:.0f} s"]
    for each in visits:
        size = f"friction {each.person.friction:.3f} m l g" if each.person.rubs else "nothing"
        lines.append(f"  {size:24} {', '.join(causes.get(name_of(each), ['failed']))}")
    return lines


def rubbing(world: World, seed: int, number: int) -> Visit:
    """A sound recording of drops that are alike; of every second person the knee rubs."""
    draw = np.random.default_rng([seed, number, 7])
    own = replace(world, friction=float(number % 2), bad=0.0, no_mass=0.0, wrong_mass=0.0)
    own = replace(own, drops=DROPS, drop=0.0, tone=0.0)
    person = replace(draw_person(own, number, draw), device=DEVICES[0])
    return hold_visit(own, person, (0, 0), draw)


def causes_of(results: Path) -> dict[str, list[str]]:
    found = defaultdict(list)
    for row in pq.read_table(results / "quantities.parquet").to_pylist():
        if row["quantity"] == "missing_physics":
            found[row["name"]].append(row["note"])
    return found
