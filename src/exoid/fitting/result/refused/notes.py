"""What a fit says of a recording that it does not follow: nothing that hangs on its model.

Sensors are compared with each other, and a swing is asked by itself (`own_swing`); a cause is named
where such a check shows it, and what else may be behind it as what can be checked.
"""

from collections.abc import Collection, Sequence

import numpy as np

from exoid.fitting.data.movement import Movement
from exoid.fitting.model.belief import Belief
from exoid.fitting.model.systematics import OF_THE_REST, by_recording
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.refused.own_swing import own_swing, rests
from exoid.fitting.result.remarks.gyro_remarks import scale_of
from exoid.fitting.result.remarks.remarks import as_taken, of_astray
from exoid.fitting.result.remarks.zero.leaning import Leaning
from exoid.fitting.result.remarks.zero.slack_words import of_missed
from exoid.fitting.solve.problem import Problem
from exoid.physics.anatomy.likeness import pendulum_length
from exoid.physics.leg import GRAVITY
from exoid.recordings.conventions.angle_convention import ON_ITS_SIDE

APART = 0.03  # of a scale: a gyro's data sheet allows half as much
SPRING = 6.0  # 1/s^2, c / J of a relaxed knee (2 to 15)
SLOW, FAST = 0.75, 2.0  # times what gravity alone makes of this body's leg: no leg is beyond
FARTHER = 1.5  # times so far must it be where that explains only most of the swing
ELSEWHERE = np.radians(4.0)  # of one leg whose drops begin at -10 and at -45 deg: 1 deg
BY_SWING = (
    "by its swing alone, whatever else is taken for granted, this leg is drawn back with "
    "{pull:.2g} 1/s^2, and gravity alone makes {usual:.2g} of a leg of this body. Check {times}"
    "body mass, height and age, and that every mass on the leg is declared."
)
TIMES = "the times (a sampling rate about {times:.2g} times the one they have would explain it), "
CYCLES = (
    "of cycles the torque is taken to be the cosine of Eq. 10, and that of a muscle seldom is: no "
    "number of the leg follows from them. Let the relaxed leg drop, or measure the torque"
)
MOVED = 3.0  # standard deviations of zero or tilt, from which on a seat may explain it
SEAT = (
    "a seat or posture that is not as declared (thigh_angle_deg of [protocol], the knee above the "
    "hip: hold a level to the thigh)"
)
OFTEN = 3  # times over the top, each of which multiplies a difference by tens
LET_GO = (
    "of a leg that was let go: {seat}a hand that stays at it or catches it, a muscle that acts, or "
    "answers its stretch ('exoid fit --with stretch_reflex'), a mass that is not declared, an "
    "encoder or a strap that drifts, a stop, dry friction (--with coulomb_friction), or a "
    "spring that is slack elsewhere than at full extension (--with stiffness_rest_angle)"
)
RIG = (
    "of a rig that was let go: dry friction ('exoid fit --with coulomb_friction'), a stop, a "
    "cable, drag that grows faster than speed, as of a paddle (--with quadratic_drag), a spring "
    "that is not linear, a hand that stays at it, a mass that is not declared"
)
OVER = (
    "it goes over the top {count} times, where the least difference grows, and no simulation of "
    "{length:.0f} s follows it. Record it below, or where it turns on and on, or number its pieces "
    "in a column segment."
)
DRIVEN = (
    "of a torque that was measured: its sign, its unit, that it is not late, and dry friction of "
    "motor, gear or hinge ('exoid fit --with coulomb_friction')"
)


def of_refused(why: str, basis: Basis, slack: Leaning | None) -> list[str]:
    """That it is not followed, what it and a `slack` spring show, and what may be behind it."""
    problem, ended = basis.problem, basis.ended
    movements, rig = problem.movements, problem.belief.rig
    seat = turned_away(problem, ended)
    return [
        *of_astray(why, problem),
        *([] if basis.ended.disturbance.apart else of_missed(slack)),
        *of_sensors(movements),
        *([] if rig else of_swing(problem.belief, movements)),
        *of_rests(movements),
        *of_the_top(movements),
        of_causes({each.kind for each in movements}, rig=rig, seat=seat),
        *as_taken(problem, ended.disturbance),
    ]


