"""A fitted model simulates a recording that it has not seen."""

from functools import partial

import jax
import jax.numpy as jnp
import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.estimate import movements_of
from exoid.fitting.misfit.residual import predict
from exoid.fitting.model.coordinates import Coordinates, SegmentUnknowns, of_segments
from exoid.fitting.multistart.starts import first_state
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.ask import take
from exoid.fitting.solve.pose import pose
from exoid.recordings.recording import Recording


def missed(fitted: FitResult, recording: Recording, *, same_begin: bool = False) -> np.ndarray:
    """Simulated minus measured angle, sample by sample, all segments behind each other.

    Every segment begins at its own first measured state; with `same_begin` at that of the fit,
    whose recording began as this one does.
    """
    basis = fitted.basis
    assert basis is not None  # of one fit
    posed, movements = basis.problem, movements_of([("later", recording)])
    problem = pose(
        movements, posed.belief, "1/T", posed.chain, owned=posed.owned, terms=posed.terms
    )
    at = take(basis.ended.best.coordinates, 0)
    zero = float(at.mounting.zero[0]) if at.mounting.zero.size else 0.0  # of the encoder
    own = at.own if same_begin else begin(movements, zero)
    point = Coordinates(at.shared, at.log_mass, at.mounting, own, at.terms)
    seen, free = jax.tree.map(jnp.asarray, (problem.observation, problem.free))
    each = of_segments(jax.tree.map(jnp.asarray, point), seen.owner)
    see = jax.jit(jax.vmap(partial(predict, stage=free, chain=problem.chain)))
    shown = np.asarray(see(each, seen).angle)
    return np.concatenate(
        [
            row[problem.own_rows(number)] - movement.angle
            for number, (row, movement) in enumerate(zip(shown, movements, strict=True))
        ]
    )


def begin(movements: list[Movement], zero: float) -> SegmentUnknowns:
    """From the first measured state of every movement, by an encoder with this zero [rad]."""
    angle, velocity = np.array([first_state(each) for each in movements]).T
    return SegmentUnknowns(np.zeros(angle.size), angle - zero, velocity)


def rms(each: np.ndarray) -> float:
    return float(np.sqrt(np.nanmean(each**2)))
