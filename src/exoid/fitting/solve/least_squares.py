"""A Levenberg-Marquardt solver that stops where the next step no longer matters."""

from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import optimistix as optx
from jaxtyping import Array, Float, PyTree, Scalar


class NegligibleStep(optx.AbstractLeastSquaresSolver):
    """Wraps a Gauss-Newton type solver and ends it as soon as its next step is negligible.

    Negligible: to first order no residual would change by more than `tolerance`. With residuals
    in units of noise that is a statement about the data. Comparing successive losses, as the
    solver itself does, fails at the optimum, where rounding decides whether a step is accepted.
    """

    inner: optx.AbstractLeastSquaresSolver
    tolerance: Float[Array, ""]  # in units of the residual
    rtol: float = 0.0  # of the interface; `inner` and `tolerance` decide
    atol: float = 0.0
    norm: Callable[[PyTree], Scalar] = optx.max_norm

    def init(self, fn, y, args, options, f_struct, aux_struct, tags) -> Any:
        return self.inner.init(fn, y, args, options, f_struct, aux_struct, tags)

    def step(self, fn, y, args, options, state, tags) -> Any:
        return self.inner.step(fn, y, args, options, state, tags)

    def terminate(self, fn, y, args, options, state, tags) -> Any:
        done, result = self.inner.terminate(fn, y, args, options, state, tags)
        proposed = jax.tree.map(jnp.subtract, state.y_eval, y)
        effect = optx.max_norm(state.f_info.jac.mv(proposed))
        # After a rejection the step is short because it is damped, not because it is done.
        fresh = (state.num_steps_since_acceptance == 0) & (state.num_accepted_steps > 0)
        return done | (fresh & (effect < self.tolerance)), result

    def postprocess(self, fn, y, aux, args, options, state, tags, result) -> Any:
        return self.inner.postprocess(fn, y, aux, args, options, state, tags, result)
