"""The sets of parameters that fit as well as the chosen one."""

from collections.abc import Mapping

import numpy as np

from exoid.fitting.multistart.search_result import SearchResult, scale_told
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import GRAVITY


def equally_good(
    problem: Problem, ended: SearchResult, rows: np.ndarray, ratios: Mapping[str, Estimate]
):
    """The range of every parameter at the chosen ratios within the limits, and a set per start.

    At given ratios each J leaves an interval of l (with m = J (m l / J) / l), so the exact ranges
    follow one by one; each start's set is its own J and l, moved into those intervals.
    """
    limits, shared = problem.belief.limits, ended.best.coordinates.shared
    moment = float(shared.gravity[0]) / GRAVITY  # m l / J
    if problem.belief.rig or moment <= 0 or not problem.gain_known:
        return {}, {}
    told = ended.local.data + ended.local.declared
    if problem.tells_inertia and not scale_told(told):
        return {}, {}  # J moves the ratios, too: the mass was on the leg in every segment
    low, high = limits.lower, limits.upper
    longest = min(float(high.com_distance), 1 / moment)  # Eq. 12
    inertia = inertia_range(problem, ended, moment, longest)
    if inertia[0] > inertia[1]:
        return {}, {}
    shortest = float(low.com_distance)
    lightest, heaviest = float(low.mass), float(high.mass)
    stiffness = value_of(ratios["stiffness_over_inertia"], shared.stiffness)
    damping = value_of(ratios["damping_over_inertia"], shared.damping)
    length = (
        max(shortest, moment * inertia[0] / heaviest),
        min(longest, moment * inertia[1] / lightest),
    )
    family = {
        "mass": (
            max(lightest, moment * inertia[0] / longest),
            min(heaviest, moment * inertia[1] / shortest),
        ),
        "inertia": inertia,
        "com_distance": length,
        "damping": (damping * inertia[0], damping * inertia[1]),
        "stiffness": (stiffness * inertia[0], stiffness * inertia[1]),
    }
    family |= {name: (value, value) for name, value in problem.belief.by_hand.leg.fix.items()}
    start = ended.starts
    each = np.clip(np.exp(start.shared.log_inertia[rows]), *inertia)
    wish = (
        start.shared.gravity[rows]
        * np.exp(start.shared.log_inertia - start.log_mass)[rows]
        / GRAVITY
    )
    distance = np.clip(
        wish,
        np.maximum(shortest, moment * each / heaviest),
        np.minimum(longest, moment * each / lightest),
    )
    members = {
        "mass": moment * each / distance,
        "inertia": each,
        "com_distance": distance,
        "damping": damping * each,
        "stiffness": stiffness * each,
    }
    return family, members


def inertia_range(
    problem: Problem, ended: SearchResult, moment: float, longest: float
) -> tuple[float, float]:
    """The inertias that all limits allow at the chosen ratios; one value where J is known."""
    chosen = float(ended.best.leg.inertia[0])
    if problem.tells_inertia:
        return chosen, chosen
    limits, best = problem.belief.limits, ended.best.coordinates
    lower = [
        float(limits.lower.inertia),
        float(limits.lower.mass * limits.lower.com_distance) / moment,
    ]
    upper = [float(limits.upper.inertia), float(limits.upper.mass) * longest / moment]
    for ratio, low, high in (
        (best.shared.stiffness[0], limits.lower.stiffness, limits.upper.stiffness),
        (best.shared.damping[0], limits.lower.damping, limits.upper.damping),
    ):
        if ratio > 0:
            lower.append(float(low / ratio))
            upper.append(float(high / ratio))
    torque = float(np.abs(best.own.torque[0]).max())
    if torque > 0:
        upper.append(float(limits.torque) / torque)
    return max(lower), min(upper)


def value_of(each: Estimate, ended: np.ndarray) -> float:
    """As it is printed, exact on a limit; where the search ended if nothing tells it."""
    return float(ended[0]) if each.value is None else each.value
