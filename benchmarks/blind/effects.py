"""What may be concealed in a case: every term of the library and some beyond it, of random form."""

from dataclasses import dataclass, field

import jax.numpy as jnp
import numpy as np

from exoid.physics.library import library
from exoid.physics.term import SensorTerm, Term, name_of

from .novel import NOVEL
from .scenario import Scenario

DEGREE = np.radians(1.0)
EXACTLY = (1.0, 1.0)
EITHER_SIGN = (-1.0, 1.0)
MARGIN = 0.02  # rad, between where a movement begins and a stop
HANGING = -np.pi / 2
FAR = {"extension_angle": 1.2, "flexion_angle": -3.2}  # rad, of stops that no leg reaches
SUFFIX = "_novel"

Range = tuple[float, float]


@dataclass(frozen=True)
class Recipe:
    """How a term is drawn: `sized` fields are its size times a number, `shape` fields do not grow.

    The size is sought between `smallest` and `largest`; a sensor's is drawn there.
    """

    smallest: float
    largest: float
    sized: dict[str, Range]
    shape: dict[str, Range] = field(default_factory=dict)
    signed: bool = False


@dataclass(frozen=True)
class Effect:
    """A term whose form is drawn, for any size."""

    term: type[Term]
    smallest: float
    largest: float
    sized: dict[str, float]
    shape: dict[str, float]

    @property
    def name(self) -> str:
        """The library's name, or that of a novelty."""
        return name_of(self.term) + (SUFFIX if self.term in NOVEL else "")

    @property
    def of_sensor(self) -> bool:
        return issubclass(self.term, SensorTerm)

    def values(self, size: float) -> dict[str, float]:
        """The parameters of this size."""
        return self.shape | {name: size * number for name, number in self.sized.items()}

    def at(self, size: float) -> Term:
        return self.term(**{name: jnp.asarray(x) for name, x in self.values(size).items()})


@dataclass(frozen=True)
class Stop(Effect):
    """A stop, whose size is by how much the free motion would pass it [rad]."""

    end: float  # rad, of the free motion
    side: float  # 1 of extension, -1 of flexion

    def values(self, size: float) -> dict[str, float]:
        stop = "extension_angle" if self.side > 0 else "flexion_angle"
        return self.shape | FAR | {stop: self.end - self.side * size}


