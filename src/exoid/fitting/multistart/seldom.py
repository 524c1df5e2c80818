"""A foot that slants the leg, a mass that hangs elsewhere: data hardly speak of them.

Errors hold what either would make of the leg, by the odds that it is there.
"""

from collections.abc import Sequence

import numpy as np

from exoid.fitting.model.systematics import FOOT, MISREAD, SELDOM, SLANT
from exoid.fitting.multistart.rare import (
    Rare,
    believed,
    found,
    places_of,
    seats,
    together,
    unit_of,
    usual_of,
    variances,
)
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.solve.problem import Problem


def slanted(problem: Problem, ended: SearchResult) -> dict[str, float]:
    """How far every quantity may be off, by the odds that the line from the knee to the centre of
    mass is not where a level seat and the encoder have it: a foot by itself puts it 2 to 3 deg off.

    Data that see this little do not ask for it, and take it for an encoder's zero.
    """
    each = [Rare("tilt", seat, SLANT, FOOT) for seat in may_be_slanted(problem)]
    return off_by_odds(problem, ended, each)


def hung_elsewhere(problem: Problem, ended: SearchResult) -> dict[str, float]:
    """How far every quantity may be off, by the odds that an added mass hangs by centimetres from
    where it is said to: a tape was read wrong, or held to its end in place of its middle.

    A mass of another extent moves alike, and by the tape's millimetres alone a fit takes it for
    that. Nothing where a sidecar says how well the distance is known.
    """
    each = []
    for entries in together(problem, "log_distance", declared_as="distance"):
        loads = [one for one in problem.recordings[entries[0]] if one.added_mass > 0]
        if not any(one.unplaced for one in loads):
            placed = float(np.mean([one.added_mass_distance for one in loads]))
            each.append(Rare("log_distance", entries, MISREAD / placed, SELDOM))
    return off_by_odds(problem, ended, each)


def off_by_odds(problem: Problem, ended: SearchResult, each: Sequence[Rare]) -> dict[str, float]:
    """How far every quantity may be off by these, as a standard deviation."""
    variance = np.zeros(len(problem.quantities))
    total = ended.local.data + ended.local.prior
    for one in each:
        seen, usual = found(problem, ended.best, 0, one, total), usual_of(problem, one)
        gain = seen.likelihood(one.deviation) - seen.likelihood(usual)
        odds = 1 / (1 + np.exp(-gain) * (1 / one.share - 1))
        variance += odds * off(problem, ended, one, total)
    return dict(zip(problem.quantities, np.sqrt(variance), strict=True))


def may_be_slanted(problem: Problem) -> list[list[int]]:
    """The `seats` of legs whose line a foot may put off, of which nobody says how far."""
    if problem.belief.rig or "tilt" not in problem.owned:
        return []
    level = problem.deviation_of("tilt")
    return [seat for seat in seats(problem) if level[seat[0]] < SLANT]


def off(problem: Problem, ended: SearchResult, one: Rare, total: np.ndarray) -> np.ndarray:
    """The mean square distance of every quantity from what it is, were this so much less sure:
    what it is then is off, and less sure.
    """
    place, unit = places_of(ended.best, one.name, one.entries), unit_of(one)
    known = unit**2 * np.linalg.inv(believed(problem, one))
    less = known * ((usual_of(problem, one) / one.deviation) ** 2 - 1)
    open_ = total.copy()
    open_[np.ix_(place, place)] += less
    after, slopes = variances(open_), ended.local.quantities
    values = getattr(ended.point.mounting, one.name)[one.entries]
    step = -after[:, place] @ less @ (values / unit)
    spread = np.einsum("qi,ij,qj->q", slopes, after - variances(total), slopes)
    return (slopes @ step) ** 2 + np.maximum(spread, 0.0)
