"""Profiles: how much worse the best fit gets where one quantity is held elsewhere.

Where the quadratic picture behind a standard error fails (a bound, a trade-off, nothing in the data
that tells), a profile still says what the recording allows: the interval in which twice the loss
rises by less than the 95 % point of chi-square with one degree of freedom (Venzon & Moolgavkar,
Applied Statistics 37(1), 1988).
"""

from dataclasses import dataclass
from typing import Literal

import jax
import numpy as np
from jaxtyping import Float

from exoid.fitting.misfit.neighbourhood import penalties, weighed
from exoid.fitting.misfit.uncertainty import decomposed, spread
from exoid.fitting.model.coordinates import Coordinates, flattened, scaled, unflattened, unscaled
from exoid.fitting.multistart.search_result import FEASIBLE, LIMITED
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.estimates.scale import UNLIKE, hidden
from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.solve.ask import advance, around, lowest, task
from exoid.fitting.solve.program_values import StartRequest

Shape = Literal["two-sided", "lower limit only", "upper limit only", "flat"]

RISE = 3.841  # of twice the loss: the 95 % point of chi-square with one degree of freedom
REACH = 3.0  # standard errors to either side that are looked at
POINTS = 13  # of a profile, odd: one is the best fit
FEWEST = 3  # of them that must be reached
PULL = 10.0  # strength over one standard error: a point falls 1 % short of its target, and says so
HALVINGS = 25  # of an interval of noise scales
WIDE = 0.5  # of a value, to either side, where nothing tells how far to look


@dataclass(frozen=True, eq=False)
class Profile:
    """The least loss for every value of one quantity.

    >>> profile = exoid.profiles(exoid.fit("drops.csv"))["damping_over_inertia"]
    >>> profile.lower < profile.estimate.value < profile.upper
    True
    """

    name: str
    estimate: Estimate
    value: Float[np.ndarray, " point"]  # in the quantity's unit, increasing
    rise: Float[np.ndarray, " point"]  # of twice the loss over the best
    lower: float | None  # of the 95 % interval; None where no value is too small
    upper: float | None

    @property
    def shape(self) -> Shape:
        """Which ends the recording and the prior can tell."""
        if self.lower is None:
            return "flat" if self.upper is None else "upper limit only"
        return "lower limit only" if self.upper is None else "two-sided"


@dataclass(frozen=True, eq=False)
class ProfiledQuantity:
    """One quantity to profile: its weights among `coordinates.quantities`, and where to look."""

    name: str
    estimate: Estimate
    weights: np.ndarray
    targets: np.ndarray
    step: float  # about one standard error
    noise_scale: float
    wider: float  # times: its error holds what leads a fit astray, too, which no loss shows
    lowest: float  # that it can be
    highest: float


def profiles(result: FitResult) -> dict[str, Profile]:
    """The profile of every parameter and ratio, all points as starts of one search.

    One of which hardly a point can be reached within the limits has no profile, and is left out; so
    is one that the fit holds back though its loss would tell it, as J where a torque's gain is
    unknown, and every one where motion and anatomy contradict each other, for the loss holds both.

    **Raises** `ValueError` for a result that has no one fit to profile (`fit_each`), or was saved.

    >>> each = exoid.profiles(exoid.fit("drops.csv"))
    >>> each["gravity_over_inertia"].estimate.unit
    '1/s^2'
    """
    basis = result.basis_to("profile")
    if result.parameters["inertia"].reason == UNLIKE:
        return {}
    limits = limits_of(result.parameters)
    quests = [
        quest
        for name, each in named(result)
        if not hidden(each)
        and (quest := posed(basis, name, each, limits.get(name, (-np.inf, np.inf))))
    ]
    request = StartRequest(
        noise_scale=np.repeat([each.noise_scale for each in quests], POINTS)[:, None]
        * basis.ended.disturbance.weighing(basis.problem.kinds),
        weights=np.concatenate([np.tile(each.weights, (POINTS, 1)) for each in quests]),
        target=np.concatenate([each.targets for each in quests]),
        strength=np.concatenate([np.full(POINTS, PULL / each.step) for each in quests]),
    )
    begins = [begin(basis, each) for each in quests]
    starts = jax.tree.map(lambda *each: np.concatenate(each), *begins)
    problem, ended = basis.problem, basis.ended
    seen = ended.best if problem.belief.by_hand.fix else ended.free
    local = around(problem, seen, row=lowest(seen))
    penalty = penalties(weighed(local, ended.disturbance.scale))
    asked = task(problem, 0.0, problem.steps, LIMITED, penalty)
    solved = advance(problem, starts, asked, request=request)
    reached = np.sum(request.weights * solved.quantities, axis=1)
    loss = np.where(solved.violation < FEASIBLE, 2 * solved.loss, np.inf)
    parts = zip(quests, reached.reshape(-1, POINTS), loss.reshape(-1, POINTS), strict=True)
    found = [traced(each, value, twice) for each, value, twice in parts]
    return {each.name: each for each in found if each is not None}


def named(result: FitResult) -> list[tuple[str, Estimate]]:
    """Parameters, mean torque, ratios, and what the terms have."""
    torque = result.torque_amplitude
    tau = [] if torque is None else [("torque_amplitude", torque)]
    return [*result.parameters.items(), *tau, *result.ratios.items(), *result.of_terms.items()]


def limits_of(parameters: dict[str, Estimate]) -> dict[str, tuple[float, float]]:
    """Between which values a parameter can be, and that a ratio of one that cannot be negative
    cannot be either.
    """
    limits = {name: ends(each) for name, each in parameters.items()}
    ratios = {
        f"{name}_over_inertia": (0.0, np.inf) for name, (lower, _) in limits.items() if lower >= 0
    }
    return limits | ratios


