"""What a leg's numbers lean on: that the knee's spring is slack at full extension (Eq. 9).

With the rest angle phi_r the spring is -c (phi - phi_r): beside Eq. 9 a constant torque c phi_r
acts. Near the end point a fit without it errs by H^-1 A'S of that torque over J, with the
sensitivities A of the residual r, S its answer to the torque, and H = A'A and what is believed:
the ratios move, and by what anatomy believes of J / (m l) the parameters with them. The data tell
S'S - S'A H^-1 A'S of the torque, and show S'A H^-1 g - S'r over that: at a minimum the slope g is
0, but where the torque is hardly told apart, a little of it counts.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from exoid.fitting.misfit.neighbourhood import pull_of_belief
from exoid.fitting.misfit.uncertainty import decomposed, inverse_times
from exoid.fitting.model.coordinates import (
    Coordinates,
    flattened,
    layout,
    quantities,
    unflattened,
)
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.fit_result import Basis, Estimate, FitResult
from exoid.fitting.solve.ask import grams_at
from exoid.fitting.solve.problem import Problem
from exoid.physics.term import name_of

BENT = np.radians(30.0)  # of flexion, where a spring may well be slack: Riener & Edrich have 61 deg
TOLD = np.radians(5.0)  # error of the rest angle below which a fit by itself shows one of BENT
FELT, WORTH = 2.0, 0.01  # errors, and share, of a ratio left open where the rest angle is told
NOTICED = 0.5  # errors of a number, from which on what is left open is told: 12 % of ± together
STIFFER = 2.0  # times as stiff as by the fit, at most: beyond, nothing is linear any more
CONSTANT = {"stiffness_rest_angle", "torque_bias"}  # terms of such a torque
LEANING = ("gravity_over_inertia", "stiffness_over_inertia")


@dataclass(frozen=True)
class Leaning:
    """How far the numbers of a leg whose spring is slack at BENT are from those of the fit."""

    off: dict[str, float]  # by the names of a result, in their units
    seen: Annotated[float, "rad"]  # the rest angle that the recording shows
    told: Annotated[float, "rad"]  # the error with which it does so
    shown: bool  # is that clear, beside all else that is missing?

    @property
    def of_ratios(self) -> np.ndarray:
        """Of the `LEANING` [1/s^2]."""
        return np.array([self.off[name] for name in LEANING])

    @property
    def spread(self) -> dict[str, float]:
        """How far the numbers of legs whose springs are slack within BENT of full extension, as a
        standard deviation, and that show the same, are from the fit's: root mean square.
        """
        trust = 1 / (1 + (self.told / BENT) ** 2)  # of what is seen, beside what is usual
        usual = float(np.hypot(trust * self.seen / BENT if trust else 0.0, np.sqrt(1 - trust)))
        return {name: abs(each) * usual for name, each in self.off.items()}


def left_open(basis: Basis, errors: Sequence[float]) -> Leaning | None:
    """What a leg's numbers lean on, where another rest angle changes the `LEANING` ratios by more
    than these errors of them, and the recording does not rule that out; else None.
    """
    found = leaning(basis)
    if found is None:
        return None
    off = [found.spread[name] for name in LEANING] if found.shown else found.of_ratios
    least = np.array(errors)
    if found.shown:
        shared = basis.ended.point.shared
        of_leg = [float(getattr(shared, name)) for name in ("gravity", "stiffness")]
        least = np.maximum(FELT * least, WORTH * np.array(of_leg))
    return None if (np.abs(off) < least).all() else found


def with_slack(result: FitResult, found: Leaning | None) -> FitResult:
    """The result, each number with how far it is open for where the spring is slack."""
    spread = {} if found is None else found.spread

    def told(known: dict[str, Estimate], of: str = "") -> dict[str, Estimate]:
        return {name: if_slack(each, spread.get(of + name, 0.0)) for name, each in known.items()}

    moment, torque = result.gravity_moment, result.torque_amplitude
    return replace(
        result,
        parameters=told(result.parameters),
        ratios=told(result.ratios),
        terms={term: told(own, f"{term}.") for term, own in result.terms.items()},
        gravity_moment=moment and if_slack(moment, spread.get("gravity_moment", 0.0)),
        torque_amplitude=torque and if_slack(torque, spread.get("torque_amplitude", 0.0)),
    )


def if_slack(each: Estimate, spread: float) -> Estimate:
    """With this error more, where it is to be noticed beside its own."""
    noticed = bool(each.standard_error) and spread > NOTICED * (each.standard_error or 0.0)
    return replace(each, if_slack=spread) if noticed else each


def slack_angle_remarks(found: Leaning | None) -> list[str]:
    """What of a leg's numbers is `left_open`."""
    if found is None:
        return []
    where = seen(found) if found.shown else bent(found)
    return [
        "m l g / J and c / J, and what goes with them, hold for a spring that is slack at full "
        f"extension (Eq. 9), and 'if slack' beside ± tells how well for others: {where}. 'exoid "
        "diagnose' asks where it is slack; the hanging angle without and with a known mass tells "
        "best."
    ]


