"""What a plan proposes: segments to record next, and the error that they would leave."""

from dataclasses import dataclass
from typing import Annotated

from exoid.twin.motion import Movement


@dataclass(frozen=True)
class Candidate:
    """One segment that could be recorded."""

    words: str
    motion: Movement
    thigh_angle: Annotated[float, "rad"] = 0.0

    @property
    def seat(self) -> tuple[float, float, float]:
        """What it has in common with others of one recording: the thigh's angle [rad], the added
        mass [kg], beside which a leg may be damped in a way of its own, and where that sits [m].
        """
        return self.thigh_angle, self.motion.added_mass, self.motion.added_mass_distance

    @property
    def effort(self) -> float:
        """Of the person who records it, against a bare drop."""
        return 1.0 + 0.5 * (self.motion.added_mass > 0) + 2.0 * (self.thigh_angle != 0)

    @property
    def voluntary(self) -> bool:
        return self.motion.amplitude is not None


@dataclass(frozen=True)
class AtHand:
    """What is known of a goal so far: standard errors, in its unit."""

    error: float  # inf where it has no number
    stays: float = 0.0  # of that, what the information of a further recording does not narrow
    if_slack: float | None = None  # more, for a spring slack elsewhere than at full extension


@dataclass(frozen=True)
class Option:
    """One segment that could be added, and the error of the goal that it would leave."""

    candidate: Candidate
    error: float


@dataclass(frozen=True)
class Plan:
    """What to record next for one quantity.

    >>> subject = exoid.Subject(kind="leg", body_mass=77.0, height=1.8)
    >>> plan = exoid.plan(None, subject, "damping_over_inertia")
    >>> plan.unit, plan.after < plan.before
    ('1/s', True)
    """

    goal: str
    symbol: str
    unit: str
    value: float
    before: float  # standard error, as the fit has it; inf where nothing tells
    after: float  # with all the proposed segments in one new recording
    proposed: list[Candidate]  # empty where none would help
    options: list[Option]  # one segment each, best first
    sentences: list[str]
    stays: float = 0.0  # of `before` and `after`, what no further recording narrows
    if_slack: float | None = None  # error more, for a spring slack elsewhere than at full extension


@dataclass(frozen=True)
class Telling:
    """One segment that could be added, and how far it would tell rivals apart."""

    candidate: Candidate
    log_odds: float  # natural logarithm, expected; of the pair hardest to tell apart
    probability: float  # that they reach 20 to 1


@dataclass(frozen=True)
class Contrast:
    """What to record next to tell rival models apart.

    >>> from exoid.physics.terms.device.coulomb_friction import CoulombFriction
    >>> from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
    >>> recording = exoid.load("drops.csv").recording
    >>> fits = [exoid.fit(recording, terms=(each,)) for each in (CoulombFriction, CubicStiffness)]
    >>> exoid.plan_between(fits, recording.subject).rivals
    ['coulomb_friction', 'cubic_stiffness']
    """

    rivals: list[str]
    at_hand: list[float]  # log odds of each against the best, by the recordings at hand
    proposed: list[Candidate]  # empty where nothing is needed, or nothing would tell
    log_odds: float  # expected of all the proposed segments; of the best, where none is
    probability: float
    if_right: list[float]  # the log odds of the same segments where this rival is right
    options: list[Telling]  # one segment each, best first
    sentences: list[str]
