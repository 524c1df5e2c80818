"""What is known of a leg in the numbers that people read, and who told them."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.fitting.misfit.uncertainty import Shares, Source
from exoid.fitting.model.term_parameters import ratio_name, ratio_unit
from exoid.online.belief import DEFAULT, Belief, knowledge_of
from exoid.online.filter.gaussian import Gaussian
from exoid.online.filter.read_out import seated
from exoid.online.model.model import Model
from exoid.online.model.unknowns import AT, FIRST_TERM, Row, own_value

RATIOS = {
    "gravity_over_inertia": "1/s^2",
    "stiffness_over_inertia": "1/s^2",
    "damping_over_inertia": "1/s",
}
SENSORS = {"zero": "rad", "gyro_bias": "rad/s", "gyro_scale": "1", "gyro_delay": "s"}
# Known no better than J, which motion alone does not tell.
ABSOLUTE = {
    "inertia": "kg m^2",
    "gravity": "N m",
    "stiffness": "N m/rad",
    "damping": "N m s/rad",
}


@dataclass(frozen=True)
class Known:
    """A quantity, its standard error, and whether the motion or the prior set it."""

    value: float
    error: float
    unit: str
    set_by: Source


def estimates(belief: Belief, model: Model = DEFAULT) -> Mapping[str, Known]:
    """The ratios, the sensors, the leg and the terms' parameters, by name.

    m l g, J, c, d and torques are the data's only where a known mass or torque was declared; a mass
    was taken as exact where the model has no `weighed` (see `Sample`), and a torque always.

    >>> known = online.estimates(online.init(exoid.expected_leg(77.0, 1.80)))
    >>> known["inertia"].set_by
    'prior'
    """
    now, told = knowledge_of(belief, model), units(model)
    with jax.enable_x64(True):
        posterior, prior = (
            [np.asarray(each) for each in read(model)(one.mean, one.root)]
            for one in (jax.tree.map(lambda both: both[0], now.filters), now.prior)
        )
    left = np.minimum((posterior[1] / prior[1]) ** 2, 1.0)
    shares = dict(zip(told, left.tolist(), strict=True))
    each = zip(told, *(column.tolist() for column in posterior), strict=True)
    return {
        name: Known(value, error, told[name], source(shares["inertia" if scales else name]))
        for name, value, error in each
        for scales in [name in ABSOLUTE or has_ratio(name, told)]
    }


def source(prior: float) -> Source:
    """Who set a value of whose precision the prior has this share."""
    return Shares(1 - prior, prior, 0.0).source


def units(model: Model) -> dict[str, str]:
    """Of every quantity, in the order of `quantities`."""
    found = RATIOS | SENSORS | ABSOLUTE
    for name, declared in model.unknowns.declared:
        found[name] = declared.unit
        if declared.inertia_power:
            found[ratio_name(name, declared)] = ratio_unit(declared)
    return found


def time_power(unit: str) -> int:
    """The power of time in a unit, kg and m being others: -2 of 1/s^2, and of N m."""
    over = unit.index("/") if "/" in unit else len(unit)
    power = 0
    for found in re.finditer(r"\b(N|s)\b(?:\^(\d+))?", unit):
        each = int(found[2] or 1) * (-2 if found[1] == "N" else 1)
        power += -each if found.start() > over else each
    return power


def has_ratio(name: str, told: Mapping[str, str]) -> bool:
    """Is it a term's parameter that goes with J?"""
    return f"{name}_over_inertia" in told or f"{name}_times_inertia" in told


def quantities(model: Model, row: Row) -> Float[Array, " quantity"]:
    """Every quantity of a row."""
    level, upright = row[AT["level_gravity"]], row[AT["upright_gravity"]]
    ratios = jnp.stack([jnp.hypot(level, upright), row[AT["stiffness"]], row[AT["damping"]]])
    sensors = [jnp.arctan2(upright, level), *(row[AT[name]] for name in list(SENSORS)[1:])]
    inertia = jnp.exp(row[AT["log_inertia"]])
    terms = []
    for at, (_, declared) in enumerate(model.unknowns.declared, start=FIRST_TERM):
        own = own_value(row[at], declared, inertia)
        terms += [own, own / inertia**declared.inertia_power][: 2 if declared.inertia_power else 1]
    return jnp.concatenate(
        [ratios, jnp.stack([*sensors, inertia]), inertia * ratios, *map(jnp.ravel, terms)]
    )


@cache
def read(model: Model) -> Callable[[Any, Any], tuple[Array, Array]]:
    """From mean and root to all quantities and their standard errors."""

    powers = np.array([time_power(unit) for unit in units(model).values()])

    def told(mean: Row, root: Any) -> tuple[Array, Array]:
        belief = seated(Gaussian(mean, root), model.node)

        def of_row(row: Row) -> Array:
            return quantities(model, row)

        values, slope = of_row(belief.level.mean), jax.jacfwd(of_row)(belief.level.mean)
        errors = belief.errors(values, slope, powers)
        tilted = jnp.zeros_like(errors).at[len(RATIOS)].set(model.node.tilt)  # zero: gamma + tilt
        return values, jnp.hypot(errors, tilted)

    return jax.jit(told)