def bent(found: Leaning) -> str:
    """How far off both ratios of a leg are whose spring is slack at BENT."""
    first, second = (
        f"{abs(one):.2g} 1/s^2 {'higher' if one > 0 else 'lower'}"
        for one in found.of_ratios.tolist()
    )
    where = f"{np.degrees(BENT):.0f} deg of flexion"
    return f"of a leg whose spring is slack at {where} m l g / J is {first}, c / J {second}"


def seen(found: Leaning) -> str:
    """Where the recording shows it slack, and how far off the ratios may be for that."""
    angle, error = -np.degrees(found.seen), np.degrees(found.told)
    gravity, stiffness = (found.spread[name] for name in LEANING)
    return (
        f"by this recording it is slack at {angle:.2g} ± {error:.2g} deg of flexion, which leaves "
        f"m l g / J open by ± {gravity:.2g} 1/s^2, c / J by ± {stiffness:.2g} 1/s^2"
    )


def leaning(basis: Basis) -> Leaning | None:
    """None on a rig, and where the model has no spring or a constant torque of its own."""
    problem, ended = basis.problem, basis.ended
    stiffness, terms = float(ended.point.shared.stiffness), map(name_of, problem.terms)
    if problem.belief.rig or stiffness <= 0 or CONSTANT & set(terms):
        return None
    pull, left, seen = answer(basis)
    spring = float(ended.local.quantities[problem.quantities.index(LEANING[1])] @ pull)
    torque = -stiffness * BENT / max(1 - spring * BENT, 1 / STIFFER)
    told = left**-0.5 / stiffness if left > 0 else np.inf
    angle = seen / left / stiffness if left > 0 else 0.0
    shown = bool(told < TOLD) and ended.disturbance.cause is None
    return Leaning(moved(problem, ended, -torque * pull), angle, told, shown)


def moved(problem: Problem, ended: SearchResult, steps: np.ndarray) -> dict[str, float]:
    """How far every number of a result goes with these steps of the coordinates."""
    here = flattened(ended.point)
    there = unflattened(here + steps * layout(ended.point).units, ended.point)
    before, after = (numbers_at(problem, point) for point in (ended.point, there))
    return {name: after[name] - before[name] for name in before}


def numbers_at(problem: Problem, point: Coordinates) -> dict[str, float]:
    """Of a point, by the names of a result; of voluntary segments the means."""
    each = dict(zip(problem.quantities, quantities(point, np).tolist(), strict=True))
    for name in ("torque_amplitude", "torque_over_inertia"):
        own = [each[one] for one in problem.quantities_of(name)]
        each |= {name: float(np.mean(own))} if own else {}
    return each | {"gravity_moment": each["gravity_over_inertia"] * each["inertia"]}


def answer(basis: Basis) -> tuple[np.ndarray, float, float]:
    """H^-1 A'S for a constant torque of 1 rad/s^2 times J, beside what is fixed by hand; what the
    data tell of the torque beside the coordinates; and, over that, the torque that they show.
    """
    problem, ended, free = basis.problem, basis.ended, basis.information.open
    scale = ended.disturbance.scale * ended.disturbance.weighing(problem.kinds)
    known, slope = ended.local.prior.copy(), np.zeros(len(ended.local.prior))
    uphill = pull_of_belief(ended.point, problem.belief.prior)
    own = seen = 0.0
    for each, unit in zip(grams_at(problem, ended.best, 0, ["torque"]), scale, strict=True):
        gram = each["torque"]
        pushed, fitted = gram.effect.sum(axis=1) / unit, gram.fitted / unit**2
        known[np.ix_(gram.place, gram.place)] += fitted[:-1, :-1]
        uphill[gram.place] += fitted[:-1, -1]
        slope[gram.place] += pushed @ gram.inside[:, :-1] / unit
        own += pushed @ pushed
        seen -= pushed @ gram.inside[:, -1] / unit
    pull = free @ inverse_times(decomposed(free.T @ known @ free), free.T @ slope)
    return pull, float(own - slope @ pull), float(seen + pull @ uphill)