RECIPES = {
    "activation_lag": Recipe(0.002, 0.1, {"lag": EXACTLY}),
    "angle_offset": Recipe(2 * DEGREE, 8 * DEGREE, {"offset": EXACTLY}, signed=True),
    "backlash": Recipe(
        5e-4,
        0.04,
        {"half_play": EXACTLY},
        {
            "frame_inertia": (0.006, 0.03),
            "frame_gravity": (0.2, 1.5),
            "hinge_friction": (0.01, 0.2),
            "hinge_damping": (0.01, 0.05),
            "contact_time": (0.008, 0.02),
            "damping_ratio": (0.4, 1.0),
        },
    ),
    "sticking_backlash": Recipe(5e-4, 0.04, {"half_play": EXACTLY}),
    "coulomb_friction": Recipe(0.003, 1.0, {"level": EXACTLY}),
    "cubic_stiffness": Recipe(0.01, 3.0, {"coefficient": EXACTLY}, signed=True),
    "cuff_compliance": Recipe(
        0.002,
        0.25,
        {"compliance": EXACTLY},
        {
            "frame_inertia": (0.01, 0.04),
            "frame_gravity": (0.4, 1.6),
            "hinge_damping": (0.03, 0.35),
            "damping_ratio": (0.15, 0.5),
        },
    ),
    "encoder_eccentricity": Recipe(
        0.5 * DEGREE, 1.5 * DEGREE, {"sine": EITHER_SIGN, "cosine": EITHER_SIGN}
    ),
    "encoder_second_harmonic": Recipe(
        0.3 * DEGREE, 1.0 * DEGREE, {"sine": EITHER_SIGN, "cosine": EITHER_SIGN}
    ),
    "encoder_gain": Recipe(0.01, 0.04, {"gain": EXACTLY}, signed=True),
    "end_range_stiffening": Recipe(
        0.01,
        6.0,
        {"extension": EXACTLY, "flexion": (0.3, 1.5)},
        {"extension_width": (0.12, 0.3), "flexion_width": (0.15, 0.3)},
    ),
    "fatigue": Recipe(0.003, 0.12, {"damping_drift": EXACTLY, "fade": EITHER_SIGN}, signed=True),
    "gyro_bias": Recipe(1.5 * DEGREE, 8 * DEGREE, {"bias": EXACTLY}, signed=True),
    "gyro_scale": Recipe(0.015, 0.13, {"scale": EXACTLY}, signed=True),
    "hard_stop": Recipe(
        0.002, 0.5, {}, {"contact_time": (0.02, 0.08), "damping_ratio": (0.1, 0.6)}
    ),
    "hysteresis": Recipe(0.005, 3.0, {"level": EXACTLY}, {"yield_angle": (0.03, 0.2)}),
    "maxwell_element": Recipe(0.02, 8.0, {"stiffness": EXACTLY}, {"relaxation_time": (0.08, 1.5)}),
    "moving_base": Recipe(
        2e-5,
        0.01,
        {"compliance": EXACTLY},
        {
            "thigh_length": (0.37, 0.47),
            "frequency": (3.0, 9.0),
            "damping_ratio": (0.2, 0.6),
            "carried": (0.8, 1.0),
            "sag": (0.0, 0.0),
        },
    ),
    "polycentric_axis": Recipe(0.003, 0.25, {"change": EXACTLY}, signed=True),
    "power_drag": Recipe(0.001, 0.3, {"coefficient": EXACTLY}, {"power": (1.4, 1.7)}),
    "quadratic_drag": Recipe(0.001, 0.3, {"coefficient": EXACTLY}),
    "slack_cubic_stiffness": Recipe(
        0.01, 3.0, {"coefficient": EXACTLY}, {"slack_angle": (-1.2, -0.3)}, signed=True
    ),
    "sensor_skew": Recipe(0.0015, 0.02, {"skew": EXACTLY}, signed=True),
    "stiffness_rest_angle": Recipe(0.03, 1.1, {"rest_angle": EXACTLY}, signed=True),
    "stretch_reflex": Recipe(
        0.01,
        3.0,
        {"gain": EXACTLY},
        {"threshold": (0.5, 2.5), "delay": (0.03, 0.07), "rise": (0.02, 0.05)},
    ),
    "stribeck_friction": Recipe(
        0.002, 0.6, {"level": EXACTLY, "excess": (0.6, 1.8)}, {"speed": (0.1, 0.6)}
    ),
    "torque_asymmetry": Recipe(0.004, 0.6, {"asymmetry": EXACTLY}, signed=True),
    "torque_bias": Recipe(0.1, 4.0, {"bias": EXACTLY}, signed=True),
    "torque_harmonic": Recipe(
        0.003,
        0.4,
        {
            "sine_3": EXACTLY,
            "sine_2": EITHER_SIGN,
            "cosine_2": (-0.5, 0.5),
            "cosine_3": (-0.5, 0.5),
        },
        signed=True,
    ),
    "wobbling_mass": Recipe(
        0.02,
        0.5,
        {"share": EXACTLY},
        {"radius": (0.15, 0.3), "frequency": (2.0, 6.0), "damping_ratio": (0.1, 0.35)},
    ),
    "zero_drift": Recipe(
        0.2 * DEGREE, 1.0 * DEGREE, {"drift": EXACTLY}, {"step": (0.0, 0.0)}, signed=True
    ),
    "angle_bump_novel": Recipe(
        0.01, 3.0, {"height": EXACTLY}, {"angle": (-1.5, -0.8), "width": (0.1, 0.25)}, signed=True
    ),
    "magnetic_detent_novel": Recipe(
        0.01, 3.0, {"height": EXACTLY}, {"waves": (7.0, 14.0), "angle": (-0.4, 0.4)}
    ),
    "angle_damping_novel": Recipe(0.005, 0.6, {"slope": EXACTLY}),
    "kick_novel": Recipe(
        0.02, 10.0, {"height": EXACTLY}, {"moment": (0.4, 1.3), "width": (0.04, 0.1)}, signed=True
    ),
    "snap_window_novel": Recipe(
        0.02, 5.0, {"push": EXACTLY}, {"angle": (-1.5, -0.8), "width": (0.12, 0.3)}
    ),
    "cubic_damping_novel": Recipe(0.0005, 0.2, {"coefficient": EXACTLY}),
}


def of_legs() -> list[type[Term]]:
    """The terms that a leg may have, each of its own: no exact twin, nothing of machines."""
    return [term for term in library() if not (term.named_only or term.mechanical)]


TERMS = {name_of(term): term for term in of_legs()} | {
    name_of(term) + SUFFIX: term for term in NOVEL
}


def draw_effect(name: str, rng: np.random.Generator, scenario: Scenario) -> Effect | None:
    """This effect in a random form; None where the motion leaves no room for it."""
    recipe = RECIPES[name]
    sign = rng.choice([-1.0, 1.0]) if recipe.signed else 1.0
    sized = {each: sign * rng.uniform(*bounds) for each, bounds in recipe.sized.items()}
    shape = {each: rng.uniform(*bounds) for each, bounds in recipe.shape.items()}
    effect = Effect(TERMS[name], recipe.smallest, recipe.largest, sized, shape)
    return effect if name != "hard_stop" else draw_stop(effect, rng, scenario)


def draw_stop(effect: Effect, rng: np.random.Generator, scenario: Scenario) -> Stop | None:
    """A stop that the free leg passes, above where it begins or below where it hangs."""
    low, high = scenario.reached
    highest_start = max(each.start_angle for each in scenario.movements)
    rooms = {1.0: high - highest_start - MARGIN, -1.0: HANGING - MARGIN - low}
    sides = [side for side, room in rooms.items() if room > 2 * effect.smallest]
    if not sides:
        return None
    side = float(rng.choice(sides))
    end, largest = (high if side > 0 else low), min(effect.largest, rooms[side])
    return Stop(effect.term, effect.smallest, largest, effect.sized, effect.shape, end, side)
