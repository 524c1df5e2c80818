"""What is seldom wrong, but then by a lot: a seat that is clearly tilted, a clock that is off.

A normal distribution of what is usual would bend the leg to such a recording. Where the data speak
clearly against it, the width of that recording's own distribution follows them (empirical Bayes):
the seat's tilt by its marginal likelihood; and where encoder and gyro disagree in scale, which may
be the gyro's fault, the encoder's gain or the clock's, the clock's by that disagreement. Of a foot
that slants the leg, and of a mass that hangs elsewhere, data hardly speak: errors hold what either
would make of the leg, by the odds that it is there.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from exoid.fitting.misfit.condensed import Neighbourhood
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.neighbourhood import declared_slopes
from exoid.fitting.model.coordinates import TYPICAL, places
from exoid.fitting.model.systematics import DISAGREE, FOOT, MISREAD, SELDOM, SLANT, sharing
from exoid.fitting.model.term_parameters import parameters_of
from exoid.fitting.multistart.beginning.tethers import FINE
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.multistart.weight_by_kind import likelihood
from exoid.fitting.solve.ask import advance, lowest, take, task, told_at
from exoid.fitting.solve.problem import Problem
from exoid.fitting.solve.program_values import Solved
from exoid.recordings.signal.both_sensors.sensor_scales import suspected

CONVINCING = 3.0  # gain of log likelihood from which on a seat is held for tilted
STEEPEST = np.radians(5.0)  # standard deviation of its tilt
LYING = 2.0  # times it: a fit with a seat that is tilted by more takes it for something else
BEYOND = 2.0  # times it the gyro's own may be
VAGUE = 1e-9  # of every information, and of one typical step, that is known of everything


@dataclass(frozen=True)
class Rare:
    """What some recordings own together, and in this `share` of all cases is seldom as declared:
    then with this standard deviation, in its own unit.
    """

    name: str  # of a `Mounting`
    entries: list[int]  # recordings
    deviation: float
    share: float


@dataclass(frozen=True, eq=False)
class Seen:
    """A value, and the variance with which all but its prior tells it, in its unit."""

    value: float
    variance: float

    def likelihood(self, deviation: float) -> float:
        """The logarithm of its marginal likelihood under a prior of this standard deviation."""
        total = self.variance + deviation**2
        return -(np.log(total) + self.value**2 / total) / 2


def with_tilted_seats(
    problem: Problem, free: Solved, row: int, left: Disturbance
) -> tuple[Problem, Solved]:
    """The same, its priors wider for seats that are clearly tilted, and all free fits under them.
    `left` is what is in the residual of the best `row`, and how its kinds of segments are weighed.

    Seen as if only white noise were in the residual, a tilt may be anything that the model misses:
    it is believed where it explains the residual better than that would.
    """
    wide = tilted(problem, free, row)
    if wide is None:
        return problem, free
    asked, weighing = task(wide, 0.0, wide.steps, FINE), left.weighing(problem.kinds)
    again = advance(wide, take(free.coordinates, [row] * free.loss.size), asked, weighing)
    gain = likelihood(wide, again, 0, left) - likelihood(problem, free, row, left)
    price = np.log(wide.deviation_of("tilt") / problem.deviation_of("tilt")).sum()
    steepest = float(np.abs(again.coordinates.mounting.tilt[lowest(again)]).max())
    if steepest > LYING * STEEPEST or not gain - price > CONVINCING:
        return problem, free
    return wide, advance(wide, free.coordinates, asked, weighing)


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


def tilted(problem: Problem, free: Solved, row: int) -> Problem | None:
    """With wider priors for the seats whose tilt stands out; None where none does."""
    if "tilt" not in problem.owned:
        return None
    declared = declared_slopes(take(free.coordinates, row), problem.belief.prior)
    total = white(problem, free, row) + declared.T @ declared
    deviation = problem.deviation_of("tilt").copy()
    chosen = False
    for seat in seats(problem):
        one = Rare("tilt", seat, STEEPEST, FOOT)
        each, usual = found(problem, free, row, one, total), deviation[seat[0]]
        wide = min(np.sqrt(max(each.value**2 - each.variance, 0.0)), STEEPEST)
        if wide > usual and each.likelihood(wide) - each.likelihood(usual) > CONVINCING:
            deviation[seat], chosen = wide, True
    return problem.widened(tilt=deviation) if chosen else None


def white(problem: Problem, at: Solved, row: int) -> np.ndarray:
    """What the data tell at an end point, were all that is left there white noise."""
    noise = max(1.0, float(at.misfit[row]) / int(problem.samples.sum()))
    return told_at(problem, at, row) / noise


def found(problem: Problem, at: Solved, row: int, one: Rare, total: np.ndarray) -> Seen:
    """What all but its own prior tells of it: what its recordings have in common.

    Of values with the prior covariance C, of which c is that with what they have in common, this is
    w = c C^-1 of them, and of the variance that it has w c is told by them.
    """
    place, unit = places_of(at, one.name, one.entries), unit_of(one)
    covariance = believed(problem, one)
    whole = covariance.min()
    weights = np.linalg.solve(covariance, np.full(len(one.entries), whole))
    inside = variances(total)[np.ix_(place, place)] * unit**2
    told = 1 / float(weights @ inside @ weights + whole * (1 - weights.sum()))
    alone = max(told - 1 / whole, 1e-9 * told)
    value = float(weights @ getattr(at.coordinates.mounting, one.name)[row, one.entries])
    return Seen(value * told / alone, 1 / alone)


def believed(problem: Problem, one: Rare) -> np.ndarray:
    """The covariance with which these are believed, in the square of their unit."""
    alike, deviation = problem.belief.prior.in_common, problem.deviation_of(one.name)[one.entries]
    assert alike is not None  # `pose` gives one
    own = getattr(alike, one.name)
    correlation = np.linalg.inv(own.T @ own)[np.ix_(one.entries, one.entries)]
    return correlation * np.outer(deviation, deviation)


def usual_of(problem: Problem, one: Rare) -> float:
    """Its standard deviation where it is as declared."""
    return float(problem.deviation_of(one.name)[one.entries[0]])


def unit_of(one: Rare) -> float:
    """That of its coordinate."""
    return float(getattr(TYPICAL.mounting, one.name))


def seats(problem: Problem) -> list[list[int]]:
    """The recordings of which no tilt is declared, in groups, each on one seat."""
    return together(problem, "tilt")


def together(problem: Problem, name: str, declared_as: str | None = None) -> list[list[int]]:
    """The recordings that do not declare this, in groups that have it in common."""
    alike, free = problem.belief.prior.in_common, undeclared(problem, name, declared_as or name)
    assert alike is not None  # `pose` gives one
    return [each for each in sharing(getattr(alike, name)) if each[0] in free]


def variances(information: np.ndarray) -> np.ndarray:
    """The covariance of what is told so much of, large where nothing is told."""
    return np.linalg.inv(information + VAGUE * np.diag(np.diag(information) + 1))


def with_doubted_clocks(problem: Problem, best: Solved, local: Neighbourhood) -> Problem | None:
    """With wider priors for the clocks of recordings in which the sensors disagree in scale.

    Motion shows only (1 + gyro scale) / (1 + clock) over the encoder's gain, but m l g / J goes by
    the square of the clock. None where no sensors disagree.
    """
    if "clock" not in problem.owned:
        return None
    clock, scale = (problem.deviation_of(name).copy() for name in ("clock", "gyro_scale"))
    total = variances(local.data + local.prior)
    chosen = False
    for entry in undeclared(problem, "clock"):
        value, gradient = gyro_scale(problem, best, local, entry)
        wide = suspected(value)
        error = float(np.sqrt(gradient @ total @ gradient))
        if abs(value) > DISAGREE * error and wide > clock[entry]:
            clock[entry], chosen = wide, True
            if scale.size:
                scale[entry] = max(scale[entry], BEYOND * abs(value))
    return problem.widened(clock=clock, gyro_scale=scale) if chosen else None


def doubted(before: Problem, after: Problem, at: Solved) -> list[int]:
    """The coordinates of the clocks whose priors are wider `after` than `before`."""
    grown = after.deviation_of("clock") > before.deviation_of("clock")
    return places_of(at, "clock", np.flatnonzero(grown).tolist())


def not_by_anatomy(local: Neighbourhood, clocks: list[int]) -> Neighbourhood:
    """The same, where what is believed of the leg narrows none of these coordinates.

    The values are those of clocks as declared: what anatomy then asks of another clock, their
    errors are not to take for evidence of this one. With the clocks k all others y go by U k,
    U = -H_yy^-1 H_yk; what is believed is believed of y - U k, of which they are no part.
    """
    total = local.data + local.prior
    others = np.setdiff1d(np.arange(len(total)), clocks)
    own = np.ix_(others, np.array(clocks))
    left = np.eye(len(total))
    left[own] = variances(total[np.ix_(others, others)]) @ total[own]
    left[clocks, clocks] = 0.0
    believed = left.T @ (local.prior - local.declared) @ left
    return replace(local, prior=believed + local.declared)


def gyro_scale(
    problem: Problem, best: Solved, local: Neighbourhood, entry: int
) -> tuple[float, np.ndarray]:
    """By how much the gyro of a recording shows too much, and the gradient of that: as the
    recording owns it, or as a term in its place has it. Zeros where it is known.
    """
    gradient = np.zeros(len(local.data))
    if entry in problem.estimated("gyro_scale"):
        gradient[place_of(best, "gyro_scale", entry)] = TYPICAL.mounting.gyro_scale
        return float(best.coordinates.mounting.gyro_scale[0, entry]), gradient
    for term in problem.terms:
        if term.replaces == "gyro_scale":
            (name,) = (each for each, _ in parameters_of((term,)))
            row = problem.quantities.index(name)
            return float(best.quantities[0, row]), local.quantities[row]
    return 0.0, gradient


def undeclared(problem: Problem, name: str, declared_as: str | None = None) -> list[int]:
    """The recordings of which this is an unknown that they do not declare."""
    first, own = [each[0] for each in problem.recordings], declared_as or name
    return [n for n in problem.estimated(name) if own not in first[n].systematics.declared]


def places_of(at: Solved, name: str, entries: list[int]) -> list[int]:
    """Which coordinates these are."""
    return [place_of(at, name, entry) for entry in entries]


def place_of(at: Solved, name: str, entry: int) -> int:
    """Which coordinate this is."""
    return int(getattr(places(take(at.coordinates, 0)).mounting, name)[entry])
