"""What a recording that could be made would leave of an error: Fisher information adds.

What is known, a candidate's (its exact sensitivities along the motion it would have) and the
prior's sum up to that of the joint fit, in which the new recording has a mounting of its own
(Atkinson, Donev & Tobias, Optimum Experimental Designs, 2007).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import jax
import numpy as np

from exoid.diagnose.candidate import Candidate, observed
from exoid.diagnose.known import LEG, Known, eliminated
from exoid.fit.belief import NAMES
from exoid.fit.chain import Raw
from exoid.fit.coordinates import TYPICAL, Coordinates, Mounting, Own
from exoid.fit.disturbance import spoiled
from exoid.fit.estimates import RATIOS
from exoid.fit.gram import gram, pushes
from exoid.fit.prior import SEAT_DEVIATION
from exoid.fit.problem import Problem, pose, sensed
from exoid.fit.starts import first_state, usual_mounting
from exoid.fit.uncertainty import Information

GOALS = (*NAMES, *list(RATIOS)[:3])
MOST = 4  # segments of a proposed recording
WORTH = 0.85  # of the error before: a further segment that leaves more is not worth its time
ENOUGH = 2e-3  # of the value: no added mass is weighed, and no leg the same tomorrow, to less
NEAR = 1.3  # of the least error: within it the simplest recording is proposed


def informations(known: Known, options: list[Candidate]) -> list[np.ndarray]:
    """What every candidate would tell of the leg's coordinates and of the new mounting."""
    number = len(known.recorded)
    new = observed(options, known.leg, known.sensors, known.gyro, number)
    movements = [*known.recorded, *new]
    problem = pose(movements, known.belief, "1/T", Raw())
    states = np.array([first_state(each) for each in movements])
    torque = np.array([option.motion.amplitude or 0.0 for option in options])
    own = Own(
        np.append(np.zeros(number), torque / np.exp(known.shared.log_inertia)), *states.T.copy()
    )
    mounting = usual_mounting(movements)
    point = Coordinates(known.shared, known.log_mass, placed(mounting, options), own)
    return [without_own(each) for each in segments_told(known, problem, point)[number:]]


def segments_told(known: Known, problem: Problem, point: Coordinates) -> list[np.ndarray]:
    """Every segment's information on its own unknowns, where what disturbed the fit acts again."""
    found, seen = known.disturbance, problem.observation
    if found is None or found.cause is None:
        every = [each.reshape(each.shape[0], -1) for each in sensed(problem, point).columns]
        noise = 1.0 if found is None else found.noise
        return [rows @ rows.T / noise**2 for rows in every]
    response = sensed(problem, point, pushes(seen.time, problem.durations))
    size = response.columns.shape[1]
    place = np.arange(size)
    return [
        spoiled(
            found, [gram(response, seen, segment, duration, found.cause, place)], size
        ).information
        for segment, duration in enumerate(problem.durations)
    ]


def placed(mounting: Mounting, options: list[Candidate]) -> Mounting:
    """The new recording's mass where the candidates carry it."""
    distance = max(option.motion.added_mass_distance for option in options)
    at = np.full_like(mounting.log_distance, np.log(distance))
    return replace(mounting, log_distance=at)


def without_own(segment: np.ndarray) -> np.ndarray:
    """A segment's information, its own start and torque eliminated, log m (untold) inserted."""
    both = eliminated(segment, segment.shape[0] - 3)
    return np.insert(np.insert(both, LEG - 1, 0.0, axis=0), LEG - 1, 0.0, axis=1)


@dataclass(frozen=True, eq=False)
class Design:
    """What any set of candidates would leave of the goal's error."""

    known: Known
    goal: str
    options: list[Candidate]
    told: list[np.ndarray]  # by each of the options

    @property
    def value(self) -> float:
        leg, shared = self.known.leg, self.known.shared
        each = [*jax.tree.leaves(leg), shared.gravity, shared.stiffness, shared.damping]
        return float(each[GOALS.index(self.goal)])

    @cached_property
    def start(self) -> np.ndarray:
        """What data and prior tell of the leg, and the prior of a new mounting."""
        size = self.told[0].shape[0]
        total = np.diag(np.append(np.zeros(LEG), mounting_prior(size - LEG)))
        total[:LEG, :LEG] = self.known.information + self.known.prior
        return total

    def error(self, chosen: Sequence[int]) -> float:
        """The standard error of the goal with these candidates as one new recording."""
        total = self.start + sum(self.told[number] for number in chosen)
        gradient = np.zeros(total.shape[0])
        gradient[:LEG] = self.known.gradients[GOALS.index(self.goal)]
        fixed = self.known.fixed
        held = np.pad(fixed, ((0, 0), (0, total.shape[0] - LEG)))
        information = Information(total, np.zeros_like(total), held)
        return information.standard_error(gradient)

    def greedy(self) -> list[int]:
        """Segment after segment, the simplest of the best, while each is worth its time.

        Two together may tell what neither does, a loaded drop and a bare one: pairs are tried where
        no single segment is worth it. Voluntary cycles are never proposed: what they tell rests on
        the form of the torque.
        """
        single = [[n] for n, option in enumerate(self.options) if not option.voluntary]
        pairs = [a + b for a in single for b in single if a <= b]
        chosen: list[int] = []
        while len(chosen) < MOST and not self.error(chosen) < ENOUGH * abs(self.value):
            more = self.worthwhile(chosen, single) or ([] if chosen else self.worthwhile([], pairs))
            if not more:
                break
            chosen = chosen + more
        return chosen

    def worthwhile(self, chosen: list[int], sets: list[list[int]]) -> list[int]:
        """The set of least effort among those that are worth it and nearly the best; else none."""
        after = [self.error(chosen + each) for each in sets]
        most = min(WORTH * self.error(chosen), NEAR * min(after))
        near = [number for number, error in enumerate(after) if error < most]
        if not near:
            return []
        effort = {n: sum(self.options[each].effort for each in sets[n]) for n in near}
        return sets[min(near, key=lambda n: (effort[n], after[n]))]


def mounting_prior(size: int) -> np.ndarray:
    """What is believed of a new mounting: of the mass' place, and of the sensors if compared."""
    each = jax.tree.map(lambda unit, sd: float(unit / sd) ** 2, TYPICAL.mounting, SEAT_DEVIATION)
    return np.array(jax.tree.leaves(each)[:size])
