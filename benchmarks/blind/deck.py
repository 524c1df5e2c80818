"""Which kinds of cases there are, and how often each comes."""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice
from typing import Literal, get_args

import numpy as np

from exoid.physics.library import library
from exoid.physics.term import SensorTerm, name_of

from .effects import SUFFIX, of_legs
from .novel import NOVEL

Category = Literal["single", "combo", "triple", "novel", "null", "unobservable"]

CATEGORIES: tuple[str, ...] = get_args(Category)

PAIRS, TRIPLES = 8, 4  # beside every term and every novelty once
NULLS, UNOBSERVABLE = 8, 2
PASSIVE = 0.6  # share of what both protocols can show
# Of these, two together are one of them, or nearly; the first change the inertia, both at once.
ALIKE = (
    {"moving_base", "polycentric_axis", "wobbling_mass"},
    {
        "coulomb_friction",
        "stribeck_friction",
        "hysteresis",
        "cuff_compliance",
        "backlash",
        "sticking_backlash",
    },
    {"torque_bias", "stiffness_rest_angle", "angle_offset", "end_range_stiffening"},
    {"cubic_stiffness", "slack_cubic_stiffness", "end_range_stiffening"},
    {"power_drag", "quadratic_drag", "stretch_reflex"},
    {"activation_lag", "torque_asymmetry", "torque_harmonic"},
)


@dataclass(frozen=True)
class Card:
    """What a case is to hold, before its scenario is drawn."""

    category: Category
    active: bool
    effects: tuple[str, ...] = ()


def deal(count: int, seed: int, category: str | None = None) -> list[Card]:
    """The first cards of a seed, all or those of one category."""
    cards = (card for card in shuffled(seed) if category in (None, card.category))
    return list(islice(cards, count))


def shuffled(seed: int) -> Iterator[Card]:
    """Decks one after another, without end."""
    rng = np.random.default_rng([seed])
    while True:
        cards = deck(rng)
        yield from (cards[at] for at in rng.permutation(len(cards)))


def deck(rng: np.random.Generator) -> list[Card]:
    """Every term of a leg once, every novelty, sets, and recordings that lack nothing."""
    names = [name_of(term) for term in of_legs()]
    novel = [name_of(term) + SUFFIX for term in NOVEL]
    return [
        *(Card("single", is_active(rng, [name]), (name,)) for name in names),
        *(Card("novel", is_active(rng, [name]), (name,)) for name in novel),
        *(together(rng, "combo", 2) for _ in range(PAIRS)),
        *(together(rng, "triple", 3) for _ in range(TRIPLES)),
        *(Card("null", is_active(rng, [])) for _ in range(NULLS)),
        *(Card("unobservable", is_active(rng, [])) for _ in range(UNOBSERVABLE)),
    ]


def together(rng: np.random.Generator, category: Category, count: int) -> Card:
    """Effects that can be told apart, of which at most one is a sensor's."""
    sensing = {name_of(term) for term in library() if issubclass(term, SensorTerm)}
    names = [name_of(term) for term in of_legs()]
    while True:
        drawn = tuple(sorted(str(each) for each in rng.choice(names, count, replace=False)))
        if all(len({*drawn} & group) < 2 for group in (*ALIKE, sensing)):
            return Card(category, is_active(rng, list(drawn)), drawn)


def is_active(rng: np.random.Generator, names: list[str]) -> bool:
    """Is the protocol voluntary? Where an effect is the muscle's, it must be."""
    voluntary = {name_of(term) for term in library() if term.voluntary}
    drawn = bool(rng.random() > PASSIVE)
    return drawn or any(name in voluntary for name in names)
