"""What a leg's numbers lean on: that the knee's spring is slack at full extension (Eq. 9).

With the rest angle phi_r the spring is -c (phi - phi_r): beside Eq. 9 a constant torque c phi_r
acts. A fit without it errs (`answer`): the ratios move, and by what anatomy believes of J / (m l)
the parameters with them.
"""

import numpy as np

from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.remarks.pushed.answer import (
    Numbers,
    answer,
    beyond_noise,
    grams_of,
    moved,
)
from exoid.fitting.result.remarks.zero.leaning import (
    BENT,
    LEANING,
    STIFFER,
    Leaning,
)
from exoid.fitting.solve.problem import Problem

TOLD = np.radians(5.0)  # error of the rest angle below which a fit by itself shows one of BENT
FELT, WORTH = 2.0, 0.01  # errors, and share, of a ratio left open where the rest angle is told
REACH, STEPS = 6.0, 20_001  # errors of the torque, beyond which none is likely; so many are tried


def left_open(
    problem: Problem,
    ended: SearchResult,
    free: np.ndarray,
    errors: dict[str, float],
    numbers: Numbers,
) -> Leaning | None:
    """What a leg's numbers lean on, where another rest angle changes one of these by more than its
    error, and the recording does not rule that out; else None.
    """
    found = leaning(problem, ended, free, numbers)
    if found is None:
        return None
    # A torque that softens the fit's spring leaves one that is slack at BENT little of its own.
    moved = found.spread if found.shown or found.pushed else found.off
    least = dict(errors)
    if found.shown:
        least = {name: FELT * error for name, error in errors.items()}
        of_leg = ended.point.shared.gravity, ended.point.shared.stiffness
        for name, value in zip(LEANING, of_leg, strict=True):
            least[name] = max(least[name], WORTH * float(value))
    return found if any(abs(moved[name]) >= each for name, each in least.items()) else None


def leaning(
    problem: Problem, ended: SearchResult, free: np.ndarray, numbers: Numbers
) -> Leaning | None:
    """Where nothing holds the coordinates in these `free` directions; None on a rig, and where the
    model has no spring or a constant torque of its own.
    """
    stiffness = float(ended.point.shared.stiffness)
    if problem.belief.rig or stiffness <= 0 or any(term.steady for term in problem.terms):
        return None
    grams, constant = grams_of(problem, ended), [1.0] * len(problem.kinds)
    pull, left, seen = answer(problem, ended, free, grams, constant)
    spring = float(ended.local.quantities[problem.quantities.index(LEANING[1])] @ pull)
    torque = -stiffness * BENT / max(1 - spring * BENT, 1 / STIFFER)
    error, found = (left**-0.5, seen / left) if left > 0 else (np.inf, 0.0)
    usual = likely(stiffness, spring, found, error) / abs(torque) if left > 0 else 1.0
    return Leaning(
        off=moved(numbers, ended, -torque * pull),
        usual=usual,
        seen=found / stiffness,
        told=error / stiffness,
        softer=spring,
        shown=bool(error / stiffness < TOLD) and ended.disturbance.cause is None,
        push=found / float(ended.point.shared.gravity),
        share=found**2 * left * ended.disturbance.scale**2 / beyond_noise(problem, ended),
    )


def shown_slack(problem: Problem, ended: SearchResult, free: np.ndarray) -> Leaning | None:
    """The same, whatever it makes of a result's numbers."""
    return leaning(problem, ended, free, lambda _: {})


def likely(stiffness: float, spring: float, shown: float, error: float) -> float:
    """The constant torque over J [rad/s^2] that a spring makes which is slack within BENT of full
    extension, as a standard deviation, where the recording shows so much of it: root mean square.

    With the torque T the fit's c / J is off by `spring` T, so that such a spring is slack at
    T / (c / J - spring T). The softer the fit's spring, the more of a stiffer one it may hide.
    """
    low, high = min(shown, 0.0) - REACH * error, max(shown, 0.0) + REACH * error
    torque = np.linspace(low, high, STEPS)
    torque = torque[stiffness > spring * torque]
    angle = torque / (stiffness - spring * torque)
    unlikely = (angle / BENT) ** 2 + ((torque - shown) / error) ** 2
    weight = np.exp((unlikely.min() - unlikely) / 2)
    return float(np.sqrt(np.average(torque**2, weights=weight)))
