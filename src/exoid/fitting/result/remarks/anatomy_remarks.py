"""How far a leg's motion is from what its body's tables expect."""

import numpy as np

from exoid.fitting.model.belief import Belief
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.leg import GRAVITY

LEANING = "m, J, l, d and c lean on anatomy, and are worth nothing where it is not this leg's"
LEFT_OUT = "The tables count for nothing here"
STRANGE = 3.29  # standard deviations from what anatomy expects: one leg in a thousand


def of_anatomy(belief: Belief, gravity: float) -> list[str]:
    """That the leg's motion and its body's tables contradict each other, and what to do."""
    leaning = LEFT_OUT if belief.untabled else LEANING
    return [
        f"{each}. Check body mass, height and age, the encoder's zero, the times "
        f"({at_rate(belief, gravity)} would explain it), and that every mass on the leg is "
        f"declared. {leaning}; what the motion tells, the ratios to J, holds."
        for each in unlike_anatomy(belief, gravity)
    ]


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
    off = from_anatomy(belief, gravity, error)
    if abs(off) < STRANGE or belief.expected is None:
        return []
    expected, scatter = length_of(belief.expected)
    return [
        f"by its motion this leg has J / (m l) = {GRAVITY / gravity:.3f} m, and anatomy expects "
        f"{expected:.3f} ± {scatter * expected:.3f} m of this body: fewer than one leg in a "
        "thousand are as far off"
    ]


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
