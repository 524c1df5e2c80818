"""What the estimator does not know, in one row: the leg, its terms, the sensors, the motion.

The encoder's angle psi = phi + zero is followed, not phi. With G = m l g / J, the thigh's angle
theta, and gamma = zero less how far the seat is tilted beyond theta, Eq. 9 says

    psi'' = tau / J - A cos(psi + theta) - B sin(psi + theta) - (c / J) psi + o - (d / J) psi',
    A = G cos(gamma),  B = G sin(gamma),  o = (c / J) zero.

That is linear in A, B, c / J, o and d / J: an extended Kalman filter is hardly wrong, however
little is known. In G, c and zero it is not: such a filter believes ten times too much of a drop.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jaxtyping import Array, Float

from exoid.online.model.sample import Sample
from exoid.physics.leg import GRAVITY
from exoid.physics.moment import Cycle, SegmentConstants
from exoid.physics.parameter import Declaration, declarations
from exoid.physics.ratios import Ratios
from exoid.physics.state import LegState
from exoid.physics.term import Term, holds, name_of

if TYPE_CHECKING:
    from exoid.online.model.weighed import Weighed

LINEAR = ("level_gravity", "upright_gravity", "stiffness", "offset", "damping")  # A B c/J o d/J
OTHERS = ("log_inertia", "gyro_bias", "gyro_scale", "gyro_delay")
OFF = ("log_mass_off", "mass_distance_off", "mass_extent")  # of a mass that is not exact
MOTION = ("angle", "angular_velocity")  # of the encoder
AT = {name: number for number, name in enumerate((*LINEAR, *OTHERS))}
FIRST_TERM = len(AT)
Row = Float[Any, " unknown"]


class Leg(eqx.Module):
    """A leg that turns as a row says."""

    place: SegmentConstants
    terms: tuple[Term, ...]
    state: LegState  # its angle by gravity: phi, but for the seat's tilt
    push: Float[Array, ""]  # rad/s^2, of a known torque, and of the spring on a tilted seat
    turned: Float[Array, ""]  # gamma: rad by which the encoder shows more than `state`


@dataclass(frozen=True)
class Unknowns:
    """Which terms Eq. 9 is given, on a thigh that is so inclined, and how well the samples' masses
    are known: without that they are exact.

    **Raises** `ValueError` for a term that remembers, drives, or is an unknown already.
    """

    terms: tuple[type[Term], ...] = ()
    thigh_angle: float = 0.0  # rad
    weighed: "Weighed | None" = None

    def __post_init__(self):
        for term in self.terms:
            if why := refused(term):
                raise ValueError(f"{name_of(term)} cannot be estimated live: {why}.")

    @property
    def declared(self) -> list[tuple[str, Declaration]]:
        """The parameters of the terms, as coulomb_friction.level."""
        return [
            (f"{name_of(term)}.{name}", each)
            for term in self.terms
            for name, each in declarations(term)
        ]

    @property
    def names(self) -> tuple[str, ...]:
        of_mass = () if self.weighed is None else OFF
        return (*AT, *(name for name, _ in self.declared), *of_mass, *MOTION)

    @property
    def size(self) -> int:
        return len(self.names)

    @property
    def first_of_mass(self) -> int:
        """Where in a row `OFF` begins, where masses are not exact."""
        return FIRST_TERM + len(self.declared)

    @property
    def curved(self) -> bool:
        """Has a term products of unknowns? Of dry friction of one level alone, none."""
        return any(
            term.torque is not Term.torque or len(list(declarations(term))) > 1
            for term in self.terms
        )

    @property
    def pushed(self) -> bool:
        """Has a term a constant torque of its own, of which a slack spring's is a part?"""
        return any(term.steady for term in self.terms)

    def terms_of(self, row: Row, inertia: Any) -> tuple[Term, ...]:
        """The terms in their own units."""
        found, at = [], FIRST_TERM
        for term in self.terms:
            values = {}
            for name, declared in declarations(term):
                values[name] = own_value(row[at], declared, inertia)
                at += 1
            found.append(term(**values))
        return tuple(found)

    def mass(self, row: Row, sample: Sample) -> tuple[Any, Any, Any]:
        """The sample's mass [kg], its distance [m], its radius of gyration squared [m^2]."""
        if self.weighed is None:
            return sample.added_mass, sample.added_mass_distance, 0.0
        heavier, farther, extent = row[self.first_of_mass :][: len(OFF)]
        mass, distance = sample.added_mass, sample.added_mass_distance
        return mass * jnp.exp(heavier), distance + farther, extent

    def leg(self, row: Row, sample: Sample) -> Leg:
        """The leg as it is loaded at a sample, and what turns it besides."""
        gravity = jnp.hypot(row[AT["level_gravity"]], row[AT["upright_gravity"]])
        turned = jnp.arctan2(row[AT["upright_gravity"]], row[AT["level_gravity"]])
        inertia = jnp.exp(row[AT["log_inertia"]])
        mass, distance, extent = self.mass(row, sample)
        loaded = inertia + mass * (distance**2 + extent)
        share = inertia / loaded
        ratios = Ratios(
            share * gravity + mass * distance * GRAVITY / loaded,
            share * row[AT["stiffness"]],
            share * row[AT["damping"]],
            jnp.asarray(self.thigh_angle),
        )
        still = Cycle(jnp.zeros(()), jnp.ones(()), jnp.zeros(()), jnp.zeros(()))
        push = share * (row[AT["offset"]] - row[AT["stiffness"]] * turned)
        return Leg(
            place=SegmentConstants(ratios, loaded, still, jnp.zeros(())),
            terms=self.terms_of(row, inertia),
            state=LegState(row[-2] - turned, row[-1]),
            push=push + sample.torque / loaded,
            turned=turned,
        )


def is_positive(declared: Declaration) -> bool:
    """Widths, times and speeds: never zero, and known by their order of size."""
    return declared.lower > 0


def own_value(value: Any, declared: Declaration, inertia: Any) -> Any:
    """A term's parameter in its own unit, from its entry in the row."""
    if is_positive(declared):
        return jnp.exp(value)
    return value * inertia**declared.inertia_power


def entry(value: float, declared: Declaration, inertia: float) -> float:
    """`own_value` undone."""
    if is_positive(declared):
        return float(np.log(value))
    return value / inertia**declared.inertia_power


def refused(term: type[Term]) -> str | None:
    """Why a term cannot be followed; None where it can."""
    if term.memory_size > 0:
        return "it remembers what was before the release; fit the recording instead"
    if term.voluntary:
        return "it is of a voluntary torque, and only free movements are followed"
    if term.same_torque and term.as_same_torque(1.0, 2.0) > 1.0:
        return f"times the unknown stiffness it is a constant torque; ask for {term.same_torque}"
    if holds(term) and any(each.unit == "1" for _, each in declarations(term)):
        return "its friction is a share of a load that is estimated, too; fit the recording instead"
    if term.by_whole_drops:
        return "its numbers are told by whole drops only; fit the recording instead"
    if term.replaces or term.everyday:
        return "zero, bias, scale and delay of the sensors are always estimated"
    return None
