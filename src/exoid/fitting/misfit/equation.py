"""Eq. 9 of one segment."""

from typing import Any

import jax.numpy as jnp
from jaxtyping import Float

from exoid.fitting.data.observation import Observation
from exoid.fitting.data.stage import Stage
from exoid.fitting.model.coordinates import Unknowns
from exoid.fitting.model.mounting import acting
from exoid.fitting.model.term_parameters import over_inertia
from exoid.physics.leg import GRAVITY
from exoid.physics.moment import Cycle, SegmentConstants
from exoid.physics.ratios import Ratios
from exoid.physics.record import record
from exoid.physics.term import Term


@record
class Equation:
    """Eq. 9 of one segment, leg and added mass together, per inertia, and what it leaves out."""

    ratios: Ratios
    cycle: Float[Any, ""]  # 1/s^2 for unit shape of Eq. 10
    torque: Float[Any, ""]  # 1/(kg m^2), for a measured torque
    share: Float[Any, ""]  # of the leg in the inertia that moves
    gain: Float[Any, "..."]  # less 1, of the sensor of that torque; without entries it is exact,
    offset: Float[Any, "..."]  # N m, and so is its zero
    terms: tuple[Term, ...] = ()


def equation(unknowns: Unknowns, observation: Observation, stage: Stage) -> Equation:
    """J + m_a (r^2 + k^2) and m l g + m_a r g move, and a leg that bears more may have another d
    and c; the tether adds its stiffness and damping.

    A recorded second is (1 + clock) s long, so every rate of the equation counts as often.
    `unknowns` are those of the segment.
    """
    shared, mounting = unknowns.shared, unknowns.mounting
    inertia, clock = jnp.exp(shared.log_inertia), 1 + of(mounting.clock)
    added = observation.added_mass * jnp.exp(of(mounting.log_added))
    off = of(mounting.log_distance) + observation.apart * of(mounting.distance_apart)
    moved = jnp.exp(observation.added_mass_moves * off)
    distance = observation.added_mass_distance * moved
    extent = observation.added_mass_extent + of(mounting.extent)
    extent += observation.apart * of(mounting.extent_apart)
    total = inertia + added * (distance**2 + extent)
    moment = shared.gravity * inertia + added * distance * GRAVITY
    share, heavier = inertia / total, observation.heavier
    stiffer = observation.stiffened * (1 + heavier * of(mounting.stiffness_under_load))
    damped = observation.damped * (1 + heavier * of(mounting.damping_under_load))
    return Equation(
        ratios=Ratios(
            gravity=clock**2 * moment / total,
            stiffness=clock**2 * shared.stiffness * stiffer * share + stage.tether**2,
            damping=clock * shared.damping * damped * share + 2 * stage.tether,
            thigh_angle=observation.thigh_angle + of(mounting.tilt),
        ),
        cycle=clock**2 * unknowns.own.torque * share,
        torque=clock**2 / total,
        share=clock**2 * share,
        gain=mounting.torque_gain,
        offset=mounting.torque_zero * observation.torque_reach,
        terms=tuple(over_inertia(term, 1 / inertia) for term in unknowns.terms),
    )


def of(leaf: Float[Any, "*entry"]) -> Float[Any, ""]:
    """The segment's entry of the mounting, 0 where it is no unknown."""
    return leaf[0] if leaf.size else jnp.zeros(())


def applied(eq: Equation, torque: Float[Any, "*time"]) -> Float[Any, "*time"]:
    """Per inertia the torque that acts where this one is shown [rad/s^2]."""
    return eq.torque * acting(torque, of(eq.offset), of(eq.gain))


def place_of(eq: Equation, observation: Observation, stage: Stage) -> SegmentConstants:
    """What a term may know of its segment."""
    inertia, clock = 1 / eq.torque, observation.clock
    cycle = Cycle(eq.cycle * inertia, clock.period, clock.frequency, clock.onset)
    return SegmentConstants(eq.ratios, inertia, cycle, clock.number, stage.tether)
