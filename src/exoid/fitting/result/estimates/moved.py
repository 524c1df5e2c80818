"""How far a fit may have moved by what is no unknown of it, and its numbers with it.

A leg may follow another law than a term, and a measured torque read other than zero where none
acts. Such a zero u is a torque that acts all the time. Around a fit without it, which moves by
dz = -(A'A + P)^-1 A'b u for it, the residual r and the response b tell it as

    u = -b'r / (1 / s^2 + b'b - b'A (A'A + P)^-1 A'b),

s being its standard deviation and P what is believed. A tilt of the seat, an encoder's zero and a
spring's slack angle make nearly the same torque: the fit takes what it cannot tell apart for those.
Where more than noise is missed, r tells none; then u is at most what would leave as much as that.
Where other segments lie beside those that a torque drove, it is an unknown of the fit itself.
"""

from dataclasses import dataclass

import numpy as np

from exoid.fitting.misfit.neighbourhood import columns, pull_of_belief
from exoid.fitting.misfit.uncertainty import VAGUE, Information
from exoid.fitting.model.coordinates import layout
from exoid.fitting.model.systematics import zero_of_torque
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.solve.ask import sensed
from exoid.fitting.solve.problem import Problem

BEYOND = 8.0  # standard deviations of what is declared, from which on nobody believes it
NOISY = 2.0  # times the sensors' noise, from which on the residual tells no zero


@dataclass(frozen=True, eq=False)
class Moved:
    """Steps of the coordinates, (coordinate, step) by cause, each of one standard deviation."""

    by: dict[str, np.ndarray]

    def widen(self, each: Estimate, gradient: np.ndarray) -> Estimate:
        """An estimate of this gradient, its error with how far it may be off."""
        for cause, steps in self.by.items():
            each = each.widened(float(np.linalg.norm(gradient @ steps)), cause=cause)
        return each

    def off(self, gradient: np.ndarray) -> float:
        """How far a quantity of this gradient may be off."""
        return float(np.linalg.norm([np.linalg.norm(gradient @ each) for each in self.by.values()]))


def moved(
    problem: Problem, ended: SearchResult, information: Information, by_law: np.ndarray | None
) -> Moved:
    """By the zero of a torque's sensor, a clock that nobody believes to be so far off, a law that a
    leg follows otherwise than a term, and `by_law` of what is missed, where one is seen.
    """
    each = {
        "clock": moved_by_clocks(problem, ended, information),
        "torque_zero": moved_by_torque_zero(problem, ended, information.free),
        "reflex_form": moved_by_law(problem, ended, information),
    }
    return Moved(each if by_law is None else each | {"missed_law": by_law[:, None]})


def moved_by_clocks(problem: Problem, ended: SearchResult, information: Information) -> np.ndarray:
    """How far it moves, (coordinate, recording), where a clock that it takes to be far off is as
    declared: the motion tells no clock.
    """
    laid, off = layout(ended.point), ended.point.mounting.clock
    wide = problem.deviation_of("clock")
    far = [each for each in problem.estimated("clock") if abs(off[each]) > BEYOND * wide[each]]
    places = np.asarray(laid.places.mounting.clock)[far].astype(int)
    return moved_with(np.diag(laid.units)[places], np.asarray(off)[far], information)


def moved_by_law(problem: Problem, ended: SearchResult, information: Information) -> np.ndarray:
    """How far it moves, (coordinate, quantity), with each quantity of which a term says so."""
    off = {name: size for term in problem.terms for name, size in term.law_of.items()}
    names = [name for name in off if name in problem.quantities]
    rows = ended.local.quantities[[problem.quantities.index(name) for name in names]]
    return moved_with(rows, np.array([off[name] for name in names]), information)


