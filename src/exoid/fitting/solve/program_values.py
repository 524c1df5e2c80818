"""What the compiled program takes in and gives back. Light to import: no solver is loaded."""

from dataclasses import replace
from functools import cache
from typing import Any

import jax
import numpy as np
from jaxtyping import Bool, Float, Int

from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.condensed import Condensed, Sensed, Triangles
from exoid.fitting.misfit.gram import CAUSES
from exoid.fitting.model.coordinates import TYPICAL, Coordinates
from exoid.fitting.model.term_parameters import typical_term
from exoid.physics.leg import LegParameters
from exoid.physics.record import record
from exoid.physics.term import Term


@record
class Task:
    """What a run of the solver is asked to do."""

    stage: Stage
    bounded: Float[Any, ""]  # 1: with prior and limits, 0: the data alone
    tolerance: Float[Any, ""]  # in units of noise
    rounds: Int[Any, ""]  # of multiplier updates
    penalty: Float[Any, " constraint"]  # rho


@record
class StartRequest:
    """What a start is asked for by itself.

    `strength` (weights . quantities - target) joins the residual. Where such a search ends, the
    loss is the least for the value that the quantity has there: a point of its profile.
    """

    noise_scale: Float[Any, "*start segment"]  # the segment's residual is divided by it
    weights: Float[Any, "*start quantity"]  # of `coordinates.quantities`
    target: Float[Any, "*start"]
    strength: Float[Any, "*start"]


@record
class Solved:
    """Where every start of the block ended."""

    coordinates: Coordinates
    leg: LegParameters
    torque: Float[Any, "*start segment"]  # N m
    loss: Float[Any, "*start"]  # half the sum of squares, data and prior
    misfit: Float[Any, "*start"]  # sum of squares of the data residual over their noise
    quantities: Float[Any, "*start quantity"]
    condensed: Condensed  # at the end point, of every segment over its `noise_scale`
    noise_scale: Float[Any, "*start segment"]
    multiplier: Float[Any, "*start constraint"]
    violation: Float[Any, "*start"]
    steps: Int[Any, "*start"]
    exhausted: Bool[Any, "*start"]
    angle: Float[Any, "*start segment time"]  # rad, as simulated
    angular_velocity: Float[Any, "*start segment time"]  # rad/s


@cache
def solved_structure(terms: tuple[type[Term], ...] = ()):
    """The tree structure of `Solved`, for a program that gives back bare arrays."""
    solved = Solved(
        coordinates=replace(TYPICAL, terms=tuple(map(typical_term, terms))),
        leg=LegParameters(*[NUMBER] * 5),
        torque=ROW,
        loss=NUMBER,
        misfit=NUMBER,
        quantities=ROW,
        condensed=Condensed(TABLE, ROW, NUMBER),
        noise_scale=ROW,
        multiplier=ROW,
        violation=NUMBER,
        steps=np.zeros((), int),
        exhausted=np.zeros((), bool),
        angle=TABLE,
        angular_velocity=TABLE,
    )
    return jax.tree.structure(solved)


NUMBER, ROW, TABLE = np.zeros(()), np.zeros(1), np.zeros((1, 1))
SENSED = jax.tree.structure(Sensed(TABLE, *[np.zeros((1, 1, 1))] * 2))
TRIANGLES = jax.tree.structure(Triangles(*[dict.fromkeys(CAUSES, TABLE)] * 2))
