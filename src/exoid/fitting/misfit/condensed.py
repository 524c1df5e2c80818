"""A segment's misfit and its derivatives at one point, as what is asked of them needs them."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

from exoid.fitting.misfit.gram import Cause
from exoid.physics.record import record


@record
class Condensed:
    """R, Q'r and the rest of one segment's residual, in units of noise and of `typical`."""

    factor: Float[Any, "*batch unknown unknown"]
    projection: Float[Any, "*batch unknown"]
    remainder: Float[Any, "*batch"]


@record
class Sensed:
    """The residual of every sample, and its derivatives, in units of noise and of `typical`."""

    residual: Float[Any, "*segment time channel"]
    columns: Float[Any, "*segment unknown time channel"]
    responses: Float[Any, "*segment push time channel"]  # to missing torques


@record
class Triangles:
    """R of (S, A, r) = Q R of a segment for each cause that may disturb it: the effects S of its
    nodes, the sensitivities A and the residual r.
    """

    inside: dict[Cause, Float[Any, "*segment node column"]]
    outside: dict[Cause, Float[Any, "*segment row rest"]]  # without S


@dataclass(frozen=True, eq=False)
class Neighbourhood:
    """First derivatives at a point in scaled coordinates, and the information they carry."""

    data: Float[np.ndarray, "coordinate coordinate"]  # Gauss-Newton information of the misfit
    prior: Float[np.ndarray, "coordinate coordinate"]  # of the prior, and of what is declared
    declared: Float[np.ndarray, "coordinate coordinate"]  # of what is declared of the recordings
    quantities: Float[np.ndarray, "quantity coordinate"]  # d of `coordinates.quantities`
    constraints: Float[np.ndarray, "constraint coordinate"]  # d g
