"""A study as files, in exoid's plain layout: sub-0001/day1/left.csv, a sidecar beside each."""

import csv
from collections.abc import Iterable
from itertools import product
from pathlib import Path

import numpy as np
from benchmarks.others.measure import Segment
from benchmarks.others.write import entries, table_text

from .visit import Visit, hold_visit
from .world import GROUPS, SIDES, Person, World, draw_person


def put_people(people: Iterable[Person], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    with (folder / "participants.csv").open("w", newline="") as file:
        table = csv.writer(file)
        table.writerow(("id", "body_mass_kg", "height_m", "age_years", "group"))
        for each in people:
            mass = "" if each.written_mass is None else each.written_mass
            group = GROUPS[each.group]
            table.writerow((each.id, mass, round(each.height, 3), each.age, group))


def put(visit: Visit, folder: Path) -> None:
    """The recording of a visit, and its copy where somebody kept it twice."""
    path = folder / visit.person.id / f"day{visit.day + 1}" / f"{SIDES[visit.side]}.csv"
    path.parent.mkdir(parents=True, exist_ok=True)
    segments = tuple(Segment(np.asarray(each.time), each.columns) for each in visit.drops)
    text = table_text(segments, clock=0.0)
    names = [path, path.with_stem(f"{path.stem}_2")] if visit.fault == "twice" else [path]
    for each in names:
        each.write_text(text, encoding="utf-8")
        each.with_suffix(".toml").write_text(sidecar(visit), encoding="utf-8")


def sidecar(visit: Visit) -> str:
    device = visit.person.device
    told = {"angle_noise_rad": device.angle_noise}
    if device.velocity_noise is not None:
        told["velocity_noise_rad_s"] = device.velocity_noise
    if device.counts:
        told["encoder_counts"] = device.counts
    lines = ["[subject]", 'kind = "leg"', "", "[protocol]", 'kind = "passive"', "", "[sensors]"]
    return "\n".join([*lines, *entries(told)]) + "\n"


def put_study(world: World, seed: int, folder: Path) -> list[Visit]:
    """All visits of all people, and the table of who they are; `seed` decides everything."""
    people, visits = [], []
    for number in range(world.people):
        draw = np.random.default_rng([seed, number])
        people.append(draw_person(world, number, draw))
        for where in product(range(len(SIDES)), range(world.days)):
            visits.append(hold_visit(world, people[-1], where, draw))
            put(visits[-1], folder)
    put_people(people, folder)
    return visits
