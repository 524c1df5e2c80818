"""Legs as the prior has them, and what a camera sees of their drop."""

import numpy as np
from benchmarks.pendulum import Leg
from benchmarks.promises.world import CAMERA, Act, recorded
from benchmarks.sbc.prior_draws import draw

from exoid.fitting.model.belief import Belief
from exoid.fitting.model.constraint import violations
from exoid.fitting.model.prior_and_limits import believe
from exoid.physics.leg import LegParameters
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording

SUBJECT = Subject(kind="leg", body_mass=74.0, height=1.78)
LASTS = 2.0  # s
START = (-0.35, -0.05)  # rad, of the drop


def belief() -> Belief:
    """Of everyone here: they are as tall and heavy as one another."""
    return believe(SUBJECT)


def person(rng: np.random.Generator) -> LegParameters:
    """From the prior, within the limits."""
    known = belief()
    while True:
        leg = draw(known.prior, rng)
        if violations(known.limits, leg, np.zeros(1), np).max() <= 0:
            return leg


def dropped(leg: LegParameters, rng: np.random.Generator) -> Recording:
    """One drop by a camera whose zero, clock and seat are a little off."""
    values = (leg.mass, leg.inertia, leg.com_distance, leg.damping, leg.stiffness)
    act = Act(rng.uniform(*START), LASTS)
    return recorded(Leg(*map(float, values)), [act], SUBJECT, CAMERA, rng)
