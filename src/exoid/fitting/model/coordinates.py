"""The coordinates in which a fit moves: what motion can tell, apart from what it cannot.

Motion fixes m l g / J, c / J, d / J and tau / J (exactly; scaling m, J, d, c and tau together
changes nothing). The inertia matters only beside a known mass or torque, the mass never.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, TypeVar

import jax
import jax.numpy as jnp
import numpy as np
from jax.flatten_util import ravel_pytree
from jaxtyping import Float, Inexact, Int, Num, PyTree

from exoid.fitting.model.mounting import Mounting
from exoid.fitting.model.term_parameters import (
    NAMES,
    over_inertia,
    parameters_of,
    ratio_name,
    typical_term,
)
from exoid.physics.leg import GRAVITY, LegParameters
from exoid.physics.parameter import declarations
from exoid.physics.record import record
from exoid.physics.term import Term

USUAL = 0.4  # kg m^2, J of a middling leg
Tree = TypeVar("Tree")


@record
class Shared:
    """What the leg owns and motion can tell."""

    log_inertia: Float[Any, "*batch"]  # log(J / kg m^2)
    gravity: Float[Any, "*batch"]  # m l g / J, 1/s^2
    stiffness: Float[Any, "*batch"]  # c / J, 1/s^2
    damping: Float[Any, "*batch"]  # d / J, 1/s


@record
class SegmentUnknowns:
    """What a segment owns."""

    torque: Float[Any, "*segment"]  # tau / J, 1/s^2
    angle: Float[Any, "*segment"]  # rad, at the segment's first sample
    angular_velocity: Float[Any, "*segment"]  # rad/s


@record
class Coordinates:
    """A point of the fit; `own` carries an axis `segment`.

    The terms' parameters are over J where they are torques, times J where they give way to them.
    """

    shared: Shared
    log_mass: Float[Any, "*batch"]  # log(m / kg)
    mounting: Mounting
    own: SegmentUnknowns
    terms: tuple[Term, ...] = ()


@record
class Unknowns:
    """What the simulation of one segment hangs on: each leaf a number, or one of every segment."""

    shared: Shared
    mounting: Mounting
    own: SegmentUnknowns
    terms: tuple[Term, ...] = ()


TYPICAL = Coordinates(
    Shared(*map(np.asarray, (0.3, 10.0, 3.0, 1.0))),
    np.asarray(0.3),
    Mounting(
        *map(
            np.asarray,
            (0.1, 0.01, 0.003, 0.05, 0.05, 0.05, 0.02, 0.01, 0.05, 0.02, 0.1, 0.1, 0.1, 0.003),
        )
    ),
    SegmentUnknowns(*map(np.asarray, (10.0, 0.1, 0.5))),
)  # a step of order one


def typical(coordinates: Coordinates) -> Coordinates:
    """A step of order one of every coordinate, the terms' included."""
    each = tuple(over_inertia(typical_term(type(term)), USUAL) for term in coordinates.terms)
    return replace(TYPICAL, terms=each)


def scaled(coordinates: Coordinates) -> Coordinates:
    """In units of `typical`: what the solver sees."""
    return jax.tree.map(lambda value, unit: value / unit, coordinates, typical(coordinates))


def unscaled(coordinates: Coordinates) -> Coordinates:
    """Back from units of `typical`."""
    return jax.tree.map(lambda value, unit: value * unit, coordinates, typical(coordinates))


def take(tree, rows):
    """These rows of every leaf."""
    rows = np.asarray(rows)
    return jax.tree.map(lambda leaf: leaf[rows], tree)


def flattened(tree: PyTree) -> np.ndarray:
    """All entries in one row."""
    return np.concatenate(jax.tree.leaves(tree), axis=None)


def unflattened(values: np.ndarray, like: Tree) -> Tree:
    """`flattened` undone; `values` may carry further axes behind."""
    leaves, structure = jax.tree.flatten(like)
    shaped, begin = [], 0
    for leaf in leaves:
        end = begin + np.size(leaf)
        shaped.append(values[begin:end].reshape((*np.shape(leaf), *values.shape[1:])))
        begin = end
    return jax.tree.unflatten(structure, shaped)


@dataclass(frozen=True, eq=False)
class Layout:
    """How the coordinates of a point lie in a row."""

    places: Coordinates  # which entry of `flattened` every coordinate is
    units: Float[np.ndarray, " coordinate"]  # `typical` of every entry

    @property
    def size(self) -> int:
        return self.units.size


def layout(point: Coordinates) -> Layout:
    """That of a point; it is the same of all points of one structure."""
    leaves, structure = jax.tree.flatten(point)
    return layout_of(structure, tuple([leaf.shape for leaf in leaves]))


@lru_cache(64)
def layout_of(structure: Any, shapes: tuple[tuple[int, ...], ...]) -> Layout:
    ones = jax.tree.unflatten(structure, list(map(np.ones, shapes)))
    units = flattened(unscaled(ones))
    return Layout(unflattened(np.arange(units.size), ones), units)


def places(point: Coordinates) -> Coordinates:
    """Which entry of `flattened` every coordinate is."""
    return layout(point).places


