"""What a user of SciPy runs: SLSQP in NumPy, SLSQP in numba, and trust-region least squares.

All minimise the misfit of `rival_kernels` from the same starts.
"""

from collections.abc import Callable
from dataclasses import astuple, dataclass
from functools import partial

import numpy as np
from scipy.optimize import least_squares, minimize

from problem import ANGLE_NOISE, GRAVITY, LOWER, REACH, TIME_STEP, UPPER, Problem
from rival_kernels import Data, compiled_residuals, flatten, python_residuals, reduced_residuals

# m l g / J (from J <= REACH m l and m l^2 <= J), c / J, d / J, tau / J where Eq. 13 holds. Eq. 13
# would let d / J reach 400 1/s, but RK4 at this step turns unstable at 279 and has false minima
# there, which cost this method 3 % of its starts.
RATIO_LOWER = np.array([GRAVITY / REACH, 0.0, 0.0, LOWER[5] / LOWER[1]])
RATIO_UPPER = np.array(
    [GRAVITY / LOWER[2], UPPER[4] / LOWER[1], 2 / TIME_STEP, UPPER[5] / LOWER[1]]
)
REACHED = 1e-3  # see success_rate


@dataclass(frozen=True, eq=False)
class Fits:
    """What became of each start (leading axis)."""

    cost: np.ndarray  # half the sum of squared residuals
    ratios: np.ndarray  # m l g / J, c / J, d / J, then tau / J of each cycle
    success: np.ndarray  # the solver's own word
    evaluations: np.ndarray  # simulations of the whole recording


def success_rate(fits: Fits, best_cost: float) -> float:
    """Share of starts whose cost is within 1e-3 of the best that any method found.

    On one cycle that is a rise of 0.4 in chi-square, less than one standard error of any
    parameter; the next minimum lies far above it, so the rate counts basins, not last digits.
    """
    return float(np.mean(fits.cost <= (1 + REACHED) * best_cost))


def slsqp_numpy(problem: Problem, starts: np.ndarray, mapper: Callable = map) -> Fits:
    """SLSQP on m, J, l, d, c, each tau and the initial states, simulated by a Python loop."""
    return fit_each(partial(slsqp, python_residuals, problem, problem), problem, starts, mapper)


def slsqp_numba(problem: Problem, starts: np.ndarray, mapper: Callable = map) -> Fits:
    """The same with a compiled simulation."""
    solve = partial(slsqp, compiled_residuals, flatten(problem), problem)
    return fit_each(solve, problem, starts, mapper)


def trf_numba(problem: Problem, starts: np.ndarray, mapper: Callable = map) -> Fits:
    """Trust-region least squares on the identifiable ratios, with compiled sensitivities.

    A `mapper` such as `multiprocessing.Pool(2).map` spreads the starts over processes.
    """
    return fit_each(partial(trf, flatten(problem)), problem, starts, mapper)


def fit_each(solve: Callable, problem: Problem, starts: np.ndarray, mapper: Callable) -> Fits:
    """Every cycle starts from the start's tau, every segment from its first sample."""
    cycles = sum(segment.frequency > 0 for segment in problem)
    states = np.array([[s.angle[0], s.angular_velocity[0]] for s in problem]).ravel()
    rows = [np.concatenate([row[:5], np.repeat(row[5], cycles), states]) for row in starts]
    each = [astuple(fit) for fit in mapper(solve, rows)]
    return Fits(*(np.array(column) for column in zip(*each, strict=True)))


def to_ratios(x: np.ndarray) -> np.ndarray:
    """(m, J, l, d, c, each tau) to the combinations that a motion can identify."""
    mass, inertia, distance, damping, stiffness = x[:5]
    return np.concatenate([[mass * distance * GRAVITY, stiffness, damping], x[5:]]) / inertia


def slsqp(residuals: Callable, data, problem: Problem, start: np.ndarray) -> Fits:
    """What SLSQP finds from one start; it needs a cost in rad^2 and parameters of order one.

    With the chi-square itself, a mean square or unscaled parameters it stops at far fewer minima.
    """
    states = 2 * len(problem)
    cycles = start.size - 5 - states
    lower = np.concatenate([LOWER[:5], np.repeat(LOWER[5], cycles), np.full(states, -np.inf)])
    upper = np.concatenate([UPPER[:5], np.repeat(UPPER[5], cycles), np.full(states, np.inf)])
    scale = np.where(np.isfinite(upper), upper - lower, 1.0)

    def square(y):
        x = y * scale
        with np.errstate(over="ignore", invalid="ignore"):
            r = residuals(np.concatenate([to_ratios(x[:-states]), x[-states:]]), data)
            return r @ r * ANGLE_NOISE**2

    def body(y):
        """How far J is above m l^2, and below what a leg of this reach can have."""
        mass, inertia, distance = (y * scale)[:3]
        return np.array([inertia - mass * distance**2, REACH * mass * distance - inertia])

    found = minimize(
        square,
        start / scale,
        method="SLSQP",
        bounds=list(zip(lower / scale, upper / scale, strict=True)),
        constraints={"type": "ineq", "fun": body},
        options={"maxiter": 1000, "ftol": 1e-8},
    )
    cost = found.fun / ANGLE_NOISE**2 / 2 if np.isfinite(found.fun) else np.inf
    return Fits(cost, to_ratios((found.x * scale)[:-states]), found.success, found.nfev)


def trf(data: Data, start: np.ndarray) -> Fits:
    states = 2 * data.amplitude.size
    cycles = start.size - 5 - states
    shared = np.concatenate([np.arange(3), np.repeat(3, cycles)])
    lower = np.concatenate([RATIO_LOWER[shared], np.full(states, -np.inf)])
    upper = np.concatenate([RATIO_UPPER[shared], np.full(states, np.inf)])
    x = np.clip(np.concatenate([to_ratios(start[:-states]), start[-states:]]), lower, upper)
    latest: dict[str, np.ndarray] = {}

    def residuals(x):
        r, latest["jacobian"] = reduced_residuals(x, data)
        return r

    found = least_squares(
        residuals,
        x,
        jac=lambda x: latest["jacobian"],  # SciPy asks for it where it last asked residuals
        bounds=(lower, upper),
        x_scale="jac",
        ftol=1e-6,
        xtol=1e-6,
        gtol=1e-6,
        max_nfev=100,
    )
    return Fits(found.cost, found.x[:-states], found.success, found.nfev)
