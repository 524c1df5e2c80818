"""A segment's misfit and its derivatives at one point, as what is asked of them needs them."""

from typing import Any

import equinox as eqx
from jaxtyping import Float


class Condensed(eqx.Module):
    """R, Q'r and the rest of one segment's residual, in units of noise and of `TYPICAL`."""

    factor: Float[Any, "*batch unknown unknown"]
    projection: Float[Any, "*batch unknown"]
    remainder: Float[Any, "*batch"]


class Sensed(eqx.Module):
    """The residual of every sample, and its derivatives, in units of noise and of `TYPICAL`."""

    residual: Float[Any, "*segment time channel"]
    columns: Float[Any, "*segment unknown time channel"]
    responses: Float[Any, "*segment push time channel"]  # to missing torques