def of_owner(mounting: Mounting, owner: Int[Any, ""]) -> Mounting:
    """The entries of one segment, which belongs to recording `seat`: each leaf of length one, or
    none where it is no unknown.
    """
    return jax.tree.map(lambda leaf: leaf[owner][None] if leaf.size else leaf, mounting)


def of_segments(point: Coordinates, owner: Int[Any, " segment"]) -> Unknowns:
    """The unknowns of every segment, by a leading axis."""

    def same(tree):
        return jax.tree.map(lambda leaf: jnp.broadcast_to(leaf, owner.shape), tree)

    mounting = jax.vmap(of_owner, in_axes=(None, 0))(point.mounting, owner)
    return Unknowns(same(point.shared), mounting, point.own, same(point.terms))


def by_segment(
    point: Coordinates, owner: Int[Any, " segment"], xp=jnp
) -> Num[Any, "segment unknown"]:
    """The unknowns of every segment in one row: what the leg, its recording, itself and the terms
    own.
    """
    count = point.own.angle.shape[0]
    shared = [xp.broadcast_to(leaf, (count,)) for leaf in jax.tree.leaves(point.shared)]
    mounting = [leaf[owner] for leaf in jax.tree.leaves(point.mounting) if leaf.size]
    terms = [xp.broadcast_to(leaf, (count,)) for leaf in jax.tree.leaves(point.terms)]
    return xp.stack([*shared, *mounting, *jax.tree.leaves(point.own), *terms], axis=1)


def in_a_row(unknowns: Unknowns):
    """The unknowns of one segment in a row, in units of `typical`, and the way back."""
    point, unravel = ravel_pytree(unknowns)
    mounting, own, terms = unknowns.mounting, unknowns.own, unknowns.terms
    units = typical(Coordinates(unknowns.shared, jnp.zeros(()), mounting, own, terms))
    each = Unknowns(units.shared, units.mounting, units.own, units.terms)
    unit, _ = ravel_pytree(jax.tree.map(jnp.full_like, unknowns, each))
    return point / unit, lambda row: unravel(row * unit)


def quantities(coordinates: Coordinates, xp=jnp) -> Inexact[Any, " quantity *column"]:
    """What a fit reports, as `quantity_names` says: m, J, l, d, c, m l g / J, c / J, d / J; of each
    segment tau, tau / J; the terms' parameters, and those that go with J by what motion tells.
    """
    shared, own = coordinates.shared, coordinates.own
    leg = jax.tree.leaves(leg_parameters(coordinates, xp))
    common = xp.stack([*leg, shared.gravity, shared.stiffness, shared.damping])
    each = [common, torque_amplitudes(coordinates, xp), own.torque]
    if not coordinates.terms:
        return xp.concatenate(each)
    values = jax.tree.leaves(with_inertia(coordinates, xp))
    ratios = [
        getattr(term, name)
        for term in coordinates.terms
        for name, declared in declarations(type(term))
        if declared.inertia_power
    ]
    return xp.concatenate([*each, xp.stack([*values, *ratios])])


def quantity_names(segments: int, terms: Sequence[type[Term]] = ()) -> list[str]:
    """Which quantity every row of `quantities` is."""
    return [
        *NAMES,
        *(f"{name}_over_inertia" for name in ("gravity", "stiffness", "damping")),
        *(f"torque_amplitude[{number}]" for number in range(segments)),
        *(f"torque_over_inertia[{number}]" for number in range(segments)),
        *(name for name, _ in parameters_of(terms)),
        *(ratio_name(name, each) for name, each in parameters_of(terms) if each.inertia_power),
    ]


def with_inertia(coordinates: Coordinates, xp=jnp) -> tuple[Term, ...]:
    """The terms in their own units."""
    inertia = xp.exp(coordinates.shared.log_inertia)
    return tuple(over_inertia(term, 1 / inertia) for term in coordinates.terms)


def leg_parameters(coordinates: Coordinates, xp=jnp) -> LegParameters:
    """P without the torque: l from m l g / J, the rest directly; `xp` is jax.numpy or numpy."""
    shared = coordinates.shared
    inertia, mass = xp.exp(shared.log_inertia), xp.exp(coordinates.log_mass)
    return LegParameters(
        mass=mass,
        inertia=inertia,
        com_distance=shared.gravity * inertia / (mass * GRAVITY),
        damping=shared.damping * inertia,
        stiffness=shared.stiffness * inertia,
    )


def shared_of(leg: LegParameters) -> Shared:
    """What motion can tell of a leg."""
    return Shared(
        log_inertia=np.log(leg.inertia),
        gravity=leg.mass * leg.com_distance * GRAVITY / leg.inertia,
        stiffness=leg.stiffness / leg.inertia,
        damping=leg.damping / leg.inertia,
    )


def torque_amplitudes(coordinates: Coordinates, xp=jnp) -> Inexact[Any, "*segment"]:
    """tau of Eq. 10 in every segment [N m]."""
    return coordinates.own.torque * xp.exp(coordinates.shared.log_inertia)
