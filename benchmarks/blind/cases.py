"""Cases of our own: simulated recordings with something concealed in them, drawn from a seed.

What is concealed is as large as its target says: with the best baseline, what remains is 2 to 15
times the noise floor. Errors of a sensor have realistic sizes instead, because no baseline sees
them.
"""

from dataclasses import dataclass, replace
from typing import Any

import jax
import numpy as np
from scipy.optimize import brentq

from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

from .deck import Card
from .effects import Effect, draw_effect
from .motion import TICK, Motion, perform
from .refit import Ratio, ratio
from .scenario import Scenario, draw_scenario, possible, readings
from .truth import Concealed, truth_entry

LEAST, MOST = 2.0, 15.0  # what remains over the noise floor
PAIRED = (2.5, 7.0)  # of each of two effects alone
TRIALS = 80  # scenarios, until one lets the effect be seen
CLOSE = 0.01  # of the logarithm of a size
BEYOND = 1e3  # stands for a motion that ran away, in noise floors
ADDED_MASS, ADDED_AT = (0.3, 1.0), (0.15, 0.40)  # kg, m: a mass of which nobody was told


@dataclass(frozen=True, eq=False)
class Case:
    """A recording, and what is concealed in it."""

    name: str
    recording: Recording
    truth: dict[str, Any]


def name_of_case(seed: int, number: int) -> str:
    return f"own-{seed}-{number:03d}"


def draw_case(card: Card, seed: int, number: int) -> Case:
    """The case of a card; scenarios in which its effects do not show are drawn again."""
    rng = np.random.default_rng([seed, number])
    for _ in range(TRIALS):
        scenario = draw_scenario(rng, active=card.active)
        hidden = conceal(card, scenario, rng)
        if hidden is not None:
            key = jax.random.key(int(rng.integers(2**31)))
            scenario, concealed, extra = hidden
            name = name_of_case(seed, number)
            entry = truth_entry(name, card, scenario, concealed, extra)
            return Case(name, record(scenario, concealed.motion, key), entry)
    raise ArithmeticError(f"case {number} of seed {seed}: {card} cannot be seen in any scenario.")


def conceal(
    card: Card, scenario: Scenario, rng: np.random.Generator
) -> tuple[Scenario, Concealed, dict[str, Any]] | None:
    """The scenario with the card's effects in it, and what else was done; None to draw again."""
    if card.category == "unobservable":
        mass, distance = rng.uniform(*ADDED_MASS), rng.uniform(*ADDED_AT)
        loaded = scenario.leg.with_added_mass(*(np.asarray(x) for x in (mass, distance)))
        scenario = replace(scenario, leg=loaded)
        extra = {"unobservable_mass": {"mass_kg": mass, "radius_m": distance}}
    else:
        extra = {}
    effects = [draw_effect(name, rng, scenario) for name in card.effects]
    drawn = tuple(each for each in effects if each is not None)
    if len(drawn) < len(effects):
        return None
    bounds = PAIRED if len(drawn) > 1 else (LEAST, MOST)
    sizes = [sized(each, scenario, rng, bounds) for each in drawn]
    alone = zip(drawn, sizes, strict=True) if len(drawn) > 1 else ()
    if not all(sizes) or not all(
        shows(at_sizes((each,), (size,), scenario)) for each, size in alone
    ):
        return None
    concealed = at_sizes(drawn, tuple(sizes), scenario)
    return (scenario, concealed, extra) if shows(concealed) else None


def sized(
    effect: Effect, scenario: Scenario, rng: np.random.Generator, bounds: tuple[float, float]
) -> float:
    """A sensor's realistic size, or the one at which a drawn ratio remains; 0 where none does."""
    least, most = bounds
    target = float(np.exp(rng.uniform(np.log(least), np.log(most))))
    low, high = np.log(effect.smallest), np.log(effect.largest)
    if effect.of_sensor:
        return float(np.exp(rng.uniform(low, high)))

    def excess(log_size: float) -> float:
        found = at_sizes((effect,), (float(np.exp(log_size)),), scenario).ratio.angle
        return float(np.log(max(found**2 - 1, 1e-9) / (target**2 - 1)))

    if excess(high) < 0:
        return effect.largest  # as large as it can be; it counts where it shows
    return 0.0 if excess(low) > 0 else float(np.exp(brentq(excess, low, high, xtol=CLOSE)))


def at_sizes(
    effects: tuple[Effect, ...], sizes: tuple[float, ...], scenario: Scenario
) -> Concealed:
    """What these effects make of the scenario."""
    terms = tuple(each.at(size) for each, size in zip(effects, sizes, strict=True))
    motion = perform(scenario.leg, scenario.movements, scenario.reading, terms)
    if not all(map(possible, motion.angle)):
        return Concealed(effects, sizes, motion, Ratio(BEYOND, BEYOND))
    return Concealed(effects, sizes, motion, ratio(scenario, motion))


def shows(concealed: Concealed) -> bool:
    """Is as much left of the effects as was promised?"""
    found, effects = concealed.ratio, concealed.effects
    if not effects:
        return found.angle < BEYOND
    if all(each.of_sensor for each in effects):
        return LEAST <= max(found.angle, found.velocity) < BEYOND
    return LEAST * (1 - CLOSE) <= found.angle <= MOST * (1 + CLOSE)


def record(scenario: Scenario, motion: Motion, key) -> Recording:
    """The raw channels of encoder and gyro at 100 Hz, each segment from its release on."""
    segments = []
    shown = zip(motion.shown_angle, motion.shown_velocity, strict=True)
    for number, (angle, velocity) in enumerate(shown):
        raw, rate = readings(scenario, angle, velocity, jax.random.fold_in(key, number))
        time = np.round(TICK * np.arange(angle.size), 6)
        segments.append(Segment(time, raw_angle=raw, raw_angular_velocity=rate))
    return Recording(tuple(segments), scenario.subject, scenario.protocol(), scenario.sensors())
