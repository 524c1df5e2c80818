"""How far a leg's motion is from what its body's tables expect."""

from typing import Literal

from exoid.fitting.model.belief import Belief
from exoid.fitting.result.remarks.zero.leaning import Leaning
from exoid.physics.anatomy.expected import STRANGE
from exoid.physics.anatomy.likeness import away, off_rate, pendulum_length, rate_of
from exoid.physics.leg import GRAVITY

LEANING = "m, J, l, d and c lean on anatomy, and are worth nothing where it is not this leg's"
LEFT_OUT = "The tables count for nothing here"
HOLDS = "what the motion tells, the ratios to J, holds"
AS_OPEN = " as well as 'if slack' beside ± says"
ALLOWED = " as well as ± says, which allows for such times"
BOTH = " as well as ± and 'if slack' beside it say, of which ± allows for such times"
RARE = "fewer than one leg in a thousand are as far off"
SWING = "gravity_over_inertia"
Times = Literal["held", "vouched", "open"]
TWICE = 2.0  # of what is open for where a spring is slack: 60 deg of flexion, if nothing shows it
BENT = (
    "With a spring that is slack in a bent position, as a relaxed knee's mostly is, it may be "
    "an ordinary leg: 'exoid fit --with stiffness_rest_angle' and 'exoid diagnose' ask where it is "
    "slack, the hanging angle without and with a known mass tells best. Else"
)


def of_anatomy(
    belief: Belief, gravity: float, slack: Leaning | None, times: Times = "open"
) -> list[str]:
    """That the leg's motion and its body's tables contradict each other, and what to do; `slack` is
    what is open for where its spring is, and `times` are held by ±, vouched for, or neither.
    """
    unlike = unlike_unless_bent(belief, gravity, slack)
    if not unlike:
        return []
    leaning = LEFT_OUT if belief.untabled else LEANING
    rate = f"the times ({at_rate(belief, gravity)} would explain it), "
    held = (BOTH if slack else ALLOWED) if times == "held" else (AS_OPEN if slack else "")
    right = "times and zero are" if times == "open" else "the zero is"
    return [
        f"{each}. {first} body mass, height and age, the encoder's zero, "
        f"{'' if times == 'vouched' else rate}and that every mass on the leg is declared. "
        f"{leaning}; {HOLDS}{held}, if {right} right."
        for each, first in unlike
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
    """The sampling rate at which this were a leg as expected, in words."""
    assert belief.expected is not None  # else no leg is unlike it
    rate = rate_of(belief.expected, gravity)
    return (
        f"a sampling rate {rate.value:.2f} ± {rate.standard_deviation:.2f} times the one they have"
    )


def unlike_anatomy(belief: Belief, gravity: float, error: float = 0.0) -> list[str]:
    """That they contradict each other; `gravity` as m l g / J, with its standard error [1/s^2]."""
    if abs(from_anatomy(belief, gravity, error)) < STRANGE:
        return []
    return [f"{compared(belief, gravity)}: {RARE}"]


def compared(belief: Belief, gravity: float) -> str:
    """What the motion shows of J / (m l), beside what is expected."""
    assert belief.expected is not None  # else no leg is unlike it
    usual = pendulum_length(belief.expected)
    return (
        f"by its motion this leg has J / (m l) = {GRAVITY / gravity:.3f} m, and anatomy expects "
        f"{usual.value:.3f} ± {usual.standard_deviation:.3f} m of this body"
    )


def from_anatomy(belief: Belief, gravity: float, error: float = 0.0) -> float:
    """How far J / (m l) is from what anatomy expects, in standard deviations of legs and of
    m l g / J; 0 where it expects nothing.
    """
    if belief.expected is None or belief.by_hand:
        return 0.0
    return away(belief.expected, gravity, error)


def off_rate_of(belief: Belief, gravity: float, error: float) -> float:
    """By which share of it the sampling rate must be another to make it a leg of this body; 0 where
    it is one, and where anatomy expects nothing.
    """
    if belief.expected is None or belief.by_hand:
        return 0.0
    return off_rate(belief.expected, gravity, error)
