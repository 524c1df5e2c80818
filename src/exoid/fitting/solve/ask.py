"""How the compiled programs are asked about a problem."""

from collections.abc import Iterable
from dataclasses import replace

import jax
import numpy as np

from exoid.fitting.data.stage import Stage
from exoid.fitting.misfit.condensed import Neighbourhood, Sensed
from exoid.fitting.misfit.gram import CAUSES, Cause, Grams
from exoid.fitting.misfit.gram_matrices import declared, gram, nodes_of, undisturbed
from exoid.fitting.misfit.information import spoiled
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.neighbourhood import columns, declared_slopes, neighbourhood, told
from exoid.fitting.model.coordinates import Coordinates, layout, take
from exoid.fitting.model.prior import mounting_residual
from exoid.fitting.model.term_parameters import parameters_of
from exoid.fitting.solve.cores.side_by_side import side_by_side
from exoid.fitting.solve.meeting import MEETING
from exoid.fitting.solve.problem import STRICT, Problem
from exoid.fitting.solve.program_cache import run, run_sense, run_triangles
from exoid.fitting.solve.program_values import Solved, StartRequest, Task
from exoid.physics.motion.step import Drive

ROUNDS = 10  # of multipliers; two digits a round
BATCH = 16  # lanes of start and segment at once: more leave the fast path of the compiled loop
PAIR = 2  # starts at once of a leg with many segments
LONG = 2000  # steps, from which on lanes that only repeat a start take longer than a program
# Segments from which on a start is alone: jaxlib factorises several large matrices on XLA's own
# threads and waits for them on one of these, for ever where two programs run beside each other.
CROWD = 16


def task(
    problem: Problem,
    tether: float,
    steps: int,
    tolerance: float,
    penalty: np.ndarray | None = None,
    rounds: int = ROUNDS,
) -> Task:
    """What to ask of the solver; with a `penalty` per constraint, prior and limits take part.

    `rounds` are the most updates of the multipliers, where there are limits.
    """
    bounded = penalty is not None
    own = [name for name, _ in parameters_of(problem.terms)]
    first = np.where(np.isin(problem.constraints, own), STRICT, 1.0)
    return Task(
        stage=Stage(np.asarray(float(tether)), np.asarray(steps), compact=bool(problem.terms)),
        bounded=np.asarray(float(bounded)),
        tolerance=np.asarray(tolerance),
        rounds=np.asarray(rounds if bounded or problem.terms else 1),
        penalty=first if penalty is None else penalty,
    )


