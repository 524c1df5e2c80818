"""Legs as the prior has them, and what a camera sees of their drop."""

import numpy as np
from benchmarks.pendulum import Leg, swing

from exoid.fit.belief import Belief, believe
from exoid.fit.constraint import violations
from exoid.fit.prior import draw
from exoid.physics.leg import LegParameters
from exoid.recording.recording import Protocol, Recording, Segment, Sensors, Subject

SUBJECT = Subject(kind="leg", body_mass=74.0, height=1.78)
CAMERA = Sensors(angle_noise=np.radians(0.3))
TIME = np.arange(100) * 0.02  # s
START = (-0.35, -0.05)  # rad, of the drop


def belief() -> Belief:
    """Of everyone here: they are as tall and heavy as one another."""
    return believe(SUBJECT, "de_leva", 1.0)


def person(rng: np.random.Generator) -> LegParameters:
    """From the prior, within the limits."""
    known = belief()
    while True:
        leg = draw(known.prior, rng)
        if violations(known.limits, leg, np.zeros(1), np).max() <= 0:
            return leg


def recorded(leg: LegParameters, rng: np.random.Generator) -> Recording:
    """One drop at 50 Hz, by SciPy."""
    values = (leg.mass, leg.inertia, leg.com_distance, leg.damping, leg.stiffness)
    angle, _ = swing(Leg(*map(float, values)), rng.uniform(*START), TIME)
    seen = angle + CAMERA.angle_noise * rng.normal(size=TIME.size)
    return Recording((Segment(TIME, raw_angle=seen),), SUBJECT, Protocol(kind="passive"), CAMERA)
