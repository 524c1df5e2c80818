"""The two tables of a study whose truth is known, without a recording: people in two groups, both
sides, days, drops, each value with an error of its own as exoid's estimates have one.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from hashlib import sha256

import numpy as np
import pandas as pd

from exoid.studies.statistics.tables.study import Study, study_of

SIDES = ("left", "right")
GROUPS = ("control", "spastic")


@dataclass(frozen=True)
class Truth:
    """How people differ in one quantity: standard deviations by level, and what shifts it."""

    quantity: str = "relaxation_index"
    unit: str = "1"
    mean: float = 1.6
    between: float = 0.20  # of people
    side: float = 0.06
    day: float = 0.07
    side_on_day: float = 0.03
    drop: float = 0.05
    error: float = 0.03  # of an estimate, median
    spread: float = 0.5  # of its logarithm
    bad: float = 0.05  # share of recordings whose errors are `worse` times as large
    worse: float = 6.0
    effect: float = -0.15  # of the second group
    shift: float = 0.0  # of each day after the first

    def error_of_occasion(self, drops: int) -> float:
        """Of the mean of drops on a day, the standard error of measurement."""
        known = self.error**2 * np.exp(2 * self.spread**2) * (1 + self.bad * (self.worse**2 - 1))
        squares = self.day**2 + self.side_on_day**2 + (self.drop**2 + known) / drops
        return float(squares**0.5)

    def correlation(self, drops: int, groups: int) -> float:
        """ICC(C,1) of all people together, in which the groups' difference tells people apart."""
        lasting = self.between**2 + self.side**2
        apart = self.effect**2 / 4 if groups > 1 else 0.0
        return (lasting + apart) / (lasting + apart + self.error_of_occasion(drops) ** 2)


@dataclass(frozen=True)
class Design:
    """Who comes how often; `absent` is the share of visits after the first that are missed."""

    people: int = 200
    groups: int = 2
    sides: int = 2
    days: int = 2
    drops: int = 5
    absent: float = 0.0
    friction: float = 0.3  # share of the second group's people in whom dry friction is found
    truths: tuple[Truth, ...] = field(default_factory=lambda: (Truth(),))


def simulate(design: Design, seed: int) -> Study:
    """A study of this design."""
    draw = np.random.default_rng(seed)
    recordings, quantities = [], []
    for number in range(design.people):
        group = number % design.groups
        rubs = group == 1 and draw.random() < design.friction
        about = {
            "participant": f"sub-{number:03d}",
            "participant_group": GROUPS[group],
            "participant_dose": float(10 * (number % 4)),
            "body_mass_kg": float(draw.normal(72, 11)),
            "age_years": float(draw.integers(20, 70)),
        }
        values = {each.quantity: person(each, design, group, draw) for each in design.truths}
        for side, day in visits(design, draw):
            row = recording(about, side, day)
            recordings.append(row)
            quantities.extend(drops_of(row, values, design, draw))
            quantities.append(diagnosed(row, rubs and draw.random() < 0.8))
    return study_of(pd.DataFrame(recordings), pd.DataFrame(quantities))


def visits(design: Design, draw: np.random.Generator) -> Iterator[tuple[int, int]]:
    for day in range(design.days):
        if day == 0 or draw.random() >= design.absent:
            yield from ((side, day) for side in range(design.sides))


@dataclass(frozen=True, eq=False)
class Legs:
    """What a person's sides are, and what they are on each day."""

    lasting: np.ndarray  # side
    by_day: np.ndarray  # side, day


def person(truth: Truth, design: Design, group: int, draw: np.random.Generator) -> Legs:
    shape = (design.sides, design.days)
    mean = truth.mean + truth.effect * group + draw.normal(0, truth.between)
    legs = draw.normal(0, truth.side, (design.sides, 1))
    days = draw.normal(0, truth.day, (1, design.days)) + truth.shift * (np.arange(design.days) > 0)
    by_day = mean + legs + days + draw.normal(0, truth.side_on_day, shape)
    return Legs((mean + legs)[:, 0], by_day)


def recording(about: dict, side: int, day: int) -> dict:
    name = f"{about['participant']}/day{day + 1}/{SIDES[side]}.csv"
    return {
        "recording": sha256(name.encode()).hexdigest()[:16],
        "name": name,
        "session": f"day{day + 1}",
        "side": SIDES[side],
        "status": "ok",
        "reason": "",
        "segments": 5,
        "duration_s": 60.0,
        "rate_hz": 100.0,
        **about,
    }


def drops_of(row: dict, values: dict, design: Design, draw: np.random.Generator) -> Iterator[dict]:
    """What exoid reads of each drop, and how sure it is."""
    side, day = SIDES.index(row["side"]), int(row["session"].removeprefix("day")) - 1
    for truth in design.truths:
        poor = truth.worse if draw.random() < truth.bad else 1.0
        for drop in range(design.drops):
            error = poor * truth.error * float(np.exp(draw.normal(0, truth.spread)))
            scatter = draw.normal(0, truth.drop) + draw.normal(0, error)
            yield {
                **{
                    each: row[each]
                    for each in ("recording", "name", "participant", "session", "side")
                },
                "segment": drop,
                "step": "drops",
                "quantity": truth.quantity,
                "value": float(values[truth.quantity].by_day[side, day] + scatter),
                "truth": float(values[truth.quantity].lasting[side]),
                "standard_error": error,
                "unit": truth.unit,
                "determined_by": "recording",
            }


def diagnosed(row: dict, rubs: bool) -> dict:
    keys = ("recording", "name", "participant", "session", "side")
    told = {"segment": -1, "step": "diagnose", "quantity": "missing_physics", "value": None}
    return {
        **{each: row[each] for each in keys},
        **told,
        "note": "dry friction" if rubs else "none",
    }
