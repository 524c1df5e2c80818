"""What is believed of the unknowns: a mean and a root of the covariance."""

from typing import Any

import equinox as eqx
from jaxtyping import Float


class Gaussian(eqx.Module):
    """A normal distribution; its covariance is root root', which rounding cannot make negative."""

    mean: Float[Any, "*filter unknown"]
    root: Float[Any, "*filter unknown unknown"]  # lower triangle
