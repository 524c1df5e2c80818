"""A fitted model simulates a recording that it has not seen."""

from collections.abc import Callable
from functools import partial

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from scipy.optimize import least_squares

from exoid.fitting.data.movement import Movement
from exoid.fitting.misfit.residual import predict
from exoid.fitting.model.coordinates import Coordinates, SegmentUnknowns, Unknowns, of_segments
from exoid.fitting.movements import movements_of
from exoid.fitting.multistart.beginning.starts import first_state
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.ask import take
from exoid.fitting.solve.pose import pose
from exoid.recordings.recording import Recording

WINDOW = 50  # first samples, which tell the first state and are not scored, as others have it


def missed(fitted: FitResult, recording: Recording, *, same_begin: bool = False) -> np.ndarray:
    """Simulated minus measured angle, sample by sample, all segments behind each other.

    Every segment begins as its first samples say, and counts from the next one on; with
    `same_begin` as that of the fit, whose recording began as this one does, and all count.
    """
    basis = fitted.basis
    assert basis is not None  # of one fit
    posed, movements = basis.problem, movements_of([("later", recording)])
    problem = pose(
        movements, posed.belief, "1/T", posed.chain, owned=posed.owned, terms=posed.terms
    )
    at = take(basis.ended.best.coordinates, 0)
    zero = float(at.mounting.zero[0]) if at.mounting.zero.size else 0.0  # of the encoder
    own = at.own if same_begin else first_states(movements, zero)
    point = Coordinates(at.shared, at.log_mass, at.mounting, own, at.terms)
    seen, free = jax.tree.map(jnp.asarray, (problem.observation, problem.free))
    each = of_segments(jax.tree.map(jnp.asarray, point), seen.owner)
    see = jax.jit(partial(predict, stage=free, chain=problem.chain))
    first, left = (0 if same_begin else WINDOW), []
    for number, movement in enumerate(movements):
        unknowns, observation = jax.tree.map(lambda leaf, k=number: leaf[k], (each, seen))
        rows = problem.own_rows(number)

        def error(unknowns, observation=observation, rows=rows, movement=movement):
            return np.asarray(see(unknowns, observation).angle)[rows] - movement.angle

        started = unknowns if same_begin else begin(unknowns, lambda one: error(one)[:WINDOW])
        left.append(error(started)[first:])
    return np.concatenate(left)


def begin(unknowns: Unknowns, error: Callable[[Unknowns], np.ndarray]) -> Unknowns:
    """With the first state, and what its terms remember, that miss the least."""
    remember = [(k, term.begun) for k, term in enumerate(unknowns.terms) if term.begun]

    def begun(one: Unknowns) -> list:
        loads = (getattr(one.terms[k], name) for k, name in remember)
        return [one.own.angle, one.own.angular_velocity, *loads]

    at = np.array(begun(unknowns))
    size = np.maximum(np.abs(at), 1e-3 * np.abs(at).max())

    def beginning(row: np.ndarray) -> Unknowns:
        return eqx.tree_at(begun, unknowns, list(map(jnp.asarray, size * row)))

    return beginning(least_squares(lambda row: error(beginning(row)), at / size, xtol=1e-10).x)


def first_states(movements: list[Movement], zero: float) -> SegmentUnknowns:
    """From the first measured state of every movement, by an encoder with this zero [rad]."""
    angle, velocity = np.array([first_state(each) for each in movements]).T
    return SegmentUnknowns(np.zeros(angle.size), angle - zero, velocity)


def rms(each: np.ndarray) -> float:
    return float(np.sqrt(np.nanmean(each**2)))
