"""Where a search for play begins, and beside what, as the recording itself tells."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np

from exoid.mismatch.flight.accelerations import Accelerations, accelerations
from exoid.mismatch.flight.laws import of_frame, of_leg
from exoid.mismatch.screen.along_motion import effects_of_last
from exoid.mismatch.screen.hypothesis import Hypothesis
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.parameter import declarations
from exoid.physics.term import Term, holds
from exoid.physics.terms.device.backlash import Backlash

HALVES = (0.008, 0.014, 0.02)  # rad, half a play
SHARES = (0.04, 0.09)  # a frame's inertia over a leg's
LAW = ("frame_gravity", "hinge_damping", "hinge_friction")  # as `of_frame` has them
CONTACT = {"contact_time": 0.012, "damping_ratio": 0.7}  # s; of a bounce
USUAL = 0.06  # share with which other causes are compared
NOTABLE = 0.98  # of the residuals' size, below which another cause acts
PARTNERS = 2  # other causes that are worth a race

Laws = tuple[Accelerations, np.ndarray]  # and the frame's


def partners(
    prepared: PreparedRecording, usable: Sequence[type[Term]], begin: Hypothesis
) -> list[Hypothesis]:
    """The causes that explain most of what is left between strikes, each where it begins."""
    laws = seen_laws(prepared)
    if laws is None or not tells_leg(prepared):
        return []
    starts = [
        begin.with_term(term, value)
        for term in usable
        for value in prepared.starts(term)
        if pushes(term)
    ]
    most = NOTABLE * of_leg(*laws, USUAL)[1]
    best: dict[type[Term], tuple[float, Hypothesis]] = {}
    for start, push in zip(starts, pushed(prepared, starts), strict=True):
        law, left = of_leg(*laws, USUAL, push)
        lower, upper = (each[-start.values[-1].size] for each in prepared.bounds(start))
        possible = lower <= law[-1] <= upper and law[:-1].min() >= 0
        if possible and left < best.get(start.terms[-1], (most,))[0]:
            best[start.terms[-1]] = left, start
    return [start for _, start in sorted(best.values(), key=lambda one: one[0])][:PARTNERS]


def pushes(term: type[Term]) -> bool:
    """Does it push a leg that nothing strikes?"""
    return not term.jumps and (term.torque is not Term.torque or holds(term))


def starts_in_flight(prepared: PreparedRecording, known: Hypothesis) -> list[Hypothesis]:
    """What is known, with play: the frame swings as before strikes, the leg as between them, for
    several plays and frames. None where a recording does not tell.
    """
    laws = seen_laws(prepared)
    if laws is None:
        return []
    legs = {share: known for share in SHARES}
    if tells_leg(prepared):
        each = zip(known.terms, known.values, strict=True)
        others = [known.with_term(term, value) for term, value in each if pushes(term)]
        pushing = pushed(prepared, others)
        for share in SHARES:
            legs[share] = swinging(prepared, known, of_leg(*laws, share, *pushing)[0])
    return [
        with_play(prepared, legs[share], laws[1], half, share)
        for half, share in product(HALVES, SHARES)
    ]


def with_play(
    prepared: PreparedRecording, known: Hypothesis, law: np.ndarray, half: float, share: float
) -> Hypothesis:
    """What is known with half a play and a frame of this share of the leg's inertia."""
    inertia = share * float(np.exp(prepared.coordinates(known).shared.log_inertia))
    frame = dict(zip(LAW, inertia * law, strict=True))
    frame |= CONTACT | {"half_play": half, "frame_inertia": inertia}
    values = np.array([frame[name] for name, _ in declarations(Backlash)])
    start = known.with_term(Backlash, values)
    return start.at(np.clip(start.unknowns, *prepared.bounds(start)))


def swinging(prepared: PreparedRecording, known: Hypothesis, law: np.ndarray) -> Hypothesis:
    """What is known on a leg of this law, with the sizes of what pushes behind it."""
    gravity, stiffness, damping, *sizes = law
    at, left = prepared.coordinates(known), iter(sizes)
    leg = replace(at.shared, gravity=gravity, stiffness=stiffness, damping=damping)
    values = [
        np.array([next(left), *value[1:]]) if pushes(term) else value
        for term, value in zip(known.terms, known.values, strict=True)
    ]
    return replace(known, point=prepared.point(replace(at, shared=leg)), values=tuple(values))


def seen_laws(prepared: PreparedRecording) -> Laws | None:
    """Accelerations and the frame's law, where strikes tell it."""
    seen = accelerations(prepared)
    frame = of_frame(seen)
    return None if frame is None or not seen.joined.any() else (seen, frame)


def tells_leg(prepared: PreparedRecording) -> bool:
    """Do accelerations tell the leg's law? Not where another torque drives it, or masses are on."""
    each = prepared.problem.movements
    return all(one.kind == "passive" and not one.added_mass > 0 for one in each)


def pushed(prepared: PreparedRecording, starts: list[Hypothesis]) -> list[np.ndarray]:
    """What the last cause of each does to the leg along the measured motion by its size."""
    alone = [replace(one, terms=one.terms[-1:], values=one.values[-1:]) for one in starts]
    each = effects_of_last(prepared, alone, prepared.measured_motion)
    return [one.push.middle[1] for one in each]
