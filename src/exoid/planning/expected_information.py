"""What a recording that could be made would leave of an error: Fisher information adds.

What is known, a candidate's (its exact sensitivities along the motion it would have) and the
prior's sum up to that of the joint fit (Atkinson, Donev & Tobias, Optimum Experimental Designs,
2007).
"""

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from itertools import combinations_with_replacement
from math import hypot

import numpy as np

from exoid.fitting.data.conditioning_chain import Raw
from exoid.fitting.data.movement import Movement
from exoid.fitting.misfit.gram import CAUSES, Cause
from exoid.fitting.misfit.information import common, spoiled
from exoid.fitting.misfit.neighbourhood import columns
from exoid.fitting.model.coordinates import Coordinates, SegmentUnknowns, Shared, quantities
from exoid.fitting.multistart.beginning.starts import first_state, usual_mounting
from exoid.fitting.solve.ask import grams_in, sensed
from exoid.fitting.solve.pose import pose
from exoid.fitting.solve.problem import Problem
from exoid.planning.next_mountings import information_error, with_recordings
from exoid.planning.planned import AtHand, Candidate
from exoid.planning.prior_knowledge import PriorKnowledge, eliminated

MOST = 4  # segments of a proposed recording
WORTH = 0.85  # of the error before: a further segment that leaves more is not worth its time
ENOUGH = 2e-3  # of the value: no added mass is weighed, and no leg the same tomorrow, to less
ALIKE = 1.05  # times the least error of what is as simple: within it the lightest is proposed
NEAR = 1.3  # of the least error: within it the simplest recording is proposed


def informations(
    known: PriorKnowledge, options: dict[Candidate, Movement]
) -> dict[Candidate, np.ndarray]:
    """What every candidate would tell of the leg's coordinates and of the new mounting."""
    told = segments_told(known, *posed(known, options))
    return {option: without_own(each, known) for option, each in zip(options, told, strict=True)}


def posed(known: PriorKnowledge, options: dict[Candidate, Movement]) -> tuple[Problem, Coordinates]:
    """The problem that these motions would pose, and what is known of the leg, from where they
    begin.
    """
    own = {"systematics": known.systematics, "least_mass": known.least_mass}
    movements = [
        replace(each, recording=number, **own) for number, each in enumerate(options.values())
    ]
    problem = pose(movements, known.belief, "1/T", Raw(), terms=known.classes)
    states = np.array([first_state(each) for each in movements])
    torque = np.array([option.motion.amplitude or 0.0 for option in options])
    own = SegmentUnknowns(torque / np.exp(known.shared.log_inertia), *states.T.copy())
    usual = usual_mounting(movements, owned=known.owned)
    return problem, Coordinates(known.shared, known.log_mass, usual, own, known.terms)


def segments_told(known: PriorKnowledge, problem: Problem, point: Coordinates) -> list[np.ndarray]:
    """Every segment's information on its own unknowns, where what disturbed the fit acts again."""
    found = known.disturbance
    if found is None or found.cause is None:
        every = [each.reshape(each.shape[0], -1) for each in sensed(problem, point).columns]
        noise = 1.0 if found is None else found.noise
        return [rows @ rows.T / noise**2 for rows in every]
    own = np.arange(columns(point, problem.observation.owner).shape[1])
    places = np.tile(own, (len(problem.movements), 1))
    causes: set[Cause] = {found.like(kind).cause or CAUSES[0] for kind in problem.kinds}
    told = []
    for grams, kind in zip(grams_in(problem, point, places, causes), problem.kinds, strict=True):
        missed = found.like(kind)
        each = grams[missed.cause or CAUSES[0]]
        told.append(spoiled(common(missed, [kind]), [each], [kind], own.size).information)
    return told


def without_own(segment: np.ndarray, known: PriorKnowledge) -> np.ndarray:
    """A segment's information on the coordinates of `known.point` and on the new mounting, its own
    start and torque eliminated, log m (untold) inserted.
    """
    leg, seat, start = len(fields(Shared)), len(known.owned), len(fields(SegmentUnknowns))
    places = np.arange(segment.shape[0])
    shared, mounting, own, terms = np.split(places, np.cumsum([leg, seat, start]))
    order = np.concatenate([shared, terms, mounting, own])
    both = eliminated(segment[np.ix_(order, order)], segment.shape[0] - start)
    return np.insert(np.insert(both, leg, 0.0, axis=0), leg, 0.0, axis=1)


@dataclass(frozen=True, eq=False)
class Design:
    """What any set of candidates would leave of the goal's error."""

    known: PriorKnowledge
    goal: str
    told: dict[Candidate, np.ndarray]  # by every candidate
    now: AtHand

    @cached_property
    def value(self) -> float:
        return float(quantities(self.known.point, np)[self.known.quantities.index(self.goal)])

    def error(self, chosen: Sequence[Candidate]) -> float:
        """The standard error of the goal with these candidates, with what stays of it."""
        if not chosen:
            return self.now.error
        total = with_recordings(self.known.prior, self.known, self.told, chosen)
        return hypot(information_error(total, self.known, self.goal), self.now.stays)

    def greedy(self) -> list[Candidate]:
        """Segment after segment, the simplest of the best, while each is worth its time.

        One movement that nothing checks is never enough, whatever its error: a model that is wrong
        bends to it. A bare drop is the least that can contradict it.

        Two together may tell what neither does, a loaded drop and a bare one: pairs are tried where
        no single segment is worth it. Voluntary cycles are never proposed: what they tell rests on
        the form of the torque.
        """
        drops = [option for option in self.told if not option.voluntary]
        single = [[option] for option in drops]
        pairs = [[*pair] for pair in combinations_with_replacement(drops, 2)]
        chosen: list[Candidate] = []
        if self.enough(chosen) and not self.known.checked:
            return [min(drops, key=lambda each: each.effort)]
        while len(chosen) < MOST and not self.enough(chosen):
            more = self.worthwhile(chosen, single) or ([] if chosen else self.worthwhile([], pairs))
            if not more:
                break
            chosen = chosen + more
        return chosen

    def enough(self, chosen: Sequence[Candidate]) -> bool:
        """Is the goal then known as well as legs stay the same?"""
        return self.error(chosen) < ENOUGH * abs(self.value)

    def worthwhile(self, chosen: list[Candidate], sets: list[list[Candidate]]) -> list[Candidate]:
        """The set of least effort among those that are worth it and nearly the best, of these the
        one with the least mass to carry that is as good; else none.
        """
        after = [self.error(chosen + each) for each in sets]
        most = min(WORTH * self.error(chosen), NEAR * min(after))
        near = [
            (sum(one.effort for one in each), error, each)
            for each, error in zip(sets, after, strict=True)
            if error < most
        ]
        if not near:
            return []
        simplest = min(near, key=lambda each: each[:2])
        alike = [each for each in near if each[0] == simplest[0] and each[1] < ALIKE * simplest[1]]
        return min(alike, key=lambda each: (carried(each[2]), each[1]))[2]


def carried(segments: list[Candidate]) -> float:
    """The masses on the leg, in all segments together [kg]."""
    return sum(each.motion.added_mass for each in segments)
