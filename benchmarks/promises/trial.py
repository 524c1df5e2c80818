"""One leg, one plan, and what came of it."""

from dataclasses import dataclass, replace

import numpy as np
from benchmarks.pendulum import GRAVITY, Leg
from benchmarks.sbc.prior_draws import draw

from exoid.fitting.estimate import fit
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.constraint import violations
from exoid.fitting.model.prior_and_limits import believe
from exoid.planning.plan import plan
from exoid.planning.planned import Candidate, Plan
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording

from .situations import Situation
from .world import Act, recorded

STARTS = 3
MASS, HEIGHT = (55.0, 95.0), (1.6, 1.95)  # kg, m
BODIES = 0.12  # of a body mass that goes with a height
USUAL = 23.5  # kg/m^2
RELAXED = np.array(
    [2.0, 2.0]
)  # 1 over the scatter of log d and log c: who is not, is not measured by a drop


@dataclass(frozen=True)
class Trial:
    """What was promised and what was reached."""

    promised: float
    error: float  # of the value, signed
    quoted: float  # standard error of the last fit
    content: bool  # did the plan say that nothing more is needed

    @property
    def ratio(self) -> float:
        return self.error / self.promised


def tried(situation: Situation, rng: np.random.Generator) -> Trial:
    """Record what is at hand, plan, record what is proposed, and fit all."""
    subject = person(rng)
    leg = owner(believe(subject), rng)
    before = []
    if situation.acts:
        before = [("old", recorded(leg, situation.acts, subject, situation.sensors, rng))]
    result = fit(before, multistart=STARTS) if before else None
    found = plan(result, subject, situation.goal)
    after: list[tuple[str, Recording]] = list(before)
    for seat in dict.fromkeys(each.thigh_angle for each in found.proposed):
        acts = [act(each) for each in found.proposed if each.thigh_angle == seat]
        after.append((f"{seat:.2f}", recorded(leg, acts, subject, situation.sensors, rng)))
    last = fit(after, multistart=STARTS)
    each = (last.parameters | last.ratios)[situation.goal]
    error = each.value - truth(leg, situation.goal)
    return Trial(promised(found), error, each.standard_error, content(found))


def person(rng: np.random.Generator) -> Subject:
    height = rng.uniform(*HEIGHT)
    mass = np.clip(USUAL * height**2 * (1 + BODIES * rng.normal()), *MASS)
    return Subject(kind="leg", body_mass=float(mass), height=float(height))


def owner(belief: Belief, rng: np.random.Generator) -> Leg:
    """A leg as the prior has it, within the limits, whose owner is relaxed."""
    prior = replace(belief.prior, knee=RELAXED)
    while True:
        leg = draw(prior, rng)
        if violations(belief.limits, leg, np.zeros(1), np).max() <= 0:
            each = (leg.mass, leg.inertia, leg.com_distance, leg.damping, leg.stiffness)
            return Leg(*map(float, each))


def act(candidate: Candidate) -> Act:
    moved = candidate.motion
    return Act(
        start=moved.start_angle,
        duration=moved.duration,
        added=moved.added_mass,
        distance=moved.added_mass_distance,
        thigh=candidate.thigh_angle,
    )


def promised(found: Plan) -> float:
    return found.after if found.proposed else found.before


def content(found: Plan) -> bool:
    return any("nothing more is needed" in each for each in found.sentences)


def truth(leg: Leg, goal: str) -> float:
    name, _, ratio = goal.partition("_over_")
    value = leg.moment * GRAVITY if name == "gravity" else getattr(leg, name)
    return value / leg.inertia if ratio else value
