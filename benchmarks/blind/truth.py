"""The entry of a case in a truth file: what is concealed in it, and how far it shows."""

from dataclasses import dataclass
from typing import Any

from .deck import Card
from .effects import Effect
from .motion import Motion
from .refit import Ratio
from .scenario import Scenario

# Another name that is as right: exactly the same motion, or a form that holds the true one.
AS_RIGHT = {
    "stiffness_rest_angle": ("torque_bias",),
    "torque_bias": ("stiffness_rest_angle",),
    "cubic_damping_novel": ("power_drag",),
}
NEARLY = {
    "coulomb_friction": ("stribeck_friction",),
    "cubic_damping_novel": ("quadratic_drag",),
}
SUBTLE, MODERATE = 3.0, 8.0  # ratios up to which an effect is called so


@dataclass(frozen=True, eq=False)
class Concealed:
    """Effects with their sizes, the motion that they make and how far it is from a baseline."""

    effects: tuple[Effect, ...]
    sizes: tuple[float, ...]
    motion: Motion
    ratio: Ratio


def truth_entry(
    name: str, card: Card, scenario: Scenario, concealed: Concealed, extra: dict[str, Any]
) -> dict[str, Any]:
    """All that is known of a case; `residual_ratio` is with noise, 1 where nothing is left."""
    done = {what: rounded(values) for what, values in extra.items()}
    pairs = list(zip(concealed.effects, concealed.sizes, strict=True))
    physical = bool(pairs) and all(each.of_sensor for each in concealed.effects)
    found = concealed.ratio
    return {
        "id": name,
        "effect": "+".join(card.effects) or "none",
        "effects": list(card.effects),
        "category": card.category,
        "also_acceptable": [x for each in card.effects for x in AS_RIGHT.get(each, ())],
        "near_equivalent": [x for each in card.effects for x in NEARLY.get(each, ())],
        "strength": ("physical" if physical else strength(found.angle)) if pairs else None,
        "protocol": "active" if scenario.active else "passive",
        "params": done | {each.name: rounded(each.values(size)) for each, size in pairs},
        "baseline": baseline(scenario),
        "segments": segments(scenario),
        "noise": noise(scenario),
        "residual_ratio": significant(found.angle),
        "residual_ratio_velocity": significant(found.velocity),
        "detectable": bool(pairs),
    }


def strength(ratio: float) -> str:
    return "subtle" if ratio <= SUBTLE else "moderate" if ratio <= MODERATE else "clear"


def baseline(scenario: Scenario) -> dict[str, float]:
    leg = scenario.leg
    values = {
        "m": leg.mass,
        "l": leg.com_distance,
        "J": leg.inertia,
        "c": leg.stiffness,
        "d": leg.damping,
    }
    return rounded(values)


def segments(scenario: Scenario) -> list[dict[str, float]]:
    return [
        rounded(
            {
                "phi0": each.start_angle,
                "T": each.duration if scenario.active else 0.0,
                "tau": each.amplitude or 0.0,
                "dur": each.duration,
            }
        )
        for each in scenario.movements
    ]


def noise(scenario: Scenario) -> dict[str, float]:
    values = {
        "angle_rad": scenario.kit.encoder.noise,
        "velocity_rad_s": scenario.kit.gyroscope.noise,
        "floor_angle_rad": scenario.angle_floor,
        "floor_velocity_rad_s": scenario.velocity_floor,
    }
    return rounded(values)


def rounded(values: dict[str, Any]) -> dict[str, float]:
    return {name: significant(value) for name, value in values.items()}


def significant(value: Any) -> float:
    """Six digits, as JSON can hold them."""
    return float(f"{float(value):.6g}")