def ends(each: Estimate) -> tuple[float, float]:
    """The least and the largest that it can be."""
    lower = -np.inf if each.lower is None else each.lower
    return lower, np.inf if each.upper is None else each.upper


def weights_of(name: str, basis: Basis) -> np.ndarray:
    """Which of `coordinates.quantities` this is, or a mean of which."""
    wanted = basis.problem.quantities_of(name)
    return np.isin(basis.problem.quantities, wanted) / len(wanted)


def posed(
    basis: Basis, name: str, estimate: Estimate, limits: tuple[float, float]
) -> ProfiledQuantity | None:
    """Where to look for one quantity; None where it does not exist, as m of a rig."""
    weights = weights_of(name, basis)
    gradient = weights @ basis.ended.local.quantities
    value = float(weights @ basis.ended.best.quantities[0])
    if estimate.by_hand == "fix":
        return None  # one value alone
    # A bound may have narrowed the error on one side only: look as far as it would reach without.
    free = basis.information.without_bounds(gradient)
    known = basis.information.standard_error(gradient)
    error = estimate.standard_error or 0.0
    wider = max(error / known, 1.0) if known else 1.0
    step = max(error / wider, free if np.isfinite(free) else 0.0)
    step = step or WIDE * abs(value) / REACH
    if not step > 0:
        return None
    targets = value + step * np.linspace(-REACH, REACH, POINTS)
    scale = matching(basis, gradient, estimate.standard_error)
    return ProfiledQuantity(name, estimate, weights, targets, float(step), scale, wider, *limits)


def matching(basis: Basis, gradient: np.ndarray, error: float | None) -> float:
    """The noise scale with which data and prior leave this quantity its error without limits.

    A disturbance widens every direction by its own factor; a profile has one, which must be right
    for its quantity.
    """
    found, local = basis.ended.disturbance, basis.ended.local
    if error is None:
        return found.scale
    plain = weighed(around(basis.problem, basis.ended.best), 1 / found.scale).data
    open_ways, least = basis.information.open, min(1.0, float(found.widening.min()))
    unlimited = basis.information.without_bounds(gradient)  # a profile meets its limits itself
    low, high = float(np.log(least)), float(np.log(found.widening.max())) + 1e-6
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        total = open_ways.T @ (plain / np.exp(2 * middle) + local.prior) @ open_ways
        wide = spread(decomposed(total), open_ways, gradient) > unlimited
        low, high = (low, middle) if wide else (middle, high)
    return float(np.exp(high))


def begin(basis: Basis, quest: ProfiledQuantity) -> Coordinates:
    """Where the quadratic picture has each point: along I^-1 times the gradient."""
    best = basis.ended.point
    gradient = quest.weights @ basis.ended.local.quantities
    total = basis.ended.local.data + basis.ended.local.prior
    total = total + np.diag(1e-6 * (1 + np.diag(total)))
    direction = np.linalg.solve(total, gradient)
    change = quest.targets - quest.weights @ basis.ended.best.quantities[0]
    flat = flattened(scaled(best)) + np.outer(change, direction / (gradient @ direction))
    points = [unscaled(unflattened(each, best)) for each in flat]
    return jax.tree.map(lambda *each: np.stack(each), *points)


def traced(quest: ProfiledQuantity, value: np.ndarray, twice: np.ndarray) -> Profile | None:
    """The profile through the points that were reached; None where they are too few for a curve."""
    order = np.argsort(value)
    value, twice = value[order], twice[order]
    good = np.isfinite(twice) & np.append(True, np.diff(value) > 1e-9 * quest.step)
    if good.sum() < FEWEST:
        return None
    value, rise = value[good], twice[good] - twice[good].min()
    best = int(np.argmin(rise))
    value = value[best] + quest.wider * (value - value[best])
    value, rise = cut(value, rise, best, (quest.lowest, quest.highest))
    best = int(np.argmin(rise))
    return Profile(
        name=quest.name,
        estimate=quest.estimate,
        value=value,
        rise=rise,
        lower=crossing(value[: best + 1][::-1], rise[: best + 1][::-1]),
        upper=crossing(value[best:], rise[best:]),
    )


def cut(
    value: np.ndarray, rise: np.ndarray, best: int, limits: tuple[float, float]
) -> tuple[np.ndarray, np.ndarray]:
    """The curve without what a wider error moved beyond the limits; it ends on them, where its
    root is linear between the points.
    """
    low, high = min(limits[0], value[best]), max(limits[1], value[best])
    inside = (value >= low) & (value <= high)
    if inside.all():
        return value, rise
    met = [end for end in (low, high) if value[0] < end < value[-1] and end not in value]
    along = np.sort([*value[inside], *met])
    return along, np.interp(along, value, np.sqrt(np.maximum(rise, 0.0))) ** 2


def crossing(value: np.ndarray, rise: np.ndarray) -> float | None:
    """Where `rise` passes RISE for good on the way out; between points its root is linear.

    A search that ends early, as at a kink of dry friction, makes a rise too large and never too
    small: what is reached beyond it counts.
    """
    last = int(np.flatnonzero(rise <= RISE)[-1])
    if last + 1 == rise.size:
        return None
    root = np.sqrt(np.maximum(rise, 0.0))
    part = (np.sqrt(RISE) - root[last]) / (root[last + 1] - root[last])
    return float(value[last] + part * (value[last + 1] - value[last]))