def advance(
    problem: Problem,
    starts: Coordinates,
    task: Task,
    scale: np.ndarray | float = 1.0,
    request: StartRequest | None = None,
) -> Solved:
    """Solve from all starts, a batch at a time: a batch ends when its slowest start has.

    The residual counts 1 / `scale`, or of each segment 1 / its entry; a `request` says so for every
    start by itself.
    """
    count = starts.log_mass.shape[0]
    few = not problem.terms and len(problem.movements) <= CROWD
    lanes = max(PAIR, BATCH // len(problem.movements)) if few else 1
    if count <= PAIR and problem.steps > LONG:
        lanes = min(lanes, PAIR)
    if MEETING.get() is not None:  # a run that many share is filled by them
        lanes = count
    if request is None:
        request = plain_request(problem, np.broadcast_to(scale, (count, len(problem.movements))))

    belief = problem.belief
    same = problem.observation, problem.known, belief.prior, belief.limits, task, problem.chain
    if lanes == count:
        return run(starts, request, *same)

    def batch(first: int) -> Solved:
        rows = np.minimum(np.arange(first, first + lanes), count - 1)
        return run(take(starts, rows), take(request, rows), *same)

    parts = side_by_side(batch, range(0, count, lanes))
    return jax.tree.map(lambda *each: np.concatenate(each)[:count], *parts)


def plain_request(problem: Problem, scale: np.ndarray) -> StartRequest:
    """Starts that are pulled nowhere; `scale` is (start, segment)."""
    nothing = np.zeros(len(scale))
    weights = np.zeros((len(scale), len(problem.quantities)))
    return StartRequest(np.array(scale), weights, nothing, nothing)


def grams_at(
    problem: Problem, at: Solved, row: int = 0, causes: Iterable[Cause] = CAUSES
) -> list[Grams]:
    """The inner products of every segment at one end point, for these causes."""
    point = take(at.coordinates, row)
    return grams_in(problem, point, columns(point, problem.observation.owner), causes)


def grams_in(
    problem: Problem, point: Coordinates, places: np.ndarray, causes: Iterable[Cause]
) -> list[Grams]:
    """The same at a point, the unknowns of every segment at these places."""
    seen, nodes = problem.observation, nodes_of(problem.durations)
    found = run_triangles(point, seen, problem.known, nodes, problem.free, problem.chain)
    return [
        {cause: gram(found, number, cause, place, own) for cause in causes}
        for number, (place, own) in enumerate(zip(places, nodes, strict=True))
    ]


def undisturbed_at(problem: Problem, at: Solved, row: int, causes: Iterable[Cause]) -> list[Grams]:
    """The same where nothing disturbs them, of what the search knows already."""
    one, owner = take(at, row), problem.observation.owner
    each = zip(columns(one.coordinates, owner), one.noise_scale, strict=True)
    return [
        dict.fromkeys(causes, undisturbed(one.condensed, number, scale, place))
        for number, (place, scale) in enumerate(each)
    ]


def declared_at(problem: Problem, at: Solved, row: int = 0) -> Grams:
    """What is declared of the recordings, beside the inner products of their segments."""
    point, prior = take(at.coordinates, row), problem.belief.prior
    residual = mounting_residual(prior, point.mounting, np)
    return dict.fromkeys(CAUSES, declared(residual, declared_slopes(point, prior)))


def sensed(problem: Problem, point: Coordinates, steady: np.ndarray | None = None) -> Sensed:
    """Residual and sensitivities of every sample at a point; with the response of every segment to
    a `steady` torque over J [rad/s^2].
    """
    seen = problem.observation
    pushes = np.zeros((len(problem.movements), 0)) if steady is None else steady[:, None]
    each = np.repeat(pushes[:, :, None], seen.time.shape[1] - 1, axis=2)
    missing = Drive(each, each, each)
    return run_sense(point, seen, problem.known, missing, problem.free, problem.chain)


def around(
    problem: Problem, at: Solved, disturbance: Disturbance | None = None, row: int = 0
) -> Neighbourhood:
    """Derivatives and information at one end point; of the data what a `disturbance` leaves."""
    one = take(at, row)
    belief, owner = problem.belief, problem.observation.owner
    local = neighbourhood(one.coordinates, one.condensed, owner, belief.prior, belief.limits)
    if disturbance is None:
        return local
    return replace(local, data=left(problem, at, row, disturbance).information)


def told_at(problem: Problem, at: Solved, row: int) -> np.ndarray:
    """The information that the data carry around one end point, of white noise alone."""
    point, condensed = take((at.coordinates, at.condensed), row)
    return told(condensed, columns(point, problem.observation.owner), layout(point).size)


def left(problem: Problem, at: Solved, row: int, disturbance: Disturbance) -> Disturbance:
    """The same disturbance, with the information that it leaves at one end point."""
    causes = set(disturbance.causes(problem.kinds))
    asked = grams_at if disturbance.cause else undisturbed_at
    every = asked(problem, at, row, causes)
    return left_by(every, problem, at, row, disturbance)


def left_by(
    every: list[Grams], problem: Problem, at: Solved, row: int, disturbance: Disturbance
) -> Disturbance:
    """The same by the inner products of every segment there."""
    causes, size = disturbance.causes(problem.kinds), layout(take(at.coordinates, row)).size
    each = [own[cause] for own, cause in zip(every, causes, strict=True)]
    return spoiled(disturbance, each, problem.kinds, size)


def better_of(*fits: Solved) -> Solved:
    """Of several fits from as many starts, the lowest of each start."""
    every = jax.tree.map(lambda *each: np.stack(each), *fits)
    best = np.argmin(finite(every.loss), axis=0)
    return jax.tree.map(lambda leaf: leaf[best, np.arange(best.size)], every)


def lowest(solved: Solved) -> int:
    """The row of the best."""
    return int(np.argmin(finite(solved.loss)))


def finite(loss: np.ndarray) -> np.ndarray:
    """A start whose loss is not a number ended nowhere: it can never be the best."""
    return np.where(np.isfinite(loss), loss, np.inf)