def turned_away(problem: Problem, ended: SearchResult) -> bool:
    """Does gravity draw the leg from elsewhere than is declared, as from a seat that is tilted?"""
    return any(
        abs(float(getattr(ended.point.mounting, name)[entry]))
        > MOVED * float(problem.deviation_of(name)[entry])
        for name in OF_THE_REST
        for entry in problem.estimated(name)
    )


def of_causes(kinds: Collection[str], *, rig: bool, seat: bool = False) -> str:
    """What may be behind it, of these kinds of movement; a `seat` where it can be."""
    let_go = RIG if rig else LET_GO.format(seat=f"{SEAT}, " if seat else "")
    said = {"active": CYCLES, "passive": let_go, "measured": DRIVEN}
    named = "; ".join(words for kind, words in said.items() if kind in kinds)
    return f"what may be behind it, and can be checked: {named}."


def of_sensors(movements: Sequence[Movement]) -> list[str]:
    """That gyro and encoder, compared with each other, differ in scale."""
    recordings, said = by_recording(list(movements)), []
    for own in recordings:
        scale = scale_of(own)
        if scale is not None and abs(scale) >= APART:
            whose = f" of {own[0].source}" if len(recordings) > 1 else ""
            said.append(
                f"compared with each other, without a model, gyro and encoder{whose} differ by "
                f"{100 * scale:+.0f} % in scale. Check unit and scale of the gyro, the encoder's "
                f"gain, and the times (a sampling rate {1 + scale:.2f} times the one they have "
                "would explain it)."
            )
    return said


def of_swing(belief: Belief, movements: Sequence[Movement]) -> list[str]:
    """That gravity does not turn a leg, or that it is drawn back as none of this body is."""
    swing = own_swing(movements)
    if swing is None:
        return []
    if swing.level:
        return [f"a spring alone draws this leg, wherever it is. {ON_ITS_SIDE}"]
    if belief.expected is None or belief.expected.covariance is None or not swing.rough:
        return []
    usual = GRAVITY / pendulum_length(belief.expected).value
    farther = 1.0 if swing.smooth else FARTHER
    if SLOW / farther < swing.pull / usual < FAST * farther:
        return []
    times = (
        ""
        if gyro_agrees(movements)
        else TIMES.format(times=float(np.sqrt((usual + SPRING) / swing.pull)))
    )
    return [BY_SWING.format(pull=swing.pull, usual=usual, times=times)]


def of_rests(movements: Sequence[Movement]) -> list[str]:
    """That movements swing about places that are not one leg's, as it was."""
    found = rests(movements)
    turned = len({each.thigh_angle for each in movements}) > 1  # they hang elsewhere then
    if turned or not found or max(found.values()) - min(found.values()) < ELSEWHERE:
        return []
    low, high = (pick(found, key=found.__getitem__) for pick in (min, max))
    return [
        f"by their swings alone segment {low} hangs at {np.degrees(found[low]):.0f} deg, segment "
        f"{high} at {np.degrees(found[high]):.0f} deg. Was a mass on the leg in one of them "
        "(added_mass_kg, a list with one entry a segment), or did the encoder, its strap or the "
        "seat slip between them? A muscle that holds the leg in one of them looks alike."
    ]


def of_the_top(movements: Sequence[Movement]) -> list[str]:
    """That one goes over the top again and again, where a free simulation is soon elsewhere."""
    for each in movements:
        if "gravity" in each.absent:
            continue
        seen = each.angle[~np.isnan(each.angle)]
        count = int(np.count_nonzero(np.diff(np.floor((seen - np.pi / 2) / (2 * np.pi)))))
        if count >= OFTEN:
            return [OVER.format(count=count, length=float(np.ptp(each.segment.time)))]
    return []


def gyro_agrees(movements: Sequence[Movement]) -> bool:
    """Does a gyro show by the same clock as the encoder how fast the leg is?"""
    return any(each.gyro_noise for each in movements) and not of_sensors(movements)
