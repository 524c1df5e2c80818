"""A study as files, in exoid's plain layout: sub-001/day1/left.csv, and one sidecar for all."""

import csv
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from benchmarks.studies.tables import GROUPS, SIDES

from .sensors import NOISE, TIME, Recording, record
from .world import Person, Visit

TOGETHER = 200  # legs that swing at once: memory
SENSORS = 1  # of a seed, what is not of people
SIDECAR = f"""\
[subject]
kind = "leg"

[protocol]
kind = "passive"

[sensors]
encoder_counts = 4096
angle_noise_rad = {NOISE[0]}
velocity_noise_rad_s = {NOISE[1]}
sample_rate_hz = 100.0
"""


def put_study(visits: Sequence[Visit], seed: int, folder: Path) -> None:
    """The recordings of all visits, and who the people are."""
    put_people({each.person.id: each.person for each in visits}.values(), folder)
    for at in range(0, len(visits), TOGETHER):
        draw = np.random.default_rng([seed, at, SENSORS])
        for each in record(visits[at : at + TOGETHER], draw):
            put(each, folder)


def put_people(people: Iterable[Person], folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "defaults.toml").write_text(SIDECAR, encoding="utf-8")
    with (folder / "participants.csv").open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(("id", "body_mass_kg", "height_m", "group"))
        for each in people:
            size = round(each.body_mass, 1), round(each.height, 3)
            table.writerow((each.id, *size, GROUPS[each.group]))


def name_of(visit: Visit) -> str:
    return f"{visit.person.id}/day{visit.day + 1}/{SIDES[visit.side]}.csv"


def put(one: Recording, folder: Path) -> None:
    """Cells of one width, so that files are equally large and batches of one shape."""
    path = folder / name_of(one.visit)
    path.parent.mkdir(parents=True, exist_ok=True)
    time, drop = np.tile(TIME, len(one.angle)), np.repeat(np.arange(len(one.angle)), TIME.size)
    rows = np.column_stack([time, drop, one.angle.ravel(), one.rate.ravel()]).ravel().tolist()
    line = "%.2f,%d,%+.6f,%+09.5f\n"
    text = (line * len(time)) % tuple(rows)
    path.write_text(f"time_s,segment,raw_angle_rad,raw_velocity_rad_s\n{text}", encoding="utf-8")