def moved_with(rows: np.ndarray, sizes: np.ndarray, information: Information) -> np.ndarray:
    """How far x moves where a quantity a'x, a row of `rows`, is off by s: C a s / a'C a, C being
    the covariance of x.
    """
    root = information.root
    if root is None:
        return np.zeros((rows.shape[1], 0))
    along = rows @ root
    told = np.sum(along**2, axis=1)
    share = np.divide(sizes, told, out=np.zeros_like(sizes), where=told > 0)
    return root @ along.T * share


def moved_by_torque_zero(problem: Problem, ended: SearchResult, free: np.ndarray) -> np.ndarray:
    """How far it may have moved the fit, (coordinate, recording), in the units that the solver
    sees; no column where no torque is measured, or where it is an unknown of the fit. In the
    `free` directions no bound holds the coordinates.
    """
    deviation = np.array([zero_of_torque(own) for own in problem.recordings])
    if "torque_zero" in problem.owned or not deviation.any():
        return np.zeros((len(ended.local.prior), 0))
    known, crossed, square, slope, missed, uphill = normal_equations(problem, ended, deviation)
    moved = np.linalg.solve(known, crossed.T)  # by a zero of one deviation
    told = variance_left(crossed, moved, square)
    unfinished = free @ (free.T @ uphill)  # what rises against a bound is at its end
    size = np.hypot(shown(told, moved, slope, unfinished), np.sqrt(told))
    if ended.disturbance.scale > NOISY:  # what is missed would be taken for a zero
        size = np.maximum(size, hidden(told, missed))
    return moved * size


def shown(told: np.ndarray, moved: np.ndarray, slope: np.ndarray, uphill: np.ndarray) -> np.ndarray:
    """Of its deviation, the zero that the residual shows. A search ends near the minimum only: what
    the slope there, `uphill`, makes of it, which the fit takes for something else, is taken off.
    """
    return told * (slope - uphill @ moved)


def hidden(told: np.ndarray, missed: np.ndarray) -> np.ndarray:
    """Of its deviation, how large a zero may be in what is `missed`, which tells none: all of it,
    unless by itself that would leave more (both sums of squares) than is missed.
    """
    return np.sqrt(np.minimum(missed * told / np.maximum(1 - told, missed * told), 1.0))


def variance_left(crossed: np.ndarray, moved: np.ndarray, square: np.ndarray) -> np.ndarray:
    """Of every zero, its variance over the one that it is declared with: all of it where the fit
    takes its response for something else, of which rounding may leave less than nothing.
    """
    return 1 / (1 + np.maximum(square - np.sum(crossed * moved.T, axis=1), 0.0))


def normal_equations(
    problem: Problem, ended: SearchResult, deviation: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """A'A + P, of the zero of every recording A'b, b'b and b'r, by one deviation of it, r'r, and
    how steeply the misfit still rises.
    """
    found, local, owner = ended.disturbance, ended.local, np.asarray(problem.observation.owner)
    driven = np.array([kind == "measured" for kind in problem.kinds])
    per_inertia = driven * deviation[owner] / np.exp(ended.point.shared.log_inertia)
    seen = sensed(problem, ended.point, per_inertia)
    size = len(local.prior)
    known, crossed = local.prior + VAGUE * np.eye(size), np.zeros((len(deviation), size))
    square, slope, missed = np.zeros((3, len(deviation)))
    uphill = pull_of_belief(ended.point, ended.held or problem.belief.prior)
    scales = found.scale * found.weighing(problem.kinds)
    for number, place in enumerate(columns(ended.point, owner)):
        rows = seen.columns[number].reshape(len(place), -1) / scales[number]
        response, residual = (
            each[number].ravel() / scales[number] for each in (seen.responses[:, 0], seen.residual)
        )
        known[np.ix_(place, place)] += rows @ rows.T
        uphill[place] += rows @ residual
        crossed[owner[number], place] += rows @ response
        square[owner[number]] += response @ response
        slope[owner[number]] += response @ residual
        missed[owner[number]] += residual @ residual
    return known, crossed, square, slope, missed, uphill
