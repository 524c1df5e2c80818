"""Recordings that could be made next: drops bare and loaded, on a tilted seat, and cycles."""

from contextlib import suppress
from dataclasses import replace
from math import radians

import jax
import numpy as np

from exoid.fitting.data.movement import Movement as Observed
from exoid.fitting.data.segment import movement
from exoid.physics.leg import LegModel
from exoid.physics.torque import NoTorque
from exoid.planning.planned import Candidate
from exoid.planning.prior_knowledge import PriorKnowledge
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from exoid.twin.motion import Movement
from exoid.twin.protocols import record

ANGLES = (-10.0, -25.0, -40.0, -55.0)  # deg, of the release; lower ones hardly swing
MASSES = (0.5, 1.0, 2.0)  # kg
HEAVY = (2.0, 4.0)  # kg, near the knee
NEAR_KNEE = 0.105  # of body height: there a mass changes m l g / J most (`limiting.py`)
ANKLE = 0.225  # of body height, from the knee
TALL = 1.75  # m, a body whose height is unknown
TILTS = (-20.0, 20.0)  # deg, of the thigh by the whole seat, the hip left as it is
ACROSS = 7  # angles of a rig
SWING = 6.0  # s, after which a relaxed leg hangs nearly still
PERIODS = (1.2, 1.6, 2.4)  # s, of voluntary cycles


def candidates(height: float | None, amplitude: float | None) -> list[Candidate]:
    """What a person can do with a chair, a weighed mass and the exoskeleton.

    Cycles are among them where `amplitude` [N m] says how this leg is moved at will.
    """
    ankle = ANKLE * (height or TALL)
    drops = [
        Candidate(f"bare leg from {angle:.0f} deg", Movement(radians(angle), SWING))
        for angle in ANGLES
    ]
    loaded = [
        Candidate(
            f"{mass:g} kg at the ankle, {ankle:.2f} m from the knee, from {angle:.0f} deg",
            Movement(radians(angle), SWING, None, mass, ankle),
        )
        for mass in MASSES
        for angle in ANGLES[:3]
    ]
    near = NEAR_KNEE * (height or TALL)
    loaded += [
        Candidate(
            f"{mass:g} kg below the knee, {near:.2f} m from it, from {angle:.0f} deg",
            Movement(radians(angle), SWING, None, mass, near),
        )
        for mass in HEAVY
        for angle in ANGLES[:3]
    ]
    tilted = [
        Candidate(
            f"bare leg from {angle:.0f} deg, seat tilted, knee {abs(tilt):.0f} deg "
            f"{'above' if tilt > 0 else 'below'} hip",
            Movement(radians(angle), SWING),
            radians(tilt),
        )
        for tilt in TILTS
        for angle in ANGLES[:2]
    ]
    cycles = [
        Candidate(
            f"voluntary cycle of {period:g} s from {ANGLES[0]:.0f} deg",
            Movement(radians(ANGLES[0]), period, amplitude),
        )
        for period in (PERIODS if amplitude else ())
    ]
    return [*drops, *loaded, *tilted, *cycles]


def drops_of_rig(lowest: float, highest: float) -> list[Candidate]:
    """A rig let go anywhere within the angles [rad] that it has been seen at."""
    angles = np.unique(np.round(np.degrees(np.linspace(lowest, highest, ACROSS)))).tolist()
    return [
        Candidate(f"let go at {each:.0f} deg", Movement(radians(each), SWING)) for each in angles
    ]


def moving(options: list[Candidate], known: PriorKnowledge) -> dict[Candidate, Observed]:
    """Every candidate as the fit would see it, without noise.

    Those are left out from which this leg hardly moves: a stiff one rests high.
    """
    each = {}
    for tilt in dict.fromkeys(option.thigh_angle for option in options):
        alike = [option for option in options if option.thigh_angle == tilt]
        made = imagine(alike, tilt, known)
        for number, option in enumerate(alike):
            with suppress(ValueError):
                each[option] = movement(made, number, option.words)
    return each


def imagine(options: list[Candidate], tilt: float, known: PriorKnowledge) -> Recording:
    """The recording of these candidates on a seat, by sensors of the noise that is known."""
    model = LegModel(known.leg, NoTorque(), np.asarray(tilt), known.model_terms)
    motions = [option.motion for option in options]
    whose = Subject(kind="rig" if known.belief.rig else "leg")  # a rig may turn where no knee does
    made = record(model, motions, jax.random.key(0), subject=whose, exact=True)
    segments = tuple(
        segment if known.gyro else replace(segment, raw_angular_velocity=None)
        for segment in made.segments
    )
    return replace(made, segments=segments, sensors=known.sensors)
