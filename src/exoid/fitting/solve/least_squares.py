"""A Levenberg-Marquardt solver that stops where the next step no longer matters."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import equinox as eqx
import jax
import jax.numpy as jnp
import lineax as lx
import optimistix as optx
from jaxtyping import Array, Float, PyTree, Scalar

EXACT = 1e-10  # a change of loss and point that is rounding; a tolerance decides before
HASTE, HASTIEST = 0.5, 1 / 16  # by which steps are damped more with each rejection, and most ...
BITES = 0.5  # ... until one shortens them to this


class HasteningTrustRegion(optx.ClassicalTrustRegion):
    """Where a rejection hardly shortened the step, the next one damps the more (Nielsen's rule,
    IMM-REP-1999-05, as long as damping does not bite).

    Unknowns are told by so many samples that a first damping of 1 is none: at a crease, as dry
    friction leaves them, one fixed share would need a dozen rejections before a step is damped.
    """

    def init(self, y, f_info_struct) -> Any:
        return super().init(y, f_info_struct), jnp.array(1.0), jnp.array(0.0)

    def step(self, first_step, y, y_eval, f_info, f_eval_info, state: Any) -> Any:
        region, share, before = state
        size, accept, result, region = super().step(
            first_step, y, y_eval, f_info, f_eval_info, region
        )
        length = optx.max_norm(jax.tree.map(jnp.subtract, y_eval, y))
        bites = accept | (length < BITES * before)
        share = jnp.where(bites, 1.0, jnp.maximum(HASTE * share, HASTIEST))
        size, before = jnp.where(accept, size, share * size), jnp.where(accept, 0.0, length)
        return size, accept, result, (replace(region, step_size=size), share, before)


def levenberg_marquardt() -> optx.LevenbergMarquardt:
    """Damped Gauss-Newton by the normal equations, its steps as above."""
    inner = optx.LevenbergMarquardt(EXACT, EXACT, linear_solver=lx.Normal(lx.Cholesky()))
    return eqx.tree_at(lambda solver: solver.search, inner, HasteningTrustRegion())


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
        return done | ((state.num_accepted_steps > 0) & (effect < self.tolerance)), result

    def postprocess(self, fn, y, aux, args, options, state, tags, result) -> Any:
        return self.inner.postprocess(fn, y, aux, args, options, state, tags, result)
