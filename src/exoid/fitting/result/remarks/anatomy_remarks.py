"""How far a leg's motion is from what its body's tables expect."""

import numpy as np

from exoid.fitting.model.belief import Belief
from exoid.fitting.result.remarks.zero.leaning import Leaning
from exoid.physics.anatomy.expected import STRANGE, ExpectedLeg
from exoid.physics.leg import GRAVITY

LEANING = "m, J, l, d and c lean on anatomy, and are worth nothing where it is not this leg's"
LEFT_OUT = "The tables count for nothing here"
HOLDS = "what the motion tells, the ratios to J, holds"
AS_OPEN = " as well as 'if slack' beside ± says"
IF_RIGHT = ", if times and zero are right"
SWING = "gravity_over_inertia"
TWICE = 2.0  # of what is open for where a spring is slack: 60 deg of flexion, if nothing shows it
BENT = (
    "With a spring that is slack in a bent position, as a relaxed knee's mostly is, it may be "
    "an ordinary leg: 'exoid fit --with stiffness_rest_angle' and 'exoid diagnose' ask where it is "
    "slack, the hanging angle without and with a known mass tells best. Else"
)


def of_anatomy(belief: Belief, gravity: float, slack: Leaning | None) -> list[str]:
    """That the leg's motion and its body's tables contradict each other, and what to do; `slack` is
    what is open for where its spring is.
    """
    leaning = LEFT_OUT if belief.untabled else LEANING
    return [
        f"{each}. {first} body mass, height and age, the encoder's zero, the times "
        f"({at_rate(belief, gravity)} would explain it), and that every mass on the leg is "
        f"declared. {leaning}; {HOLDS}{AS_OPEN if slack else ''}{IF_RIGHT}."
        for each, first in unlike_unless_bent(belief, gravity, slack)
    ]


def unlike_unless_bent(
    belief: Belief, gravity: float, slack: Leaning | None
) -> list[tuple[str, str]]:
    """How it is unlike, and how what is to be checked begins."""
    if bent_explains(belief, gravity, slack):
        return [
            (
                f"{compared(belief, gravity)} whose spring is slack at full extension",
                f"{BENT} check",
            )
        ]
    return [(each, "Check") for each in unlike_anatomy(belief, gravity)]


def bent_explains(
    belief: Belief, gravity: float, slack: Leaning | None, error: float = 0.0
) -> bool:
    """Is it a leg as this body's may be, if only its spring is slack in a bent position?"""
    if slack is None or slack.off[SWING] >= 0:
        return False
    bent = gravity - TWICE * slack.spread[SWING]
    short = from_anatomy(belief, gravity, error) <= -STRANGE
    return short and from_anatomy(belief, bent, error) > -STRANGE


def at_rate(belief: Belief, gravity: float) -> str:
    """The sampling rate at which this were a leg as expected: m l g / J [1/s^2] goes with its
    square.
    """
    assert belief.expected is not None  # else no leg is unlike it
    length, scatter = length_of(belief.expected)
    times = float(np.sqrt(GRAVITY / gravity / length))
    return f"a sampling rate {times:.2f} ± {times * scatter / 2:.2f} times the one they have"


def unlike_anatomy(belief: Belief, gravity: float, error: float = 0.0) -> list[str]:
    """That they contradict each other; `gravity` as m l g / J, with its standard error [1/s^2]."""
    if abs(from_anatomy(belief, gravity, error)) < STRANGE:
        return []
    return [f"{compared(belief, gravity)}: fewer than one leg in a thousand are as far off"]


def compared(belief: Belief, gravity: float) -> str:
    """What the motion shows of J / (m l), beside what is expected."""
    assert belief.expected is not None  # else no leg is unlike it
    expected, scatter = length_of(belief.expected)
    return (
        f"by its motion this leg has J / (m l) = {GRAVITY / gravity:.3f} m, and anatomy expects "
        f"{expected:.3f} ± {scatter * expected:.3f} m of this body"
    )


def from_anatomy(belief: Belief, gravity: float, error: float = 0.0) -> float:
    """How far J / (m l) is from what anatomy expects, in standard deviations of legs and of
    m l g / J; 0 where it expects nothing.
    """
    expected = belief.expected
    if expected is None or expected.covariance is None or belief.by_hand or gravity <= 0:
        return 0.0
    length, scatter = length_of(expected)
    return float(np.log(GRAVITY / gravity / length)) / float(np.hypot(scatter, error / gravity))


def length_of(expected: ExpectedLeg) -> tuple[float, float]:
    """What is expected of J / (m l) [m], and its relative scatter."""
    assert expected.covariance is not None
    length = expected.inertia.value / (expected.mass.value * expected.com_distance.value)
    return length, float(np.sqrt(expected.covariance[2][2]))
